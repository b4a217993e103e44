// How much of the domain each vert stands for.
#pragma once

#include <concino/geometry/measure.hpp>
#include <concino/mesh/element_map.hpp>

#include <Eigen/SparseCore>

#include <array>
#include <cmath>
#include <cstddef>

namespace concino {

namespace detail {

/// The area of the triangle or the volume, without a sign, of the tet with these corners.
template<class M, std::size_t N>
double simplex_measure(const M& m, const std::array<vert_t<M>, N>& corner) {
  const vec3 o = to_vec3(point(m, corner[0]));
  const vec3 normal = cross(to_vec3(point(m, corner[1])) - o, to_vec3(point(m, corner[2])) - o);
  if constexpr (N == 3) return norm(normal) / 2;
  else return std::abs(dot(normal, to_vec3(point(m, corner[3])) - o)) / 6;
}

}  // namespace detail

/// The share of each vert in the areas or volumes around it: each poly gives equal parts to its verts.
/// Needs:  Embedded AnyMesh, no temporary.
/// Result: a map of double; positive on verts of some poly with a measure, 0 on others; sums to the measure of the mesh. A poly turned
///         inside out counts by the absolute value of its volume, since a mass is positive.
/// Cost:   O(size of the polys) time, O(V) memory.      Errors: none.
/// Source: the barycentric lumped mass of the finite element method; paper section 2.2.
template<class M>
  requires requirement::is_no_temporary<M> && AnyMesh<M> && Embedded<M>
vert_map<M, double> vert_masses(M&& m) {
  auto mass = make_vert_map<double>(m, 0.0);
  if constexpr (TriMesh<M> || TetMesh<M>) {  // read once
    for (const poly_t<M> p : polys(m)) {
      std::array<vert_t<M>, arity_v<M>> corner;
      std::size_t n = 0;
      for (const vert_t<M> v : adj_p2v(m, p))
        if (n < corner.size()) corner[n++] = v;
      const double part = detail::simplex_measure(m, corner) / arity_v<M>;
      for (const vert_t<M>& v : corner) mass[v] += part;
    }
    return mass;
  }
  for (const poly_t<M> p : polys(m)) {
    double n = 0;
    for ([[maybe_unused]] const vert_t<M> v : adj_p2v(m, p)) n += 1;
    const double part = std::abs(measure(m, p)) / n;
    for (const vert_t<M> v : adj_p2v(m, p)) mass[v] += part;
  }
  return mass;
}

/// The same as a diagonal matrix.
/// Needs:  Embedded AnyMesh.
/// Result: vert_index_bound(m) rows and columns, by index_of, every diagonal entry present (0 for verts of no poly and deleted ones).
/// Cost:   as vert_masses.      Errors: none.
template<AnyMesh M>
  requires Embedded<M>
Eigen::SparseMatrix<double> mass_matrix(const M& m) {
  const auto mass = vert_masses(m);
  const auto n = static_cast<Eigen::Index>(mass.values().size());
  Eigen::SparseMatrix<double> a(n, n);
  a.resizeNonZeros(n);
  for (int i = 0; i < n; ++i) {
    a.outerIndexPtr()[i] = a.innerIndexPtr()[i] = i;
    a.valuePtr()[i] = mass.values()[static_cast<std::size_t>(i)];
  }
  a.outerIndexPtr()[n] = static_cast<int>(n);
  return a;
}

}  // namespace concino
