// A heat matrix by rows, its verts in the order in which heat decreases. Independent of the mesh type and of solvers.
#pragma once

#include <concino/core/compiled.hpp>

#include <Eigen/SparseCore>

#include <span>
#include <vector>

namespace concino::detail {

/// A heat matrix whose verts are in the order in which heat decreases. Each row has the entries left of its diagonal
/// only, with the sign reversed.
struct heat_rows {
  std::vector<int> begin{0}, column;
  std::vector<double> entry, diagonal;
  std::vector<double> mass;  // the sum of the whole row, at least min_mass of its diagonal entry

  static constexpr double min_mass = 1e-3;

  heat_rows() = default;
  /// lower: the lower triangle of the matrix, with positive diagonal entries. order: its rows in the new order.
  heat_rows(const Eigen::SparseMatrix<double>& lower, std::span<const int> order);
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/fields/detail/heat/heat_rows.ipp>
#endif
