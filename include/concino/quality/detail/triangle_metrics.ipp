// Defines the quality metrics of triangles, as in the chapter on triangles of the Verdict manual.
#pragma once

#include <concino/quality/detail/metric_row.hpp>

namespace concino::detail {

struct triangle_metrics {
  vec3 edge[3];  // from vert i to vert i + 1
  double mean_size;

  explicit triangle_metrics(const poly_geometry& g)
      : edge{g.points[1] - g.points[0], g.points[2] - g.points[1], g.points[0] - g.points[2]}, mean_size(g.mean_size) {}

  double doubled_area() const { return length_of(cross(edge[0], edge[1])); }
  double squared_edges() const { return dot(edge[0], edge[0]) + dot(edge[1], edge[1]) + dot(edge[2], edge[2]); }
  std::array<double, 3> lengths() const { return {length_of(edge[0]), length_of(edge[1]), length_of(edge[2])}; }

  double area() const { return doubled_area() / 2; }
  double aspect_ratio() const {
    const auto l = lengths();
    return ratio_or_infinite(std::max({l[0], l[1], l[2]}) * (l[0] + l[1] + l[2]),
                             2 * std::numbers::sqrt3 * doubled_area());
  }
  double aspect_frobenius() const {
    return ratio_or_infinite(squared_edges(), 2 * std::numbers::sqrt3 * doubled_area());
  }
  double distortion() const { return 1; }  // the map of a triangle is linear
  double edge_ratio() const {
    const auto l = lengths();
    return ratio_or_infinite(std::max({l[0], l[1], l[2]}), std::min({l[0], l[1], l[2]}));
  }
  /// The largest angle is opposite the longest edge, the smallest one opposite the shortest.
  double angle_opposite(unsigned k) const { return angle_in_degrees(edge[(k + 1) % 3], -edge[(k + 2) % 3]); }
  double maximum_angle() const {
    const auto l = lengths();
    if (std::min({l[0], l[1], l[2]}) == 0) return 180;
    return angle_opposite(static_cast<unsigned>(std::max_element(l.begin(), l.end()) - l.begin()));
  }
  double minimum_angle() const {
    const auto l = lengths();
    return angle_opposite(static_cast<unsigned>(std::min_element(l.begin(), l.end()) - l.begin()));
  }
  double equiangle_skew() const { return skew_of_angles(minimum_angle(), maximum_angle(), 60); }
  double radius_ratio() const {
    const auto l = lengths();
    const double a = doubled_area();
    return ratio_or_infinite(l[0] * l[1] * l[2] * (l[0] + l[1] + l[2]), 4 * a * a);
  }
  double normalized_inradius() const {
    const double r = radius_ratio();
    return r == no_limit ? 0 : 1 / r;
  }
  double relative_size_squared() const { return squared_relative_size(area(), mean_size); }
  double scaled_jacobian() const {
    const auto l = lengths();
    const double largest = std::max({l[0] * l[1], l[1] * l[2], l[2] * l[0]});
    return std::min(1.0, ratio_or_zero(2 / std::numbers::sqrt3 * doubled_area(), largest));
  }
  double shape() const {
    return std::min(1.0, ratio_or_zero(2 * std::numbers::sqrt3 * doubled_area(), squared_edges()));
  }
  double shape_and_size() const { return shape() * relative_size_squared(); }
};

CONCINO_INLINE std::span<const metric_row> triangle_rows() {
  using t = triangle_metrics;
  static constexpr metric_row rows[] = {
      {metric::area, metric_of<t, &t::area>, size_of(std::numbers::sqrt3 / 4, 2)},
      {metric::aspect_frobenius, metric_of<t, &t::aspect_frobenius>, ratio_to(1.3)},
      {metric::aspect_ratio, metric_of<t, &t::aspect_ratio>, ratio_to(1.3)},
      {metric::condition, metric_of<t, &t::aspect_frobenius>, ratio_to(1.3)},  // equal for triangles
      {metric::distortion, metric_of<t, &t::distortion>, {{0.5, 1}, {-no_limit, no_limit}, 1, 0}},
      {metric::edge_ratio, metric_of<t, &t::edge_ratio>, ratio_to(1.3)},
      {metric::equiangle_skew, metric_of<t, &t::equiangle_skew>, deviation_to(0.5, 1)},
      {metric::maximum_angle, metric_of<t, &t::maximum_angle>, {{60, 90}, {0, 180}, 60, 0}},
      {metric::mean_ratio, metric_of<t, &t::shape>, part_from(0.25)},
      {metric::minimum_angle, metric_of<t, &t::minimum_angle>, {{30, 60}, {0, 60}, 60, 0}},
      {metric::normalized_inradius, metric_of<t, &t::normalized_inradius>, part_from(0.15)},
      {metric::radius_ratio, metric_of<t, &t::radius_ratio>, ratio_to(3)},
      {metric::relative_size_squared, metric_of<t, &t::relative_size_squared>, relative_from(0.25)},
      {metric::scaled_jacobian, metric_of<t, &t::scaled_jacobian>, part_from(0.5)},
      {metric::shape, metric_of<t, &t::shape>, part_from(0.25)},
      {metric::shape_and_size, metric_of<t, &t::shape_and_size>, relative_from(0.25)},
  };
  return rows;
}

}  // namespace concino::detail
