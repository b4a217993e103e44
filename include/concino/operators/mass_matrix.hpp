// The mass of each vert: its share of the area or volume, as a map or a matrix.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/message.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/core/product.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/mesh/element_map.hpp>
#include <concino/operators/detail/element_assembly.hpp>
#include <concino/operators/detail/simplex_mass.hpp>
#include <concino/operators/detail/virtual_elements.hpp>

#include <Eigen/SparseCore>

#include <array>
#include <cmath>
#include <cstddef>

namespace concino {

namespace detail {

template<class M>
[[noreturn, gnu::noinline, gnu::cold]] void throw_infinite_mass(const M& m) {
  for (const poly_t<M> p : polys(m))
    if (!std::isfinite(measure(m, p)))
      core::throw_joined<invalid_mesh>(
          {"vert_masses: poly ", index_of(m, p), " has points that are not finite, so it has no mass; move its verts"});
  core::throw_joined<invalid_mesh>({"vert_masses: the sum of the measures of the polys is infinite; scale the mesh"});
}

}  // namespace detail

/// The share of each vert in the areas or volumes around it: each poly is divided equally among its verts.
/// Needs:  EmbeddedMesh, no temporary.
/// Result: a map of double; positive on verts of some poly with a measure, 0 on others; sums to the measure of the
///         mesh. An inverted poly counts by the absolute value of its volume, since a mass is positive.
/// Cost:   O(size of the polys) time, O(V) memory.
/// Errors: invalid_mesh if points of a poly are not finite, or so far apart that the measures sum to infinity.
/// Source: the barycentric lumped mass of the finite element method; paper section 2.2.
template<class M>
  requires requirement::is_lvalue_or_view<M> && EmbeddedMesh<M>
vert_map<M, double> vert_masses(M&& m) {
  auto mass = make_vert_map<double>(m, 0.0);
  if constexpr (TriMesh<M> || TetMesh<M>) {  // reads the verts of each poly only once
    for (const poly_t<M> p : polys(m)) {
      std::array<vert_t<M>, arity_v<M>> corner;
      std::size_t n = 0;
      for (const vert_t<M> v : adj_p2v(m, p))
        if (n < corner.size()) corner[n++] = v;
      const double part = detail::simplex_measure(m, corner) / arity_v<M>;
      for (const vert_t<M>& v : corner) mass[v] += part;
    }
  } else {
    for (const poly_t<M> p : polys(m)) {
      double n = 0;
      for ([[maybe_unused]] const vert_t<M> v : adj_p2v(m, p)) n += 1;
      const double part = n > 0 ? std::abs(measure(m, p)) / n : 0;
      for (const vert_t<M> v : adj_p2v(m, p)) mass[v] += part;
    }
  }
  for (std::size_t i = 0; i < vert_index_bound(m); ++i)
    if (!std::isfinite(mass.data()[i])) detail::throw_infinite_mass(m);
  return mass;
}

namespace detail {

inline Eigen::SparseMatrix<double> diagonal_matrix(const double* x, std::size_t size) {
  const auto n = static_cast<Eigen::Index>(size);
  Eigen::SparseMatrix<double> a(n, n);
  a.resizeNonZeros(n);
  for (int i = 0; i < n; ++i) {
    a.outerIndexPtr()[i] = a.innerIndexPtr()[i] = i;
    a.valuePtr()[i] = x[i];
  }
  a.outerIndexPtr()[n] = static_cast<int>(n);
  return a;
}

}  // namespace detail

struct mass_matrix_options {
  bool lumped = true;  // a diagonal matrix, of vert_masses; otherwise the Galerkin matrix, which does not lose the
                       // order of a load
};

/// The mass matrix of functions on verts: u . M u is the integral of the square of u.
/// Needs:  EmbeddedMesh.
/// Result: vert_index_bound(m) rows and columns, by index_of, every diagonal entry present (0 for verts of no poly;
///         with lumped masses for deleted ones too); sums to the measure of the mesh. Lumped: vert_masses as a
///         diagonal. Otherwise the hat functions of the verts are projected to linear functions on each poly, and the
///         squares of the remainders at the verts are added with a weight. The matrix is then positive definite on the
///         verts of polys that do not intersect themselves. On triangles and tets it is the mass matrix of linear
///         elements.
/// Cost:   lumped as vert_masses, otherwise as laplacian.
/// Errors: invalid_mesh as vert_masses, or, unless lumped, if a poly has points that are not finite, or no area or
///         volume; unsupported then if the matrix would be too large for 32-bit indices.
/// Source: Ahmad et al. 2013, "Equivalent projectors for virtual element methods".
template<EmbeddedMesh M>
Eigen::SparseMatrix<double> mass_matrix(const M& m, const mass_matrix_options& options = {}) {
  if (!options.lumped) {
    if constexpr (TriMesh<M> || TetMesh<M>) return detail::simplex_mass(m);  // faster: a closed formula
    else
      return with_both_triangles(detail::assemble_elements<M>(
          m, [&] { return detail::poly_operator_of<M>([&] { return detail::virtual_mass<M>(m); }); }));
  }
  const auto mass = vert_masses(m);
  return detail::diagonal_matrix(mass.data(), vert_index_bound(m));
}

// What to write instead of calls that cannot compile.
template<class... T> void vert_masses(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void vert_masses(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void vert_masses(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void mass_matrix(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void mass_matrix(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
