// Residuals of linear systems: checks whether a computed solution is accurate, compared to rounding errors, and
// improves it.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/error.hpp>
#include <concino/core/product.hpp>
#include <concino/core/system_checks.hpp>

#include <Eigen/SparseCore>

#include <concepts>
#include <cstddef>
#include <memory>

namespace concino::core {

/// r = b - a x, for a compressed matrix, or for a symmetric one given by its lower triangle. Plain loops, because
/// Eigen's expressions take long to compile.
/// Result: the largest |r_i| / (|a| |x| + |b|)_i: the relative change of matrix and right-hand side that would make x
///         exact. It does not depend on the scale of rows.
double residual(const Eigen::SparseMatrix<double>& a, const Eigen::VectorXd& x, const Eigen::VectorXd& b,
                Eigen::VectorXd& r, bool is_lower_triangle);

/// The largest |r_i| / (|b_i| + the largest |a_ij| of the row times max|x|). Rows with large entries do not hide the
/// others, and small parts of x are not measured separately. a: as above.
double residual_beside_largest(const Eigen::SparseMatrix<double>& a, const Eigen::VectorXd& x, const Eigen::VectorXd& b,
                               const Eigen::VectorXd& r, bool is_lower_triangle);

[[noreturn, gnu::cold]] void throw_not_solved(const char* caller, double error);

/// Whether the last factorised matrix is solved by iteration, to a residual that the solver measures itself, relative
/// to the largest values of the solution: parts that are far smaller than others have no correct digits.
template<class Solver>
bool is_iterative([[maybe_unused]] const Solver& solver) {
  if constexpr (requires { { solver.is_iterative() } -> std::convertible_to<bool>; }) return solver.is_iterative();
  else return false;
}

/// A reference to a SparseSolver of any type, so that the functions below are compiled once. The solver must outlive
/// it.
class solver_ref {
  struct functions {
    Eigen::VectorXd (*solve)(const void*, const Eigen::VectorXd&);
    bool (*is_iterative)(const void*);
    double (*residual)(const void*);
  };
  template<class Solver>
  static constexpr functions functions_of = {
      [](const void* s, const Eigen::VectorXd& b) -> Eigen::VectorXd {
        return static_cast<const Solver*>(s)->solve(b);
      },
      [](const void* s) { return core::is_iterative(*static_cast<const Solver*>(s)); },
      []([[maybe_unused]] const void* s) -> double {
        if constexpr (requires(const Solver& solver) {
                        { solver.residual() } -> std::convertible_to<double>;
                      })
          return static_cast<const Solver*>(s)->residual();
        else return 0;
      }};

  const void* solver_;
  const functions* functions_;

 public:
  template<class Solver>
    requires(!std::same_as<Solver, solver_ref>)
  solver_ref(const Solver& solver) : solver_(std::addressof(solver)), functions_(&functions_of<Solver>) {}

  Eigen::VectorXd solve(const Eigen::VectorXd& b) const { return functions_->solve(solver_, b); }
  /// As core::is_iterative.
  bool is_iterative() const { return functions_->is_iterative(solver_); }
  /// The residual that the solver reports for its last solve; 0 if it reports none.
  double residual() const { return functions_->residual(solver_); }
};

/// Factorises a symmetric matrix given by its lower triangle. Solvers that read both triangles get both.
template<class Solver>
void factorize_symmetric(Solver& solver, const Eigen::SparseMatrix<double>& lower) {
  if constexpr (requires { requires Solver::reads_both_triangles; }) {
    Eigen::SparseMatrix<double> storage;
    solver.factorize(with_both_triangles(compressed(lower, storage)));
  } else {
    solver.factorize(lower);
  }
}

/// Errors: always solver_error, with the message for a singular matrix over verts.
[[noreturn, gnu::cold]] void throw_singular_at_vert(const char* caller, std::size_t vert, const char* why);

/// The same for a system over verts. vert_of(row): the index of a vert.
/// Errors: solver_error that names the problem, the vert at which the matrix is singular, and what helps.
template<class Solver, class VertOf>
void factorize_over_verts(Solver& solver, const Eigen::SparseMatrix<double>& lower, const char* caller,
                          const VertOf& vert_of) {
  try {
    factorize_symmetric(solver, lower);
  } catch (const singular_row& e) {
    throw_singular_at_vert(caller, static_cast<std::size_t>(vert_of(e.row)), e.what());
  }
}

/// Solves with a factorised matrix and applies iterative refinement while that helps. a: that matrix, compressed, or
/// its lower triangle.
/// Errors: solver_error if the residual is more than 1e-8. For iterative solvers: if, relative to the largest values,
///         it is more than 1e-5 and more than ten times what the solver reports, which happens if the matrix is not
///         what the solver assumes.
Eigen::VectorXd solve_and_check(solver_ref solver, const Eigen::SparseMatrix<double>& a, const Eigen::VectorXd& b,
                                const char* caller, bool is_lower_triangle = true);

}  // namespace concino::core

#ifndef CONCINO_COMPILED
#include <concino/core/detail/residual.ipp>
#endif
