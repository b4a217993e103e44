// Triangles from any surface.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/generate/detail/common/construct_from_arrays.hpp>
#include <concino/generate/detail/common/finite.hpp>
#include <concino/generate/detail/outlines/flat_triangles.hpp>
#include <concino/generate/detail/subdivide/subdivision.hpp>
#include <concino/mesh/trimesh.hpp>

#include <algorithm>
#include <span>
#include <vector>

namespace concino {

struct to_triangles_options {
  bool properties = true;                             // whether named properties are transferred, if m has any
  concino::correspondence* correspondence = nullptr;  // unless null, filled with the elements of m of which those of
                                                      // the result were made
};

namespace detail {

/// Adds the origins of the triangles of a polygon: the poly, weighted by area.
inline void add_parts_of_polygon(std::span<const vec3> corners, std::span<const polygon_triangle> triangles,
                                 std::uint32_t poly, element_origins& origins) {
  if (triangles.size() == 1) return origins.add(poly);
  double size = 0;
  for (const vec3& x : corners) size = std::max(size, distance(x, corners[0]));
  const auto step = [&](std::uint32_t from, std::uint32_t to) {
    return size > 0 ? (corners[to] - corners[from]) / size : vec3{};
  };
  for (const auto& [i, j, k] : triangles) origins.add({{poly, norm(cross(step(i, j), step(i, k)))}});
}

}  // namespace detail

/// Cuts each polygon into triangles by diagonals, without new verts.
/// Needs:  Embedded SurfaceMesh. Its polygons may be concave, and need not be planar.
/// Result: a trimesh. Its verts are those of verts(m); its polys follow those of m and have their orientation, n - 2
///         for a polygon of n verts, cut as triangulate_polygon does, with flips where a triangle of collinear verts
///         would have no area. Areas do not change where polygons are planar. Named properties are transferred by their
///         rules; triangles count by their areas. Polygons that share two verts, but not the edge between them, may get
///         the same diagonal, an edge of more than two triangles.
/// Cost:   that of triangulate_polygon for all polygons.
/// Errors: invalid_mesh that names a vert whose point is not finite. invalid_argument if the result would have too many
///         elements.
template<SurfaceMesh M>
  requires Embedded<M>
trimesh to_triangles(const M& m, const to_triangles_options& options = {}) {
  detail::check_points_finite("to_triangles", m, "validate() lists all such verts");
  detail::check_element_counts<trimesh>("to_triangles", "the mesh", static_cast<double>(num_verts(m)),
                                        static_cast<double>(detail::num_poly_corners(m)) / 2);
  const std::vector<std::uint32_t> vert_number = core::numbered(m, verts(m), vert_index_bound(m));
  const subdivide_options shared{1, options.properties, options.correspondence};
  const bool wanted = detail::wants_origins(m, shared);
  surface_arrays a{core::copy_points(m), {}, {}, 3};
  a.verts.reserve(6 * num_polys(m));
  element_origins from;
  detail::polygon_cutter cut;
  std::vector<vert_id> loop;
  std::vector<vec3> corners;
  for (const poly_t<M> p : polys(m)) {
    loop.clear(), corners.clear();
    for (const vert_t<M> v : adj_p2v(m, p)) {
      loop.push_back(vert_id{vert_number[index_of(m, v)]});
      corners.push_back(a.points[loop.back().raw()]);
    }
    const auto triangles = cut(corners);
    for (const auto& [i, j, k] : triangles) a.verts.insert(a.verts.end(), {loop[i], loop[j], loop[k]});
    if (wanted) detail::add_parts_of_polygon(corners, triangles, static_cast<std::uint32_t>(index_of(m, p)), from);
  }
  detail::subdivided<trimesh> result{trimesh(std::move(a))};
  if (wanted) {
    result.from.polys = std::move(from);
    detail::set_origins(m, detail::copied_verts(m), {}, shared, result);
  }
  if (options.correspondence) *options.correspondence = std::move(result.from);
  return std::move(result.mesh);
}

// What to write instead of calls that cannot compile.
template<class... T> void to_triangles(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void to_triangles(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
