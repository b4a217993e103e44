// The Galerkin product of multigrid: the matrix of a coarser level.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/solve/detail/multigrid/aggregates.hpp>

#include <Eigen/SparseCore>

namespace concino::detail {

/// P^T A P for the lower triangle of A; the result is a lower triangle too, with sorted columns. A diagonal entry that
/// is only rounding errors belongs to the kernel of A, and is replaced by a positive number; has_kernel: then set.
Eigen::SparseMatrix<double> coarse_matrix(const Eigen::SparseMatrix<double>& lower, const prolongation& p,
                                          bool& has_kernel);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/solve/detail/multigrid/coarse_matrix.ipp>
#endif
