// Separatrices: the lines of edges, or the sheets of faces, that go straight on from singularities.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/graph/edge_walk.hpp>
#include <concino/layout/detail/blocks.hpp>

#include <vector>

namespace concino {

/// The separatrices of a mesh of quads: walks along edges that leave singular verts into the surface and go straight on
/// at regular ones.
/// Needs:  a surface whose polys are quads.
/// Result: walks in the order of the singular verts that they leave; each ends at the next singular vert or at the
///         boundary. No edge is in two walks, and edges at the boundary are in none.
/// Cost:   O(elements).
/// Errors: invalid_mesh if a poly is not a quad.
/// Source: Bommes et al. 2013, as singular_verts.
template<requirement::may_be_quads M>
std::vector<edge_walk<M>> separatrices(const M& m) {
  const auto all_verts = detail::by_number<vert_t<M>>(verts(m), num_verts(m));
  const auto all_edges = detail::by_number<edge_t<M>>(edges(m), num_edges(m));
  std::vector<edge_walk<M>> walks;
  for (const auto& found : detail::find_separatrices(detail::cube_tables_of(m, "separatrices"))) {
    edge_walk<M>& walk = walks.emplace_back();
    for (const std::uint32_t v : found.ridges) walk.verts.push_back(all_verts[v]);
    for (const std::uint32_t e : found.facets) walk.edges.push_back(all_edges[e]);
  }
  return walks;
}

/// The separatrices of a mesh of hexes: faces that leave singular edges into the volume and go straight on at regular
/// ones.
/// Needs:  HexMesh M.
/// Result: groups of faces that continue each other. No face is in two of them, and faces at the boundary are in none.
/// Cost:   O(elements).
/// Errors: none.
/// Source: Gao, Deng, Chen 2015, as singular_edges.
template<HexMesh M>
std::vector<std::vector<face_t<M>>> separatrices(const M& m) {
  const auto all_faces = detail::by_number<face_t<M>>(faces(m), num_faces(m));
  std::vector<std::vector<face_t<M>>> groups;
  for (const auto& found : detail::find_separatrices(detail::cube_tables_of(m, "separatrices"))) {
    groups.emplace_back();
    for (const std::uint32_t f : found.facets) groups.back().push_back(all_faces[f]);
  }
  return groups;
}

// What to write instead of calls that cannot compile.
template<class... T> void separatrices(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()

}  // namespace concino
