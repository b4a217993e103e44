// The x that brings A x closest to b, with values given for some unknowns.
#pragma once

#include <concino/concepts/sparse_solver.hpp>
#include <concino/solve/auto_solver.hpp>
#include <concino/solve/detail/conditions.hpp>
#include <concino/solve/detail/equilibrate.hpp>

#include <initializer_list>
#include <type_traits>
#include <utility>

namespace concino {

namespace requirement {

/// The solver takes matrices with more rows than columns, as qr does.
template<class S> concept solves_least_squares = requires { requires std::remove_cvref_t<S>::solves_least_squares; };

}  // namespace requirement

struct least_squares_result {
  Eigen::VectorXd x;
  double residual = 0;  // |b - A x|, or the root of sum w_i (b - A x)_i^2
};

namespace detail {

template<class D, class Solver>
least_squares_result least_squares(const char* who, Eigen::SparseMatrix<double> a, Eigen::VectorXd b, const D& given, Solver& solver) {
  a.makeCompressed();
  check_entries(who, a);
  check_right_hand_side(who, b, a.rows());
  const conditions problem(who, a.cols(), given);
  Eigen::SparseMatrix<double> j = problem.columns_of_unknowns(a);
  b -= a * problem.x;
  const std::vector<double> scale = scale_columns(j);
  Eigen::VectorXd y = Eigen::VectorXd::Zero(j.cols());
  if (j.cols() > 0) {
    if constexpr (requirement::solves_least_squares<Solver>) {
      solver.factorize(j);
      y = solver.solve(b);
    } else {
      const Eigen::SparseMatrix<double> transposed = j.transpose();
      const Eigen::SparseMatrix<double> normal = transposed * j;
      solver.factorize(normal);
      Eigen::VectorXd r = b;
      for (int step = 0; step < 3; ++step) {  // normal equations lose half the digits; solving for what is left brings them back
        y += solver.solve(Eigen::VectorXd(transposed * r));
        r = b - j * y;
      }
    }
  }
  const double residual = (b - j * y).norm();
  return {problem.with(scaled(std::move(y), scale)), residual};
}

}  // namespace detail

/// Minimises |A x - b| over all x with x_i = v for the pairs (i, v) of `given`, braces or any container.
/// Needs:  A: any shape; its columns of unknowns not given are independent. solver: a SparseSolver for positive definite matrices,
///         which gets the normal equations, columns scaled and the result corrected (Bjorck 1987); or qr, which gets A, for columns that are
///         nearly dependent.
/// Result: x, with given values exact, and what is left, |A x - b|.      Cost: one factorisation of A^T A, or of A.
/// Errors: solver_error if A has entries that are not finite, columns that depend on others, or b another size or entries that are not finite;
///         invalid_argument if an index is out of range, or a value is not finite, or given twice and differently.
/// Source: Bjorck 1987 (corrected semi-normal equations).
template<class D = std::initializer_list<std::pair<Eigen::Index, double>>, class Solver = auto_solver>
  requires SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
least_squares_result least_squares(const Eigen::SparseMatrix<double>& A, const Eigen::VectorXd& b, const D& given = {}, Solver&& solver = {}) {
  return detail::least_squares("least_squares", A, b, given, solver);
}

/// The same, with a weight w_i per row: minimises sum w_i (A x - b)_i^2. A row of weight 0 says nothing.
/// Errors: as least_squares; invalid_argument if w has another size than A has rows, or a weight is negative or not finite.
template<class D = std::initializer_list<std::pair<Eigen::Index, double>>, class Solver = auto_solver>
  requires SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
least_squares_result weighted_least_squares(const Eigen::SparseMatrix<double>& A, const Eigen::VectorXd& w, const Eigen::VectorXd& b,
                                            const D& given = {}, Solver&& solver = {}) {
  const char* const who = "weighted_least_squares";
  if (w.size() != A.rows())
    detail::throw_joined<invalid_argument>({who, ": there are ", static_cast<std::size_t>(w.size()), " weights, but ",
                                            static_cast<std::size_t>(A.rows()), " rows"});
  for (Eigen::Index i = 0; i < w.size(); ++i)
    if (!(w[i] >= 0 && std::isfinite(w[i])))
      detail::throw_joined<invalid_argument>({who, ": the weight of row ", static_cast<std::size_t>(i), " is ", detail::number_text(w[i]),
                                              "; weights must be finite and not negative"});
  detail::check_right_hand_side(who, b, A.rows());
  const Eigen::VectorXd root = w.cwiseSqrt();
  return detail::least_squares(who, root.asDiagonal() * A, root.cwiseProduct(b), given, solver);
}

}  // namespace concino
