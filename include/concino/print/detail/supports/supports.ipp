// Defines supports.hpp. The projection of a triangle is cut into convex pieces, each of which has one surface below it.
// There the height of the supports is a linear function, which is integrated exactly. Triangles above many small ones
// are divided first, so that few of these are below each part.
#pragma once

#include <concino/core/small_array.hpp>
#include <concino/print/detail/supports/supports.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace concino::detail {

struct projected_point {
  double x, y;
};
using plane_polygon = core::small_array<projected_point, 12>;

template<class Points>
void assign(plane_polygon& polygon, const Points& points) {
  polygon.clear();
  for (const projected_point& x : points) polygon.push_back(x);
}

/// Keeps the part of a convex polygon where a linear function is at least 0; `rest` becomes the other one. value(p):
/// the function.
template<class F>
void divide_polygon(plane_polygon& polygon, plane_polygon& rest, const F& value) {
  const std::size_t n = polygon.size();
  core::small_array<double, 12> values;
  bool positive = false, negative = false;
  for (const projected_point& x : polygon) {
    values.push_back(value(x));
    positive = positive || values.back() > 0;
    negative = negative || values.back() < 0;
  }
  rest.clear();
  if (!negative) return;
  if (!positive) {
    assign(rest, polygon);
    polygon.clear();
    return;
  }
  plane_polygon kept;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = i + 1 < n ? i + 1 : 0;
    const projected_point &a = polygon[i], &b = polygon[j];
    if (values[i] >= 0) kept.push_back(a);
    if (values[i] <= 0) rest.push_back(a);
    if ((values[i] > 0 && values[j] < 0) || (values[i] < 0 && values[j] > 0)) {
      const double t = values[i] / (values[i] - values[j]);
      const projected_point c{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
      kept.push_back(c);
      rest.push_back(c);
    }
  }
  assign(polygon, kept);
}

inline double doubled_area(const plane_polygon& p) {
  double sum = 0;
  for (std::size_t i = 2; i < p.size(); ++i)
    sum += (p[i - 1].x - p[0].x) * (p[i].y - p[0].y) - (p[i - 1].y - p[0].y) * (p[i].x - p[0].x);
  return sum;
}

/// Integrates over the pieces of the projection of one triangle, the ceiling.
class support_pieces {
  using floors = std::span<const height_triangle* const>;
  static constexpr std::size_t few = 8;
  static constexpr int max_depth = 24;

  const height_triangle& ceiling_;
  double plate_, tolerance_;
  supports_size sum_;

  double floor_at(const height_triangle* floor, const projected_point& p) const {
    return floor ? floor->at(p.x, p.y) : plate_;
  }

  /// Adds a piece; floor is null for the plate.
  void integrate(const plane_polygon& p, const height_triangle* floor) {
    core::small_array<double, 12> lengths;
    for (const projected_point& x : p) lengths.push_back(std::max(0.0, ceiling_.at(x.x, x.y) - floor_at(floor, x)));
    for (std::size_t i = 2; i < p.size(); ++i) {
      const double doubled = (p[i - 1].x - p[0].x) * (p[i].y - p[0].y) - (p[i - 1].y - p[0].y) * (p[i].x - p[0].x);
      const double mean = (lengths[0] + lengths[i - 1] + lengths[i]) / 3;
      if (!(doubled > 0) || !(mean > tolerance_)) continue;
      sum_.volume += 0.5 * doubled * mean;
      sum_.contact_area += 0.5 * doubled * (ceiling_.area_factor + (floor ? floor->area_factor : 0));
    }
  }

  static double edge_value(const height_triangle& t, std::size_t k, const projected_point& x) {
    const vec3 &a = t.corners[k], &b = t.corners[k < 2 ? k + 1 : 0];
    return (b.x - a.x) * (x.y - a.y) - (b.y - a.y) * (x.x - a.x);
  }

  /// Whether p is beyond an edge of t. If not, they may still be apart.
  static bool is_beyond_edge(const height_triangle& t, const plane_polygon& p) {
    for (std::size_t k = 0; k < 3; ++k)
      if (std::all_of(p.begin(), p.end(), [&](const projected_point& x) { return edge_value(t, k, x) <= 0; }))
        return true;
    return false;
  }
  /// Whether a triangle and t are apart. Pieces have edges too short for this: their directions are lost.
  static bool is_apart(const plane_polygon& triangle, const height_triangle& t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const projected_point &a = triangle[i], &b = triangle[i < 2 ? i + 1 : 0];
      if (std::all_of(t.corners.begin(), t.corners.end(),
                      [&](const vec3& x) { return (b.x - a.x) * (x.y - a.y) - (b.y - a.y) * (x.x - a.x) <= 0; }))
        return true;
    }
    return is_beyond_edge(t, triangle);
  }

  /// Whether p and t have an area in common.
  static bool overlap(const plane_polygon& p, const height_triangle& t) {
    if (is_beyond_edge(t, p)) return false;
    plane_polygon inside, rest;
    assign(inside, p);
    for (std::size_t k = 0; k < 3 && inside.size() >= 3; ++k)
      divide_polygon(inside, rest, [&](const projected_point& x) { return edge_value(t, k, x); });
    return inside.size() >= 3 && doubled_area(inside) > 0;
  }

  /// Below p there is `floor`, except where one of the candidates, sorted by height from the highest, is above it and
  /// below the ceiling.
  void find_floors(const plane_polygon& outline, floors candidates, const height_triangle* floor) {
    plane_polygon p, rest;
    assign(p, outline);
    for (std::size_t i = 0; i < candidates.size() && p.size() >= 3; ++i) {
      const height_triangle& s = *candidates[i];
      double lowest = std::numeric_limits<double>::infinity(), ceiling = -lowest;
      for (const projected_point& x : p) {
        lowest = std::min(lowest, floor_at(floor, x));
        ceiling = std::max(ceiling, ceiling_.at(x.x, x.y));
      }
      if (s.high <= lowest) break;  // so are all others
      if (s.low > ceiling + tolerance_ || !overlap(p, s)) continue;  // a cut would only make more pieces
      const floors others = candidates.subspan(i + 1);
      const auto keep = [&](const auto& value) {
        divide_polygon(p, rest, value);
        if (rest.size() >= 3) find_floors(rest, others, floor);
      };
      for (std::size_t k = 0; k < 3 && p.size() >= 3; ++k)
        keep([&](const projected_point& x) { return edge_value(s, k, x); });
      if (p.size() >= 3)
        keep([&](const projected_point& x) { return ceiling_.at(x.x, x.y) + tolerance_ - s.at(x.x, x.y); });
      if (p.size() >= 3) keep([&](const projected_point& x) { return s.at(x.x, x.y) - floor_at(floor, x); });
      floor = &s;
    }
    if (p.size() >= 3) integrate(p, floor);
  }

  /// Divides a triangle while that makes fewer candidates for each of its parts.
  void divide(const plane_polygon& p, const std::vector<const height_triangle*>& candidates, int depth) {
    if (candidates.size() <= few || depth == max_depth) return find_floors(p, candidates, nullptr);
    const auto middle = [&](std::size_t a, std::size_t b) {
      return projected_point{0.5 * p[a].x + 0.5 * p[b].x, 0.5 * p[a].y + 0.5 * p[b].y};
    };
    const projected_point ab = middle(0, 1), bc = middle(1, 2), ca = middle(2, 0);
    plane_polygon parts[4];
    const std::array<projected_point, 3> corners[] = {{p[0], ab, ca}, {ab, p[1], bc}, {ca, bc, p[2]}, {ab, bc, ca}};
    for (std::size_t i = 0; i < 4; ++i) assign(parts[i], corners[i]);
    std::vector<const height_triangle*> below[4];
    std::size_t all = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      for (const height_triangle* t : candidates)
        if (!is_apart(parts[i], *t)) below[i].push_back(t);
      all += below[i].size();
    }
    if (5 * all > 12 * candidates.size()) return find_floors(p, candidates, nullptr);
    for (std::size_t i = 0; i < 4; ++i) divide(parts[i], below[i], depth + 1);
  }

 public:
  support_pieces(const height_triangle& ceiling, double plate, double tolerance)
      : ceiling_(ceiling), plate_(plate), tolerance_(tolerance) {}

  supports_size operator()(std::vector<const height_triangle*> candidates) {
    plane_polygon outline;
    for (const vec3& c : ceiling_.corners) outline.push_back({c.x, c.y});
    candidates.erase(std::remove_if(candidates.begin(), candidates.end(),
                                    [&](const height_triangle* t) { return is_apart(outline, *t); }),
                     candidates.end());
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const height_triangle* a, const height_triangle* b) { return a->high > b->high; });
    divide(outline, candidates, 0);
    return sum_;
  }
};

CONCINO_INLINE int make_height_triangle(const std::array<vec3, 3>& corners, double tolerance, height_triangle& t) {
  const vec3 doubled = cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double size = norm(doubled), flat = std::abs(doubled.z);
  if (!(flat > 1e-12 * size)) return 0;
  double longest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const vec3 &a = corners[k], &b = corners[k < 2 ? k + 1 : 0];
    longest = std::max(longest, std::hypot(b.x - a.x, b.y - a.y));
  }
  if (!(flat > tolerance * longest)) return 0;
  t.corners = corners;
  if (doubled.z < 0) std::swap(t.corners[1], t.corners[2]);
  t.slope_x = -doubled.x / doubled.z;
  t.slope_y = -doubled.y / doubled.z;
  t.low = std::min({corners[0].z, corners[1].z, corners[2].z});
  t.high = std::max({corners[0].z, corners[1].z, corners[2].z});
  t.area_factor = size / flat;
  return doubled.z > 0 ? 1 : -1;
}

CONCINO_INLINE supports_size measure_supports(const height_triangle& ceiling,
                                              std::vector<const height_triangle*> candidates, double plate,
                                              double tolerance) {
  return support_pieces(ceiling, plate, tolerance)(std::move(candidates));
}

}  // namespace concino::detail
