// Interpolation of multigrid at rows whose positive entries cancel most of the negative ones, as on stretched polygons.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/solve/detail/multigrid/aggregates.hpp>

#include <Eigen/SparseCore>

#include <cstddef>
#include <vector>

namespace concino::detail {

/// Rows of a symmetric matrix with large positive entries off the diagonal. On stretched polygons the stabilisation of
/// virtual elements makes them: it is as large as the stiffness along the short direction and vanishes for linear
/// functions only. So functions that are linear along the long direction have little energy, as those of a bent beam,
/// and steps between aggregates have much. The filtered matrix of aggregates does not show that. So these rows are
/// smoothed by several Jacobi steps with all their entries. Small weights are left out, since cycles would cost twice
/// as much with them.
class cancelling_rows {
  static constexpr double share = 0.1;          // of the diagonal entry: the least sum of positive entries of such a
                                                // row
  static constexpr double damping = 0.55;       // of a Jacobi step; 0.45 to 0.65 differ little
  static constexpr double small_weight = 0.05;  // of the largest weight of a row: what is left out
  static constexpr int steps = 3, max_per_row = 200;

  std::vector<char> contains_;
  Eigen::SparseMatrix<double, Eigen::RowMajor> step_;  // the matrix of a Jacobi step; the identity in other rows

  static std::vector<char> find(const Eigen::SparseMatrix<double>& a);
  prolongation smooth_once(const prolongation& p, std::size_t max_entries) const;

 public:
  /// Whether so many rows are of this kind that fewer iterations pay for the time. They do not in rows with few
  /// entries, as of quads, whose stabilisation does not see bent lines, and in rows with many, as of hexes, since
  /// coarse matrices would not be sparse.
  static bool pay_for(const Eigen::SparseMatrix<double>& a);

  /// a: the lower triangle; each column begins with its diagonal entry.
  explicit cancelling_rows(const Eigen::SparseMatrix<double>& a);

  bool contains(std::size_t i) const { return contains_[i] != 0; }

  /// p with these rows smoothed; there it has one coarse value before. Empty if p is, or if the result had more than
  /// `max_entries` entries.
  prolongation smooth(prolongation p, std::size_t max_entries) const {
    for (int step = 0; step < steps && p.columns > 0; ++step) p = smooth_once(p, max_entries);
    return p;
  }
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/solve/detail/multigrid/cancelling_rows.ipp>
#endif
