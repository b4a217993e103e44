// The number of independent loops of a mesh that are not filled: the first Betti number.
#pragma once

#include <concino/concepts/facets.hpp>
#include <concino/concepts/mesh.hpp>
#include <concino/core/compiled.hpp>
#include <concino/graph/disjoint_sets.hpp>

#include <cstddef>
#include <vector>

namespace concino::detail {

[[noreturn]] void throw_loops_not_counted(const char* caller, const char* kind, std::size_t facet, const char* what);

/// The components of the boundary of a volume: boundary faces that share edges.
/// Errors: unsupported if more than two of them share one.
template<VolumeMesh M>
std::ptrdiff_t count_boundary_components(const M& m, const char* caller) {
  disjoint_sets sets(face_index_bound(m));
  std::ptrdiff_t components = 0;
  for (const face_t<M> f : faces(m)) components += is_boundary(m, f);
  for (const edge_t<M> e : edges(m)) {
    std::size_t n = 0, first = 0;
    for (const face_t<M> f : adj_e2f(m, e)) {
      if (!is_boundary(m, f)) continue;
      if (n == 0) first = index_of(m, f);
      else components -= sets.unite(first, index_of(m, f));
      if (++n > 2) throw_loops_not_counted(caller, "edge", index_of(m, e), "more than two boundary faces");
    }
  }
  return components;
}

/// By Euler's formula from components and cavities. Of a volume the number of cavities is that of boundary components
/// less that of components connected through faces, since it lies in space (Alexander's duality).
/// Errors: unsupported that names a facet with more than two polys, or an edge with more than two boundary faces;
///         unsupported if a volume has no boundary.
template<AnyMesh M>
std::ptrdiff_t count_loops(const M& m, const char* caller) {
  disjoint_sets by_edges(vert_index_bound(m)), by_facets(poly_index_bound(m));
  auto components = static_cast<std::ptrdiff_t>(num_verts(m)),
       poly_components = static_cast<std::ptrdiff_t>(num_polys(m));
  for (const vert_t<M> v : verts(m))
    for (const vert_t<M> w : adj_v2v(m, v)) components -= by_edges.unite(index_of(m, v), index_of(m, w));
  std::vector<unsigned char> is_open(poly_index_bound(m));
  for (const facet_t<M> f : facets(m)) {
    std::size_t n = 0, first = 0;
    for (const poly_t<M> p : adj_facet2p(m, f)) {
      if (n == 0) first = index_of(m, p);
      else poly_components -= by_facets.unite(first, index_of(m, p));
      if (++n > 2)
        throw_loops_not_counted(caller, dimension_v<M> == 2 ? "edge" : "face", index_of(m, f), "more than two polys");
    }
    if (n == 1) is_open[first] = 1;
  }
  std::ptrdiff_t closed = 0;
  for (const poly_t<M> p : polys(m))
    if (is_open[index_of(m, p)]) is_open[by_facets.root(index_of(m, p))] = 1;
  for (const poly_t<M> p : polys(m))
    closed += by_facets.root(index_of(m, p)) == index_of(m, p) && !is_open[index_of(m, p)];
  auto chi = static_cast<std::ptrdiff_t>(num_verts(m)) - static_cast<std::ptrdiff_t>(num_edges(m));
  if constexpr (dimension_v<M> == 2) {  // the polygons of a surface are its polys, those of a volume its faces
    return components + closed - chi - static_cast<std::ptrdiff_t>(num_polys(m));
  } else {
    if (closed > 0) throw_loops_not_counted(caller, "poly", 0, "no boundary, like all connected to it");
    chi += static_cast<std::ptrdiff_t>(num_faces(m)) - static_cast<std::ptrdiff_t>(num_polys(m));
    return components + count_boundary_components(m, caller) - poly_components - chi;
  }
}

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/fields/detail/topology/first_betti_number.ipp>
#endif
