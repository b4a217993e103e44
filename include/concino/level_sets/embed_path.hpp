// embed_path: a path on a surface becomes edges of it.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/level_sets/detail/embed/path_embedder.hpp>
#include <concino/level_sets/embed.hpp>

#include <concepts>
#include <vector>

namespace concino {

struct embed_path_options {
  bool closed = false;  // the last point is joined to the first one
};

/// A path on a surface of type M, as edges of it.
template<class M>
struct embedded_path {
  std::vector<edge_t<M>> edges;      // one after another, along the path
  std::vector<vert_t<M>> verts;      // by point of the path: the vert there
  std::vector<vert_t<M>> new_verts;  // each once
};

namespace requirement {

/// What can be a point of a path along edges.
template<class X, class M>
concept is_path_point = std::same_as<X, vert_t<M>> || std::same_as<X, edge_point<M>> || std::same_as<X, mesh_point<M>>;

}  // namespace requirement

/// Makes a path across a surface edges of it, such as an iso-line, a geodesic or a seam.
/// Needs:  EditableSurfaceMesh M of general polygons or of triangles; points at verts or on edges, as vert_t<M>,
///         edge_point<M> or mesh_point<M>, each of which is on one poly with the next one.
/// Result: the edges of the path. Two points on one edge are joined along it, others across the poly that has both; of
///         several polys it is the one with the lowest index. Polygons are cut to polygons, triangles to triangles. One
///         part of each poly keeps its descriptor; elements that are not cut keep theirs. Points that are equal become
///         one vert. A line between two points of a concave polygon may leave it; then its parts overlap. Named
///         properties follow as in replace_polys; those of verts are interpolated along the edge.
/// Cost:   the elements at the verts of the polys that are cut, but O(mesh) the first time, and sorting these.
/// Errors: invalid_argument that names a point inside a poly, a point whose parameter is not in [0, 1], or two points
///         that are not on one poly. Likewise if the path crosses itself inside a poly. unsupported if the library of m
///         cannot represent the result. The mesh is unchanged then, also if memory runs out. In an open transaction it
///         can be undone.
template<EditableSurfaceMesh M, class X>
  requires requirement::has_room_for_parts<M> && requirement::is_path_point<X, M>
embedded_path<M> embed_path(M& m, const std::vector<X>& points, const embed_path_options& options = {}) {
  detail::path_embedder<M> embedder(m);
  for (const X& x : points) embedder.add_point(x);
  embedded_path<M> result;
  embedder.run(options.closed, result.edges, result.verts, result.new_verts);
  return result;
}

// What to write instead of calls that cannot compile.
template<class... T> void embed_path(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<EditableSurfaceMesh M, class R = mistake::remedy<mistake::use_general_polys>>
  requires(!requirement::has_room_for_parts<M>)
void embed_path(M&, ...) = delete;  // convert<polygonmesh>(m) has room for the parts of quads

}  // namespace concino
