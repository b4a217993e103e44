// The dual of a mesh: a vert for each poly, a poly for each vert.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/generate/detail/star_checker.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/polyhedralmesh.hpp>

namespace concino {

/// What becomes of verts on the boundary.
enum class dual_boundary {
  clipped,    // their cells end there: at the vert, the midpoints of its boundary edges and, in volumes, the centroids of its boundary faces
  discarded,  // they have no cell
};

struct dual_mesh_options {
  dual_boundary boundary = dual_boundary::clipped;  // what becomes of verts on the boundary
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

}  // namespace detail

/// The dual mesh: a vert at the centroid of each poly, a poly for each vert, an edge between polys that share an edge (surfaces) or a face
/// (volumes), and in volumes a face for each edge, through the polys around it, which need not be planar.
/// Needs:  Embedded AnyMesh, manifold: at most two polys at an edge (face), the polys around each vert one disk (ball).
/// Result: a polygonmesh or polyhedralmesh. Poly i is the cell of the i-th vert of verts(m) that has one: of the verts of some poly all
///         (clipped) or the inner ones (discarded). With clipped cells vert i is the i-th poly of polys(m), others follow, and the dual
///         covers what m covers: it has the same measure where m lies in a plane or all boundary faces of the volume are planar. Two polys that
///         share several edges (faces) stay joined through the midpoint (centroid) of each. Windings are those of m; cells of volumes
///         face outward where those of m do.
/// Cost:   O(size of the mesh), but for the square of the number of polys around one vert (surface) or edge (volume).
/// Errors: invalid_mesh that names the vert, edge, face or poly that is not manifold, not closed or not at a finite point, or an inner vert
///         of a volume that has two edges only.
/// Source: paper section 2.2, "mesh dualization"; the barycentric dual, as in Hirani 2003, "Discrete exterior calculus".
template<SurfaceMesh M>
  requires Embedded<M>
polygonmesh dual_mesh(const M& m, const dual_mesh_options& options = {}) {
  const bool clipped = options.boundary == dual_boundary::clipped;
  detail::dual_parts<M> parts(m, clipped);
  surface_arrays a;
  core::reserve_large(a.verts, parts.num_corners());
  a.offsets.reserve(num_verts(m) + 1);
  a.offsets.push_back(0);
  for (const vert_t<M> v : verts(m)) {
    const std::size_t i = index_of(m, v);
    if (!parts.has_polys(i)) continue;
    std::uint32_t own = parts.none;
    if (parts.is_border_hub(i)) {
      if (!clipped) continue;
      own = parts.add_vert(to_vec3(point(m, v)));
    }
    parts.add_loop(i, own, a.verts);
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
  const detail::face_sides<M> sides(m);
  detail::dual_parts<M> parts(m, clipped, sides);
  detail::star_checker<M> stars(m, parts);

  std::vector<unsigned char> on_border(vert_index_bound(m));
  for (const face_t<M> f : faces(m))
    if (parts.is_border(index_of(m, f)))
      for (const detail::face_side& s : sides.of(index_of(m, f))) on_border[s.from] = 1;

  polyhedra_arrays a;
  core::reserve_large(a.face_verts, parts.num_corners());
  a.face_offsets.push_back(0);
  a.poly_offsets.push_back(0);
  const auto close_face = [&] { a.face_offsets.push_back(static_cast<std::uint32_t>(a.face_verts.size())); };
  std::vector<std::uint32_t> face_of(edge_index_bound(m), none), middle_of(edge_index_bound(m), none);
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
    if (parts.is_border_hub(i)) middle_of[i] = parts.add_vert(middle);
    face_of[i] = static_cast<std::uint32_t>(a.num_faces());
    parts.add_loop(i, middle_of[i], a.face_verts);
    close_face();
  }

  for (const vert_t<M> v : verts(m)) {
    const std::size_t i = index_of(m, v);
    bool any = false;
    for (const edge_t<M> e : adj_v2e(m, v)) any = any || parts.has_polys(index_of(m, e));
    if (!any || (on_border[i] && !clipped)) continue;
    stars.check(v, on_border[i]);
    for (const edge_t<M> e : adj_v2e(m, v)) {
      const std::size_t k = index_of(m, e);
      if (face_of[k] == none) continue;
      a.poly_faces.push_back(face_id{face_of[k]});
      a.outward.push_back(sides.second_end(k) != i);  // loops turn as seen from the second end
    }
    if (on_border[i]) {
      const std::uint32_t own = parts.add_vert(to_vec3(point(m, v)));
      for (const face_t<M> f : adj_v2f(m, v)) {
        if (!parts.is_border(index_of(m, f))) continue;
        const auto ring = sides.of(index_of(m, f));
        std::size_t k = 0;
        while (ring[k].from != i) ++k;
        const std::uint32_t before = middle_of[ring[k == 0 ? ring.size() - 1 : k - 1].edge], after = middle_of[ring[k].edge];
        a.poly_faces.push_back(face_id{a.num_faces()});
        for (const poly_t<M> p : adj_f2p(m, f)) a.outward.push_back(face_is_outward(m, p, f));  // one poly
        for (const std::uint32_t x : {own, after, parts.facet_vert(index_of(m, f)), before}) a.face_verts.push_back(vert_id{x});
        close_face();
      }
    }
    a.poly_offsets.push_back(static_cast<std::uint32_t>(a.poly_faces.size()));
  }
  a.points = std::move(parts.points);
  if (!clipped) detail::drop_unused(a.points, a.face_verts);
  return polyhedralmesh(std::move(a));
}

// What to write instead of calls that cannot compile.
template<class... T> void dual_mesh(mistake::no_mesh_traits<mistake::include_adapter>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or a sibling
template<class... T> void dual_mesh(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
