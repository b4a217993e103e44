// How much of the domain each vert stands for.
#pragma once

#include <concino/geometry/measure.hpp>
#include <concino/mesh/element_map.hpp>

#include <Eigen/SparseCore>

#include <cmath>
#include <vector>

namespace concino {

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
  a.reserve(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    a.startVec(i);
    a.insertBack(i, i) = mass.values()[static_cast<std::size_t>(i)];
  }
  a.finalize();
  return a;
}

}  // namespace concino
