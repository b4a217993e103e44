// Bodies of geodesic_walker.hpp: walks straight over triangles that are unfolded one after the other.
#pragma once

#include <concino/lines/detail/geodesics/geodesic_walker.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace concino::detail {

CONCINO_INLINE walk_state leave_vert(const core::unfolded_triangles& t, int v, double fan_angle, double full_turn) {
  constexpr double tolerance = 1e-12;  // a direction along the boundary does not lead out of the surface because of
                                       // rounding
  const auto i = static_cast<std::size_t>(v);
  const double whole = t.whole_turn[i];
  double angle = fan_angle - full_turn * std::floor(fan_angle / full_turn);
  if (angle > whole && angle - full_turn > -tolerance) angle = 0;
  if (angle > whole && angle < whole + tolerance) angle = whole;
  if (angle > whole) return {};
  int best = -1;
  double outside = std::numeric_limits<double>::infinity();
  for (int k = t.first_corner[i]; k < t.first_corner[i + 1]; ++k) {
    const int c = t.corner[static_cast<std::size_t>(k)];
    const auto at = static_cast<std::size_t>(c);
    const double off = std::max(t.turn[at] - angle, angle - t.turn[at] - t.angle[at]);
    if (off < outside) {
      outside = off;
      best = c;
    }
  }
  if (best < 0) return {};
  const auto at = static_cast<std::size_t>(best);
  const double within = std::clamp(angle - t.turn[at], 0.0, t.angle[at]),
               from_side = t.is_backward[at] ? t.angle[at] - within : within;
  return {best, 0, 0, std::cos(from_side), std::sin(from_side), walk_state::location::at_start};
}

/// One walk. Points are in the frame of the side that was crossed last.
class straight_walk {
  using point = core::unfolded_triangles::plane_point;
  static constexpr double vert_tolerance = 1e-12;  // a line that passes nearer to a vert, as a fraction of the edge,
                                                   // passes through it

  const core::unfolded_triangles& t_;
  walk_state at_;
  walk_result result_;

  struct crossing {
    int side = -1;
    double along = 0, distance = 0;  // along: as a fraction of the side
    double direction_along = 0, direction_out = 0;
  };

  static double cross(const point& a, const point& b) { return a.x * b.y - a.y * b.x; }

  /// Where the walk leaves the triangle through the side from a to b, if it leads there.
  void consider(int side, const point& a, const point& b, crossing& best) const {
    const point edge{b.x - a.x, b.y - a.y}, to{a.x - at_.x, a.y - at_.y}, d{at_.dx, at_.dy};
    const double out = cross(d, edge);
    if (!(out > 0)) return;
    const double distance = std::max(cross(to, edge) / out, 0.0);
    if (best.side >= 0 && distance >= best.distance) return;
    const double length = t_.length[static_cast<std::size_t>(side)];
    best = {side, std::clamp(cross(to, d) / out, 0.0, 1.0), distance, (d.x * edge.x + d.y * edge.y) / length,
            out / length};
  }

  crossing leave_triangle() const {
    using core::unfolded_triangles;
    const int s = at_.side;
    const point a{0, 0}, b{t_.length[static_cast<std::size_t>(s)], 0}, c = t_.apex[static_cast<std::size_t>(s)];
    crossing best;
    consider(unfolded_triangles::next(s), b, c, best);
    if (at_.where == walk_state::location::at_start) {
      // cannot happen but by rounding
      if (best.side < 0) best = {unfolded_triangles::next(s), at_.dy > 0 ? 1.0 : 0.0, 0, 0, 1};
      return best;
    }
    consider(unfolded_triangles::previous(s), c, a, best);
    if (at_.where == walk_state::location::inside) consider(s, a, b, best);
    return best;
  }

  void turn_to_unit_length() {
    const double size = std::sqrt(at_.dx * at_.dx + at_.dy * at_.dy);
    at_.dx /= size;
    at_.dy /= size;
  }

  bool stop(line_end why) {
    result_.stopped_by = why;
    return false;
  }

  /// Goes on through a vert with equal angles on both sides; at the boundary, with half a turn on the side of the
  /// surface. Returns whether that is possible.
  bool pass_vert(const crossing& c) {
    const int corner = c.along < 0.5 ? c.side : core::unfolded_triangles::next(c.side);
    const auto i = static_cast<std::size_t>(t_.start(corner));
    result_.stops.push_back({t_.start(corner), -1, 0, 0, false});
    if (t_.around[i] == core::unfolded_triangles::vert_fan::other) return stop(line_end::non_manifold);
    // The angle from the side to the way back, which is on the other side of the crossed edge's normal.
    const double along_way_back = c.along < 0.5 ? -c.direction_along : c.direction_along;
    const double from_edge =
        std::clamp(std::atan2(c.direction_out, along_way_back), 0.0, t_.angle[static_cast<std::size_t>(corner)]);
    const double back =
        t_.fan_angle(corner, c.along < 0.5 ? from_edge : t_.angle[static_cast<std::size_t>(corner)] - from_edge);
    if (t_.around[i] == core::unfolded_triangles::vert_fan::open_fan) {
      constexpr double pi = std::numbers::pi, tolerance = 1e-12;
      const double whole = t_.whole_turn[i], left = back + pi, right = back - pi;
      if (left > whole + tolerance && right < -tolerance) return stop(line_end::boundary);
      at_ = leave_vert(t_, static_cast<int>(i),
                       left <= whole + tolerance ? std::min(left, whole) : std::max(right, 0.0), whole + 2 * pi);
      return at_.side >= 0 || stop(line_end::boundary);
    }
    at_ = leave_vert(t_, static_cast<int>(i), back + t_.whole_turn[i] / 2, t_.whole_turn[i]);
    return at_.side >= 0 || stop(line_end::boundary);
  }

  bool cross_side(const crossing& c) {
    result_.stops.push_back({-1, c.side, c.along, 0, false});
    const int other = t_.twin[static_cast<std::size_t>(c.side)];
    if (other == c.side) return stop(line_end::boundary);
    if (t_.twin[static_cast<std::size_t>(other)] != c.side) return stop(line_end::non_manifold);
    const bool is_reversed = t_.start(other) != t_.start(c.side);
    const double fraction = is_reversed ? 1 - c.along : c.along;
    at_ = {other,
           fraction * t_.length[static_cast<std::size_t>(other)],
           0,
           is_reversed ? -c.direction_along : c.direction_along,
           c.direction_out,
           walk_state::location::on_side};
    turn_to_unit_length();
    return true;
  }

  /// Walks through one triangle. Returns whether the walk goes on.
  bool step(double length) {
    const crossing c = leave_triangle();
    const double left = length - result_.length;
    if (c.side < 0 || c.distance >= left) {
      at_.x += left * at_.dx;
      at_.y += left * at_.dy;
      at_.where = walk_state::location::inside;
      result_.length = length;
      result_.stops.push_back({-1, at_.side, at_.x, at_.y, true});
      return stop(line_end::max_length);
    }
    result_.length += c.distance;
    result_.last = at_;
    if (c.along < vert_tolerance || c.along > 1 - vert_tolerance) return pass_vert(c);
    return cross_side(c);
  }

 public:
  straight_walk(const core::unfolded_triangles& t, const walk_state& from) : t_(t), at_(from) {}

  walk_result run(double length, std::size_t max_steps) {
    result_.last = at_;
    if (!(length > 0)) return result_;
    for (std::size_t n = 0; step(length); ++n)
      if (n + 1 >= max_steps) {
        result_.stopped_by = line_end::max_steps;
        break;
      }
    if (result_.stopped_by == line_end::max_length || result_.stopped_by == line_end::max_steps) result_.last = at_;
    return result_;
  }
};

CONCINO_INLINE walk_result walk_straight(const core::unfolded_triangles& t, walk_state from, double length,
                                         std::size_t max_steps) {
  return straight_walk(t, from).run(length, max_steps);
}

}  // namespace concino::detail
