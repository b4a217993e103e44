// Bodies of flat_mesh_of.hpp: converts any mesh to a flat_mesh, without copying arrays that the mesh already stores in
// this form.
#pragma once

#include <concino/io/detail/formats/flat_mesh_of.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace concino::detail {

template<class T>
void list_collector<T>::end(std::size_t length) {
  if (lists_ == 0) arity_ = length;
  if (offsets_.empty() && (length != arity_ || arity_ == 0))
    for (std::size_t i = 0; i <= lists_; ++i) offsets_.push_back(i * arity_);
  values_ += length;
  ++lists_;
  if (!offsets_.empty()) offsets_.push_back(values_);
}

template<class T>
void list_collector<T>::refer_to(const T* first, const T* last) {
  if (!is_copy_ && values_ == 0) first_ = first;
  if (!is_copy_ && first != last && first != first_ + values_) {
    copies_.assign(first_, first_ + values_);
    is_copy_ = true;
  }
  if (is_copy_) copies_.insert(copies_.end(), first, last);
  end(static_cast<std::size_t>(last - first));
}

template<class T>
flat_lists<T> list_collector<T>::lists() const {
  return {std::span<const T>(is_copy_ ? copies_.data() : first_, values_), std::span<const std::size_t>(offsets_),
          offsets_.empty() ? arity_ : 0};
}

CONCINO_INLINE void element_numbers::renumber(std::size_t bound) {
  lists_hold_numbers = false;
  numbers.resize(bound);
  for (std::size_t i = 0; i < size; ++i) {
    numbers[i] = static_cast<std::uint32_t>(i);
    indices.push_back(static_cast<std::uint32_t>(i));
  }
}

#ifdef CONCINO_COMPILED
template class list_collector<vert_id>;
template class list_collector<face_id>;
#endif

}  // namespace concino::detail
