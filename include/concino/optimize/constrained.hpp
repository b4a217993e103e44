// Minima of quadratic functions under linear equality constraints, by Lagrange multipliers.
#pragma once

#include <concino/concepts/sparse_solver.hpp>
#include <concino/core/system_checks.hpp>
#include <concino/optimize/detail/independent_rows.hpp>
#include <concino/solve/lu.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace concino {

struct constrained_result {
  Eigen::VectorXd x;
  Eigen::VectorXd multipliers;   // one per row of C: K x + C^T multipliers = b; 0 for redundant rows
  std::size_t redundant = 0;     // number of rows of C that depend on earlier rows, and were dropped
};

/// The stationary point of x^T K x / 2 - b^T x among all x with C x = d. It is the minimum if K is positive definite in
/// the null space of C. K itself may be singular, as the Laplacian of a mesh without boundary values is, if C
/// determines the rest.
/// Needs:  K: symmetric, n x n, both triangles; C: m x n, any rank. solver: a SparseSolver for symmetric indefinite
///         matrices. ldlt and others that read one triangle are allowed, but ldlt does not exchange pivots, so it fails
///         on some systems that lu, the default, solves.
/// Result: x, the multipliers, and the number of redundant constraints. A constraint is redundant if its row depends on
///         the rows before it up to rounding errors, some 1e-15 of its largest entry, in any units of rows. Its right
///         side must then agree with theirs up to 1e-9 of the numbers from which it is computed. Rows that differ by a
///         little more are constraints, and lose as many digits as they have in common.
/// Cost:   one factorisation of n + m unknowns, and an elimination of C with its fill-in.
/// Errors: solver_error if a constraint contradicts those before it (the message names its row), if K and C leave x
///         undetermined, or if an entry is not finite or a size is wrong.
/// Source: Nocedal, Wright, Numerical Optimization, 2006, section 16.1.
template<class Solver = lu>
  requires SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd> constrained_result
  solve_with_constraints(const Eigen::SparseMatrix<double>& K, const Eigen::VectorXd& b,
                         const Eigen::SparseMatrix<double>& C, const Eigen::VectorXd& d, Solver&& solver = {}) {
    const char* const caller = "solve_with_constraints";
    Eigen::SparseMatrix<double> k_storage, c_storage;
    const Eigen::SparseMatrix<double>&k = core::compressed(K, k_storage), &c = core::compressed(C, c_storage);
    core::check_square(caller, k);
    core::check_entries(caller, k);
    core::check_right_hand_side(caller, b, k.rows());
    if (c.cols() != k.cols())
      core::throw_joined<solver_error>({caller, ": the constraints are on ", static_cast<std::size_t>(c.cols()),
                                        " unknowns, but there are ", static_cast<std::size_t>(k.cols())});
    core::check_entries(caller, c);
    core::check_right_hand_side(caller, d, c.rows());
    const detail::row_space space = detail::independent_rows(caller, c, d);
    const std::vector<int>& kept = space.independent;
    const auto n = static_cast<int>(k.cols()), m = static_cast<int>(kept.size());
    std::vector<int> new_row(static_cast<std::size_t>(c.rows()), -1);
    Eigen::VectorXd right(n + m);
    right.head(n) = b;
    for (int i = 0; i < m; ++i) {
      new_row[static_cast<std::size_t>(kept[static_cast<std::size_t>(i)])] = n + i;
      right[n + i] = space.is_nearly_dependent ? space.reduced[static_cast<std::size_t>(i)].value
                                               : d[kept[static_cast<std::size_t>(i)]];
    }
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(static_cast<std::size_t>(k.nonZeros() + 2 * c.nonZeros()));
    const auto couple = [&](int row, int column, double value) {
      entries.emplace_back(row, column, value);
      entries.emplace_back(column, row, value);
    };
    for (int column = 0; column < n; ++column) {
      for (Eigen::SparseMatrix<double>::InnerIterator it(k, column); it; ++it)
        entries.emplace_back(static_cast<int>(it.row()), column, it.value());
      for (Eigen::SparseMatrix<double>::InnerIterator it(c, column); it; ++it)
        if (const int row = new_row[static_cast<std::size_t>(it.row())]; row >= 0 && !space.is_nearly_dependent)
          couple(row, column, it.value());
    }
    if (space.is_nearly_dependent)  // the original rows would lose more digits
      for (int i = 0; i < m; ++i)
        for (const auto& [column, value] : space.reduced[static_cast<std::size_t>(i)].entries)
          couple(n + i, column, value);
    Eigen::SparseMatrix<double> whole(n + m, n + m);
    whole.setFromTriplets(entries.begin(), entries.end());
    try {
      solver.factorize(whole);
    } catch (const solver_error& e) {
      core::throw_joined<solver_error>({caller, ": K and ", static_cast<std::size_t>(m),
                                        " constraints do not determine the ", static_cast<std::size_t>(n),
                                        " unknowns, or the solver fails: ", std::string(e.what())});
    }
    Eigen::VectorXd found = solver.solve(right);
    found += solver.solve(Eigen::VectorXd(right - whole * found));
    constrained_result r;
    r.x = found.head(n);
    r.multipliers = Eigen::VectorXd::Zero(c.rows());
    std::vector<double> multipliers(found.data() + n, found.data() + n + m);
    if (space.is_nearly_dependent) space.multipliers_of_original_rows(multipliers);
    for (std::size_t i = 0; i < kept.size(); ++i) r.multipliers[kept[i]] = multipliers[i];
    r.redundant = static_cast<std::size_t>(c.rows()) - kept.size();
    return r;
  }

}  // namespace concino
