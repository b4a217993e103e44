// The dual mesh: it has a vert for each poly and a poly for each vert.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/generate/detail/dual/surface_dual.hpp>
#include <concino/generate/detail/dual/volume_dual.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/geometry/normals.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/polyhedralmesh.hpp>

#include <utility>
#include <vector>

namespace concino {

namespace detail {

/// The cells of a surface that do not face the side of the normal of their vert.
template<SurfaceMesh M>
std::vector<poly_id> inverted_cells(const M& m, const dual_maps& maps, const polygonmesh& dual) {
  std::vector<poly_id> inverted;
  for (const vert_t<M> v : verts(m))
    if (const poly_id cell = maps.poly_of_vert[index_of(m, v)];
        !cell.is_none() && !(dot(vert_normal(m, v), normal(dual, cell)) > 0))
      inverted.push_back(cell);
  return inverted;
}
inline std::vector<poly_id> inverted_cells(const polyhedralmesh& dual) {
  std::vector<poly_id> inverted;
  for (const poly_id p : polys(dual))
    if (!(measure(dual, p) > 0)) inverted.push_back(p);
  return inverted;
}

template<SurfaceMesh M, class Creases>
polygonmesh dual_mesh_of(const M& m, const Creases& creases, const dual_mesh_options& o) {
  dual_maps maps;
  dual_maps* const wanted = o.maps || o.inverted ? &maps : nullptr;
  const boundary_creases<M, Creases> at(m, creases, o);
  surface_arrays a = surface_dual(m, at, o.points, wanted);
  if (!at.has_boundary_cells()) drop_unused_dual_verts(a.points, a.verts, wanted);
  polygonmesh dual(std::move(a));
  if (o.inverted) *o.inverted = inverted_cells(m, maps, dual);
  if (o.maps) *o.maps = std::move(maps);
  return dual;
}
template<VolumeMesh M, class Creases>
polyhedralmesh dual_mesh_of(const M& m, const Creases& creases, const dual_mesh_options& o) {
  dual_maps maps;
  const boundary_creases<M, Creases> at(m, creases, o);
  volume_dual<M> builder(m, at, o.points);
  polyhedra_arrays a = builder.build();
  if (o.maps) maps = builder.maps();
  if (!at.has_boundary_cells()) drop_unused_dual_verts(a.points, a.face_verts, o.maps ? &maps : nullptr);
  polyhedralmesh dual(std::move(a));
  if (o.inverted) *o.inverted = inverted_cells(dual);
  if (o.maps) *o.maps = std::move(maps);
  return dual;
}

}  // namespace detail

/// The dual mesh: a vert at the centroid of each poly, a poly for each vert, and an edge between polys that share an
/// edge (surfaces) or a face (volumes). In volumes it has a face for each edge, through the polys around it; that face
/// need not be planar.
/// Needs:  EmbeddedMesh, manifold: at most two polys at an edge (face); the polys around each vert form one disk
///         (ball). For circumcentres all polys are triangles or tets, in a mesh of any kind. creases[x], if passed,
///         converts to bool: whether x is a crease of the boundary, a vert of a surface or an edge of a volume. For a
///         region of m, pass submesh(m, keep).
/// Result: a polygonmesh or polyhedralmesh. Poly i is the cell of the i-th vert of verts(m) that has a cell. All verts
///         that belong to polys have one (clipped, closed), or only those in the interior (discarded). Unless cells are
///         discarded, vert i is the dual of the i-th poly of polys(m), and more verts follow. Two polys that share
///         several edges (faces) are connected through the midpoint (centroid) of each. The orientation is that of m;
///         the faces of dual polyhedra are outward if those of m are. Clipped with creases everywhere, as by default,
///         the dual covers the same region as m: it has the same measure if m lies in a plane or all boundary faces of
///         the volume are planar. With creases only where the boundary turns, that is still so, with fewer verts and
///         faces. A cell has one face for each part of the boundary between two creases, and a vert where two or more
///         creases meet. Edges between boundary faces that share several edges are creases in any case, also of closed
///         cells. A cell may be inverted, since the verts of the dual need not surround its vert. This happens with
///         polyhedra of very different shapes, with polys that are not convex, and with circumcentres if m is not
///         Delaunay. options.inverted lists the cells of volumes without positive volume. Of surfaces it lists those
///         whose normal and that of their vert point to different sides, and those without area.
/// Cost:   O(size of the mesh), plus the squares of the numbers of polys around each vert (surface) or edge (volume).
/// Errors: invalid_mesh that names the vert, edge, face or poly that is not manifold, not closed, not at a finite point
///         or without circumcentre, or an interior vert of a volume that has only two edges. invalid_argument for
///         circumcentres that names a poly that is no triangle or tet. invalid_argument for a negative angle, for
///         creases given twice, or given for closed cells.
/// Source: paper section 2.2, "mesh dualization"; the barycentric dual, as in Hirani 2003, "Discrete exterior
///         calculus".
template<EmbeddedMesh M>
auto dual_mesh(const M& m, const dual_mesh_options& options = {}) {
  return detail::dual_mesh_of(m, detail::creases_by_angle(), options);
}
template<EmbeddedMesh M, class C>
  requires requirement::is_boundary_crease_map<C, M>
auto dual_mesh(const M& m, const C& creases, const dual_mesh_options& options = {}) {
  return detail::dual_mesh_of(m, creases, options);
}

// What to write instead of calls that cannot compile.
template<class... T> void dual_mesh(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void dual_mesh(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
