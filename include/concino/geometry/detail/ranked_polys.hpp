// The points of a mesh and its polys by rank, which is their position in polys(m). Points are scaled by a power of two
// that makes the largest coordinate about 1. This is exact, and avoids overflow and underflow of products in predicates
// and distances.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/error.hpp>
#include <concino/core/vec3.hpp>
#include <concino/geometry/bounding_box.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

using corner_index = std::uint32_t;

/// Sorts values into the order of the leaves of a tree.
template<class T>
void arrange(std::vector<T>& values, const std::vector<std::uint32_t>& order) {
  std::vector<T> arranged(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) arranged[i] = values[order[i]];
  values = std::move(arranged);
}

/// Assigns numbers from 0 in the order of first use, so that values used together are close together in memory.
class first_come_numbers {
  static constexpr std::uint32_t none = ~std::uint32_t{0};
  std::vector<std::uint32_t> number_;
  std::uint32_t num_numbered_ = 0;

 public:
  explicit first_come_numbers(std::size_t n) : number_(n, none) {}
  bool has(std::size_t i) const { return number_[i] != none; }
  std::uint32_t operator()(std::size_t i) {
    if (number_[i] == none) number_[i] = num_numbered_++;
    return number_[i];
  }
  template<class T>
  void arrange(std::vector<T>& values) const {
    std::vector<T> arranged(num_numbered_);
    for (std::size_t i = 0; i < number_.size(); ++i)
      if (has(i)) arranged[number_[i]] = values[i];
    values = std::move(arranged);
  }
};

template<class M>
class ranked_polys {
  std::vector<poly_t<M>> polys_;

 protected:
  std::vector<vec3> points_;  // by index of vert; followed by further points of the kind of poly
  double largest_ = 0;        // magnitude of a coordinate of a corner of a poly
  int exponent_ = 0;          // of the unit of length
  double to_tree_ = 1, to_mesh_ = 1;

  static double magnitude(const vec3& x) { return std::max({std::abs(x.x), std::abs(x.y), std::abs(x.z)}); }

  explicit ranked_polys(const M& m) {
    polys_.reserve(num_polys(m));
    for (const poly_t<M> p : polys(m)) polys_.push_back(p);
    points_.resize(vert_index_bound(m));
    for (const vert_t<M> v : verts(m)) points_[index_of(m, v)] = to_vec3(point(m, v));
  }

  /// Call it for each corner of poly p. Verts of no poly do not matter.
  void see(const M& m, const poly_t<M>& p, corner_index v) {
    const vec3& x = points_[v];
    if (!is_finite(x))
      core::throw_joined<invalid_mesh>({"bounding_tree: poly ", index_of(m, p),
                                        " has a vert whose point is not finite; validate(m) lists all of them"});
    largest_ = std::max(largest_, magnitude(x));
  }
  /// Call it after all corners.
  void scale() {
    std::frexp(largest_, &exponent_);
    exponent_ = std::min(std::max(exponent_, -1000), 1000);
    to_tree_ = std::ldexp(1.0, -exponent_);
    to_mesh_ = std::ldexp(1.0, exponent_);
    for (vec3& x : points_) x *= to_tree_;
  }

 public:
  std::size_t num_ranks() const { return polys_.size(); }
  const poly_t<M>& poly(std::size_t rank) const { return polys_[rank]; }

  vec3 to_mesh(const vec3& x) const { return to_mesh_ * x; }
  vec3 to_tree(const vec3& x) const { return to_tree_ * x; }
  /// x in the units of the tree, limited so that its squared distance does not overflow. A point that is too far is
  /// moved along the line to the origin; seen from there, too, all of the mesh is equally far up to rounding.
  vec3 to_tree_within_reach(const vec3& x) const {
    const double far = magnitude(x);
    return far * to_tree_ <= 0x1p200 ? to_tree_ * x : x / far * 0x1p200;
  }
  /// The distance of two points, both passed in units of the mesh and of the tree.
  double distance_in_mesh(const vec3& x, const vec3& y, const vec3& x_in_tree, const vec3& y_in_tree) const {
    return magnitude(x) * to_tree_ <= 0x1p200 ? to_mesh_ * distance(x_in_tree, y_in_tree) : distance(x, y);
  }
  /// The box in the units of the tree. Infinite bounds remain infinite.
  box to_tree(const box& b) const {
    box r;
    r.min = to_tree_ * b.min;
    r.max = to_tree_ * b.max;
    return r;
  }
  /// A length of 1 in the tree is 2^exponent in the mesh.
  int exponent() const { return exponent_; }
};

/// Items of N corners, triangles or tets: item i is a part of the poly with rank owner(i).
template<class M, std::size_t N>
class simplex_pieces : public ranked_polys<M> {
 protected:
  using base = ranked_polys<M>;
  using base::points_;

  std::vector<std::array<corner_index, N>> corners_;
  std::vector<std::uint32_t> owners_;

  explicit simplex_pieces(const M& m) : base(m) {}

  /// Each poly is one item.
  void add_polys(const M& m) {
    corners_.resize(this->num_ranks());
    owners_.resize(this->num_ranks());
    for (std::size_t r = 0; r < corners_.size(); ++r) {
      owners_[r] = static_cast<std::uint32_t>(r);
      std::size_t k = 0;
      for (const vert_t<M> v : adj_p2v(m, this->poly(r))) {
        const auto i = static_cast<corner_index>(index_of(m, v));
        this->see(m, this->poly(r), i);
        if (k < N) corners_[r][k++] = i;
      }
    }
    this->scale();
  }

 public:
  std::size_t size() const { return corners_.size(); }
  std::uint32_t owner(std::size_t i) const { return owners_[i]; }
  const vec3& corner(std::size_t i, std::size_t k) const { return points_[corners_[i][k]]; }
  box box_of(std::size_t i) const {
    box b;
    for (const corner_index c : corners_[i]) b.add(points_[c]);
    return b;
  }
  void arrange(const std::vector<std::uint32_t>& order) {
    detail::arrange(corners_, order);
    detail::arrange(owners_, order);
    first_come_numbers number(points_.size());
    for (auto& simplex : corners_)
      for (corner_index& c : simplex) c = number(c);
    number.arrange(points_);
  }
};

}  // namespace concino::detail
