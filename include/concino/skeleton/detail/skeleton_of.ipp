// Defines skeleton_of.hpp: a flow that makes the surface thin, and collapses of edges until no triangles are left.
#pragma once

#include <concino/core/number_text.hpp>
#include <concino/skeleton/detail/contraction.hpp>
#include <concino/skeleton/detail/curve_nodes.hpp>
#include <concino/skeleton/skeleton_of.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace concino::detail {

/// Errors: invalid_mesh if an edge does not have two triangles that are oriented alike.
inline void require_closed_surface(const closed_triangles& s) {
  if (s.triangles.empty()) core::throw_joined<invalid_mesh>({"skeleton_of: the surface has no polys"});
  std::vector<std::array<std::uint32_t, 2>> directed;
  for (const auto& t : s.triangles)
    for (std::size_t k = 0; k < 3; ++k) directed.push_back({t[k], t[(k + 1) % 3]});
  std::sort(directed.begin(), directed.end());
  for (std::size_t i = 0; i < directed.size(); ++i) {
    const std::uint32_t a = directed[i][0], b = directed[i][1];
    const std::array<std::uint32_t, 2> back{b, a};
    const bool is_closed = std::binary_search(directed.begin(), directed.end(), back);
    if (a != b && is_closed && (i == 0 || directed[i] != directed[i - 1])) continue;
    std::size_t poly = 0;
    const auto has_edge = [&](const std::array<std::uint32_t, 3>& t) {
      return (t[0] == a && t[1] == b) || (t[1] == a && t[2] == b) || (t[2] == a && t[0] == b);
    };
    while (!has_edge(s.triangles[poly])) ++poly;
    core::throw_joined<invalid_mesh>({"skeleton_of: the surface is not closed, manifold and oriented, at an edge of ",
                                      "the poly at place ", poly, "; validate(m) names such edges"});
  }
}

CONCINO_INLINE collapsed_curve collapsed_to_curve(const closed_triangles& surface, const skeleton_of_options& options) {
  if (!(options.area >= 1e-6 && options.area <= 0.5))
    core::throw_joined<invalid_argument>({"skeleton_of_options: area is ", core::number_text(options.area),
                                          "; it has to be from 1e-6 to 0.5, as a part of the first area"});
  if (options.max_steps < 1)
    core::throw_joined<invalid_argument>(
        {"skeleton_of_options: max_steps is ", options.max_steps, "; it has to be 1 or more"});
  require_closed_surface(surface);
  // Coordinates of a size near 1, relative to one of the points.
  double size = 0;
  for (const vec3& x : surface.points) size = std::max(size, norm(0.5 * x - 0.5 * surface.points[0]));
  const int exponent = size > 0 && std::isfinite(size) ? std::ilogb(size) : 0;
  std::vector<vec3> local;
  for (const vec3& x : surface.points) {
    const vec3 d = 0.5 * x - 0.5 * surface.points[0];
    local.push_back({std::ldexp(d.x, -exponent), std::ldexp(d.y, -exponent), std::ldexp(d.z, -exponent)});
  }
  contraction flow(local, surface.triangles);
  if (!flow.has_area()) core::throw_joined<invalid_mesh>({"skeleton_of: the surface has no area"});
  const std::vector<double> masses = flow.masses();
  const std::vector<medial_ball> balls = flow.balls();
  for (int i = 0; i < options.max_steps; ++i) {
    report_progress(options.progress, static_cast<double>(i) / options.max_steps, "contracting");
    const double before = flow.relative_area();
    flow.step();
    if (std::abs(before - flow.relative_area()) < options.area) break;
  }
  report_progress(options.progress, 0, "collapsing edges");
  const double left = flow.relative_area();
  const triangle_complex of_edges = flow.curve();
  curve_nodes nodes(of_edges, flow.points(), local, masses, balls);
  if (!options.keep_short) nodes.join_short_bones();
  collapsed_curve curve;
  auto found = nodes.result();
  for (vec3& x : found.points)
    x = 2 * vec3{std::ldexp(x.x, exponent), std::ldexp(x.y, exponent), std::ldexp(x.z, exponent)} + surface.points[0];
  for (double& r : found.radii) r = 2 * std::ldexp(r, exponent);
  curve.skeleton = skeleton(std::move(found.points), std::move(found.edges), std::move(found.radii));
  curve.from = std::move(found.from);
  curve.area = left;
  return curve;
}

}  // namespace concino::detail
