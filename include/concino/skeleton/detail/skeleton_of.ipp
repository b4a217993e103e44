// Defines skeleton_of.hpp: a flow that makes the surface thin, and collapses of edges until no triangles are left.
#pragma once

#include <concino/core/number_text.hpp>
#include <concino/skeleton/detail/curve_collapse.hpp>
#include <concino/skeleton/skeleton_of.hpp>
#include <concino/solve/ldlt.hpp>

#include <Eigen/SparseCore>

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

/// A surface that flows by its mean curvature. Each vert resists with the area that it had, times the factor by which
/// that has shrunk.
class curvature_flow {
  using matrix = Eigen::SparseMatrix<double>;

  const std::vector<std::array<std::uint32_t, 3>>& triangles_;
  std::vector<double> first_areas_, areas_;
  ldlt solver_;
  double first_area_ = 0, time_ = 0;

  void measure() {
    areas_.assign(points.size(), 0);
    area = 0;
    for (const auto& t : triangles_) {
      const double part = norm(cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]])) / 2;
      for (const std::uint32_t v : t) areas_[v] += part / 3;
      area += part;
    }
  }

 public:
  std::vector<vec3> points;  // of a size near 1
  double area = 0;

  curvature_flow(std::vector<vec3> at, const std::vector<std::array<std::uint32_t, 3>>& triangles)
      : triangles_(triangles), points(std::move(at)) {
    measure();
    first_areas_ = areas_;
    first_area_ = area;
    // The first step is that in which a detail of the size of the triangles vanishes.
    time_ = 0.5 * area / static_cast<double>(triangles.size());
  }
  const std::vector<double>& first_areas() const { return first_areas_; }
  double part_of_area() const { return area / first_area_; }

  /// An implicit step with positive cotangent weights: no point leaves the convex hull of the points.
  void step() {
    const auto n = static_cast<Eigen::Index>(points.size());
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(triangles_.size() * 12 + points.size());
    constexpr double largest_cotangent = 1e5;
    for (const auto& t : triangles_)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t v = t[k], a = t[(k + 1) % 3], b = t[(k + 2) % 3];
        const vec3 to_a = points[a] - points[v], to_b = points[b] - points[v];
        const double sine = norm(cross(to_a, to_b)), cosine = dot(to_a, to_b);
        // Angles above 90 degrees would repel: their weights are nearly 0.
        const double of_angle = cosine > 0 ? cosine / std::max(sine, cosine / largest_cotangent) : 1e-6;
        const double weight = time_ * of_angle / 2;
        for (const auto& [i, j] : {std::pair(a, b), std::pair(b, a)}) {
          entries.emplace_back(static_cast<int>(i), static_cast<int>(i), weight);
          entries.emplace_back(static_cast<int>(i), static_cast<int>(j), -weight);
        }
      }
    Eigen::MatrixXd right(n, 3);
    for (std::size_t v = 0; v < points.size(); ++v) {
      const double first = std::max(first_areas_[v], 1e-12 * first_area_);
      const double resistance = first * std::clamp(first / std::max(areas_[v], 1e-300), 1.0, 1e8);
      entries.emplace_back(static_cast<int>(v), static_cast<int>(v), resistance);
      for (std::size_t k = 0; k < 3; ++k)
        right(static_cast<Eigen::Index>(v), static_cast<Eigen::Index>(k)) = resistance * points[v][k];
    }
    matrix system(n, n);
    system.setFromTriplets(entries.begin(), entries.end());
    solver_.factorize(system);
    for (std::size_t k = 0; k < 3; ++k) {
      const Eigen::VectorXd x = solver_.solve(right.col(static_cast<Eigen::Index>(k)));
      for (std::size_t v = 0; v < points.size(); ++v) points[v][k] = x[static_cast<Eigen::Index>(v)];
    }
    time_ *= 2;
    measure();
  }
};

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
  curvature_flow flow(local, surface.triangles);
  if (!(flow.area > 0)) core::throw_joined<invalid_mesh>({"skeleton_of: the surface has no area"});
  for (int i = 0; i < options.max_steps && flow.part_of_area() > options.area; ++i) {
    report_progress(options.progress, static_cast<double>(i) / options.max_steps, "contracting");
    flow.step();
  }
  report_progress(options.progress, 0, "collapsing edges");
  curve_collapse collapse(flow.points, flow.first_areas(), surface.triangles);
  collapse.run();
  curve_nodes nodes(collapse, local, flow.first_areas());
  if (!options.keep_short) nodes.join_short_bones();
  collapsed_curve curve;
  auto found = nodes.result();
  for (vec3& x : found.points)
    x = 2 * vec3{std::ldexp(x.x, exponent), std::ldexp(x.y, exponent), std::ldexp(x.z, exponent)} + surface.points[0];
  for (double& r : found.radii) r = 2 * std::ldexp(r, exponent);
  curve.skeleton = skeleton(std::move(found.points), std::move(found.edges), std::move(found.radii));
  curve.from = std::move(found.from);
  curve.area = flow.part_of_area();
  return curve;
}

}  // namespace concino::detail
