// Bodies of convex_outline.hpp: a convex polygon in the plane, as the domain of a Voronoi diagram.
#pragma once

#include <concino/core/message.hpp>
#include <concino/generate/detail/voronoi/convex_outline.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace concino::detail {

CONCINO_INLINE convex_outline::convex_outline(std::vector<vec3> points) : points_(std::move(points)) {
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (!std::isfinite(points_[i].x) || !std::isfinite(points_[i].y) || (i == 0 && !std::isfinite(points_[i].z)))
      core::throw_joined<invalid_argument>({"Voronoi diagram: point ", i, " of the outline is not finite"});
  if (points_.size() < 3)
    core::throw_joined<invalid_argument>(
        {"Voronoi diagram: the outline has ", points_.size(), " points; it must have 3 or more"});
}

CONCINO_INLINE box convex_outline::domain() const {
  box b;
  for (const vec3& x : points_) b.add(x);
  const double margin = (b.max.x - b.min.x) / 32 + (b.max.y - b.min.y) / 32;
  b.min -= vec3{margin, margin, 0}, b.max += vec3{margin, margin, 0};
  b.min.z = b.max.z = points_[0].z;
  return b;
}

/// The lines of an outline: its segments, or several in a row.
class outline_lines {
  static constexpr double slack = 1024;  // lattice steps: points this near to a line are on it
  struct corner {
    std::size_t index;
    std::array<std::int64_t, 2> x;
  };
  std::vector<corner> corners_;     // counter-clockwise, from the leftmost on
  std::vector<std::size_t> first_;  // of each line: the position of its first corner

  /// Twice the area of a triangle.
  static int128 area(const corner& a, const corner& b, const corner& c) {
    return static_cast<int128>(b.x[0] - a.x[0]) * (c.x[1] - a.x[1]) -
           static_cast<int128>(b.x[1] - a.x[1]) * (c.x[0] - a.x[0]);
  }
  static double length(const corner& a, const corner& b) {
    return std::hypot(static_cast<double>(b.x[0] - a.x[0]), static_cast<double>(b.x[1] - a.x[1]));
  }
  /// Whether the line from a to b goes on to c.
  static bool continues(const corner& a, const corner& b, const corner& c) {
    const int128 along = static_cast<int128>(b.x[0] - a.x[0]) * (c.x[0] - b.x[0]) +
                         static_cast<int128>(b.x[1] - a.x[1]) * (c.x[1] - b.x[1]);
    return along > 0 && std::abs(static_cast<double>(area(a, b, c))) <= slack * length(a, b);
  }
  const corner& after(std::size_t i) const { return corners_[i + 1 == corners_.size() ? 0 : i + 1]; }
  const corner& start(std::size_t line) const { return corners_[first_[line]]; }
  const corner& end(std::size_t line) const { return line + 1 == first_.size() ? corners_[0] : start(line + 1); }
  /// Whether a line runs in a direction from 0 to less than 180 degrees.
  bool is_upward(std::size_t line) const {
    const auto &a = start(line).x, &b = end(line).x;
    return b[1] > a[1] || (b[1] == a[1] && b[0] > a[0]);
  }

  void order_corners(const std::vector<vec3>& points, const site_lattice<2>& lattice) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const corner c{i, lattice.rounded(points[i])};
      if (corners_.empty() || corners_.back().x != c.x) corners_.push_back(c);
    }
    while (corners_.size() > 1 && corners_.back().x == corners_[0].x) corners_.pop_back();
    int128 twice_area = 0;
    double perimeter = 0;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      twice_area += area(corners_[0], corners_[i], after(i));
      perimeter += length(corners_[i], after(i));
    }
    if (!(std::abs(static_cast<double>(twice_area)) > slack * perimeter))
      core::throw_joined<invalid_argument>({"Voronoi diagram: the outline has no area"});
    if (twice_area < 0) std::reverse(corners_.begin(), corners_.end());
    std::rotate(
        corners_.begin(),
        std::min_element(corners_.begin(), corners_.end(), [](const corner& a, const corner& b) { return a.x < b.x; }),
        corners_.end());
  }

  void check_convex() const {
    std::size_t turns = 0;
    for (std::size_t s = 0; s < first_.size(); ++s) {
      const std::size_t next = s + 1 == first_.size() ? 0 : s + 1;
      if (area(start(s), end(s), end(next)) <= 0)
        core::throw_joined<invalid_argument>({"Voronoi diagram: the outline is not convex at point ", end(s).index});
      if (!is_upward(s) && is_upward(next)) ++turns;
    }
    if (turns != 1)
      core::throw_joined<invalid_argument>(
          {"Voronoi diagram: the outline is not convex: it winds around its inside more than once"});
  }

 public:
  outline_lines(const std::vector<vec3>& points, const site_lattice<2>& lattice) {
    order_corners(points, lattice);
    first_.push_back(0);
    for (std::size_t i = 1; i < corners_.size(); ++i)
      if (!continues(corners_[first_.back()], corners_[i], after(i))) first_.push_back(i);
    check_convex();
  }

  std::vector<lattice_plane<2>> walls() const {
    std::vector<lattice_plane<2>> all;
    for (std::size_t s = 0; s < first_.size(); ++s) {
      const corner &a = start(s), &b = end(s);
      const double scale = 0x1p47 / length(a, b);
      lattice_plane<2> w{{std::llround(scale * static_cast<double>(b.x[1] - a.x[1])),
                          std::llround(scale * static_cast<double>(a.x[0] - b.x[0]))},
                         -(int128{1} << 110)};
      const auto include = [&](const corner& x) {  // four steps outwards, so that rounded sites on the boundary are
                                                   // inside
        w.c = std::max(
            w.c, 2 * (static_cast<int128>(w.n[0]) * x.x[0] + static_cast<int128>(w.n[1]) * x.x[1]) + (int128{1} << 50));
      };
      for (std::size_t i = first_[s]; i < (s + 1 == first_.size() ? corners_.size() : first_[s + 1]); ++i)
        include(corners_[i]);
      include(b);
      all.push_back(w);
    }
    return all;
  }
};

CONCINO_INLINE std::vector<lattice_plane<2>> convex_outline::walls(const site_lattice<2>& lattice) const {
  return outline_lines(points_, lattice).walls();
}

}  // namespace concino::detail
