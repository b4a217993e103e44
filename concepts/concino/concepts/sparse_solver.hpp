// SparseSolver: factorise a matrix once, solve with many right-hand sides. Handed in as the last argument of every problem that ends in
// a linear system.
//
// Laws:
//   SS1  after factorize(a) has returned, solve(b) is the x with a x = b up to rounding errors, as often as asked
//   SS2  a matrix or a right-hand side that cannot be solved is an exception derived from concino::error, never a result that is not finite
#pragma once

#include <concepts>
#include <type_traits>

namespace concino {

template<class S, class Matrix, class Vector>
concept SparseSolver = requires(std::remove_reference_t<S>& s, const std::remove_cvref_t<S>& solved, const Matrix& a, const Vector& b) {
  s.factorize(a);
  { solved.solve(b) } -> std::convertible_to<Vector>;
};

}  // namespace concino
