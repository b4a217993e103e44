// cut_along(m, edges): cuts a surface open along edges.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/error.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/graph/detail/corners.hpp>
#include <concino/mesh/arrays.hpp>
#include <concino/mesh/correspondence.hpp>

#include <initializer_list>

namespace concino {

template<class M>
struct cut_along_result {
  surface_arrays surface;        // from which a trimesh, quadmesh or polygonmesh can be constructed
  std::vector<vert_t<M>> verts;  // verts[i]: the vert of m that vert i of the surface is, or of which it is a copy
  std::vector<poly_t<M>> polys;  // polys[i]: the poly of m that poly i of the surface is

  /// The same by indices, for transfer_properties(m, mesh_of_surface, cut.correspondence(m)); edges follow from their
  /// verts.
  concino::correspondence correspondence(const M& m) const {
    return {origins_of(m, verts), {}, {}, origins_of(m, polys)};
  }
};

/// The surface m with duplicated verts, so that the two polys at a cut edge do not share it any more. A vert is
/// duplicated if the cut, together with the boundary of m, separates its polys. So a cut that ends in the interior of
/// the surface keeps its last vert, and a single edge with both ends in the interior opens nothing.
/// Needs:  Embedded SurfaceMesh M, with or without boundary, manifold or not; cut: edges of m in braces or in a
///         container, or a container of walks, such as the result of homology_generators. An edge may occur several
///         times.
/// Result: arrays with the polys of m in their order and orientation, with their number of verts in `arity` if the type
///         fixes it. The first num_verts(m) verts are those of m in their order; copies follow, at the same points.
/// Cost:   O(elements of m + length of cut) time, but for the union of corners, and memory.
/// Errors: invalid_mesh if an edge is not one of m.
template<SurfaceMesh M, class Cut = std::initializer_list<edge_t<M>>>
  requires Embedded<M>
cut_along_result<M> cut_along(const M& m, const Cut& cut) {
  std::vector<unsigned char> edge_is_cut(edge_index_bound(m));
  std::vector<unsigned char> splits(vert_index_bound(m));  // verts of the cut: others do not change
  std::vector<edge_t<M>> known(edge_is_cut.size());  // so that the test whether m has an edge is fast on every mesh
  for (const edge_t<M> e : edges(m)) known[index_of(m, e)] = e;
  const auto take = [&](const edge_t<M>& e) {
    if (index_of(m, e) >= known.size() || !(known[index_of(m, e)] == e))
      throw invalid_mesh("cut_along: one of the edges is not an edge of the mesh; take them from edges(m)");
    edge_is_cut[index_of(m, e)] = 1;
    for (const vert_t<M> v : adj_e2v(m, e)) splits[index_of(m, v)] = 1;
  };
  for (const auto& x : cut) {
    if constexpr (requires { x.edges.begin(); })
      for (const auto& e : x.edges) take(e);
    else take(x);
  }

  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  cut_along_result<M> result;
  surface_arrays& s = result.surface;
  std::vector<std::uint32_t> number(splits.size());
  for (const vert_t<M> v : verts(m)) {
    number[index_of(m, v)] = static_cast<std::uint32_t>(s.points.size());
    result.verts.push_back(v);
    s.points.push_back(to_vec3(point(m, v)));
  }
  detail::corner_classes<M> corners(m, [&](std::size_t e) { return edge_is_cut[e] != 0; });
  s.arity = static_cast<std::uint32_t>(arity_v<M>);
  if (s.arity == 0) s.offsets.push_back(0);
  std::vector<std::uint32_t> class_number;  // of classes at verts that split, by the root corner of the class
  std::vector<unsigned char> is_used(splits.size());
  for (const poly_t<M> p : polys(m)) {
    std::size_t corner = corners.first[index_of(m, p)];
    for (const vert_t<M> v : adj_p2v(m, p)) {
      const std::size_t at = index_of(m, v), here = corner++;
      std::uint32_t n = number[at];
      if (splits[at]) {
        const std::size_t c = corners.classes.root(here);
        if (class_number.size() <= c) class_number.resize(c + 1, none);
        if (class_number[c] == none && is_used[at]) {
          class_number[c] = static_cast<std::uint32_t>(s.points.size());
          result.verts.push_back(v);
          s.points.push_back(vec3(s.points[n]));
        } else if (class_number[c] == none) {
          class_number[c] = n;
          is_used[at] = 1;
        }
        n = class_number[c];
      }
      s.verts.push_back(vert_id{n});
    }
    if (s.arity == 0) s.offsets.push_back(static_cast<std::uint32_t>(s.verts.size()));
    result.polys.push_back(p);
  }
  return result;
}

// What to write instead of calls that cannot compile.
template<class... T> void cut_along(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void cut_along(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
