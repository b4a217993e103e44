// alive_elements: the existing elements of one kind, which are the indices 0 .. bound-1 without the deleted ones.
// Deletion leaves a gap, so no other element changes its index. Nothing is stored before the first deletion. Edits
// allocate all memory first and cannot fail afterwards.
#pragma once

#include <concino/concepts/ranges.hpp>

#include <algorithm>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino::detail {

/// Reserves memory for n more values, so that adding them cannot fail.
template<class T>
void reserve_more(std::vector<T>& v, std::size_t n) {
  if (v.capacity() - v.size() >= n) return;
  v.reserve(std::max(v.size() + n, 2 * v.size()));
}

/// One more than the largest index of each kind of elements; 0 for faces if there are none.
struct index_bounds {
  std::size_t verts = 0, edges = 0, faces = 0, polys = 0, corners = 0;
};

struct compaction;  // compaction.hpp

template<class Id>
class alive_elements {
  std::size_t bound_ = 0;
  std::size_t deleted_ = 0;
  std::vector<std::uint8_t> dead_;  // empty, or one flag per index

 public:
  alive_elements() = default;
  explicit alive_elements(std::size_t n) : bound_(n) {}
  alive_elements(const alive_elements&) = default;
  alive_elements(alive_elements&& o) noexcept
      : bound_(std::exchange(o.bound_, 0)), deleted_(std::exchange(o.deleted_, 0)), dead_(std::exchange(o.dead_, {})) {}
  alive_elements& operator=(alive_elements o) noexcept {
    std::swap(bound_, o.bound_);
    std::swap(deleted_, o.deleted_);
    dead_.swap(o.dead_);
    return *this;
  }

  std::size_t bound() const { return bound_; }
  std::size_t size() const { return bound_ - deleted_; }
  bool contains(Id x) const { return x.raw() < bound_ && (dead_.empty() || !dead_[x.raw()]); }
  id_range<Id> all() const { return id_range<Id>(bound_, dead_.empty() ? nullptr : dead_.data()); }

  /// After this call, n calls of add() cannot fail.
  void reserve(std::size_t n) {
    if (!dead_.empty()) reserve_more(dead_, n);
  }
  /// After this call remove() cannot fail.
  void reserve_removal() {
    if (dead_.empty() && dead_.capacity() < bound_) dead_.reserve(std::max(bound_, 2 * dead_.capacity()));
  }

  /// After this call, so many calls of remove(), followed by so many of add(), cannot fail.
  void reserve_change(std::size_t removed, std::size_t added) {
    if (removed == 0) reserve(added);
    else if (dead_.capacity() < bound_ + added) dead_.reserve(std::max(bound_ + added, 2 * dead_.capacity()));
  }

  /// For undoing: sets the index bound and the number of elements, and whether x is one.
  void restore_size(std::size_t bound, std::size_t size) {
    bound_ = bound, deleted_ = bound - size;
    if (!dead_.empty()) dead_.resize(bound, 0);
  }
  void restore(Id x, bool is_alive) {
    if (!dead_.empty()) dead_[x.raw()] = !is_alive;
  }

  Id add() {
    if (!dead_.empty()) dead_.push_back(0);
    return Id{bound_++};
  }
  void remove(Id x) {
    if (!contains(x)) return;
    if (dead_.empty()) dead_.assign(bound_, 0);
    dead_[x.raw()] = 1;
    ++deleted_;
  }
};

}  // namespace concino::detail
