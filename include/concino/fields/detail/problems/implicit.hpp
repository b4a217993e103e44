// The system (M + a K) u = M f of an implicit heat step and of smoothing. M is a mass, K minus a Laplacian or a power
// of it.
#pragma once

#include <concino/fields/detail/problems/dirichlet.hpp>
#include <concino/fields/detail/problems/laplace_system.hpp>
#include <concino/fields/detail/problems/masses.hpp>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace concino::detail {

/// a + factor b, for matrices with sorted rows in each column.
inline Eigen::SparseMatrix<double> sum_of(const Eigen::SparseMatrix<double>& a, double factor,
                                          const Eigen::SparseMatrix<double>& b) {
  Eigen::SparseMatrix<double> r(a.rows(), a.cols());
  r.resizeNonZeros(a.nonZeros() + b.nonZeros());
  int at = 0;
  const auto put = [&](int row, double x) {
    r.innerIndexPtr()[at] = row;
    r.valuePtr()[at++] = x;
  };
  for (int c = 0; c < a.cols(); ++c) {
    int i = a.outerIndexPtr()[c], j = b.outerIndexPtr()[c];
    const int a_end = a.outerIndexPtr()[c + 1], b_end = b.outerIndexPtr()[c + 1];
    while (i < a_end || j < b_end) {
      const int none = static_cast<int>(a.rows()), in_a = i < a_end ? a.innerIndexPtr()[i] : none,
                in_b = j < b_end ? b.innerIndexPtr()[j] : none;
      if (in_a < in_b) put(in_a, a.valuePtr()[i++]);
      else if (in_b < in_a) put(in_b, factor * b.valuePtr()[j++]);
      else put(in_a, a.valuePtr()[i++] + factor * b.valuePtr()[j++]);
    }
    r.outerIndexPtr()[c + 1] = at;
  }
  r.resizeNonZeros(at);
  return r;
}

/// The mass matrix for a discretisation, both triangles: its own mass, the lumped mass, or the Galerkin mass.
/// Errors: invalid_mesh if a vert with edges has no mass, and those of lumped_masses and mass_matrix.
template<class M, class D>
Eigen::SparseMatrix<double> mass_beside(const M& m, const D& discretisation, bool lumped, const char* caller) {
  if constexpr (!requirement::has_masses<D, M>)
    if (!lumped) return mass_matrix(m, {.lumped = false});
  const std::vector<double> mass = lumped_masses(m, discretisation, caller);
  return diagonal_matrix(mass.data(), mass.size());
}

template<class M>
class implicit_system {
  constrained_system<M> system_;
  Eigen::SparseMatrix<double> mass_;
  const char* caller_;

 public:
  /// mass and k: both triangles. Not yet factorised.
  template<class D>
  implicit_system(const M& m, const D& discretisation, constrained_verts<M>&& constrained,
                  Eigen::SparseMatrix<double>&& mass, double amount, const Eigen::SparseMatrix<double>& k,
                  const char* caller)
      : system_(std::move(constrained)), caller_(caller) {
    mass_.swap(mass);  // the move operations of Eigen 3.4 would copy
    system_.verts.number_all(m, coupling_edges<M, D>(m, discretisation));
    for (const vert_t<M> v : verts(m)) {
      const auto i = index_of(m, v);
      if (system_.verts.unknown[v] >= 0 && !has_mass(mass_, i))
        core::throw_joined<invalid_mesh>({caller_, ": vert ", i, " has edges but no polys, so no mass; use uniform"});
    }
    system_.restrict_to_unknowns(sum_of(mass_, amount, k));
  }

  const constrained_verts<M>& constrained() const { return system_.verts; }

  template<class Solver>
  void factorize(Solver& solver, const progress& on_progress) const { system_.factorize(solver, on_progress, caller_); }

  /// The values of a field at all verts.
  /// Errors: invalid_argument if one is not finite at a vert that has edges or is constrained.
  template<class T, class F>
  vert_map<M, T> values_of(const M& m, const F& f) const {
    auto u = make_vert_map<T>(m);
    for (const vert_t<M> v : verts(m)) {
      const T x = u[v] = as_field_value<T>(value_at(m, f, v));
      if (system_.verts.unknown[v] == constrained_verts<M>::isolated) continue;
      for (std::size_t k = 0; k < component_count<T>; ++k)
        if (!std::isfinite(field_component(x, k)))
          core::throw_joined<invalid_argument>({caller_, ": the value at vert ", index_of(m, v), " is not finite"});
    }
    return u;
  }

  /// Replaces f by u. Constrained and isolated verts keep their values. Isolated verts, which share no poly with
  /// others, are not read.
  /// Errors: solver_error.
  template<class T, class Solver>
  void apply(const Solver& solver, vert_map<M, T>& f) const {
    const T* const at = f.data();
    const int *const begin = mass_.outerIndexPtr(), *const row = mass_.innerIndexPtr();
    const double* const entry = mass_.valuePtr();
    const auto load = [&](std::size_t k, int c) {
      double sum = 0;
      for (int l = begin[c]; l < begin[c + 1]; ++l) sum += entry[l] * field_component(at[row[l]], k);
      return sum;
    };
    system_.template solve<T>(solver, load, f, caller_);
  }
};

}  // namespace concino::detail
