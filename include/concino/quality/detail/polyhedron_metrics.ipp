// Defines the quality metrics of all volume cells, those of prisms and pyramids among them. Those of tets and hexes
// that have the same names agree.
#pragma once

#include <concino/core/small_array.hpp>
#include <concino/quality/detail/metric_row.hpp>
#include <concino/quality/detail/kernel_fraction.hpp>

namespace concino::detail {

struct polyhedron_metrics {
  /// Three edges of a vert: all of them, or, if there are more, three in succession, the middle one last.
  struct corner {
    vec3 u, v, w;
  };
  /// What corners are compared with: the inverse of the matrix of scalar products of unit edges in the regular shape,
  /// and their determinant.
  struct regular_corner {
    double uu, vv, ww, uv, vw, wu, det;
  };
  static constexpr regular_corner of_cube{1, 1, 1, 0, 0, 0, 1};
  // all angles of 60 degrees
  static constexpr regular_corner of_tet{1.5, 1.5, 1.5, -0.5, -0.5, -0.5, 0.70710678118654752};
  // 60 degrees between u and v
  static constexpr regular_corner of_prism{4.0 / 3, 4.0 / 3, 1, -2.0 / 3, 0, 0, 0.86602540378443865};
  // 90 degrees between u and v, else 60
  static constexpr regular_corner of_pyramid{1.5, 1.5, 2, 0.5, -1, -1, 0.70710678118654752};

  const poly_geometry& g;

  explicit polyhedron_metrics(const poly_geometry& of) : g(of) {}

  const regular_corner& regular() const {
    static constexpr regular_corner of_shape[] = {of_cube, of_cube,  of_cube,    of_tet,
                                                  of_cube, of_prism, of_pyramid, of_cube};
    return of_shape[static_cast<unsigned>(g.shape)];
  }
  std::span<const unsigned> face(std::size_t k) const {
    return g.face_verts.subspan(g.face_begins[k], g.face_begins[k + 1] - g.face_begins[k]);
  }
  std::size_t num_faces() const { return g.face_begins.size() - 1; }

  /// Calls f(corner) for each. Faces at a vert follow one another: the edge by which a loop arrives is that by which
  /// the next one leaves.
  template<class F> void for_each_corner(const F& f) const {
    const auto num_verts = static_cast<unsigned>(g.points.size());
    core::small_array<unsigned, 64> links(2 * g.points.size(), num_verts);
    // of each neighbour, around the vert
    const std::span<unsigned> after(links.data(), num_verts), before(links.data() + num_verts, num_verts);
    for (unsigned v = 0; v < num_verts; ++v) {
      std::fill(links.begin(), links.end(), num_verts);
      unsigned valence = 0, last = 0;
      for (std::size_t k = 0; k < num_faces(); ++k) {
        const auto loop = face(k);
        for (std::size_t i = 0; i < loop.size(); ++i) {
          if (loop[i] != v) continue;
          const unsigned a = loop[i == 0 ? loop.size() - 1 : i - 1], b = loop[i + 1 == loop.size() ? 0 : i + 1];
          after[a] = b, before[b] = a;
          last = std::max(last, a);
          ++valence;
        }
      }
      if (g.shape == poly_shape::prism) last = (v + 3) % 6;  // the edge that is not one of a triangle
      for (unsigned a = 0; a < num_verts; ++a) {
        if (after[a] == num_verts || before[a] == num_verts || (valence <= 3 && a != last)) continue;
        f(corner{g.points[after[a]] - g.points[v], g.points[before[a]] - g.points[v], g.points[a] - g.points[v]});
      }
    }
  }
  template<class F> double smallest_at_corners(const F& f) const {
    double q = 1;
    for_each_corner([&](const corner& c) { q = std::min(q, f(c)); });
    return std::max(-1.0, q);
  }
  value_range squared_lengths() const {
    value_range r{no_limit, 0};
    for (std::size_t k = 0; k < num_faces(); ++k) {
      const auto loop = face(k);
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const vec3 e = g.points[loop[i + 1 == loop.size() ? 0 : i + 1]] - g.points[loop[i]];
        const double q = dot(e, e);
        r.low = std::min(r.low, q), r.high = std::max(r.high, q);
      }
    }
    return r;
  }

  double volume() const {
    double sum = 0;
    for (std::size_t k = 0; k < num_faces(); ++k) {
      const auto loop = face(k);
      vec3 total, doubled;
      for (const unsigned v : loop) total += g.points[v] - g.points[0];
      for (std::size_t i = 1; i + 1 < loop.size(); ++i)
        doubled += cross(g.points[loop[i]] - g.points[loop[0]], g.points[loop[i + 1]] - g.points[loop[0]]);
      sum += dot(total, doubled) / static_cast<double>(loop.size());
    }
    return sum / 6;
  }
  double edge_ratio() const {
    const value_range r = squared_lengths();
    return ratio_or_infinite(std::sqrt(r.high), std::sqrt(r.low));
  }
  /// That of the worst face.
  double equiangle_skew() const {
    double q = 0;
    for (std::size_t k = 0; k < num_faces(); ++k) {
      const auto loop = face(k);
      const std::size_t n = loop.size();
      value_range angles{180, 0};
      for (std::size_t i = 0; i < n; ++i) {
        const vec3& at = g.points[loop[i]];
        const double angle = angle_in_degrees(g.points[loop[(i + 1) % n]] - at, g.points[loop[(i + n - 1) % n]] - at);
        angles = {std::min(angles.low, angle), std::max(angles.high, angle)};
      }
      q = std::max(q, skew_of_angles(angles.low, angles.high, 180 - 360 / static_cast<double>(n)));
    }
    return q;
  }
  double relative_size_squared() const { return squared_relative_size(volume(), g.mean_size); }
  double scaled_jacobian() const {
    const double det = regular().det;
    return smallest_at_corners([&](const corner& c) {
      const double lengths = length_of(c.u) * length_of(c.v) * length_of(c.w);
      return lengths > 0 ? dot(c.u, cross(c.v, c.w)) / (lengths * det) : 0;
    });
  }
  double mean_ratio() const {
    const regular_corner& k = regular();
    return smallest_at_corners([&](const corner& c) {
      const double root = std::cbrt(dot(c.u, cross(c.v, c.w)) / k.det);
      const double squares = k.uu * dot(c.u, c.u) + k.vv * dot(c.v, c.v) + k.ww * dot(c.w, c.w) +
                             2 * (k.uv * dot(c.u, c.v) + k.vw * dot(c.v, c.w) + k.wu * dot(c.w, c.u));
      return squares > 0 ? (root < 0 ? -3 : 3) * root * root / squares : 0;
    });
  }
  double planarity() const {
    double q = 1;
    for (std::size_t k = 0; k < num_faces(); ++k) {
      const auto loop = face(k);
      q = std::min(q, planarity_of_loop(loop.size(), [&](std::size_t i) -> const vec3& { return g.points[loop[i]]; }));
    }
    return q;
  }
  double star_shapedness() const { return kernel_fraction_of_polyhedron(g, volume()); }
};

CONCINO_INLINE std::span<const metric_row> polyhedron_rows() {
  using s = polyhedron_metrics;
  static constexpr metric_row rows[] = {
      {metric::edge_ratio, metric_of<s, &s::edge_ratio>, ratio_to(3)},
      {metric::equiangle_skew, metric_of<s, &s::equiangle_skew>, deviation_to(0.5, 1)},
      {metric::mean_ratio, metric_of<s, &s::mean_ratio>, signed_part_from(0.3)},
      {metric::planarity, metric_of<s, &s::planarity>, part_from(0.9)},
      {metric::relative_size_squared, metric_of<s, &s::relative_size_squared>, relative_from(0.3)},
      {metric::scaled_jacobian, metric_of<s, &s::scaled_jacobian>, signed_part_from(0.3)},
      {metric::star_shapedness, metric_of<s, &s::star_shapedness>, part_from(0.1)},
      {metric::volume, metric_of<s, &s::volume>, size_of(no_ideal, 3)},
  };
  return rows;
}

}  // namespace concino::detail
