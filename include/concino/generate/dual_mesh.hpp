// The dual of a mesh: a vert for each poly, a poly for each vert.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/generate/detail/volume_dual.hpp>
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

/// The dual mesh: a vert at the centroid of each poly, a poly for each vert, and an edge between polys that share an edge (surfaces) or a face
/// (volumes). In volumes it has a face for each edge, through the polys around it; that face need not be planar.
/// Needs:  EmbeddedMesh, manifold: at most two polys at an edge (face), the polys around each vert one disk (ball).
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
    if (parts.is_border_centre(i)) {
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
  const bool clipped = options.boundary == dual_boundary::clipped;
  polyhedra_arrays a = detail::volume_dual<M>(m, clipped).build();
  if (!clipped) detail::drop_unused(a.points, a.face_verts);
  return polyhedralmesh(std::move(a));
}

// What to write instead of calls that cannot compile.
template<class... T> void dual_mesh(mistake::no_mesh_traits<mistake::include_adapter>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or a sibling
template<class... T> void dual_mesh(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
