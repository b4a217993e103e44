// The dual mesh: it has a vert for each poly and a poly for each vert.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/generate/detail/volume_dual.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/polyhedralmesh.hpp>

namespace concino {

/// How verts on the boundary are treated. A cell is the dual poly of a vert.
enum class dual_boundary {
  clipped,    // their cells end at the boundary: at the vert, the midpoints of its boundary edges and, in volumes, the centroids of its boundary faces
  discarded,  // they have no cells
};

struct dual_mesh_options {
  dual_boundary boundary = dual_boundary::clipped;  // how verts on the boundary are treated
};

namespace detail {

/// Removes the dual verts that no loop uses.
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
/// Needs:  EmbeddedMesh, manifold: at most two polys at an edge (face); the polys around each vert form one disk (ball).
/// Result: a polygonmesh or polyhedralmesh. Poly i is the cell of the i-th vert of verts(m) that has a cell. All verts that belong to polys have
///         one (clipped), or only those in the interior (discarded). With clipped cells, vert i is the dual of the i-th poly of polys(m), and more
///         verts follow. The dual then covers the same region as m: it has the same measure if m lies in a plane or all boundary faces of the volume
///         are planar. Two polys that share several edges (faces) are connected through the midpoint (centroid) of each. The orientation is that
///         of m; the faces of dual polyhedra are outward if those of m are.
/// Cost:   O(size of the mesh), plus the squares of the numbers of polys around each vert (surface) or edge (volume).
/// Errors: invalid_mesh that names the vert, edge, face or poly that is not manifold, not closed or not at a finite point, or an interior vert
///         of a volume that has only two edges.
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
template<class... T> void dual_mesh(mistake::no_mesh_traits<mistake::include_adapter>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter
template<class... T> void dual_mesh(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
