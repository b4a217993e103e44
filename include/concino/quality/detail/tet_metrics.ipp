// Defines the quality metrics of tets, as in the chapter on tetrahedra of the Verdict manual.
#pragma once

#include <concino/quality/detail/metric_row.hpp>

namespace concino::detail {

struct tet_metrics {
  vec3 edge[6];  // 01 12 20 03 13 23
  double mean_size;

  explicit tet_metrics(const poly_geometry& g) : mean_size(g.mean_size) {
    const auto& p = g.points;
    edge[0] = p[1] - p[0], edge[1] = p[2] - p[1], edge[2] = p[0] - p[2], edge[3] = p[3] - p[0], edge[4] = p[3] - p[1],
    edge[5] = p[3] - p[2];
  }

  double squared(unsigned i) const { return dot(edge[i], edge[i]); }
  double squared_edges() const { return squared(0) + squared(1) + squared(2) + squared(3) + squared(4) + squared(5); }
  std::array<double, 6> lengths() const {
    return {length_of(edge[0]), length_of(edge[1]), length_of(edge[2]),
            length_of(edge[3]), length_of(edge[4]), length_of(edge[5])};
  }
  static double largest(const std::array<double, 6>& x) { return *std::max_element(x.begin(), x.end()); }
  static double smallest(const std::array<double, 6>& x) { return *std::min_element(x.begin(), x.end()); }
  /// Twice the areas of the faces opposite the verts.
  std::array<double, 4> doubled_areas() const {
    return {length_of(cross(edge[1], edge[4])), length_of(cross(edge[2], edge[3])), length_of(cross(edge[0], edge[3])),
            length_of(cross(edge[2], edge[0]))};
  }
  double surface() const {
    const auto a = doubled_areas();
    return (a[0] + a[1] + a[2] + a[3]) / 2;
  }

  double jacobian() const { return dot(cross(edge[2], edge[0]), edge[3]); }
  double volume() const { return jacobian() / 6; }
  double aspect_frobenius() const { return ratio_or_infinite(1, std::abs(mean_ratio())); }
  double aspect_gamma() const {
    const double root_mean_square = std::sqrt(squared_edges() / 6);
    return ratio_or_infinite(root_mean_square * root_mean_square * root_mean_square,
                             std::numbers::sqrt2 * std::abs(jacobian()));
  }
  double aspect_ratio() const {
    return ratio_or_infinite(largest(lengths()) * surface(), std::sqrt(6.0) * std::abs(jacobian()));
  }
  double circumradius() const {
    return length_of(squared(3) * cross(edge[2], edge[0]) + squared(2) * cross(edge[3], edge[0]) +
                     squared(0) * cross(edge[3], edge[2])) /
           (2 * std::abs(jacobian()));
  }
  double inradius() const {
    const double area = surface();
    return area > 0 ? jacobian() / (2 * area) : 0;
  }
  double radius_ratio() const { return jacobian() != 0 ? circumradius() / (3 * std::abs(inradius())) : no_limit; }
  double aspect_beta() const { return jacobian() > 0 ? radius_ratio() : no_limit; }
  static double inradius_of(const vec3& a, const vec3& b, const vec3& c, const vec3& d) {
    const vec3 u = b - a, v = c - a, w = d - a;
    return ratio_or_zero(std::abs(dot(cross(u, v), w)), length_of(cross(u, v)) + length_of(cross(v, w)) +
                                                            length_of(cross(w, u)) + length_of(cross(v - u, w - u)));
  }
  /// The smallest inradius of 12 parts, over the circumradius; divided by that of the regular tet. The parts are 4 tets
  /// at the verts, up to the midpoints of edges, and 8 in the octahedron between these midpoints, about their mean.
  double normalized_inradius() const {
    const double det = jacobian();
    if (det == 0) return 0;
    const vec3 p[] = {{}, edge[0], -edge[2], edge[3]};
    const vec3 mean = (p[1] + p[2] + p[3]) / 4;
    double q = no_limit;
    for (unsigned k = 0; k < 4; ++k) {
      const vec3 &a = p[k], &b = p[(k + 1) % 4], &c = p[(k + 2) % 4], &d = p[(k + 3) % 4];
      const vec3 ab = (a + b) / 2, ac = (a + c) / 2, ad = (a + d) / 2, bc = (b + c) / 2, bd = (b + d) / 2,
                 cd = (c + d) / 2;
      q = std::min({q, inradius_of(a, ab, ac, ad), inradius_of(ab, ac, ad, mean), inradius_of(bc, bd, cd, mean)});
    }
    return std::copysign(q / circumradius() * 6 / (std::numbers::sqrt3 - 1), det);
  }
  double collapse_ratio() const {
    static constexpr unsigned face_edges[4][3] = {{1, 4, 5}, {2, 3, 5}, {0, 3, 4}, {0, 1, 2}};  // opposite the verts
    const auto l = lengths();
    const auto a = doubled_areas();
    double largest_product = 0;
    for (unsigned i = 0; i < 4; ++i) {
      const unsigned* const e = face_edges[i];
      largest_product = std::max(largest_product, a[i] * std::max({l[e[0]], l[e[1]], l[e[2]]}));
    }
    return largest_product > 0 ? jacobian() / largest_product : 0;
  }
  /// The condition number of the matrix that maps the corner of a regular tet to a corner.
  double condition() const {
    const vec3 c1 = edge[0], c2 = (-2 * edge[2] - edge[0]) / std::numbers::sqrt3,
               c3 = (3 * edge[3] + edge[2] - edge[0]) / std::sqrt(6.0);
    const vec3 n12 = cross(c1, c2), n23 = cross(c2, c3), n31 = cross(c3, c1);
    const double t1 = dot(c1, c1) + dot(c2, c2) + dot(c3, c3), t2 = dot(n12, n12) + dot(n23, n23) + dot(n31, n31);
    return ratio_or_infinite(std::sqrt(t1 * t2), 3 * dot(c1, n23));
  }
  double distortion() const { return 1; }  // the map of a tet is linear
  double edge_ratio() const { return ratio_or_infinite(largest(lengths()), smallest(lengths())); }

  /// The dihedral angles at the edges, in degrees.
  std::array<double, 6> dihedral_angles() const {
    // along the edge, and from its start to the two other verts
    const vec3 arms[6][3] = {{edge[0], -edge[2], edge[3]}, {edge[1], -edge[0], edge[4]}, {edge[2], -edge[1], edge[5]},
                             {edge[3], edge[0], -edge[2]}, {edge[4], edge[1], -edge[0]}, {edge[5], edge[2], -edge[1]}};
    std::array<double, 6> angle;
    for (unsigned i = 0; i < 6; ++i)
      angle[i] = angle_in_degrees(cross(arms[i][0], arms[i][1]), cross(arms[i][0], arms[i][2]));
    return angle;
  }
  double minimum_angle() const { return smallest(dihedral_angles()); }
  double equiangle_skew() const {
    const auto dihedral = dihedral_angles();
    const vec3 faces[4][3] = {{edge[1], edge[5], -edge[4]},
                              {edge[2], edge[3], -edge[5]},
                              {edge[0], edge[4], -edge[3]},
                              {edge[0], edge[1], edge[2]}};
    double low = 180, high = 0;
    for (const auto& f : faces)
      for (unsigned i = 0; i < 3; ++i) {
        const double angle = angle_in_degrees(f[i], -f[(i + 2) % 3]);
        low = std::min(low, angle), high = std::max(high, angle);
      }
    return std::max(skew_of_angles(low, high, 60),
                    skew_of_angles(smallest(dihedral), largest(dihedral), in_degrees(std::acos(1.0 / 3))));
  }
  double equivolume_skew() const {
    if (jacobian() == 0) return no_limit;
    const double length = circumradius() * std::sqrt(8.0 / 3);
    return 1 - volume() * 6 * std::numbers::sqrt2 / (length * length * length);
  }
  double relative_size_squared() const { return squared_relative_size(volume(), mean_size); }
  double scaled_jacobian() const {
    const auto l = lengths();
    const double det = jacobian();
    const double largest_product =
        std::max({l[0] * l[2] * l[3], l[0] * l[1] * l[4], l[1] * l[2] * l[5], l[3] * l[4] * l[5]});
    return largest_product > 0 ? std::clamp(std::numbers::sqrt2 * det / largest_product, -1.0, 1.0) : 0;
  }
  double mean_ratio() const {
    const double squares = squared_edges(), root = std::cbrt(jacobian() / 2);
    return squares > 0 ? std::clamp((root < 0 ? -12 : 12) * root * root / squares, -1.0, 1.0) : 0;
  }
  double shape() const { return std::max(0.0, mean_ratio()); }
  double shape_and_size() const { return shape() * relative_size_squared(); }
};

CONCINO_INLINE std::span<const metric_row> tet_rows() {
  using t = tet_metrics;
  static constexpr metric_row rows[] = {
      {metric::aspect_beta, metric_of<t, &t::aspect_beta>, ratio_to(3)},
      {metric::aspect_frobenius, metric_of<t, &t::aspect_frobenius>, ratio_to(1.3)},
      {metric::aspect_gamma, metric_of<t, &t::aspect_gamma>, ratio_to(3)},
      {metric::aspect_ratio, metric_of<t, &t::aspect_ratio>, ratio_to(3)},
      // sqrt(2/3)
      {metric::collapse_ratio,
       metric_of<t, &t::collapse_ratio>,
       {{0.1, no_limit}, {-no_limit, no_limit}, 0.81649658092772603, 0}},
      {metric::condition, metric_of<t, &t::condition>, ratio_to(3)},
      {metric::distortion, metric_of<t, &t::distortion>, {{0.5, 1}, {-no_limit, no_limit}, 1, 0}},
      {metric::edge_ratio, metric_of<t, &t::edge_ratio>, ratio_to(3)},
      {metric::equiangle_skew, metric_of<t, &t::equiangle_skew>, deviation_to(0.5, 1)},
      {metric::equivolume_skew, metric_of<t, &t::equivolume_skew>, deviation_to(0.7, no_limit)},
      {metric::inradius, metric_of<t, &t::inradius>, size_of(0.20412414523193151, 1)},  // sqrt(6) / 12
      {metric::jacobian, metric_of<t, &t::jacobian>, size_of(std::numbers::sqrt2 / 2, 3)},
      {metric::mean_ratio, metric_of<t, &t::mean_ratio>, signed_part_from(0.3)},
      {metric::minimum_angle,
       metric_of<t, &t::minimum_angle>,
       {{40, 70.528779365509309}, {0, 70.528779365509309}, 70.528779365509309, 0}},
      {metric::normalized_inradius, metric_of<t, &t::normalized_inradius>, signed_part_from(0.15)},
      {metric::radius_ratio, metric_of<t, &t::radius_ratio>, ratio_to(3)},
      {metric::relative_size_squared, metric_of<t, &t::relative_size_squared>, relative_from(0.3)},
      {metric::scaled_jacobian, metric_of<t, &t::scaled_jacobian>, signed_part_from(0.5)},
      {metric::shape, metric_of<t, &t::shape>, part_from(0.3)},
      {metric::shape_and_size, metric_of<t, &t::shape_and_size>, relative_from(0.2)},
      {metric::volume, metric_of<t, &t::volume>, size_of(std::numbers::sqrt2 / 12, 3)},
  };
  return rows;
}

}  // namespace concino::detail
