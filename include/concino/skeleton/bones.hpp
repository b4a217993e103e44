// The leaves, joints and bones of curve skeletons and other graphs in space.
#pragma once

#include <concino/concepts/maps.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/io/skeleton_graph.hpp>
#include <concino/skeleton/bone_curve.hpp>
#include <concino/skeleton/detail/flat_curves.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino {

/// A bone: a path between verts that are leaves or joints, through verts with two neighbours. It has copies of points
/// and radii, and can outlive the graph.
template<class M>
struct bone : bone_curve {
  std::vector<vert_t<M>> verts;  // points[i] is that of verts[i]; each two in succession are an edge
};

/// The verts with exactly one neighbour, and those with three or more.
/// Needs:  PrimalGraph M.      Result: in the order of verts(g).      Cost: O(verts + edges).      Errors: none.
template<PrimalGraph M>
std::vector<vert_t<M>> leaves(const M& g) {
  std::vector<vert_t<M>> found;
  for (const vert_t<M> v : verts(g))
    if (detail::num_neighbours_up_to_3(g, v) == 1) found.push_back(v);
  return found;
}
template<PrimalGraph M>
std::vector<vert_t<M>> joints(const M& g) {
  std::vector<vert_t<M>> found;
  for (const vert_t<M> v : verts(g))
    if (detail::num_neighbours_up_to_3(g, v) == 3) found.push_back(v);
  return found;
}

/// The bones of a graph in space: for (const auto& b : bones(load_skeleton("hand.skel"))) sample(b, 0.5);
/// Needs:  EmbeddedGraph M. radii: a map from verts to numbers; those of a skeleton are used if none is passed.
/// Result: bones that have each edge once. Each goes from a leaf or joint to one, and ends where it begins if it is a
///         cycle; a cycle without joints is one bone, which begins at its first vert. Verts without edges have none.
///         Bones are in the order of the verts at which they begin, those between leaves and joints first.
/// Cost:   O(verts + edges).
/// Errors: invalid_mesh if a point is not finite; invalid_argument if a radius is negative or not finite.
template<EmbeddedGraph M, class Map>
  requires ReadableMap<Map, vert_t<M>>
std::vector<bone<M>> bones(const M& g, const Map& radii) {
  std::vector<vert_t<M>> in_order;
  for (const vert_t<M> v : verts(g)) in_order.push_back(v);
  const detail::flat_curves flat = detail::flat_curves_of(g, radii, "bones");
  std::vector<bone<M>> all;
  for (const auto& walk : detail::bone_walks(flat)) {
    all.push_back({detail::curve_along(flat, walk), {}});
    for (const std::uint32_t v : walk) all.back().verts.push_back(in_order[v]);
  }
  return all;
}
template<EmbeddedGraph M>
std::vector<bone<M>> bones(const M& g) {
  return bones(g, detail::radii_of(g));
}

// What to write instead of calls that cannot compile.
template<class... T> void leaves(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void joints(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void bones(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void bones(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
