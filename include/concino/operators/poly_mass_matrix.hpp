// The area or volume of each poly, as a map and as the mass matrix of vector fields on polys.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/mesh/element_map.hpp>
#include <concino/operators/detail/compressed_columns.hpp>

#include <cmath>

namespace concino {

namespace detail {

template<class M>
double poly_mass(const char* caller, const M& m, const poly_t<M>& p) {
  const double mass = std::abs(measure(m, p));
  if (!std::isfinite(mass))
    core::throw_joined<invalid_mesh>({caller, ": the ", dimension_v<M> == 2 ? "area" : "volume", " of poly ",
                                      index_of(m, p), " is not a finite number; look at the points of its verts"});
  return mass;
}

}  // namespace detail

/// The area or volume of each poly. An inverted poly counts by the absolute value of its volume, since a mass is
/// positive.
/// Needs:  EmbeddedMesh, no temporary.
/// Result: a map of double, 0 or more; sums to the measure of the mesh.      Cost: O(size of the polys) time, O(P)
///         memory.
/// Errors: invalid_mesh, naming a poly whose points, or whose area or volume, are not finite.
/// Source: the mass matrix of piecewise constant functions; paper section 2.2.
template<class M>
  requires requirement::is_lvalue_or_view<M> && EmbeddedMesh<M>
poly_map<M, double> poly_masses(M&& m) {
  using mesh = std::remove_cvref_t<M>;
  auto mass = make_poly_map<double>(m, 0.0);
  for (const poly_t<mesh> p : polys(m)) mass[p] = detail::poly_mass<mesh>("poly_masses", m, p);
  return mass;
}

/// The poly masses as a diagonal matrix for vectors on polys, each mass three times: x^T M y is the integral of the
/// scalar product of x and y.
/// Needs:  EmbeddedMesh.
/// Result: 3 poly_index_bound(m) rows and columns, the mass of poly p at 3p, 3p + 1 and 3p + 2; those of deleted polys
///         are empty.
/// Cost:   as poly_masses.      Errors: as poly_masses; unsupported if the matrix would be too large for 32-bit
///         indices.
template<EmbeddedMesh M>
Eigen::SparseMatrix<double> poly_mass_matrix(const M& m) {
  constexpr const char* caller = "poly_mass_matrix";
  const std::size_t size = 3 * poly_index_bound(m);
  auto a = detail::empty_columns(caller, size, size);
  int* const begin = a.outerIndexPtr();
  for (const poly_t<M> p : polys(m))
    for (std::size_t k = 1; k <= 3; ++k) begin[3 * index_of(m, p) + k] = 1;
  detail::make_room(caller, a);
  for (const poly_t<M> p : polys(m)) {
    const double mass = detail::poly_mass(caller, m, p);
    const std::size_t first = 3 * index_of(m, p);
    for (std::size_t c = first; c < first + 3; ++c) {
      a.innerIndexPtr()[begin[c]] = static_cast<int>(c);
      a.valuePtr()[begin[c]] = mass;
    }
  }
  return a;
}

// What to write instead of calls that cannot compile.
template<class... T> void poly_masses(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void poly_masses(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void poly_masses(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void poly_mass_matrix(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void poly_mass_matrix(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
