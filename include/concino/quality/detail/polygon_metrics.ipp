// Defines the quality metrics of all polygons. Those of triangles and quads that have the same names are special cases.
#pragma once

#include <concino/geometry/enclosing_ball.hpp>
#include <concino/geometry/inscribed_circle.hpp>
#include <concino/quality/detail/kernel_fraction.hpp>
#include <concino/quality/detail/metric_row.hpp>

namespace concino::detail {

struct polygon_metrics {
  std::span<const vec3> p;
  double mean_size;

  explicit polygon_metrics(const poly_geometry& g) : p(g.points), mean_size(g.mean_size) {}

  /// An edge of a corner, the one before it, and the determinant as seen along the vector area.
  struct corner {
    vec3 out, in;
    double det;
  };
  std::size_t size() const { return p.size(); }
  vec3 edge(std::size_t i) const { return p[i + 1 == size() ? 0 : i + 1] - p[i]; }
  vec3 area_vector() const {
    vec3 doubled;
    for (std::size_t i = 1; i + 1 < size(); ++i) doubled += cross(p[i] - p[0], p[i + 1] - p[0]);
    return 0.5 * doubled;
  }
  double regular_angle() const { return std::numbers::pi * (1 - 2 / static_cast<double>(size())); }
  /// Calls f(corner) for each; all determinants are 0 if the polygon has no vector area.
  template<class F> void for_each_corner(const F& f) const {
    vec3 n = area_vector();
    const double length = length_of(n);
    if (length > 0) n /= length;
    vec3 in = edge(size() - 1);
    for (std::size_t i = 0; i < size(); ++i) {
      const vec3 out = edge(i);
      f(corner{out, in, dot(n, cross(in, out))});
      in = out;
    }
  }
  template<class F> value_range range_at_corners(const F& f) const {
    value_range r{no_limit, -no_limit};
    for_each_corner([&](const corner& c) {
      const double q = f(c);
      r.low = std::min(r.low, q), r.high = std::max(r.high, q);
    });
    return r;
  }
  value_range angles() const {
    return range_at_corners([](const corner& c) {
      const double angle = angle_in_degrees(c.out, -c.in);
      return c.det < 0 ? 360 - angle : angle;
    });
  }
  value_range squared_lengths() const { return range_at_corners([](const corner& c) { return dot(c.out, c.out); }); }

  double area() const { return length_of(area_vector()); }
  double edge_ratio() const {
    const value_range r = squared_lengths();
    return ratio_or_infinite(std::sqrt(r.high), std::sqrt(r.low));
  }
  double maximum_angle() const { return squared_lengths().low > 0 ? angles().high : 360; }
  double minimum_angle() const { return squared_lengths().low > 0 ? angles().low : 0; }
  double equiangle_skew() const {
    return skew_of_angles(minimum_angle(), maximum_angle(), in_degrees(regular_angle()));
  }
  double relative_size_squared() const { return squared_relative_size(area(), mean_size); }
  double scaled_jacobian() const {
    const double sine = std::sin(regular_angle());
    const auto q = range_at_corners([&](const corner& c) {
      const double lengths = length_of(c.in) * length_of(c.out);
      return lengths > 0 ? c.det / (lengths * sine) : 0;
    });
    return std::clamp(q.low, -1.0, 1.0);
  }
  double mean_ratio() const {
    const double angle = regular_angle(), sine = std::sin(angle), cosine = std::cos(angle);
    const auto q = range_at_corners([&](const corner& c) {
      const double squares = dot(c.in, c.in) + dot(c.out, c.out) + 2 * cosine * dot(c.in, c.out);
      return squares > 0 ? 2 * sine * c.det / squares : 0;
    });
    return std::clamp(q.low, -1.0, 1.0);
  }
  double planarity() const { return planarity_of_loop(size(), [&](std::size_t i) -> const vec3& { return p[i]; }); }
  double star_shapedness() const { return kernel_fraction_of_polygon(p, area_vector()); }
  double area_perimeter_ratio() const {
    double perimeter = 0;
    for (std::size_t i = 0; i < size(); ++i) perimeter += length_of(edge(i));
    return perimeter > 0 ? std::min(1.0, 4 * std::numbers::pi * area() / (perimeter * perimeter)) : 0;
  }
  double circle_ratio() const {
    const core::flat_polygon flat(p);
    if (!(flat.area() > 0) || flat.find_touching_edges()) return 0;
    return std::min(1.0, ratio_or_zero(inscribed_circle(p, {.tolerance = 1e-11}).radius, enclosing_circle(p).radius));
  }
};

CONCINO_INLINE std::span<const metric_row> polygon_rows() {
  using s = polygon_metrics;
  static constexpr metric_row rows[] = {
      {metric::area, metric_of<s, &s::area>, size_of(no_ideal, 2)},
      {metric::area_perimeter_ratio, metric_of<s, &s::area_perimeter_ratio>, {{0.25, 1}, {0, 1}, no_ideal, 0}},
      {metric::circle_ratio, metric_of<s, &s::circle_ratio>, {{0.1, 1}, {0, 1}, no_ideal, 0}},
      {metric::edge_ratio, metric_of<s, &s::edge_ratio>, ratio_to(3)},
      {metric::equiangle_skew, metric_of<s, &s::equiangle_skew>, deviation_to(0.5, no_limit)},
      {metric::maximum_angle, metric_of<s, &s::maximum_angle>, {{0, 170}, {0, 360}, no_ideal, 0}},
      {metric::mean_ratio, metric_of<s, &s::mean_ratio>, signed_part_from(0.3)},
      {metric::minimum_angle, metric_of<s, &s::minimum_angle>, {{45, 180}, {0, 360}, no_ideal, 0}},
      {metric::planarity, metric_of<s, &s::planarity>, part_from(0.9)},
      {metric::relative_size_squared, metric_of<s, &s::relative_size_squared>, relative_from(0.25)},
      {metric::scaled_jacobian, metric_of<s, &s::scaled_jacobian>, signed_part_from(0.3)},
      {metric::star_shapedness, metric_of<s, &s::star_shapedness>, part_from(0.1)},
  };
  return rows;
}

}  // namespace concino::detail
