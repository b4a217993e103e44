// Correspondence between meshes: for each element of a new mesh, the elements of the old mesh of which it was made.
// Elements are stored by index, so it does not depend on the mesh types, and all algorithms that make a mesh of another
// one return it. correspondence.hpp transfers values and properties.
#pragma once

#include <concino/concepts/ranges.hpp>

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <vector>

namespace concino {

/// An element of the mesh before, with its weight in the element of the new mesh.
struct origin {
  std::uint32_t index;  // index_of in the mesh before
  double weight = 1;    // >= 0, finite: the size of the common part, such as an area, or an interpolation weight; only
                        // ratios count

  friend bool operator==(const origin&, const origin&) = default;
};

/// The origins of the elements of one kind in a new mesh, by index: the elements of that kind in the mesh before of
/// which each was made; none, one or several. Copies and parts of a split element have that element as origin. A merged
/// element has several origins, and so has an interpolated one.
class element_origins {
  std::vector<std::uint32_t> single_;   // by element: its origin; of those with a list, its number
  std::vector<std::uint64_t> has_list_;  // a bit for each element up to the last one that has several origins, or a
                                         // weight other than 1
  std::vector<std::size_t> first_;      // by list: where it begins, and where the last ends
  std::vector<origin> list_;

  bool has_list(std::size_t i) const { return i / 64 < has_list_.size() && (has_list_[i / 64] >> i % 64 & 1u); }

 public:
  static constexpr std::uint32_t none = ~0u;

  /// The origins of one element.
  class range {
    const origin* list_ = nullptr;
    std::size_t size_ = 0;
    origin single_{none};

   public:
    using value_type = origin;
    using iterator = detail::index_iterator<range>;

    range() = default;
    explicit range(std::uint32_t single) : size_(single != none), single_{single} {}
    range(const origin* list, std::size_t size) : list_(list), size_(size) {}

    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    origin operator[](std::size_t k) const {
      assert(k < size_);
      return list_ ? list_[k] : single_;
    }
    iterator begin() const { return {*this, 0}; }
    iterator end() const { return {*this, size_}; }
  };

  element_origins() = default;
  /// At most one origin for each element; `none` if the element does not exist or has no origin.
  explicit element_origins(std::vector<std::uint32_t> single) : single_(std::move(single)) {}

  /// The number of elements with known origins: the index bound of the new mesh, once it is complete.
  std::size_t size() const { return single_.size(); }
  range operator[](std::size_t i) const {
    assert(i < size());
    if (!has_list(i)) return range(single_[i]);
    const std::size_t k = single_[i];
    return range(list_.data() + first_[k], first_[k + 1] - first_[k]);
  }
  /// The origin of an element that has exactly one, else `none`.
  std::uint32_t only(std::size_t i) const {
    const range r = (*this)[i];
    return r.size() == 1 ? r[0].index : none;
  }

  /// Adds the origins of the next element, whose index is size() before the call.
  void add(std::uint32_t one) { single_.push_back(one); }
  void add(std::span<const origin> several) {
    single_.push_back(none);
    set(single_.size() - 1, several);
  }
  void add(std::initializer_list<origin> several) { add(std::span<const origin>(several.begin(), several.size())); }

  /// Sets the origins of an element that had at most one.
  void set(std::size_t i, std::span<const origin> several) {
    assert(i < size() && !has_list(i));
    if (first_.empty()) first_.push_back(0);
    if (has_list_.size() <= i / 64) has_list_.resize(i / 64 + 1);
    has_list_[i / 64] |= std::uint64_t{1} << i % 64;
    single_[i] = static_cast<std::uint32_t>(first_.size() - 1);
    const std::size_t before = list_.size();
    list_.resize(before + several.size());
    for (std::size_t k = 0; k < several.size(); ++k) list_[before + k] = several[k];
    first_.push_back(list_.size());
  }
};

/// The origins of all verts, edges, faces and polys of a new mesh, by index. A kind of elements with unknown origins is
/// empty. The origins of edges and faces can then be found from their verts (match_edges_and_faces), those of corners
/// from their polys and verts.
struct correspondence {
  element_origins verts, edges, faces, polys, corners = {};
};

}  // namespace concino
