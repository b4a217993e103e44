// Polys with any number of verts, as lists of corners: a polygon is one list, a polyhedron has one for each face.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace concino::detail {

/// Corners of faces run counter-clockwise seen from outside their poly.
class poly_lists {
  std::vector<unsigned> corners_, ends_, poly_ends_;

  static std::size_t start(const std::vector<unsigned>& ends, std::size_t i) { return i == 0 ? 0 : ends[i - 1]; }

 public:
  std::size_t num_polys() const { return poly_ends_.size(); }
  std::size_t num_lists() const { return ends_.size(); }
  const std::vector<unsigned>& corners() const { return corners_; }
  const std::vector<unsigned>& ends() const { return ends_; }
  const std::vector<unsigned>& poly_ends() const { return poly_ends_; }

  /// The lists of poly k are those from first_list(k) to last_list(k) - 1.
  std::size_t first_list(std::size_t k) const { return start(poly_ends_, k); }
  std::size_t last_list(std::size_t k) const { return poly_ends_[k]; }
  std::size_t size_of(std::size_t k) const { return last_list(k) - first_list(k); }
  std::span<const unsigned> list(std::size_t i) const {
    return std::span(corners_).subspan(start(ends_, i), ends_[i] - start(ends_, i));
  }
  /// The corners of all lists of poly k.
  std::span<const unsigned> corners_of(std::size_t k) const {
    const std::size_t first = start(ends_, first_list(k));
    return std::span(corners_).subspan(first, start(ends_, last_list(k)) - first);
  }
  bool has(std::size_t k, unsigned v) const {
    const auto all = corners_of(k);
    return std::find(all.begin(), all.end(), v) != all.end();
  }

  void add_corner(unsigned v) { corners_.push_back(v); }
  void end_list() { ends_.push_back(static_cast<unsigned>(corners_.size())); }
  /// Reverses the list that has not ended yet.
  void reverse_open_list() {
    std::reverse(corners_.begin() + static_cast<std::ptrdiff_t>(start(ends_, ends_.size())), corners_.end());
  }
  void add_list(std::span<const unsigned> list) {
    corners_.insert(corners_.end(), list.begin(), list.end());
    end_list();
  }
  void end_poly() { poly_ends_.push_back(static_cast<unsigned>(ends_.size())); }
  /// Replaces each corner by number(corner).
  template<class F>
  void renumber(const F& number) {
    for (unsigned& v : corners_) v = number(v);
  }
};

/// Calls f(from, to) for the edges of a cyclic list.
template<class F>
void for_each_edge_of(std::span<const unsigned> list, const F& f) {
  for (std::size_t i = 0; i < list.size(); ++i) f(list[i], list[i + 1 < list.size() ? i + 1 : 0]);
}

inline std::vector<unsigned> sorted_list(std::span<const unsigned> list) {
  std::vector<unsigned> all(list.begin(), list.end());
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

}  // namespace concino::detail
