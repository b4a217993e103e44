// Products of sparse matrices, and both triangles of a symmetric one, for powers of operators. Eigen's own product adds
// a second to the compile time of every program that includes it.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/error.hpp>
#include <concino/core/message.hpp>

#include <Eigen/SparseCore>

#include <vector>

#ifdef CONCINO_COMPILED
// The copy of matrices that are not compressed, which every copy and every return statement instantiates.
extern template void Eigen::internal::assign_sparse_to_sparse<Eigen::SparseMatrix<double>, Eigen::SparseMatrix<double>>(
    Eigen::SparseMatrix<double>&, const Eigen::SparseMatrix<double>&);
#endif

namespace concino {

/// The full symmetric matrix with this lower triangle, for solvers that read both triangles.
/// Needs:  lower: square, compressed, rows sorted within columns, no entries above the diagonal.
/// Result: a matrix with rows sorted within columns; entries that are 0 are kept.      Cost: O(entries) time and
///         memory.
/// Errors: invalid_argument if lower is not square or not compressed; unsupported if 32-bit indices cannot count the
///         entries.
Eigen::SparseMatrix<double> with_both_triangles(const Eigen::SparseMatrix<double>& lower);

/// The product a diag(d) b, such as K M^-1 K of a Laplacian and lumped masses; if d is all 1, the product of a and b.
/// Needs:  a, b: compressed; columns of a, numbers in d and rows of b are equally many.
/// Result: a matrix with rows sorted within columns. Entries that cancel are stored as 0: the pattern depends on those
///         of a and b alone.
/// Cost:   O(multiplications + entries log of those in a column) time, O(entries) memory.
/// Errors: invalid_argument if sizes do not fit or a matrix is not compressed; unsupported if 32-bit indices cannot
///         count the entries.
/// Source: Gustavson 1978, "Two fast algorithms for sparse matrices".
Eigen::SparseMatrix<double> scaled_product(const Eigen::SparseMatrix<double>& a, const std::vector<double>& d,
                                           const Eigen::SparseMatrix<double>& b);

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/core/detail/product.ipp>
#endif
