// Shortest paths over triangles by windows: parts of edges that see their source along straight lines once the
// triangles between are unfolded.
#pragma once

#include <concino/core/unfolded_triangles.hpp>
#include <concino/fields/detail/exact/exact_window.hpp>
#include <concino/fields/detail/exact/path_tree.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace concino::detail {

/// One query: distances of all verts from the added sources, in the units of the triangles. A window is dropped only if
/// a known path is shorter, by more than rounding, to everything the window sees. So windows on shortest paths remain.
class exact_windows {
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr double safe_factor = 1 - 1e-12;   // a < safe_factor * b implies that a is less than b in spite of
                                                     // rounding
  static constexpr double smallest_part = 1e-14;  // shortest window, as a fraction of its edge

  using window = exact_window;
  const core::unfolded_triangles& t_;
  path_tree* const paths_;                    // where paths are recorded, if requested
  int from_ = path_tree::none;                // the node of this tree from which the current windows and arrivals come
  std::vector<int> node_;                     // the node of each window in this tree
  std::vector<double> distance_, direction_;  // by vert; angle in the fan at which the shortest known path arrives,
                                              // NaN: paths leave in all directions
  std::vector<exact_arrival> first_at_apex_;  // by side: the first arrival at the apex of its triangle through this
                                              // side
  std::vector<window> windows_;
  std::vector<int> unused_, excluded_;          // excluded_: triangles that contain the source; no shortest path
                                                // returns to them
  exact_events events_;

  double& at(int v) { return distance_[static_cast<std::size_t>(v)]; }
  double length(int s) const { return t_.length[static_cast<std::size_t>(s)]; }
  core::unfolded_triangles::plane_point apex(int s) const { return t_.apex[static_cast<std::size_t>(s)]; }
  double angle(int c) const { return t_.angle[static_cast<std::size_t>(c)]; }

  /// A path of that length arrives at vert v in corner c, at an angle of from_side from the side that starts there.
  void relax_vert(int v, double length_of_path, int c, double from_side) {
    if (!(length_of_path < at(v))) return;
    at(v) = length_of_path;
    if (paths_) paths_->arrive(v, from_);
    if (!t_.may_be_passed(v)) return;
    direction_[static_cast<std::size_t>(v)] = t_.fan_angle(c, from_side);
    events_.push(length_of_path, -1 - v);
  }

  /// Whether, for all points of a window on side s, a path through one end of the side is shorter. The window is
  /// measured from the start of the side.
  bool is_dominated(int s, const window& w) {
    return at(t_.start(s)) + w.end < safe_factor * (w.before + plane_norm(w.x - w.end, w.y)) ||
           at(t_.end(s)) + (length(s) - w.begin) < safe_factor * (w.before + plane_norm(w.x - w.begin, w.y));
  }

  /// Continues a window on side s of a crossed triangle into the triangles on the other side of the edge.
  void propagate(int s, window w) {
    const double size = length(s);
    if (!(w.end - w.begin > smallest_part * size) || !(w.y > 0) || is_dominated(s, w)) return;
    for (int other = t_.twin[static_cast<std::size_t>(s)]; other != s;
         other = t_.twin[static_cast<std::size_t>(other)]) {
      if (std::find(excluded_.begin(), excluded_.end(), other / 3) != excluded_.end()) continue;
      window next = t_.start(other) == t_.start(s) ? w : w.reversed(size);
      next.side = other;
      const double nearest = std::clamp(next.x, next.begin, next.end);
      int index = static_cast<int>(windows_.size());
      if (unused_.empty()) {
        windows_.push_back(next);
      } else {
        index = unused_.back();
        unused_.pop_back();
        windows_[static_cast<std::size_t>(index)] = next;
      }
      if (paths_) {
        node_.resize(windows_.size());
        node_[static_cast<std::size_t>(index)] = paths_->add({next.x, next.y, other, from_});
      }
      events_.push(next.before + plane_norm(next.x - nearest, next.y), index);
    }
  }

  void cross_triangle(const window& w) {
    const int s = w.side, to_right = core::unfolded_triangles::next(s), to_left = core::unfolded_triangles::previous(s);
    if (w.source >= 0 && w.before > at(w.source)) return;
    const double size = length(s);
    const core::unfolded_triangles::plane_point top = apex(s);
    // where the line from the source to the apex crosses the side
    const double middle = w.x + (top.x - w.x) * (w.y / (w.y + top.y));
    const bool meets_left = w.begin < middle, meets_right = w.end > middle;
    bool left = meets_left, right = meets_right;
    if (left && right) {
      const double there = w.before + plane_norm(top.x - w.x, top.y + w.y);
      const double sine = w.y * top.x + top.y * w.x, cosine = top.y * (w.y + top.y) - top.x * (w.x - top.x);
      if (there < at(t_.start(to_left)))
        relax_vert(t_.start(to_left), there, to_left, std::clamp(std::atan2(sine, cosine), 0.0, angle(to_left)));
      // Of the windows that see the apex, only the first goes on to both sides. The path from it to the apex cuts off
      // one side of all others, because they have come through the same triangles. This needs an edge with at most two
      // triangles.
      exact_arrival& first = first_at_apex_[static_cast<std::size_t>(s)];
      if (there < first.distance) {
        first = {there, middle};
      } else if (t_.is_manifold && first.distance < safe_factor * there) {
        if (first.crossing < middle - 1e-12 * size) left = false;
        if (first.crossing > middle + 1e-12 * size) right = false;
      }
    }
    if (left) {
      const double along = length(to_left), cx = top.x / along, cy = top.y / along;
      window next = w;  // measured from the start of side s
      next.begin = w.intersect_side(w.begin, cx, cy, along);
      next.end = meets_right ? along : w.intersect_side(w.end, cx, cy, along);
      next.x = cx * w.x - cy * w.y;
      next.y = cx * w.y + cy * w.x;
      const double px = next.begin * cx, py = next.begin * cy;
      if (!(at(t_.end(s)) + plane_norm(size - px, py) < safe_factor * (w.before + plane_norm(px - w.x, py + w.y))))
        propagate(to_left, next.reversed(along));
    }
    if (right) {
      const window mirrored = w.reversed(size);
      const double along = length(to_right), cx = (size - top.x) / along, cy = top.y / along;
      window next = w;
      next.begin = mirrored.intersect_side(mirrored.begin, cx, cy, along);
      next.end = meets_left ? along : mirrored.intersect_side(mirrored.end, cx, cy, along);
      next.x = cx * mirrored.x - cy * w.y;
      next.y = cx * w.y + cy * mirrored.x;
      const double px = next.begin * cx, py = next.begin * cy;
      if (!(at(t_.start(s)) + plane_norm(size - px, py) <
            safe_factor * (w.before + plane_norm(px - mirrored.x, py + w.y))))
        propagate(to_right, next);
    }
  }

  /// Continues paths from vert v into corner c, between two angles from the side that starts there, tolerance included.
  void propagate_into_corner(int v, int c, double low, double high) {
    const int s = core::unfolded_triangles::next(c), last = core::unfolded_triangles::previous(c);
    const double x = apex(s).x, y = apex(s).y;
    const auto meeting = [&](double from_side) {
      const double along = y * std::cos(from_side) + x * std::sin(from_side),
                   perpendicular = y * std::sin(from_side) - x * std::cos(from_side);
      return along > 0 ? std::clamp(x + y * (perpendicular / along), 0.0, length(s)) : length(s);
    };
    const bool first_side = low <= 0, second_side = high >= angle(c);
    const double before = at(v);
    if (first_side) relax_vert(t_.start(s), before + length(c), s, angle(s));
    if (second_side) relax_vert(t_.start(last), before + length(last), last, 0);
    propagate(s, {first_side ? 0 : meeting(low), second_side ? length(s) : meeting(high), x, y, before, s, v});
  }

  void propagate_from_vert(int v) {
    const auto i = static_cast<std::size_t>(v);
    from_ = path_tree::at_vert(v);
    const double from = direction_[i], whole = t_.whole_turn[i],
                 half = std::numbers::pi - core::unfolded_triangles::turn_tolerance;
    for (int k = t_.first_corner[i]; k < t_.first_corner[i + 1]; ++k) {
      const int c = t_.corner[static_cast<std::size_t>(k)];
      const double size = angle(c);
      // clips a range of angles to the corner; they are relative to its first side, and may be one whole turn apart
      const auto part = [&](double low, double high) {
        if (low > high || high < 0 || low > size) return;
        if (t_.is_backward[static_cast<std::size_t>(c)]) propagate_into_corner(v, c, size - high, size - low);
        else propagate_into_corner(v, c, low, high);
      };
      const double begin = t_.turn[static_cast<std::size_t>(c)];
      if (t_.around[i] == core::unfolded_triangles::vert_fan::other || std::isnan(from)) {
        propagate_into_corner(v, c, 0, size);
      } else if (t_.around[i] == core::unfolded_triangles::vert_fan::fan) {
        part(from + half - begin, from + whole - half - begin);
        part(from + half - begin - whole, from - half - begin);
      } else {
        part(from + half - begin, infinity);
        part(-infinity, from - half - begin);
      }
    }
  }

  bool is_off(int s, core::unfolded_triangles::plane_point p) const { return p.y > smallest_part * length(s); }

  /// Starts straight paths from that point through the triangle.
  void start_in(const point_in_triangle& t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const core::unfolded_triangles::plane_point p = t.from[k];
      const int s = t.side[k];
      relax_vert(t_.start(s), plane_norm(p.x, p.y), s, std::clamp(std::atan2(p.y, p.x), 0.0, angle(s)));
      if (is_off(s, p)) propagate(s, {0, length(s), p.x, p.y, 0, s, -1});
    }
  }

 public:
  /// paths: an empty tree, in which the shortest paths are recorded.
  explicit exact_windows(const core::unfolded_triangles& t, path_tree* paths = nullptr)
      : t_(t), paths_(paths), distance_(t.around.size(), infinity), direction_(t.around.size()),
        first_at_apex_(t.vert.size()) {}

  /// Adds a source at vert v, where the path length is length_before.
  void add_vert(int v, double length_before) {
    if (!(length_before < at(v))) return;
    at(v) = length_before;
    if (paths_) paths_->arrive(v, path_tree::none);
    direction_[static_cast<std::size_t>(v)] = std::numeric_limits<double>::quiet_NaN();
    events_.push(length_before, -1 - v);
  }

  /// Adds the only source, in the triangle of side s: x along the side, y perpendicular to it.
  void add_point(int s, double x, double y) {
    std::vector<point_in_triangle> all{seen_from_edges(t_, s, {x, y})};
    for (std::size_t k = 0; k < 3; ++k) {
      const int side = all[0].side[k];
      const core::unfolded_triangles::plane_point p = all[0].from[k];
      if (plane_norm(p.x, p.y) <= smallest_part * length(side)) return add_vert(t_.start(side), plane_norm(p.x, p.y));
      if (is_off(side, p)) continue;
      if (paths_) paths_->start_on(side, std::clamp(p.x / length(side), 0.0, 1.0));
      for (int other = t_.twin[static_cast<std::size_t>(side)]; other != side;
           other = t_.twin[static_cast<std::size_t>(other)])
        all.push_back(seen_from_edges(t_, other, {t_.start(other) == t_.start(side) ? p.x : length(side) - p.x, 0}));
    }
    for (const point_in_triangle& t : all) excluded_.push_back(t.side[0] / 3);
    from_ = path_tree::at_point;
    for (const point_in_triangle& t : all) start_in(t);
  }

  /// The distances of all verts, +inf where no path exists. With a target only distances up to that of the target are
  /// final.
  const std::vector<double>& run(int target = -1) {
    while (!events_.empty()) {
      const auto [when, what] = events_.first();
      if (target >= 0 && safe_factor * when > at(target)) break;
      events_.pop();
      if (what < 0) {
        if (when == at(-1 - what)) propagate_from_vert(-1 - what);
        continue;
      }
      const window w = windows_[static_cast<std::size_t>(what)];
      unused_.push_back(what);
      if (paths_) from_ = node_[static_cast<std::size_t>(what)];
      cross_triangle(w);
      if (paths_) paths_->release(from_);
    }
    return distance_;
  }
};

}  // namespace concino::detail
