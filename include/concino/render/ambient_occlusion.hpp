// Ambient occlusion: the part of the sky that is visible from the polys of a mesh. Cavities are dark, ridges bright.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/core/parallel.hpp>
#include <concino/core/progress.hpp>
#include <concino/mesh/element_map.hpp>
#include <concino/render/box_tree_tracer.hpp>
#include <concino/render/detail/sampling.hpp>
#include <concino/render/detail/unit_scene.hpp>

#include <limits>
#include <span>

namespace concino {

struct ambient_occlusion_options {
  int directions = 128;  // per polygon, 1 or more
  double distance = std::numeric_limits<double>::infinity();  // above 0, in units of the mesh: surfaces farther away do not occlude
  concino::progress progress = {};                            // called with the fraction done and "ambient occlusion"
};

/// The fraction of the hemisphere above every poly that the surface does not occlude, weighted by the cosine to the normal.
/// Needs:  EmbeddedMesh M, oriented so that its normals point outward.
/// Result: a map of double in [0, 1], 1 for polys of a plane. For the polys of a volume it is the mean over their boundary faces by area, 0 if they
///         have none. Rays start at the middles of the triangles of a polygon. The result does not depend on the number of threads.
/// Cost:   `directions` rays for each visible polygon, at least one for each of its triangles; parallel.
/// Errors: invalid_argument if an option is out of its range; as make_drawable; cancelled.
/// Source: Zhukov, Iones and Kronin 1998; Malley's sampling of the cosine.
template<class M, RayTracer T = box_tree_tracer>
  requires requirement::is_lvalue_or_view<M> && EmbeddedMesh<M>
poly_map<M, double> ambient_occlusion(M&& m, const ambient_occlusion_options& options = {}, const T& tracer = {}) {
  if (options.directions < 1) throw invalid_argument("ambient_occlusion: directions must be 1 or more");
  if (!(options.distance > 0)) throw invalid_argument("ambient_occlusion: distance must be positive");
  const drawable d = make_drawable(m, {.crease_angle = 0});
  const detail::unit_scene scene({&d, 1});
  const auto caster = tracer.build(scene.soup);
  const double far = std::min(1e30, scene.to_unit(options.distance));

  const std::size_t n = d.polygons().size();
  std::vector<std::uint32_t> first(n + 1, 0);
  for (const std::uint32_t p : d.polygon_of) ++first[p + 1];
  for (std::size_t p = 0; p < n; ++p) first[p + 1] += first[p];
  std::vector<double> free(n), area(n);
  detail::report_progress(options.progress, 0, "ambient occlusion");
  const auto polygon = [&](std::size_t p) {
    const unsigned triangles = first[p + 1] - first[p];
    const unsigned each = std::max(1u, static_cast<unsigned>(options.directions) / std::max(1u, triangles));
    for (std::uint32_t t = first[p]; t < first[p + 1]; ++t) {
      const auto at = [&](std::size_t k) { return scene.point(d.corners[d.triangles[t][k]]); };
      const vec3 a = at(0), b = at(1), c = at(2), normal = cross(b - a, c - a);
      const double size = norm(normal);
      if (!(size > 0)) continue;
      const vec3 up = normal / size, start = (a + b + c) / 3 + up * 3e-5;
      const detail::frame around(up);
      const detail::unit_point shift = detail::random_point(t);
      unsigned open = 0;
      for (unsigned k = 0; k < each; ++k) {
        const vec3 direction = detail::cosine_direction(around, detail::spread_point(k, shift));
        open += !caster.occluded(start, direction, 0, far);
      }
      free[p] += size * open / each;
      area[p] += size;
    }
  };
  parallel_for(n, polygon, 64, [&](double fraction) {
    detail::report_progress(options.progress, fraction, "ambient occlusion");
    return false;
  });

  auto result = make_poly_map<double>(m, 0.0);
  std::vector<double> whole(result.values().size(), 0.0);
  for (std::size_t p = 0; p < n; ++p) {
    result.values()[d.polys[p]] += free[p];
    whole[d.polys[p]] += area[p];
  }
  for (std::size_t i = 0; i < whole.size(); ++i)
    if (whole[i] > 0) result.values()[i] /= whole[i];
  detail::report_progress(options.progress, 1, "ambient occlusion");
  return result;
}

// What to write instead of calls that cannot compile.
template<class... T> void ambient_occlusion(mistake::no_mesh_traits<mistake::include_adapter>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter
template<class... T> void ambient_occlusion(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void ambient_occlusion(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
