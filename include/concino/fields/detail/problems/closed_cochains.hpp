// Values on directed edges whose sums around polygons are 0, but not around all loops: a basis of the first cohomology.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/concepts/mesh.hpp>
#include <concino/core/compiled.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// The edges and polygons of a mesh. An edge is directed from its first end.
struct edge_complex {
  std::size_t verts = 0;                            // the bound of their indices
  std::vector<std::array<std::uint32_t, 2>> edges;  // by index; two equal ends where there is no edge
  std::vector<std::uint32_t> first = {0};           // of the edges of each polygon, and the number of all at the end
  std::vector<std::uint32_t> loop_edges;            // of the polygons
  std::vector<double> signs;                        // 1 if the polygon is passed along the edge, -1 against it

  /// loop, loop_edges: the ranges of its verts and edges; edge k joins verts k and k + 1.
  template<class M, class Loop, class Edges>
  void add_polygon(const M& m, const Loop& loop, const Edges& edges_in) {
    auto it = edges_in.begin();
    for (const vert_t<M> v : loop) {
      const edge_t<M> e = *it;
      loop_edges.push_back(static_cast<std::uint32_t>(index_of(m, e)));
      signs.push_back(end_verts(m, e).first == v ? 1.0 : -1.0);
      ++it;
    }
    first.push_back(static_cast<std::uint32_t>(loop_edges.size()));
  }
};

template<AnyMesh M>
edge_complex make_edge_complex(const M& m) {
  edge_complex c;
  c.verts = vert_index_bound(m);
  c.edges.resize(edge_index_bound(m));
  for (const edge_t<M> e : edges(m)) {
    const auto ends = end_verts(m, e);
    c.edges[index_of(m, e)] = {static_cast<std::uint32_t>(index_of(m, ends.first)),
                               static_cast<std::uint32_t>(index_of(m, ends.second))};
  }
  if constexpr (dimension_v<M> == 2) {  // the polygons of a surface are its polys, those of a volume its faces
    for (const poly_t<M> p : polys(m)) c.add_polygon(m, adj_p2v(m, p), adj_p2e(m, p));
  } else {
    for (const face_t<M> f : faces(m)) c.add_polygon(m, adj_f2v(m, f), adj_f2e(m, f));
  }
  return c;
}

/// As many as independent loops that no polygons fill (with real coefficients). Each is a value for each edge, by
/// index; they are linearly independent, also modulo differences of values at verts.
/// Cost:   O(size of the complex) times their number, if few values are to be chosen; see closed_cochains.ipp.
std::vector<std::vector<double>> closed_cochains(const edge_complex& complex);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/fields/detail/problems/closed_cochains.ipp>
#endif
