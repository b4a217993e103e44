// Bodies of poly_triangles.hpp: the triangles of polys, each laid into the plane: what maps to the plane are measured
// and computed with.
#pragma once

#include <concino/core/error.hpp>
#include <concino/geometry/triangulate_polygon.hpp>
#include <concino/parametrize/detail/poly_triangles.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace concino::detail {

CONCINO_INLINE std::array<double, 2> singular_values(const plane_matrix& j) {
  const double same = std::hypot(j.xx + j.yy, j.yx - j.xy) / 2, mirrored = std::hypot(j.xx - j.yy, j.yx + j.xy) / 2;
  return {same + mirrored, same - mirrored};
}

CONCINO_INLINE plane_matrix plane_triangle::derivative(const uv_point& a, const uv_point& b, const uv_point& c) const {
  const auto& g = gradient;
  // Differences first, so that a constant has the derivative 0.
  const uv_point d{b[0] - a[0], b[1] - a[1]}, e{c[0] - a[0], c[1] - a[1]};
  return {d[0] * g[1][0] + e[0] * g[2][0], d[0] * g[1][1] + e[0] * g[2][1],
          d[1] * g[1][0] + e[1] * g[2][0], d[1] * g[1][1] + e[1] * g[2][1]};
}

/// The triangles of one poly, of which diagonals are flipped until circumcircles are empty.
class empty_circle_flips {
  struct diagonal {
    std::uint32_t low, high, triangle, opposite;
  };
  std::span<const vec3> points_;
  std::vector<polygon_triangle> triangles_;
  struct flip {
    double angles;    // the sum of those opposite to the diagonal
    std::size_t use;  // the first of the two
  };
  std::vector<diagonal> uses_;
  std::vector<flip> flips_;
  std::vector<unsigned char> is_changed_;

  double angle_at(std::uint32_t at, std::uint32_t a, std::uint32_t b) const {
    const vec3 x = points_[a] - points_[at], y = points_[b] - points_[at];
    return std::atan2(norm(cross(x, y)), dot(x, y));
  }

  // The diagonals whose circumcircles are not empty, the worst first, so that the order does not depend on the first
  // corner.
  void find_flips() {
    uses_.clear();
    flips_.clear();
    const auto n = static_cast<std::uint32_t>(points_.size());
    for (std::uint32_t t = 0; t < triangles_.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = triangles_[t][k], b = triangles_[t][(k + 1) % 3];
        if ((a + 1) % n == b || (b + 1) % n == a) continue;
        uses_.push_back({std::min(a, b), std::max(a, b), t, triangles_[t][(k + 2) % 3]});
      }
    std::sort(uses_.begin(), uses_.end(), [](const diagonal& x, const diagonal& y) {
      return std::array{x.low, x.high, x.triangle} < std::array{y.low, y.high, y.triangle};
    });
    for (std::size_t i = 0; i + 1 < uses_.size(); ++i) {
      const diagonal &x = uses_[i], &y = uses_[i + 1];
      if (x.low != y.low || x.high != y.high) continue;
      constexpr double rounding = 1e-9;
      const double sum = angle_at(x.opposite, x.low, x.high) + angle_at(y.opposite, x.low, x.high);
      if (sum > std::numbers::pi + rounding) flips_.push_back({sum, i});
    }
    std::sort(flips_.begin(), flips_.end(), [](const flip& x, const flip& y) {
      return x.angles != y.angles ? x.angles > y.angles : x.use < y.use;
    });
  }

  // Flips diagonals of triangles that no other flip of this round has changed.
  bool flip_once() {
    find_flips();
    is_changed_.assign(triangles_.size(), 0);
    for (const flip& f : flips_) {
      const diagonal &x = uses_[f.use], &y = uses_[f.use + 1];
      if (is_changed_[x.triangle] || is_changed_[y.triangle]) continue;
      const bool low_first = is_forward(triangles_[x.triangle], x.low, x.high);
      const std::uint32_t from = low_first ? x.low : x.high, to = low_first ? x.high : x.low;
      // from, to, x.opposite become from, y.opposite, x.opposite and y.opposite, to, x.opposite
      triangles_[x.triangle] = {from, y.opposite, x.opposite};
      triangles_[y.triangle] = {y.opposite, to, x.opposite};
      is_changed_[x.triangle] = is_changed_[y.triangle] = 1;
    }
    return !flips_.empty();
  }
  static bool is_forward(const polygon_triangle& t, std::uint32_t a, std::uint32_t b) {
    return (t[0] == a && t[1] == b) || (t[1] == a && t[2] == b) || (t[2] == a && t[0] == b);
  }

 public:
  std::span<const polygon_triangle> operator()(std::span<const vec3> points, std::span<const polygon_triangle> some) {
    points_ = points;
    triangles_.assign(some.begin(), some.end());
    if (points.size() == 3) return triangles_;
    constexpr int max_rounds = 100;  // planar polys need few; others may have no such triangles
    for (int round = 0; round < max_rounds && flip_once(); ++round) {}
    return triangles_;
  }
};

inline plane_triangle laid_flat(const std::array<std::uint32_t, 3>& corner, const vec3& o, const vec3& p,
                                const vec3& q) {
  const vec3 side = p - o, other = q - o;
  const double a = norm(side), twice = norm(cross(side, other));
  const double longest = std::max({a, norm(other), norm(q - p)});
  constexpr double rounding = 1e-14;
  plane_triangle t{corner, {}, 0};
  if (!(twice > rounding * longest * longest)) return t;
  const double b = dot(side, other) / a, c = twice / a;
  t.gradient = {{{-c / twice, (b - a) / twice}, {c / twice, -b / twice}, {0, a / twice}}};
  t.area = twice / 2;
  return t;
}

CONCINO_INLINE poly_triangles::poly_triangles(const flat_polys& f) {
  polygon_triangulator cut;
  empty_circle_flips flips;
  std::vector<vec3> ring;
  triangles.reserve(f.corners.size() / 3);
  first.reserve(f.num_polys() + 1);
  for (std::size_t p = 0; p < f.num_polys(); ++p) {
    ring.clear();
    for (std::uint32_t c = f.first[p]; c < f.first[p + 1]; ++c) ring.push_back(f.points[f.corners[c]]);
    for (const polygon_triangle& t : flips(ring, cut(ring))) {
      triangles.push_back(laid_flat({f.first[p] + t[0], f.first[p] + t[1], f.first[p] + t[2]}, ring[t[0]], ring[t[1]],
                                    ring[t[2]]));
      area += triangles.back().area;
    }
    first.push_back(static_cast<std::uint32_t>(triangles.size()));
  }
}

CONCINO_INLINE void poly_triangles::check_areas(const flat_polys& f, const char* caller) const {
  for (std::size_t p = 0; p < f.num_polys(); ++p)
    for (std::uint32_t t = first[p]; t < first[p + 1]; ++t)
      if (!(triangles[t].area > 0))
        core::throw_joined<invalid_mesh>({caller, ": poly ", f.poly_index[p], " has ",
                                          f.first[p + 1] - f.first[p] == 3 ? "no area" : "a part without area",
                                          "; repair(m, {.degenerate = degenerate_elements::collapse}) removes such "
                                          "triangles"});
}

}  // namespace concino::detail
