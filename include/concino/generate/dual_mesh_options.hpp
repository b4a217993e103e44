// The options of dual_mesh, and the maps from a mesh to its dual.
#pragma once

#include <concino/concepts/maps.hpp>
#include <concino/concepts/mesh.hpp>

#include <concepts>
#include <vector>

namespace concino {

/// How verts on the boundary are treated. A cell is the dual poly of a vert.
enum class dual_boundary {
  clipped,    // their cells end at the boundary: at the vert, the midpoints of its boundary edges and, in volumes, the
              // centroids of its boundary faces
  closed,     // as clipped, but without creases: cells cut off the corners and, in volumes, the edges of the boundary
  discarded,  // they have no cells
};

/// Where the dual verts of polys, and those of facets on the boundary, are.
enum class dual_points {
  centroids,
  circumcentres,  // of meshes of triangles or tets only: cells of Delaunay meshes are Voronoi cells, and their faces
                  // are planar
};

/// The elements of a dual mesh by the index of the element of the mesh that each belongs to; an invalid descriptor
/// where there is none.
struct dual_maps {
  std::vector<poly_id> poly_of_vert;  // cells
  std::vector<face_id> face_of_edge;  // of volumes: the faces around edges; empty for surfaces
  std::vector<vert_id> vert_of_poly;
  std::vector<vert_id> vert_of_face;  // of volumes: those on the boundary, and those between polys that share more than
                                      // one; empty for surfaces
  std::vector<vert_id> vert_of_edge;  // midpoints: of surfaces, as vert_of_face; of volumes, of creases
  std::vector<vert_id> vert_of_vert;  // corners of the boundary
};

struct dual_mesh_options {
  dual_boundary boundary = dual_boundary::clipped;  // how verts on the boundary are treated
  double crease_angle_deg = 0;  // of clipped cells: the least angle, in degrees, by which the boundary turns at a
                                // crease; 0: it has creases everywhere
  dual_points points = dual_points::centroids;  // where the dual verts of polys are
  dual_maps* maps = nullptr;  // unless null, filled with the elements of the dual
  std::vector<poly_id>* inverted = nullptr;  // unless null, filled with the cells that are inverted, see dual_mesh
};

namespace detail {

template<class M> struct crease_of {};
template<SurfaceMesh M> struct crease_of<M> { using type = vert_t<M>; };
template<VolumeMesh M> struct crease_of<M> { using type = edge_t<M>; };

/// What creases of the boundary are: verts of a surface, edges of a volume.
template<class M> using crease_t = typename crease_of<M>::type;

}  // namespace detail

namespace requirement {

/// creases[x] says whether x, on the boundary of M, is a crease: a vert of a surface or an edge of a volume.
template<class C, class M>
concept is_boundary_crease_map = ReadableMap<C, concino::detail::crease_t<M>> &&
    requires(const C& creases, const concino::detail::crease_t<M>& x) {
  { creases[x] } -> std::convertible_to<bool>;
};

}  // namespace requirement

}  // namespace concino
