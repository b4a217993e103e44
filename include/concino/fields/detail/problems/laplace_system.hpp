// Minus the Laplacian, or a power of it, with prescribed values at some verts: the system of harmonic maps and
// Poisson's equation. Also the masses in equations of heat and smoothing.
#pragma once

#include <concino/core/number_text.hpp>
#include <concino/core/precompiled.hpp>
#include <concino/core/product.hpp>
#include <concino/fields/detail/problems/dirichlet.hpp>
#include <concino/fields/detail/problems/scaled_mesh.hpp>
#include <concino/operators/laplacian.hpp>
#include <concino/operators/mass_matrix.hpp>
#include <concino/operators/stiffness.hpp>

#include <cmath>
#include <concepts>
#include <cstddef>
#include <utility>
#include <vector>

namespace concino::detail {

/// The mass of each vert, by index: that of the discretisation, or the lumped mass.
/// Errors: invalid_mesh, naming a vert with edges but without mass, and those of vert_masses; invalid_argument if the
///         mass that the discretisation gives at such a vert is not a positive number.
template<class M, class D>
std::vector<double> lumped_masses(const M& m, const D& discretisation, const char* caller) {
  std::vector<double> r(vert_index_bound(m), 1.0);
  const coupling_edges<M, D> edges(m, discretisation);
  if constexpr (requirement::has_masses<D, M>) {
    const auto mass = discretisation.masses(m);
    for (const vert_t<M> v : verts(m)) {
      const auto i = index_of(m, v);
      r[i] = static_cast<double>(mass[v]);
      if (!(r[i] > 0 && std::isfinite(r[i])) && edges.has_any(v))
        core::throw_joined<invalid_argument>({caller, ": the discretisation gives vert ", i, " the mass ",
                                              core::number_text(r[i]), "; masses must be positive and finite"});
    }
  } else {
    const auto mass = vert_masses(m);
    for (std::size_t i = 0; i < r.size(); ++i) r[i] = mass.data()[i];
    for (const vert_t<M> v : verts(m))
      if (!(mass[v] > 0) && edges.has_any(v))
        core::throw_joined<invalid_mesh>({caller, ": vert ", index_of(m, v),
                                    " has edges but no polys with a measure, so no mass; use uniform"});
  }
  return r;
}

/// Minus the Laplacian of the discretisation, both triangles.
template<class M, class D>
Eigen::SparseMatrix<double> minus_laplacian(const M& m, const D& discretisation) {
  Eigen::SparseMatrix<double> a = laplacian(m, discretisation);
  double* const x = a.valuePtr();
  for (Eigen::Index k = 0; k < a.nonZeros(); ++k) x[k] = -x[k];
  return a;
}

/// A (M^-1 A)^(n-1), both triangles. A mass that is not positive counts as 1.
Eigen::SparseMatrix<double> polyharmonic(const Eigen::SparseMatrix<double>& a, const std::vector<double>& mass,
                                         int exponent);

/// A (M^-1 A)^(n-1) for A minus the Laplacian and M the lumped mass.
/// Errors: as lumped_masses; unsupported where 32-bit indices do not suffice; those of laplacian.
template<class M, class D>
Eigen::SparseMatrix<double> polyharmonic(const M& m, const D& discretisation, int exponent, const char* caller) {
  if (exponent == 1) return minus_laplacian(m, discretisation);
  const Eigen::SparseMatrix<double> a = minus_laplacian(m, discretisation);
  return polyharmonic(a, lumped_masses(m, discretisation, caller), exponent);
}

/// The system of the unknowns for this matrix. m: the mesh of the constrained verts, or a view of it.
template<class At, class M, class D>
constrained_system<M> laplace_system(const At& m, constrained_verts<M>&& constrained, const D& discretisation,
                                     int exponent, const char* caller) {
  constrained_system<M> r(std::move(constrained));
  if (exponent > 1) {  // powers also couple unknowns through constrained verts
    r.restrict_to_unknowns(polyharmonic(m, discretisation, exponent, caller));
    return r;
  }
  const auto& unknown = r.verts.unknown;
  bool is_whole = false;
  Eigen::SparseMatrix<double> a = with_stiffness(
      m, discretisation,
      [&](const auto& weights) {  // directly into the matrix of the unknowns
        auto lower = core::assemble<core::lower_triangle>(
            m, weights, static_cast<std::size_t>(r.verts.unknowns), 1.0, [&](const vert_t<M>& v) { return unknown[v]; },
            [](int, const vert_t<M>&, double) {});
        for (const vert_t<M>& v : r.verts.prescribed)
          weights.for_each_neighbour(v, [&](const vert_t<M>& w, double weight) {
            if (const int row = unknown[w]; row >= 0)
              r.couplings.push_back({row, static_cast<int>(index_of(m, v)), weight});
          });
        return lower;
      },
      [&](auto make_element) {
        is_whole = true;
        return assemble_stiffness<At>(m, make_element, 1.0);
      });
  if (is_whole) r.restrict_to_unknowns(a);
  else r.lower.swap(a);
  return r;
}

/// Numbers the unknowns and assembles their system at a size near 1: scaling the Laplacian does not change a harmonic
/// map.
template<class M, class D>
constrained_system<M> unit_laplace_system(const M& m, constrained_verts<M>&& constrained, const D& discretisation,
                                          int exponent, const char* caller) {
  constrained.number_reached(m, coupling_edges<M, D>(m, discretisation), caller);
  return at_unit_size(m, discretisation, [&](const auto& at, int) {
    return laplace_system(at, std::move(constrained), discretisation, exponent, caller);
  });
}

/// The discretisations for which the compiled library contains the system of the native meshes.
template<class D>
inline constexpr bool is_of_library = std::same_as<D, virtual_elements_t> || std::same_as<D, uniform_t>;

/// unit_laplace_system, defined in the compiled library only.
template<class M, class D>
constrained_system<M> precompiled_laplace_system(const M& m, constrained_verts<M>&& constrained,
                                                 const D& discretisation, int exponent, const char* caller);

template<class M, class D>
constrained_system<M> harmonic_system(const M& m, constrained_verts<M>&& constrained, const D& discretisation,
                                      int exponent, const char* caller) {
  if constexpr (core::is_precompiled<M> && is_of_library<D>)
    return precompiled_laplace_system(m, std::move(constrained), discretisation, exponent, caller);
  else return unit_laplace_system(m, std::move(constrained), discretisation, exponent, caller);
}

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/fields/detail/problems/laplace_system.ipp>
#endif
