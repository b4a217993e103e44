// Weights of bones by heat: the bones nearest to verts, and the system of equations.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/vec3.hpp>
#include <concino/deform/skin_weights.hpp>

#include <Eigen/SparseCore>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// The bones that are nearest to a point, at the same distance but for rounding.
struct nearest_bones {
  std::vector<std::uint32_t> bones;
  double distance = 0;
  vec3 point;  // of the first of them, nearest to the vert
};
nearest_bones bones_nearest_to(const std::vector<std::array<vec3, 2>>& bones, const vec3& x);

struct bone_heat_rows {
  std::vector<std::size_t> used;        // indices of verts
  std::vector<nearest_bones> nearest;   // of each of them; without bones where none is seen
  std::vector<nearest_bones> fallback;  // the same, seen or not, for verts without polys
  double size = 0;
};
struct computed_weights {
  skin_weights weights;
  std::size_t num_negative = 0;
};
/// laplacian: negative semidefinite, both triangles; mass: of each vert index.
/// Errors: solver_error if no vert of a component sees a bone.
computed_weights diffuse_heat(const Eigen::SparseMatrix<double>& laplacian, const std::vector<double>& mass,
                              const bone_heat_rows& rows, std::size_t num_bones, double amount, double min_weight);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/deform/detail/weights/heat.ipp>
#endif
