// The dual of a mesh: a vert for each poly, a poly for each vert.
#pragma once

#include <concino/generate/detail/dual_parts.hpp>
#include <concino/graph/detail/disjoint_sets.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/polyhedralmesh.hpp>

namespace concino {

enum class dual_boundary {
  clipped,    // the cells of verts on the boundary end there: at the vert, the midpoints of its boundary edges and (volumes) the centroids of boundary faces
  discarded,  // verts on the boundary have no cell
};

struct dual_mesh_options {
  dual_boundary boundary = dual_boundary::clipped;
};

namespace detail {

/// Keeps the dual verts that some loop uses.
inline void drop_unused(std::vector<vec3>& points, std::vector<vert_id>& loops) {
  std::vector<std::uint32_t> number(points.size());
  for (const vert_id v : loops) number[v.raw()] = 1;
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (number[i] == 0) continue;
    points[kept] = points[i];
    number[i] = kept++;
  }
  points.resize(kept);
  for (vert_id& v : loops) v = vert_id{number[v.raw()]};
}

/// Whether the polys around verts of a volume make one ball, or half a ball at the boundary: else their dual cells would be no closed manifolds.
template<class M>
class star_checker {
  const M& m_;
  dual_parts<M>& parts_;
  std::vector<std::uint32_t> slot_;  // of a poly, by number, among those at the vert

 public:
  star_checker(const M& m, dual_parts<M>& parts) : m_(m), parts_(parts), slot_(parts.points.size()) {}

  /// The polygon mesh seen from v on a small sphere: its verts are edges, its edges faces, its polys polys.
  void check(const vert_t<M>& v, bool on_border) {
    std::size_t np = 0, nf = 0, ne = 0, pieces = 0;
    for (const poly_t<M> p : adj_v2p(m_, v)) slot_[parts_.number_of(p)] = static_cast<std::uint32_t>(np++);
    disjoint_sets joined(np);
    pieces = np;
    for (const face_t<M> f : adj_v2f(m_, v)) {
      const auto i = static_cast<std::uint32_t>(index_of(m_, f));
      if (!parts_.is_used(i)) continue;
      ++nf;
      if (!parts_.is_border(i) && joined.unite(slot_[parts_.polys_of(i)[0]], slot_[parts_.polys_of(i)[1]])) --pieces;
    }
    for (const edge_t<M> e : adj_v2e(m_, v)) ne += parts_.has_polys(index_of(m_, e));
    if (pieces != 1 || ne + np != nf + (on_border ? 1 : 2)) parts_.refuse("the polys around vert ", index_of(m_, v), " are no single ball");
    if (!on_border && ne < 3) parts_.refuse("vert ", index_of(m_, v), " has only two edges: its cell would be flat");
  }
};

}  // namespace detail

/// The dual mesh: a vert at the centroid of each poly, a poly for each vert, an edge between polys that share an edge (surfaces) or face (volumes), and in
/// volumes a face for each edge, through the polys around it, which need not be planar.
/// Needs:  Embedded AnyMesh, manifold: at most two polys at an edge (face), the polys around each vert one disk (ball). Verts of no poly have no cell.
/// Result: a polygonmesh or polyhedralmesh. Poly i is the cell of the i-th vert of verts(m) that has one: of those with polys, all (clipped) or the inner
///         ones (discarded). With clipped cells, vert i is the i-th poly of polys(m), others follow, and the dual covers what m covers: its measure is the
///         same where the boundary edges are straight and the boundary faces planar. Two polys that share several edges (faces) stay joined through the
///         midpoint (centroid) of each. Windings are those of m, volumes' cells face outward.
/// Cost:   O(size of the mesh) but for the square of the number of polys around one vert (surface) or edge (volume).
/// Errors: invalid_mesh that names the vert, edge, face or poly that is not manifold, not closed, not at a finite point, or an inner vert of a volume with
///         two edges only.
/// Source: capability G3 of the paper, "dualisation"; barycentric dual as in Okabe, Boots, Sugihara, Chiu 2000.
template<SurfaceMesh M>
  requires Embedded<M>
polygonmesh dual_mesh(const M& m, const dual_mesh_options& options = {}) {
  const bool clipped = options.boundary == dual_boundary::clipped;
  detail::dual_parts<M> parts(m, clipped);
  surface_arrays a;
  a.offsets.push_back(0);
  for (const vert_t<M> v : verts(m)) {
    const std::size_t i = index_of(m, v);
    if (!parts.has_polys(i)) continue;
    if (parts.is_border_hub(i)) {
      if (!clipped) continue;
      parts.add_hub_vert(i, to_vec3(point(m, v)));
    }
    parts.add_loop(i, a.verts);
    a.offsets.push_back(static_cast<std::uint32_t>(a.verts.size()));
  }
  a.points = std::move(parts.points);
  if (!clipped) detail::drop_unused(a.points, a.verts);
  return polygonmesh(std::move(a));
}

template<VolumeMesh M>
  requires Embedded<M>
polyhedralmesh dual_mesh(const M& m, const dual_mesh_options& options = {}) {
  constexpr std::uint32_t none = ~0u;
  const bool clipped = options.boundary == dual_boundary::clipped;
  detail::dual_parts<M> parts(m, clipped);
  detail::star_checker<M> stars(m, parts);

  std::vector<unsigned char> on_border(vert_index_bound(m));
  for (const face_t<M> f : faces(m))
    if (const auto i = static_cast<std::uint32_t>(index_of(m, f)); parts.is_border(i))
      for (const auto& side : parts.sides(i)) on_border[side.from] = 1;

  polyhedra_arrays a;
  a.face_offsets.push_back(0);
  a.poly_offsets.push_back(0);
  const auto close_face = [&] { a.face_offsets.push_back(static_cast<std::uint32_t>(a.face_verts.size())); };
  std::vector<std::uint32_t> face_of(edge_index_bound(m), none);
  for (const edge_t<M> e : edges(m)) {
    const std::size_t i = index_of(m, e);
    if (!parts.has_polys(i)) continue;
    bool wanted = clipped;
    vec3 middle;
    for (const vert_t<M> v : adj_e2v(m, e)) {
      wanted = wanted || !on_border[index_of(m, v)];
      middle += 0.5 * to_vec3(point(m, v));
    }
    if (!wanted) continue;
    if (parts.is_border_hub(i)) parts.add_hub_vert(i, middle);
    face_of[i] = static_cast<std::uint32_t>(a.num_faces());
    parts.add_loop(i, a.face_verts);
    close_face();
  }

  for (const vert_t<M> v : verts(m)) {
    const auto i = static_cast<std::uint32_t>(index_of(m, v));
    const auto& around = adj_v2p(m, v);
    if (!(around.begin() != around.end()) || (on_border[i] && !clipped)) continue;
    stars.check(v, on_border[i]);
    for (const edge_t<M> e : adj_v2e(m, v)) {
      if (face_of[index_of(m, e)] == none) continue;
      a.poly_faces.push_back(face_id{face_of[index_of(m, e)]});
      a.outward.push_back(parts.second_end(index_of(m, e)) != i);  // loops turn as seen from the second end
    }
    if (on_border[i]) {
      const std::uint32_t own = parts.add_vert(to_vec3(point(m, v)));
      for (const face_t<M> f : adj_v2f(m, v)) {
        const auto face = static_cast<std::uint32_t>(index_of(m, f));
        if (!parts.is_border(face)) continue;
        const auto sides = parts.sides(face);
        std::size_t k = 0;
        while (sides[k].from != i) ++k;
        const std::uint32_t before = parts.hub_vert(sides[k == 0 ? sides.size() - 1 : k - 1].edge), after = parts.hub_vert(sides[k].edge);
        for (const std::uint32_t x : {own, after, parts.facet_vert(face), before}) a.face_verts.push_back(vert_id{x});
        close_face();
        a.poly_faces.push_back(face_id{a.num_faces() - 1});
        a.outward.push_back(parts.is_outward(face));
      }
    }
    a.poly_offsets.push_back(static_cast<std::uint32_t>(a.poly_faces.size()));
  }
  a.points = std::move(parts.points);
  if (!clipped) detail::drop_unused(a.points, a.face_verts);
  return polyhedralmesh(std::move(a));
}

}  // namespace concino
