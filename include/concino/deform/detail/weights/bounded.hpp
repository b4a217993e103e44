// Bounded biharmonic weights of handles, by quadratic programs.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/progress.hpp>
#include <concino/deform/skin_weights.hpp>

#include <Eigen/SparseCore>

#include <cstddef>
#include <vector>

namespace concino::detail {

struct bounded_limits {
  double tolerance = 0, min_weight = 0;
  int max_iterations = 0;
};

/// laplacian: both triangles. mass: of each vert index, 0 of those without neighbours. handles: indices of verts.
/// Errors: see bounded_biharmonic_weights.
skin_weights make_bounded_weights(const Eigen::SparseMatrix<double>& laplacian, const std::vector<double>& mass,
                                  const std::vector<std::vector<std::size_t>>& handles, const bounded_limits& limits,
                                  const progress& on_progress);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/deform/detail/weights/bounded.ipp>
#endif
