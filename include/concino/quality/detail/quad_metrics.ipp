// Defines the quality metrics of quads, as in the chapter on quadrilaterals of the Verdict manual.
#pragma once

#include <concino/quality/detail/metric_row.hpp>

namespace concino::detail {

struct quad_metrics {
  vec3 edge[4];  // from vert i to vert i + 1
  double mean_size;

  explicit quad_metrics(const poly_geometry& g) : mean_size(g.mean_size) {
    for (unsigned i = 0; i < 4; ++i) edge[i] = g.points[(i + 1) % 4] - g.points[i];
  }

  const vec3& before(unsigned i) const { return edge[(i + 3) % 4]; }  // the edge that ends at vert i
  vec3 axis(unsigned k) const { return edge[k] - edge[k + 2]; }
  vec3 corner_normal(unsigned i) const { return cross(before(i), edge[i]); }
  double length_squared(unsigned i) const { return dot(edge[i], edge[i]); }
  std::array<double, 4> lengths() const {
    return {length_of(edge[0]), length_of(edge[1]), length_of(edge[2]), length_of(edge[3])};
  }
  double longest_diagonal() const { return std::max(length_of(edge[0] + edge[1]), length_of(edge[1] + edge[2])); }

  /// The Jacobian determinants of the corners, as seen along the normal at the centre; 0 if that has no length.
  std::array<double, 4> determinants() const {
    vec3 n = cross(axis(0), axis(1));
    const double length = length_of(n);
    if (length == 0) return {};
    n /= length;
    return {dot(n, corner_normal(0)), dot(n, corner_normal(1)), dot(n, corner_normal(2)), dot(n, corner_normal(3))};
  }
  static double smallest(const std::array<double, 4>& x) { return *std::min_element(x.begin(), x.end()); }
  static double largest(const std::array<double, 4>& x) { return *std::max_element(x.begin(), x.end()); }
  static double sum(const std::array<double, 4>& x) { return x[0] + x[1] + x[2] + x[3]; }

  double area() const { return sum(determinants()) / 4; }
  double aspect_ratio() const { return ratio_or_infinite(largest(lengths()) * sum(lengths()), sum(determinants())); }
  double condition() const {
    const auto det = determinants();
    double q = 0;
    for (unsigned i = 0; i < 4; ++i)
      q = std::max(q, ratio_or_infinite(length_squared(i) + length_squared((i + 3) % 4), 2 * det[i]));
    return q;
  }
  /// The smallest Jacobian determinant at the verts and at Gauss points of a shell: of the bilinear surface and of the
  /// normals at the verts, interpolated. Where that is not flat, as in Verdict, also half of the shell's thickness
  /// above and below, which is a thousandth of the root of its area.
  double distortion() const {
    const double near = (1 + 1 / std::numbers::sqrt3) / 2, far = 1 - near;
    const vec3 centre = cross(axis(0), axis(1));
    vec3 n[4];
    double q = no_limit, area = 0;
    bool flat = true;
    for (unsigned i = 0; i < 4; ++i) {
      n[i] = corner_normal(i);
      const double length = length_of(n[i]);
      q = std::min(q, std::copysign(length, dot(n[i], centre)));
      if (length > 0) n[i] /= length;
      flat = flat && std::abs(dot(n[0], n[i])) >= 0.99;
      area +=
          length_of(cross(near * edge[i] - far * edge[(i + 2) % 4], far * edge[(i + 1) % 4] - near * before(i))) / 4;
    }
    if (area == 0) return 0;
    const double half = flat ? 0 : 0.0005 * std::sqrt(area) / std::numbers::sqrt3;
    for (const double height : {-half, half}) {
      vec3 e[4];
      for (unsigned i = 0; i < 4; ++i) e[i] = edge[i] + height * (n[(i + 1) % 4] - n[i]);
      for (unsigned i = 0; i < 4; ++i) {
        const vec3 normal =
            near * near * n[i] + near * far * (n[(i + 1) % 4] + n[(i + 3) % 4]) + far * far * n[(i + 2) % 4];
        q = std::min(
            q, dot(normal, cross(near * e[i] - far * e[(i + 2) % 4], far * e[(i + 1) % 4] - near * e[(i + 3) % 4])));
      }
    }
    return q / area;
  }
  double edge_ratio() const { return ratio_or_infinite(largest(lengths()), smallest(lengths())); }
  double jacobian() const { return smallest(determinants()); }
  double frobenius_of_corner(unsigned i) const {
    return ratio_or_infinite(length_squared(i) + length_squared((i + 3) % 4), 2 * length_of(corner_normal(i)));
  }
  double max_aspect_frobenius() const {
    return largest({frobenius_of_corner(0), frobenius_of_corner(1), frobenius_of_corner(2), frobenius_of_corner(3)});
  }
  double med_aspect_frobenius() const {
    return sum({frobenius_of_corner(0), frobenius_of_corner(1), frobenius_of_corner(2), frobenius_of_corner(3)}) / 4;
  }
  double max_edge_ratio() const {
    const double x = length_of(axis(0)), y = length_of(axis(1));
    return ratio_or_infinite(std::max(x, y), std::min(x, y));
  }
  /// Angles at concave corners are more than 180 degrees.
  std::array<double, 4> angles() const {
    const auto det = determinants();
    std::array<double, 4> q;
    for (unsigned i = 0; i < 4; ++i) {
      const double angle = angle_in_degrees(edge[i], -before(i));
      q[i] = det[i] < 0 ? 360 - angle : angle;
    }
    return q;
  }
  double maximum_angle() const { return smallest(lengths()) == 0 ? 360 : largest(angles()); }
  double minimum_angle() const { return smallest(lengths()) == 0 ? 0 : smallest(angles()); }
  double equiangle_skew() const { return skew_of_angles(minimum_angle(), maximum_angle(), 90); }
  double oddy() const {
    double q = 0;
    for (unsigned i = 0; i < 4; ++i) {
      const double difference = length_squared(i) - length_squared((i + 3) % 4), product = dot(edge[i], before(i));
      const vec3 n = corner_normal(i);
      q = std::max(q, ratio_or_infinite(difference * difference + 4 * product * product, 2 * dot(n, n)));
    }
    return q;
  }
  double radius_ratio() const {
    const double squares = length_squared(0) + length_squared(1) + length_squared(2) + length_squared(3);
    const double smallest_area = smallest({length_of(corner_normal(0)), length_of(corner_normal(1)),
                                           length_of(corner_normal(2)), length_of(corner_normal(3))});
    return ratio_or_infinite(std::sqrt(squares) * std::max(largest(lengths()), longest_diagonal()),
                             2 * std::numbers::sqrt2 * smallest_area);
  }
  double relative_size_squared() const { return squared_relative_size(area(), mean_size); }
  double scaled_jacobian() const {
    const auto det = determinants();
    const auto l = lengths();
    double q = 1;
    for (unsigned i = 0; i < 4; ++i) q = std::min(q, l[i] * l[(i + 3) % 4] > 0 ? det[i] / (l[i] * l[(i + 3) % 4]) : 0);
    return std::max(-1.0, q);
  }
  double mean_ratio() const {
    const auto det = determinants();
    double q = 1;
    for (unsigned i = 0; i < 4; ++i) {
      const double squares = length_squared(i) + length_squared((i + 3) % 4);
      q = std::min(q, squares > 0 ? 2 * det[i] / squares : 0);
    }
    return q;
  }
  double shape() const { return std::max(0.0, mean_ratio()); }
  double shape_and_size() const { return shape() * relative_size_squared(); }
  double shear() const { return std::max(0.0, scaled_jacobian()); }
  double shear_and_size() const { return shear() * relative_size_squared(); }
  double skew() const {
    const double x = length_of(axis(0)), y = length_of(axis(1));
    return x * y > 0 ? std::min(1.0, std::abs(dot(axis(0), axis(1))) / (x * y)) : 1;
  }
  double stretch() const { return ratio_or_zero(std::numbers::sqrt2 * smallest(lengths()), longest_diagonal()); }
  double taper() const {
    return ratio_or_infinite(length_of(edge[0] + edge[2]), std::min(length_of(axis(0)), length_of(axis(1))));
  }
  double warpage() const {
    vec3 n[4];
    for (unsigned i = 0; i < 4; ++i) {
      n[i] = corner_normal(i);
      const double length = length_of(n[i]);
      if (length == 0) return no_limit;
      n[i] /= length;
    }
    const double cosine = std::min(dot(n[0], n[2]), dot(n[1], n[3]));
    return std::clamp(1 - cosine * cosine * cosine, 0.0, 2.0);
  }
};

CONCINO_INLINE std::span<const metric_row> quad_rows() {
  using q = quad_metrics;
  static constexpr metric_row rows[] = {
      {metric::area, metric_of<q, &q::area>, size_of(1, 2)},
      {metric::aspect_ratio, metric_of<q, &q::aspect_ratio>, ratio_to(1.3)},
      {metric::condition, metric_of<q, &q::condition>, ratio_to(4)},
      {metric::distortion, metric_of<q, &q::distortion>, {{0.5, 1}, {-no_limit, no_limit}, 1, 0}},
      {metric::edge_ratio, metric_of<q, &q::edge_ratio>, ratio_to(1.3)},
      {metric::equiangle_skew, metric_of<q, &q::equiangle_skew>, deviation_to(0.5, no_limit)},
      {metric::jacobian, metric_of<q, &q::jacobian>, size_of(1, 2)},
      {metric::max_aspect_frobenius, metric_of<q, &q::max_aspect_frobenius>, ratio_to(1.3)},
      {metric::max_edge_ratio, metric_of<q, &q::max_edge_ratio>, ratio_to(1.3)},
      {metric::maximum_angle, metric_of<q, &q::maximum_angle>, {{90, 135}, {0, 360}, 90, 0}},
      {metric::mean_ratio, metric_of<q, &q::mean_ratio>, signed_part_from(0.3)},
      {metric::med_aspect_frobenius, metric_of<q, &q::med_aspect_frobenius>, ratio_to(1.3)},
      {metric::minimum_angle, metric_of<q, &q::minimum_angle>, {{45, 90}, {0, 360}, 90, 0}},
      {metric::oddy, metric_of<q, &q::oddy>, deviation_to(0.5, no_limit)},
      {metric::radius_ratio, metric_of<q, &q::radius_ratio>, ratio_to(1.3)},
      {metric::relative_size_squared, metric_of<q, &q::relative_size_squared>, relative_from(0.3)},
      {metric::scaled_jacobian, metric_of<q, &q::scaled_jacobian>, signed_part_from(0.3)},
      {metric::shape, metric_of<q, &q::shape>, part_from(0.3)},
      {metric::shape_and_size, metric_of<q, &q::shape_and_size>, relative_from(0.2)},
      {metric::shear, metric_of<q, &q::shear>, part_from(0.3)},
      {metric::shear_and_size, metric_of<q, &q::shear_and_size>, relative_from(0.2)},
      {metric::skew, metric_of<q, &q::skew>, deviation_to(0.5, 1)},
      {metric::stretch, metric_of<q, &q::stretch>, {{0.25, 1}, {0, no_limit}, 1, 0}},
      {metric::taper, metric_of<q, &q::taper>, deviation_to(0.7, no_limit)},
      {metric::warpage, metric_of<q, &q::warpage>, deviation_to(0.7, no_limit)},
  };
  return rows;
}

}  // namespace concino::detail
