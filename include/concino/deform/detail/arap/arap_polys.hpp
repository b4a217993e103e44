// As rigid as possible with spokes and rims: the matrices of polys, and their part of both steps of an iteration.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/vec3.hpp>
#include <concino/deform/detail/skin/best_rotation.hpp>
#include <concino/operators/discretisation.hpp>

#include <Eigen/SparseCore>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// The images of the unit vectors under a rotation, or a sum of such.
using rotation_columns = std::array<vec3, 3>;
inline vec3 turned(const rotation_columns& r, const vec3& a) { return a.x * r[0] + a.y * r[1] + a.z * r[2]; }

/// The energy is the sum, over the polys and their verts, of the weights of pairs of verts of the poly times the squared
/// difference between the pair and its rest, rotated by the rotation of the vert. The sum over the pairs of a poly is
/// not negative, though single weights may be. Verts are numbers.
class arap_polys {
  std::vector<std::uint32_t> first_{0}, vert_;  // the verts of each poly; a place is an index of vert_
  std::vector<std::size_t> first_weight_{0};
  std::vector<double> weight_;                             // of each poly the pairs (1, 0), (2, 0), (2, 1), (3, 0) ...
  std::vector<std::uint32_t> first_place_, place_, poly_;  // the places of each vert; the poly of each place
  std::vector<vec3> pull_;  // of each place: the sum of weights times the edges to it in its poly, at rest

  /// The sum of weights times the squares of differences of y, one for each vert of the poly.
  double squares(std::size_t poly, const std::vector<vec3>& y) const;

 public:
  bool is_empty() const { return vert_.empty(); }

  /// Adds a poly with this lower triangle of its matrix, row after row.
  void add(const std::vector<std::uint32_t>& verts, const std::vector<double>& entries);

  /// Minus the matrix of the energy for given rotations, both triangles. size: more than any vert.
  Eigen::SparseMatrix<double> laplacian(std::size_t size) const;

  /// To be called once, after the last poly: the points at rest, and the unit of weights from now on.
  void prepare(const std::vector<vec3>& rest, double weight_unit);

  /// The best rotation at each vert with polys, and the energy.
  double local_step(const std::vector<vec3>& rest, const std::vector<vec3>& x,
                    std::vector<rotation_columns>& rotations) const;

  /// The sum of the rotations of the verts of each poly; the right side of the equation of a vert, for these sums.
  std::vector<rotation_columns> sums_of(const std::vector<rotation_columns>& rotations) const;
  vec3 right_side(std::size_t vert, const std::vector<rotation_columns>& sums) const {
    vec3 sum;
    for (std::uint32_t k = first_place_[vert]; k < first_place_[vert + 1]; ++k)
      sum += turned(sums[poly_[place_[k]]], pull_[place_[k]]);
    return sum;
  }
};

/// The matrices of the polys of m.
/// Errors: those of the discretisation.
template<class M, class D>
arap_polys arap_polys_of(const M& m, const D& discretisation) {
  arap_polys all;
  auto matrix_of = discretisation.poly_matrices(m);
  local_matrix<vert_t<M>> local;
  std::vector<std::uint32_t> index;
  for (const poly_t<M> p : polys(m)) {
    matrix_of(p, local);
    index.clear();
    for (const vert_t<M> v : local.verts) index.push_back(static_cast<std::uint32_t>(index_of(m, v)));
    all.add(index, local.entries);
  }
  return all;
}

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/deform/detail/arap/arap_polys.ipp>
#endif
