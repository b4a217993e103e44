// A window of exact geodesics: a part of an edge that sees its source; and the order in which windows are continued.
#pragma once

#include <concino/core/unfolded_triangles.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace concino::detail {

/// The length of a vector in a plane.
inline double plane_norm(double x, double y) { return std::sqrt(x * x + y * y); }

/// A part of an edge that sees its source along straight lines.
struct exact_window {
  double begin, end;  // along the side, from its start
  double x, y;        // position of the source: along the side, and perpendicular to it, away from the triangle to be
                      // crossed next
  double before;      // the path length at the source
  int side, source;   // source: a vert, or -1

  /// The same, measured from the other end of a side of this size.
  exact_window reversed(double size) const { return {size - end, size - begin, size - x, y, before, side, source}; }

  /// Where the line from the source through the base at `through` meets a side of direction (along_x, along_y) and
  /// length `size`: the distance from their common start.
  double intersect_side(double through, double along_x, double along_y, double size) const {
    const double slope = y * along_x - (through - x) * along_y;
    return slope > 0 ? std::min(through * y / slope, size) : size;
  }
};

/// The first path that arrives at the apex of a triangle through one of its sides, and where it crosses the side.
struct exact_arrival {
  double distance = std::numeric_limits<double>::infinity(), crossing = 0;
};

/// What is continued next: windows and verts, by their distance.
class exact_events {
  using event = std::pair<double, int>;  // distance; a window, or -1 - a vert
  static constexpr auto later = [](const event& a, const event& b) { return a > b; };
  std::vector<event> events_;

 public:
  bool empty() const { return events_.empty(); }
  event first() const { return events_.front(); }
  void push(double when, int what) {
    events_.push_back({when, what});
    std::push_heap(events_.begin(), events_.end(), later);
  }
  void pop() {
    std::pop_heap(events_.begin(), events_.end(), later);
    events_.pop_back();
  }
};

/// The sides of a triangle, and a point in it relative to each side: along the side and perpendicular to it.
struct point_in_triangle {
  std::array<int, 3> side;
  std::array<core::unfolded_triangles::plane_point, 3> from;
};
inline point_in_triangle seen_from_edges(const core::unfolded_triangles& t, int s,
                                         core::unfolded_triangles::plane_point p) {
  const auto length = [&t](int side) { return t.length[static_cast<std::size_t>(side)]; };
  const core::unfolded_triangles::plane_point apex = t.apex[static_cast<std::size_t>(s)];
  const int right = core::unfolded_triangles::next(s), left = core::unfolded_triangles::previous(s);
  const double back = length(s) - p.x, lx = apex.x / length(left), ly = apex.y / length(left);
  const double rx = (length(s) - apex.x) / length(right), ry = apex.y / length(right);
  return {{s, right, left},
          {{p,
            {rx * back + ry * p.y, ry * back - rx * p.y},
            {length(left) - (lx * p.x + ly * p.y), ly * p.x - lx * p.y}}}};
}

}  // namespace concino::detail
