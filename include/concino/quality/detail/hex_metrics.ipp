// Defines the quality metrics of hexes, as in the chapter on hexahedra of the Verdict manual.
#pragma once

#include <concino/quality/detail/metric_row.hpp>

namespace concino::detail {

struct hex_metrics {
  /// The vectors along the three edges of a corner, or along the principal axes: the columns of a Jacobian matrix.
  struct frame {
    vec3 u, v, w;
    double determinant() const { return dot(u, cross(v, w)); }
    double squares() const { return dot(u, u) + dot(v, v) + dot(w, w); }
    double condition() const {
      const vec3 a = cross(u, v), b = cross(v, w), c = cross(w, u);
      return ratio_or_infinite(std::sqrt(squares() * (dot(a, a) + dot(b, b) + dot(c, c))), 3 * determinant());
    }
    double scaled_determinant() const {
      const double lengths = length_of(u) * length_of(v) * length_of(w);
      return lengths > 0 ? std::clamp(determinant() / lengths, -1.0, 1.0) : 0;
    }
    double mean_ratio() const {
      const double root = std::cbrt(determinant()), sum = squares();
      return sum > 0 ? std::clamp((root < 0 ? -3 : 3) * root * root / sum, -1.0, 1.0) : 0;
    }
    double oddy() const {
      const double uu = dot(u, u), vv = dot(v, v), ww = dot(w, w), uv = dot(u, v), vw = dot(v, w), wu = dot(w, u);
      const double tensor = uu * uu + vv * vv + ww * ww + 2 * (uv * uv + vw * vw + wu * wu), trace = uu + vv + ww,
                   det = determinant();
      return det > 0 ? std::max(0.0, tensor - trace * trace / 3) / (det * std::cbrt(det)) : no_limit;
    }
  };
  static constexpr unsigned edges[12][2] = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6},
                                            {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
  static constexpr unsigned corners[8][3] = {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7},
                                             {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}};
  static constexpr unsigned faces[6][4] = {{0, 3, 2, 1}, {1, 2, 6, 5}, {4, 5, 6, 7},
                                           {3, 0, 4, 7}, {0, 1, 5, 4}, {2, 3, 7, 6}};

  std::span<const vec3> p;
  double mean_size;

  explicit hex_metrics(const poly_geometry& g) : p(g.points), mean_size(g.mean_size) {}

  frame corner(unsigned i) const { return {p[corners[i][0]] - p[i], p[corners[i][1]] - p[i], p[corners[i][2]] - p[i]}; }
  /// The principal axes; 0 if they are so short that they consist of rounding errors.
  frame axes() const {
    frame f{(p[1] - p[0]) + (p[2] - p[3]) + (p[5] - p[4]) + (p[6] - p[7]),
            (p[3] - p[0]) + (p[2] - p[1]) + (p[7] - p[4]) + (p[6] - p[5]),
            (p[4] - p[0]) + (p[5] - p[1]) + (p[6] - p[2]) + (p[7] - p[3])};
    const double rounding = 1e-15 * std::sqrt(f.squares());
    for (vec3* const x : {&f.u, &f.v, &f.w})
      if (length_of(*x) < rounding) *x = {};
    return f;
  }
  /// The smallest or largest value of f at the corners.
  template<class F> double smallest_at_corners(const F& f) const {
    double q = f(corner(0));
    for (unsigned i = 1; i < 8; ++i) q = std::min(q, f(corner(i)));
    return q;
  }
  template<class F> double largest_at_corners(const F& f) const {
    double q = f(corner(0));
    for (unsigned i = 1; i < 8; ++i) q = std::max(q, f(corner(i)));
    return q;
  }
  double shortest_edge() const {
    double q = no_limit;
    for (const auto& e : edges) q = std::min(q, length_of(p[e[1]] - p[e[0]]));
    return q;
  }
  double longest_edge() const {
    double q = 0;
    for (const auto& e : edges) q = std::max(q, length_of(p[e[1]] - p[e[0]]));
    return q;
  }
  std::array<double, 4> diagonals() const {
    return {length_of(p[6] - p[0]), length_of(p[7] - p[1]), length_of(p[4] - p[2]), length_of(p[5] - p[3])};
  }

  double diagonal() const {
    const auto d = diagonals();
    return ratio_or_zero(*std::min_element(d.begin(), d.end()), *std::max_element(d.begin(), d.end()));
  }
  /// The volume under the bilinear surfaces through the verts of the faces, and its gradients with respect to the
  /// verts.
  double volume_and_gradients(vec3 (&gradient)[8]) const {
    double sum = 0;
    for (const auto& f : faces) {
      const vec3 a = p[f[0]] - p[0], b = p[f[1]] - p[0], c = p[f[2]] - p[0], d = p[f[3]] - p[0];
      const vec3 total = a + b + c + d, along = c - a, across = d - b, normal = cross(along, across),
                 s = cross(across, total), t = cross(total, along);
      sum += dot(total, normal);
      gradient[f[0]] += normal - s, gradient[f[1]] += normal - t, gradient[f[2]] += normal + s,
          gradient[f[3]] += normal + t;
    }
    return sum / 24;
  }
  double volume() const {
    vec3 gradient[8];
    return volume_and_gradients(gradient);
  }
  double dimension() const {
    vec3 gradient[8];
    const double v = std::abs(volume_and_gradients(gradient));
    double squares = 0;
    for (const vec3& g : gradient) squares += dot(g, g) / 576;
    return ratio_or_zero(v, std::sqrt(2 * squares));
  }
  /// The smallest Jacobian determinant at the verts and at 2 x 2 x 2 Gauss points, over the volume.
  double distortion() const {
    const double v = volume();
    if (v == 0) return 0;
    const double near = (1 + 1 / std::numbers::sqrt3) / 4, far = (1 - 1 / std::numbers::sqrt3) / 4;
    double q = no_limit;
    for (unsigned i = 0; i < 8; ++i) {
      q = std::min(q, corner(i).determinant() / v);
      // Derivatives along an axis at the Gauss point nearest to vert i: means of the 4 edges along it, by their
      // distances.
      const unsigned x = i & 1u, y = i >> 1 & 1u, z = i >> 2;
      const double wx[2] = {x ? far : near, x ? near : far}, wy[2] = {y ? far : near, y ? near : far},
                   wz[2] = {z ? far : near, z ? near : far};
      const frame f{wy[0] * wz[0] * (p[1] - p[0]) + wy[1] * wz[0] * (p[2] - p[3]) + wy[0] * wz[1] * (p[5] - p[4]) +
                        wy[1] * wz[1] * (p[6] - p[7]),
                    wx[0] * wz[0] * (p[3] - p[0]) + wx[1] * wz[0] * (p[2] - p[1]) + wx[0] * wz[1] * (p[7] - p[4]) +
                        wx[1] * wz[1] * (p[6] - p[5]),
                    wx[0] * wy[0] * (p[4] - p[0]) + wx[1] * wy[0] * (p[5] - p[1]) + wx[1] * wy[1] * (p[6] - p[2]) +
                        wx[0] * wy[1] * (p[7] - p[3])};
      q = std::min(q, 64 * f.determinant() / v);  // the weights sum up to 1/4
    }
    return q;
  }
  double edge_ratio() const { return ratio_or_infinite(longest_edge(), shortest_edge()); }
  double equiangle_skew() const {
    double low = 180, high = 0;
    for (const auto& f : faces)
      for (unsigned i = 0; i < 4; ++i) {
        const double angle = angle_in_degrees(p[f[(i + 1) % 4]] - p[f[i]], p[f[(i + 3) % 4]] - p[f[i]]);
        low = std::min(low, angle), high = std::max(high, angle);
      }
    return skew_of_angles(low, high, 90);
  }
  double jacobian() const {
    return std::min(smallest_at_corners([](const frame& f) { return f.determinant(); }), axes().determinant() / 64);
  }
  double max_aspect_frobenius() const { return largest_at_corners([](const frame& f) { return f.condition(); }); }
  double med_aspect_frobenius() const {
    double sum = 0;
    for (unsigned i = 0; i < 8; ++i) sum += corner(i).condition();
    return sum / 8;
  }
  double max_edge_ratio() const {
    const frame f = axes();
    const double x = length_of(f.u), y = length_of(f.v), z = length_of(f.w);
    return ratio_or_infinite(std::max({x, y, z}), std::min({x, y, z}));
  }
  double nodal_jacobian_ratio() const {
    const auto det = [](const frame& f) { return f.determinant(); };
    const double largest = largest_at_corners(det);
    return largest > 0 ? smallest_at_corners(det) / largest : -no_limit;
  }
  double oddy() const { return std::max(largest_at_corners([](const frame& f) { return f.oddy(); }), axes().oddy()); }
  double relative_size_squared() const { return squared_relative_size(volume(), mean_size); }
  double scaled_jacobian() const {
    return std::min(smallest_at_corners([](const frame& f) { return f.scaled_determinant(); }),
                    axes().scaled_determinant());
  }
  double mean_ratio() const {
    return std::min(smallest_at_corners([](const frame& f) { return f.mean_ratio(); }), axes().mean_ratio());
  }
  double shape() const { return std::max(0.0, mean_ratio()); }
  double shape_and_size() const { return shape() * relative_size_squared(); }
  double shear() const { return std::max(0.0, scaled_jacobian()); }
  double shear_and_size() const { return shear() * relative_size_squared(); }
  double skew() const {
    const frame f = axes();
    const double x = length_of(f.u), y = length_of(f.v), z = length_of(f.w);
    if (!(std::min({x, y, z}) > 0)) return no_limit;
    return std::min(1.0, std::max({std::abs(dot(f.u, f.v)) / (x * y), std::abs(dot(f.u, f.w)) / (x * z),
                                   std::abs(dot(f.v, f.w)) / (y * z)}));
  }
  double stretch() const {
    const auto d = diagonals();
    return ratio_or_zero(std::numbers::sqrt3 * shortest_edge(), *std::max_element(d.begin(), d.end()));
  }
  double taper() const {
    const frame f = axes();
    const double x = length_of(f.u), y = length_of(f.v), z = length_of(f.w);
    const double xy = length_of((p[2] - p[3]) - (p[1] - p[0]) + (p[6] - p[7]) - (p[5] - p[4]));
    const double xz = length_of((p[5] - p[1]) - (p[4] - p[0]) + (p[6] - p[2]) - (p[7] - p[3]));
    const double yz = length_of((p[7] - p[4]) - (p[3] - p[0]) + (p[6] - p[5]) - (p[2] - p[1]));
    return std::max({ratio_or_infinite(xy, std::min(x, y)), ratio_or_infinite(xz, std::min(x, z)),
                     ratio_or_infinite(yz, std::min(y, z))});
  }
};

CONCINO_INLINE std::span<const metric_row> hex_rows() {
  using h = hex_metrics;
  static constexpr metric_row rows[] = {
      {metric::condition, metric_of<h, &h::max_aspect_frobenius>, ratio_to(3)},  // another name
      {metric::diagonal, metric_of<h, &h::diagonal>, part_from(0.65)},
      {metric::dimension, metric_of<h, &h::dimension>, {{0, no_limit}, {0, no_limit}, std::numbers::inv_sqrt3, 1}},
      {metric::distortion, metric_of<h, &h::distortion>, {{0.5, 1}, {-no_limit, no_limit}, 1, 0}},
      {metric::edge_ratio, metric_of<h, &h::edge_ratio>, ratio_to(no_limit)},
      {metric::equiangle_skew, metric_of<h, &h::equiangle_skew>, deviation_to(0.5, 1)},
      {metric::jacobian, metric_of<h, &h::jacobian>, size_of(1, 3)},
      {metric::max_aspect_frobenius, metric_of<h, &h::max_aspect_frobenius>, ratio_to(3)},
      {metric::max_edge_ratio, metric_of<h, &h::max_edge_ratio>, ratio_to(1.3)},
      {metric::mean_ratio, metric_of<h, &h::mean_ratio>, signed_part_from(0.3)},
      {metric::med_aspect_frobenius, metric_of<h, &h::med_aspect_frobenius>, ratio_to(3)},
      {metric::nodal_jacobian_ratio, metric_of<h, &h::nodal_jacobian_ratio>, {{0, 1}, {-no_limit, 1}, 1, 0}},
      {metric::oddy, metric_of<h, &h::oddy>, deviation_to(0.5, no_limit)},
      {metric::relative_size_squared, metric_of<h, &h::relative_size_squared>, relative_from(0.5)},
      {metric::scaled_jacobian, metric_of<h, &h::scaled_jacobian>, signed_part_from(0.5)},
      {metric::shape, metric_of<h, &h::shape>, part_from(0.3)},
      {metric::shape_and_size, metric_of<h, &h::shape_and_size>, relative_from(0.2)},
      {metric::shear, metric_of<h, &h::shear>, part_from(0.3)},
      {metric::shear_and_size, metric_of<h, &h::shear_and_size>, relative_from(0.2)},
      {metric::skew, metric_of<h, &h::skew>, deviation_to(0.5, no_limit)},
      {metric::stretch, metric_of<h, &h::stretch>, {{0.25, 1}, {0, no_limit}, 1, 0}},
      {metric::taper, metric_of<h, &h::taper>, deviation_to(0.5, no_limit)},
      {metric::volume, metric_of<h, &h::volume>, size_of(1, 3)},
  };
  return rows;
}

}  // namespace concino::detail
