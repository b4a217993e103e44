// Chooses a camera for a scene.
#pragma once

#include <concino/render/box_tree_tracer.hpp>
#include <concino/render/detail/trace/unit_scene.hpp>
#include <concino/render/view.hpp>

#include <cmath>
#include <span>

namespace concino {

/// The view, among 36 around the scene, that shows the most of every drawable. Small drawables count as much as large
/// ones.
/// Needs:  options.towards is preferred unless another direction is clearly better.
/// Result: a camera that frames the scene. It is the same for the same scene.
/// Cost:   about 30,000 rays for each drawable, and a pass over the points for each of 36 directions.
/// Errors: as frame.
template<RayTracer T = box_tree_tracer>
camera best_view(std::span<const drawable> drawables, double aspect, const view_options& options = {},
                 const T& tracer = {}) {
  const camera first = frame(drawables, aspect, options);
  const detail::unit_scene scene(drawables);
  const auto caster = tracer.build(scene.soup);
  constexpr double pi = 3.14159265358979323846;
  constexpr std::size_t looks = 1024;  // the number of triangles of each drawable that are tested
  constexpr double enough = 0.08;      // fraction of a drawable's area; to show more of it improves the score little
  const vec3 up = options.up / norm(options.up), right = first.right, front = cross(right, up);
  const double elevation = std::atan2(dot(first.back, up), dot(first.back, front));

  // The visible projected area of a drawable, and its area. The ratio is a quarter for a ball, and small for a sheet
  // seen from its edge.
  struct part {
    double seen, area;
  };
  const auto visible = [&](const camera& c, std::size_t i) {
    const drawable& d = drawables[i];
    const std::size_t n = d.triangles.size(), tries = std::min(n, looks);
    part p{0, 0};
    for (std::size_t k = 0; k < tries; ++k) {
      const auto& t = d.triangles[n * k / tries];
      const auto at = [&](std::size_t j) { return scene.point(scene.first_point(i) + d.corners[t[j]]); };
      const vec3 x = (at(0) + at(1) + at(2)) / 3, area = cross(at(1) - at(0), at(2) - at(0));
      const vec3 ahead = x - c.eye;
      const double away = c.parallel ? -dot(ahead, c.back) : norm(ahead);
      const vec3 ray = c.parallel ? -c.back : ahead / away;
      p.area += norm(area);
      if (away > 0 && !caster.occluded(x - ray * away, ray, 0, away - 1e-3)) p.seen += std::abs(dot(area, ray));
    }
    const double scale = tries > 0 ? static_cast<double>(n) / static_cast<double>(tries) : 0;
    return part{p.seen * scale, p.area * scale};
  };

  camera best = first;
  double best_score = -std::numeric_limits<double>::infinity();
  for (const double tilt : {0.0, 18.0, -12.0})
    for (int turn = 0; turn < 12; ++turn) {
      const double angle = (turn % 2 ? turn + 1 : -turn) / 2 * pi / 6;  // 0, 30, -30, 60 ... degrees
      const double height = std::min(1.4, std::max(0.05, elevation + tilt * pi / 180));
      view_options turned = options;
      turned.towards = (front * std::cos(angle) + right * std::sin(angle)) * std::cos(height) + up * std::sin(height);
      const camera c = turn == 0 && tilt == 0 ? first : frame(drawables, aspect, turned);
      const camera unit = scene.to_unit(c);
      double score = -0.30 * std::abs(angle) / pi - 0.12 * (tilt != 0);
      part whole{0, 0};
      for (std::size_t i = 0; i < drawables.size(); ++i) {
        const part p = visible(unit, i);
        if (!(p.area > 0)) continue;
        score += std::log(0.02 + std::min(enough, p.seen / p.area));
        whole.seen += p.seen;
        whole.area += p.area;
      }
      if (whole.area > 0) score += 3 * whole.seen / whole.area;
      if (score > best_score + 1e-9) best_score = score, best = c;
    }
  return best;
}

}  // namespace concino
