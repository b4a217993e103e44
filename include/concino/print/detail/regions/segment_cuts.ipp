// Defines segment_cuts.hpp.
#pragma once

#include <concino/geometry/orientation.hpp>
#include <concino/print/detail/regions/segment_cuts.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <queue>
#include <set>
#include <utility>

namespace concino::detail {

/// A line that sweeps over segments from left to right; at one x, from below to above.
class cutting_sweep {
  /// A part of a segment, ends in the order of the sweep. It bends a little where the segment was cut.
  struct part {
    std::uint32_t segment, first, last;
  };
  /// The parts on the line, from below to above.
  struct below {
    using is_transparent = void;
    const cutting_sweep* sweep;

    bool operator()(std::uint32_t i, std::uint32_t j) const {
      if (i == j) return false;
      const part &x = sweep->parts_[i], &y = sweep->parts_[j];
      const bool i_is_later = !(sweep->points_[x.first] < sweep->points_[y.first]);
      const part &earlier = i_is_later ? y : x, &later = i_is_later ? x : y;
      int side = sweep->side(earlier, later.first);
      if (side == 0) side = sweep->side(earlier, later.last);
      if (side == 0) return i < j;
      return i_is_later ? side < 0 : side > 0;
    }
    bool operator()(std::uint32_t i, const snapped_point& p) const { return sweep->side(sweep->parts_[i], p) > 0; }
    bool operator()(const snapped_point& p, std::uint32_t i) const { return sweep->side(sweep->parts_[i], p) < 0; }
  };
  using line = std::set<std::uint32_t, below>;
  /// A part begins or ends at a point.
  struct event {
    snapped_point at;
    std::uint32_t point, part;
    friend bool operator<(const event& a, const event& b) { return b.at < a.at; }  // the first is on top
  };

  std::vector<snapped_point>& points_;
  const std::vector<numbered_segment>& segments_;
  const bool first_only_;
  std::vector<part> parts_;
  line line_{below{this}};
  std::vector<line::iterator> place_;  // by part
  std::priority_queue<event> events_;
  std::vector<std::uint32_t> beginning_;       // parts
  std::uint32_t previous_ = 0;                 // the point of the event before
  std::vector<std::uint32_t> ended_, ending_;  // segments with a part that ended there, or ends here
  std::vector<segment_cut> cuts_;

  vec3 at(std::uint32_t p) const { return as_vec3(points_[p]); }
  /// 1 if a point is above a part, -1 if it is below.
  int side(const part& x, const snapped_point& p) const { return orient2d(at(x.first), at(x.last), as_vec3(p)); }
  int side(const part& x, std::uint32_t p) const { return side(x, points_[p]); }

  static bool cross(const vec3& a, const vec3& b, const vec3& c, const vec3& d) {
    return orient2d(a, b, c) * orient2d(a, b, d) < 0 && orient2d(c, d, a) * orient2d(c, d, b) < 0;
  }
  static snapped_point crossing(const vec3& a, const vec3& b, const vec3& c, const vec3& d) {
    const vec3 u = b - a, v = d - c, w = c - a;
    const double t = std::clamp((w.x * v.y - w.y * v.x) / (u.x * v.y - u.y * v.x), 0.0, 1.0);
    return {static_cast<std::int64_t>(std::nearbyint(a.x + t * u.x)),
            static_cast<std::int64_t>(std::nearbyint(a.y + t * u.y))};
  }
  /// Whether a point is at most half a unit away from the inner part of a segment.
  bool is_near(const numbered_segment& s, std::uint32_t p) const {
    const vec3 a = at(s[0]), step = at(s[1]) - a, x = at(p) - a;
    const double along = dot(x, step), length2 = dot(step, step);
    if (!(along > 0 && along < length2)) return false;
    const double across = step.x * x.y - step.y * x.x;
    return across * across <= 0.25 * length2;
  }

  void add_event(std::uint32_t point, std::uint32_t i) { events_.push({points_[point], point, i}); }
  std::uint32_t add_part(std::uint32_t segment, std::uint32_t p, std::uint32_t q) {
    if (points_[q] < points_[p]) std::swap(p, q);
    const auto i = static_cast<std::uint32_t>(parts_.size());
    parts_.push_back({segment, p, q});
    place_.push_back(line_.end());
    add_event(q, i);
    return i;
  }

  /// Ends a part at a point further on, where another one begins.
  void shorten(std::uint32_t i, std::uint32_t point) {
    const auto [segment, first, last] = parts_[i];
    if (points_[last] == points_[point]) return;
    parts_[i].last = point;
    add_event(point, i);
    const std::uint32_t rest = add_part(segment, point, last);
    add_event(parts_[rest].first, rest);
  }

  /// Cuts two neighbours on the line where they cross. The segments as they were tell where, so that they do not drift
  /// from cut to cut.
  void cut_crossing(std::uint32_t i, std::uint32_t j, const snapped_point& now) {
    const part x = parts_[i], y = parts_[j];
    if (x.segment == y.segment || !cross(at(x.first), at(x.last), at(y.first), at(y.last))) return;
    const vec3 a = at(segments_[x.segment][0]), b = at(segments_[x.segment][1]), c = at(segments_[y.segment][0]),
               d = at(segments_[y.segment][1]);
    if (!cross(a, b, c, d)) return;
    const auto point = static_cast<std::uint32_t>(points_.size());
    points_.push_back(crossing(a, b, c, d));
    cuts_.push_back({x.segment, point});
    cuts_.push_back({y.segment, point});
    if (!(now < points_[point])) return;
    shorten(i, point);
    shorten(j, point);
  }

  /// Cuts a part on the line at the point where the line is.
  void cut_here(line::iterator place, std::uint32_t point) {
    const auto [segment, first, last] = parts_[*place];
    cuts_.push_back({segment, point});
    place_[*place] = line_.end();
    line_.erase(place);
    beginning_.push_back(add_part(segment, point, last));
  }

  /// Cuts segments at points above their last end, or below their first one, which the line does not see: steep ones
  /// pass near to the next point with the same x.
  void cut_in_column(std::uint32_t point) {
    if (points_[previous_][0] != points_[point][0]) return;
    for (const std::uint32_t s : ended_)
      if (is_near(segments_[s], point)) cuts_.push_back({s, point});
    for (const std::uint32_t i : beginning_)
      if (is_near(segments_[parts_[i].segment], previous_)) cuts_.push_back({parts_[i].segment, previous_});
  }

  void pass(std::uint32_t point) {
    const snapped_point now = points_[point];
    ending_.clear();
    beginning_.clear();
    while (!events_.empty() && events_.top().at == now) {
      const std::uint32_t i = events_.top().part;
      events_.pop();
      if (points_[parts_[i].first] == now) beginning_.push_back(i);
      else if (points_[parts_[i].last] == now && place_[i] != line_.end()) {
        line_.erase(std::exchange(place_[i], line_.end()));
        ending_.push_back(parts_[i].segment);
      }
    }
    cut_in_column(point);
    auto above = line_.lower_bound(now);
    const auto is_near_to = [&](line::iterator place) { return is_near(segments_[parts_[*place].segment], point); };
    while (above != line_.end() && is_near_to(above)) cut_here(above++, point);
    while (above != line_.begin() && is_near_to(std::prev(above))) cut_here(std::prev(above), point);
    if (beginning_.empty() && above != line_.end() && above != line_.begin())
      cut_crossing(*std::prev(above), *above, now);
    for (const std::uint32_t i : beginning_) place_[i] = line_.insert(i).first;
    for (const std::uint32_t i : beginning_) {
      if (place_[i] != line_.begin()) cut_crossing(*std::prev(place_[i]), i, now);
      if (std::next(place_[i]) != line_.end()) cut_crossing(i, *std::next(place_[i]), now);
    }
    previous_ = point;
    ended_.swap(ending_);
  }

 public:
  cutting_sweep(std::vector<snapped_point>& points, const std::vector<numbered_segment>& segments, bool first_only)
      : points_(points), segments_(segments), first_only_(first_only) {
    for (std::uint32_t s = 0; s < segments.size(); ++s) {
      const std::uint32_t i = add_part(s, segments[s][0], segments[s][1]);
      add_event(parts_[i].first, i);
    }
  }

  std::vector<segment_cut> run() {
    while (!events_.empty() && !(first_only_ && !cuts_.empty())) pass(events_.top().point);
    return std::move(cuts_);
  }
};

CONCINO_INLINE std::vector<segment_cut> find_cuts(std::vector<snapped_point>& points,
                                                  const std::vector<numbered_segment>& segments, bool first_only) {
  return cutting_sweep(points, segments, first_only).run();
}

}  // namespace concino::detail
