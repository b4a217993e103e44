// Which elements of one mesh the elements of another one were made of: correspondence. By index of the elements, whatever types the meshes are of, so
// that every algorithm that makes a mesh of another one says it alike. correspondence.hpp takes values and properties along.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <vector>

namespace concino {

/// An element of the mesh before, and how much of it is in the element of the new mesh.
struct origin {
  std::uint32_t index;  // index_of in the mesh before
  double weight = 1;    // >= 0, finite: what both have in common, such as an area, or a weight of interpolation; only ratios count

  friend bool operator==(const origin&, const origin&) = default;
};

/// Of the elements of one kind of a new mesh, by index: the elements of that kind of the mesh before that they were made of, none, one or several.
/// Elements that were copied or split name the same origin; an element that was merged names several, one that was put between others too.
class element_origins {
  std::vector<std::uint32_t> single_;  // as long as no element has more than one, with the amount 1
  std::vector<std::size_t> first_;     // else: where the origins of each begin, and where the last ends
  std::vector<origin> list_;

  void make_lists() {
    if (!first_.empty()) return;
    first_.push_back(0);
    for (const std::uint32_t i : single_) {
      if (i != none) list_.push_back({i});
      first_.push_back(list_.size());
    }
    single_ = {};
  }

 public:
  static constexpr std::uint32_t none = ~0u;

  /// The origins of one element.
  class range {
    const origin* list_;
    std::size_t size_;
    origin single_;

   public:
    class iterator {
      const range* r_;
      std::size_t i_;

     public:
      using value_type = origin;
      iterator(const range& r, std::size_t i) : r_(&r), i_(i) {}
      origin operator*() const { return (*r_)[i_]; }
      iterator& operator++() {
        ++i_;
        return *this;
      }
      bool operator==(const iterator& o) const { return i_ == o.i_; }
    };

    explicit range(std::uint32_t single) : list_(nullptr), size_(single != none), single_{single} {}
    range(const origin* list, std::size_t size) : list_(list), size_(size), single_{none} {}

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
  /// At most one origin for each, `none` where there is no such element or where it was made of nothing.
  explicit element_origins(std::vector<std::uint32_t> single) : single_(std::move(single)) {}

  /// Of how many elements the origins are known: the index bound of the new mesh, once it is complete.
  std::size_t size() const { return first_.empty() ? single_.size() : first_.size() - 1; }
  range operator[](std::size_t i) const {
    assert(i < size());
    if (first_.empty()) return range(single_[i]);
    return range(list_.data() + first_[i], first_[i + 1] - first_[i]);
  }
  /// The origin of an element that has exactly one, else `none`.
  std::uint32_t only(std::size_t i) const {
    const range r = (*this)[i];
    return r.size() == 1 ? r[0].index : none;
  }

  /// The origins of the next element, whose index is size() before.
  void add(std::uint32_t one) {
    if (first_.empty()) {
      single_.push_back(one);
    } else {
      if (one != none) list_.push_back({one});
      first_.push_back(list_.size());
    }
  }
  void add(std::span<const origin> several) {
    make_lists();
    list_.insert(list_.end(), several.begin(), several.end());
    first_.push_back(list_.size());
  }
  void add(std::initializer_list<origin> several) { add(std::span<const origin>(several.begin(), several.size())); }
};

/// Of a mesh that was made of another one: for each vert, edge, face and poly by its index, what it was made of. A kind of elements of which nothing is
/// known is empty; edges and faces then follow from their verts (match_edges_and_faces), corners from their polys and verts.
struct correspondence {
  element_origins verts, edges, faces, polys, corners = {};
};

}  // namespace concino
