// The option of direct solvers: how they order the unknowns.
#pragma once

#include <Eigen/SparseCore>

#include <vector>

namespace concino {

/// Computes an elimination order: a permutation of the rows, in the order in which they are eliminated. It may depend
/// only on the pattern of the matrix, which is square, compressed and not empty, and is to be read as symmetric: one or
/// both of two entries (i, j) and (j, i) are present. concino::metis is one.
using elimination_ordering = std::vector<int> (*)(const Eigen::SparseMatrix<double>& matrix);

/// Of ldlt, llt and cholmod.
struct direct_solver_options {
  elimination_ordering ordering = nullptr;  // nullptr: what the solver chooses
};

}  // namespace concino
