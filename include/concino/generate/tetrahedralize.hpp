// Tets that fill a closed surface, by a back end that the caller passes, such as concino::tetgen.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/generate/detail/volumes/closed_surface.hpp>
#include <concino/generate/detail/volumes/tetrahedralize_steps.hpp>
#include <concino/generate/detail/volumes/verified_tets.hpp>
#include <concino/generate/tetrahedralize_options.hpp>
#include <concino/mesh/element_map.hpp>

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace concino {

/// The tets that fill a surface M, and which of their elements belong to elements of M.
template<SurfaceMesh M>
struct tetrahedralization {
  static constexpr std::uint32_t no_label = ~0u;

  tetmesh mesh;
  std::vector<vert_id> extra_verts;   // by extra point: its vert; none if it lies outside or in a hole
  std::vector<std::uint32_t> labels;  // by poly of the mesh: the label of its region, or no_label; empty without
                                      // regions
  tetrahedralize_report report;
  vert_map<M, vert_id> vert_map_of_surface;
  std::vector<std::optional<poly_t<M>>> polys_of_faces;  // by face of the mesh

  /// The vert of the mesh at a vert of the surface; none if that has no poly, or lies in a hole.
  vert_id vert_of(const vert_t<M>& v) const { return vert_map_of_surface[v]; }
  /// The poly of the surface of which a face of the mesh is a part; empty for all other faces.
  std::optional<poly_t<M>> poly_of(face_id f) const { return polys_of_faces[f.raw()]; }
};

/// Fills a closed surface with tets. The verts of the surface are verts of the result; what else is asked for is in the
/// options, and what the back end can do in its header. Parts around which the surface winds 0 times, such as cavities
/// with boundaries of their own that are oriented outward of the solid, stay empty.
/// Needs:  Embedded SurfaceMesh, closed, all edges of two polys, without self-intersections. It may have several parts.
///         Polys may be oriented in any way that has a consistent one: parts that are oriented consistently stay as
///         they are, others get a positive volume. Polys with more than three verts are cut by triangulate_polygon; the
///         report lists those that are not planar.
/// Result: verified before it is returned: all tets have a positive volume (by orient3d), the boundary is the surface
///         (with keep_boundary its triangles, otherwise triangles that cover them), and the tets have the enclosed
///         volume, to 1e-9 of it. Back ends that approximate the surface promise a distance instead. Tets that miss a
///         wanted shape, length or volume are in the report, and report.not_met says so in a sentence. By default the
///         boundary is kept, so tets at it are about as large as its polys, whatever max_volume is: with keep_boundary
///         = false they can be smaller. The same each time.
/// Cost:   that of the back end, and O(n log n) for the checks before and after it; the report has their times.
/// Errors: invalid_mesh that names the elements if the surface is empty, open, flat, not orientable, intersects itself
///         or a facet, has edges with more than two polys, repeated points, points that are not finite, or polys
///         without area. invalid_argument if an option is out of its range. unsupported if the back end failed,
///         crashed, took longer than allowed, or returned something else than promised. cancelled.
template<SurfaceMesh M, requirement::is_tet_back_end BackEnd>
  requires Embedded<M>
tetrahedralization<M> tetrahedralize(const M& m, const BackEnd& back_end,
                                  const tetrahedralize_options& input_options = {}) {
  const core::profiled_options profiled(input_options, "tetrahedralize");
  const tetrahedralize_options& options = *profiled;
  detail::tetrahedralize_steps steps(options);
  detail::polygon_arrays polygons = detail::polygons_of(m);
  const std::vector<std::uint32_t> point_of_vert = polygons.point_of_vert;
  detail::closed_surface surface = detail::checked_surface(std::move(polygons), options);
  steps.end_of_check();
  tetrahedralize_output output = back_end.tetrahedralize(surface.input, options);
  steps.end_of_back_end();
  detail::verified_tets tets = [&] {
    if constexpr (!requirement::approximates_surface<BackEnd>)
      return detail::verified(surface, std::move(output), options, back_end.name());
    else
      return detail::verified_approximation(surface, std::move(output),
                                            back_end.surface_distance(surface.input.diagonal), back_end.name());
  }();

  tetrahedralization<M> result{std::move(tets.mesh), {}, {}, {}, make_vert_map<vert_id>(m), {}};
  const auto vert_at = [&](std::size_t i) {
    return tets.vert_of_point[i] == tets.no_vert ? vert_id() : vert_id{tets.vert_of_point[i]};
  };
  std::size_t position = 0, used = 0;
  for (const vert_t<M> v : verts(m))
    if (const std::uint32_t i = point_of_vert[position++]; i != detail::polygon_arrays::no_point)
      result.vert_map_of_surface[v] = vert_at(i), ++used;
  for (; used < tets.vert_of_point.size(); ++used) result.extra_verts.push_back(vert_at(used));
  std::vector<poly_t<M>> surface_polys;
  for (const poly_t<M> p : polys(m)) surface_polys.push_back(p);
  result.polys_of_faces.resize(tets.triangle_of_face.size());
  for (std::size_t f = 0; f < tets.triangle_of_face.size(); ++f)
    if (const std::uint32_t t = tets.triangle_of_face[f]; t < surface.input.surface_triangles)
      result.polys_of_faces[f] = surface_polys[surface.poly_of_triangle[t]];
  for (const std::uint32_t r : tets.region_of_poly)
    result.labels.push_back(r == tets.no_region ? result.no_label : options.regions[r].label);
  result.report.not_planar = std::move(surface.not_planar);
  detail::list_poor_tets(result.mesh, tets.region_of_poly, options, result.report);
  detail::describe_missed_bounds(num_polys(result.mesh),
                              options.keep_boundary && !requirement::approximates_surface<BackEnd>, result.report);
  steps.end_of_verification(result.report);
  return result;
}

// What to write instead of calls that cannot compile.
template<class... T> void tetrahedralize(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void tetrahedralize(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<SurfaceMesh M> requires Embedded<M> void tetrahedralize(const M&, const tetrahedralize_options& = {}) = delete;  // pass a back end: tetrahedralize(m, tetgen), with #include <concino/adapters/tetgen.hpp> (Debian: libtet1.5-dev)

}  // namespace concino
