// The product of a mass matrix and a field, for the right-hand sides of Poisson's equation, heat flow and smoothing.
#pragma once

#include <concino/fields/detail/problems/dirichlet.hpp>

#include <cmath>
#include <cstddef>

namespace concino::detail {

/// y = a x for a symmetric matrix that stores both triangles, column by column. Uses loops, because Eigen's expressions
/// take long to compile.
inline void symmetric_times(const Eigen::SparseMatrix<double>& a, const Eigen::VectorXd& x, Eigen::VectorXd& y) {
  const int n = static_cast<int>(a.cols()), *const begin = a.outerIndexPtr(), *const row = a.innerIndexPtr();
  y.resize(n);
  for (int c = 0; c < n; ++c) {
    double sum = 0;
    for (int k = begin[c]; k < begin[c + 1]; ++k) sum += a.valuePtr()[k] * x[row[k]];
    y[c] = sum;
  }
}

/// Whether the vert with this index has a mass.
inline bool has_mass(const Eigen::SparseMatrix<double>& mass, std::size_t i) {
  for (int k = mass.outerIndexPtr()[i]; k < mass.outerIndexPtr()[i + 1]; ++k)
    if (mass.valuePtr()[k] != 0) return true;
  return false;
}

/// The mass matrix, which stores both triangles, times f. Reads f at the verts that have a mass.
/// Errors: invalid_argument if f is not finite there; the message begins with `what`.
template<class T, class M, class F>
right_hand_sides<T> mass_times(const M& m, const Eigen::SparseMatrix<double>& mass, const F& f, const char* what) {
  auto x = zeros<T>(static_cast<std::size_t>(mass.cols()));
  for (const vert_t<M> v : verts(m)) {
    const auto i = index_of(m, v);
    if (!has_mass(mass, i)) continue;
    const T value = as_field_value<T>(value_at(m, f, v));
    for (std::size_t k = 0; k < component_count<T>; ++k) {
      if (!std::isfinite(field_component(value, k)))
        core::throw_joined<invalid_argument>({what, " at vert ", i, " is not finite"});
      x[k][static_cast<Eigen::Index>(i)] = field_component(value, k);
    }
  }
  right_hand_sides<T> y;
  for (std::size_t k = 0; k < component_count<T>; ++k) symmetric_times(mass, x[k], y[k]);
  return y;
}

}  // namespace concino::detail
