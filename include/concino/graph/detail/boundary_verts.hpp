// Which verts lie on the boundary of a surface or volume.
#pragma once

#include <concino/concepts/mesh.hpp>

#include <cstddef>
#include <vector>

namespace concino::detail {

/// By index: the verts of edges (surfaces) or faces (volumes) with exactly one poly.
template<AnyMesh M>
std::vector<unsigned char> boundary_verts(const M& m) {
  std::vector<unsigned char> on_boundary(static_cast<std::size_t>(vert_index_bound(m)));
  const auto mark = [&](const auto& facet_polys, const auto& facet_verts) {
    std::size_t n = 0;
    for ([[maybe_unused]] const poly_t<M> p : facet_polys) ++n;
    if (n != 1) return;
    for (const vert_t<M> v : facet_verts) on_boundary[static_cast<std::size_t>(index_of(m, v))] = 1;
  };
  if constexpr (SurfaceMesh<M>)
    for (const edge_t<M> e : edges(m)) mark(adj_e2p(m, e), adj_e2v(m, e));
  else
    for (const face_t<M> f : faces(m)) mark(adj_f2p(m, f), adj_f2v(m, f));
  return on_boundary;
}

}  // namespace concino::detail
