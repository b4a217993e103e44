// Ambient occlusion: the part of the sky that is visible from the polys or verts of a mesh. Cavities are dark, ridges
// bright.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/core/parallel.hpp>
#include <concino/core/profiler.hpp>
#include <concino/core/progress.hpp>
#include <concino/mesh/element_map.hpp>
#include <concino/render/box_tree_tracer.hpp>
#include <concino/render/detail/trace/sampling.hpp>
#include <concino/render/detail/trace/unit_scene.hpp>
#include <concino/render/make_drawable.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

namespace concino {

struct ambient_occlusion_options {
  int rays = 128;                                             // per polygon or vert, 1 or more
  double distance = std::numeric_limits<double>::infinity();  // above 0, in units of the mesh: surfaces farther away do
                                                              // not occlude
  concino::progress progress = {};                            // called with the fraction done and "ambient occlusion"
  concino::profiler* profiler = nullptr;                      // measures the call and its steps
};

namespace detail {

/// Where rays start in a triangle: weights of its corners.
struct place_in_triangle {
  double a, b, c;
};

/// Adds the mean visible part of the sky by index: index_of(t, k) is that of place k of triangle t; places with the
/// same group_of(t, k) < num_groups share rays.
template<RayTracer T, class GroupOf, class IndexOf>
void add_visible_sky(const drawable& d, std::span<const place_in_triangle> places,
                     const ambient_occlusion_options& options, const T& tracer, std::size_t num_groups,
                     GroupOf&& group_of, IndexOf&& index_of, std::span<double> result) {
  if (options.rays < 1) throw invalid_argument("ambient_occlusion: rays must be 1 or more");
  if (!(options.distance > 0)) throw invalid_argument("ambient_occlusion: distance must be positive");
  const unit_scene scene({&d, 1});
  const auto caster = tracer.build(scene.soup);
  const double far = std::min(1e30, scene.to_unit(options.distance));
  const std::size_t n = d.triangles.size(), each = places.size();
  std::vector<unsigned> num_places(num_groups, 0);
  for (std::size_t t = 0; t < n; ++t)
    for (std::size_t k = 0; k < each; ++k) ++num_places[group_of(t, k)];

  std::vector<double> area(n, 0.0), visible(n * each, 0.0);
  const char* label = "ambient occlusion";
  report_progress(options.progress, 0, label);
  const auto triangle = [&](std::size_t t) {
    const auto at = [&](std::size_t k) { return scene.point(d.corners[d.triangles[t][k]]); };
    const vec3 a = at(0), b = at(1), c = at(2), normal = cross(b - a, c - a);
    area[t] = norm(normal);
    if (!(area[t] > 0)) return;
    const vec3 up = normal / area[t];
    const frame around(up);
    for (std::size_t k = 0; k < each; ++k) {
      const vec3 start = a * places[k].a + b * places[k].b + c * places[k].c + up * 3e-5;
      const unit_point shift = random_point(t * each + k);
      const unsigned rays = std::max(1u, static_cast<unsigned>(options.rays) / num_places[group_of(t, k)]);
      unsigned open = 0;
      for (unsigned r = 0; r < rays; ++r)
        open += !caster.occluded(start, cosine_direction(around, low_discrepancy_point(r, shift)), 0, far);
      visible[t * each + k] = static_cast<double>(open) / rays;
    }
  };
  parallel_for(n, triangle, 64, [&](double fraction) {
    report_progress(options.progress, fraction, label);
    return false;
  });

  std::vector<double> whole(result.size(), 0.0);
  for (std::size_t t = 0; t < n; ++t)
    for (std::size_t k = 0; k < each; ++k) {
      result[index_of(t, k)] += visible[t * each + k] * area[t];
      whole[index_of(t, k)] += area[t];
    }
  for (std::size_t i = 0; i < whole.size(); ++i)
    if (whole[i] > 0) result[i] /= whole[i];
  report_progress(options.progress, 1, label);
}

}  // namespace detail

/// The fraction of the hemisphere above every poly that the surface does not occlude, weighted by the cosine to the
/// normal.
/// Needs:  EmbeddedMesh M, oriented so that its normals point outward.
/// Result: a map of double in [0, 1], 1 for polys of a plane. For the polys of a volume it is the mean over their
///         boundary faces by area, 0 if they have none. Rays start at the middles of the triangles of a polygon. The
///         result does not depend on the number of threads.
/// Cost:   `rays` rays for each visible polygon, at least one for each of its triangles; parallel.
/// Errors: invalid_argument if an option is out of its range; as make_drawable; cancelled.
/// Source: Zhukov, Iones and Kronin 1998; Malley's sampling of the cosine.
template<class M, RayTracer T = box_tree_tracer>
  requires requirement::is_lvalue_or_view<M> && EmbeddedMesh<M>
poly_map<M, double> ambient_occlusion(M&& m, const ambient_occlusion_options& options = {}, const T& tracer = {}) {
  const core::profiled_options profiled(options, "ambient_occlusion");
  const drawable d = make_drawable(m, {.crease_angle = 0});
  auto result = make_poly_map<double>(m, 0.0);
  const detail::place_in_triangle middle[] = {{1.0 / 3, 1.0 / 3, 1.0 / 3}};
  detail::add_visible_sky(
      d, middle, *profiled, tracer, d.polys.size(), [&](std::size_t t, std::size_t) { return d.polygon_of[t]; },
      [&](std::size_t t, std::size_t) { return d.polys[d.polygon_of[t]]; }, result.values());
  return result;
}

/// The fraction of the sky that the surface does not occlude at every vert: the mean over the triangles of polygons
/// around it, by area.
/// Needs:  as ambient_occlusion.
/// Result: a map of double in [0, 1], 1 for verts of a plane; 0 for verts without polys and those inside a volume. Rays
///         start in the triangles, an eighth of the way from the vert to the middle.
/// Cost:   `rays` rays for each visible vert, at least one for each triangle around it; parallel.
/// Errors: as ambient_occlusion.
/// Source: as ambient_occlusion.
template<class M, RayTracer T = box_tree_tracer>
  requires requirement::is_lvalue_or_view<M> && EmbeddedMesh<M> vert_map<M, double> ambient_occlusion_at_verts(
      M&& m, const ambient_occlusion_options& options = {}, const T& tracer = {}) {
    const core::profiled_options profiled(options, "ambient_occlusion_at_verts");
    const drawable d = make_drawable(m, {.crease_angle = 0});
    auto result = make_vert_map<double>(m, 0.0);
    constexpr double near = 1 - 1.0 / 12, other = 1.0 / 24;
    const detail::place_in_triangle near_corners[] = {{near, other, other}, {other, near, other}, {other, other, near}};
    const auto point_of = [&](std::size_t t, std::size_t k) { return d.corners[d.triangles[t][k]]; };
    detail::add_visible_sky(
        d, near_corners, *profiled, tracer, d.points.size(), point_of,
        [&](std::size_t t, std::size_t k) { return d.verts[point_of(t, k)]; }, result.values());
    return result;
  }

// What to write instead of calls that cannot compile.
template<class... T> void ambient_occlusion(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void ambient_occlusion(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void ambient_occlusion(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void ambient_occlusion_at_verts(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void ambient_occlusion_at_verts(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void ambient_occlusion_at_verts(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
