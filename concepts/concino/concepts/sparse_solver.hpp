// SparseSolver: factorises a sparse matrix once and solves for many right-hand sides. It is the last argument of every
// algorithm that solves linear systems.
//
// Laws:
//   SS1  after factorize(a) has returned, solve(b) is the x with a x = b up to rounding errors, for any number of calls
//   SS2  a matrix or a right-hand side that cannot be solved causes an exception derived from concino::error, never a
//        result that is not finite
//
// Optional members, which algorithms check for:
//   static constexpr bool reads_both_triangles = true    symmetric matrices are passed complete; otherwise as their
//                                                        lower triangle
//   static constexpr bool solves_least_squares = true    factorises matrices with more rows than columns, and solves
//                                                        least-squares problems
//   bool is_iterative() const                                solves to a tolerance: values far smaller than the largest
//                                                            have no correct digits
//   double residual() const                              of iterative solvers: of the last solve, which may miss its
//                                                        tolerance if that was allowed
//   options() const                                      the arguments for a similar solver; without it, further
//                                                        solvers are default-constructed or copied
//   void use_order_of(const S&)                          reuses the elimination order that another solver has found,
//                                                        for matrices of the same pattern
#pragma once

#include <concino/concepts/requirement.hpp>

#include <concepts>
#include <type_traits>

namespace concino {

namespace requirement {

template<class S, class Matrix> concept has_factorize = requires(std::remove_reference_t<S>& s, const Matrix& a) {
  s.factorize(a);
};
struct factorize_requirement {
  template<class S, class Matrix, class Vector> static constexpr bool holds = has_factorize<S, Matrix>;
  template<class S, class Matrix, class Vector> static consteval void explain() {
    static_assert(detail::missing<S>, "concino: SparseSolver needs factorize: void factorize(const Matrix&); throws a concino::solver_error if it cannot");
  }
};

template<class S, class Vector> concept has_solve = requires(const std::remove_cvref_t<S>& s, const Vector& b) {
  { s.solve(b) } -> std::convertible_to<Vector>;
};
struct solve_requirement {
  template<class S, class Matrix, class Vector> static constexpr bool holds = has_solve<S, Vector>;
  template<class S, class Matrix, class Vector> static consteval void explain() {
    static_assert(!requires(const std::remove_cvref_t<S>& s, const Vector& b) { s.solve(b); } || detail::missing<S>, "concino: solve is there, but what it returns does not convert to Vector");
    static_assert(requires(const std::remove_cvref_t<S>& s, const Vector& b) { s.solve(b); } || !requires(std::remove_cvref_t<S>& s, const Vector& b) { s.solve(b); } || detail::missing<S>, "concino: solve is there, but is not const");
    static_assert(detail::missing<S>, "concino: SparseSolver needs solve: Vector solve(const Vector& b) const; the x with a x = b for the matrix a factorised last");
  }
};

using sparse_solver_requirements = list<factorize_requirement, solve_requirement>;

}  // namespace requirement

template<class S, class Matrix, class Vector>
concept SparseSolver = requirement::has_factorize<S, Matrix> && requirement::has_solve<S, Vector>;

/// Fails to compile with one sentence that names the first thing S lacks to be a SparseSolver and what to write.
template<class S, class Matrix, class Vector>
consteval void explain_sparse_solver() {
  using first = requirement::first_missing<requirement::sparse_solver_requirements, S, Matrix, Vector>;
  if constexpr (!SparseSolver<S, Matrix, Vector>) first::template explain<S, Matrix, Vector>();
}

}  // namespace concino
