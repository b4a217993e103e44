// Defines sweep of planar_segments.hpp.
#pragma once

#include <concino/core/error.hpp>
#include <concino/generate/detail/outlines/segment_status.hpp>
#include <concino/generate/planar_segments.hpp>
#include <concino/geometry/orientation.hpp>
#include <concino/graph/disjoint_sets.hpp>

#include <algorithm>
#include <string>

namespace concino::detail {

/// The sweep line moves in the direction of x; points with equal x are met in the order of y.
class segment_sweep {
  static constexpr std::uint32_t none = segment_status::none;

  const core::planar_segments& g_;
  core::swept_segments result_;
  segment_status status_;
  std::uint32_t tree_ = none;                 // the segments that meet the sweep line, upwards
  std::vector<std::uint32_t> last_;           // by segment that meets the sweep line: the last point met of the region
                                              // above it
  std::vector<std::uint32_t> begin_, starts_;  // begin_[p] to begin_[p + 1]: the segments in starts_ that begin at
                                               // point p
  std::vector<std::uint8_t> is_met_;          // by component, which is the smallest of its points
  disjoint_sets components_;
  std::vector<std::uint32_t> ending_;
  const std::vector<std::uint8_t>* divided_ = nullptr;  // by segment: whether the region above it is divided by
                                                        // diagonals, if not null
  std::vector<std::uint8_t> is_last_;         // by point, if divided_: no segment begins there, so that the region
                                              // needs a diagonal to the next point

  std::string name(std::uint32_t s) const {
    return core::joined({g_.first_input[s], " (points ", g_.segments[s][0], " and ", g_.segments[s][1], ")"});
  }
  int orientation(std::uint32_t s, const vec3& x) const {
    return orient2d(g_.points[g_.segments[s][0]], g_.points[g_.segments[s][1]], x);
  }

  /// Two neighbours in the order must not cross.
  void check_pair(std::uint32_t s, std::uint32_t t) const {
    if (s == none || t == none) return;
    const auto& [a, b] = g_.segments[s];
    const auto& [c, d] = g_.segments[t];
    if (orientation(s, g_.points[c]) * orientation(s, g_.points[d]) < 0 &&
        orientation(t, g_.points[a]) * orientation(t, g_.points[b]) < 0)
      core::throw_joined<invalid_argument>({g_.caller, ": segments ", name(std::min(s, t)), " and ",
                                            name(std::max(s, t)), " cross; divide them by a common point"});
  }

  /// Divides the segments on the sweep line into those below x, through x and above x.
  std::array<std::uint32_t, 3> divide(const vec3& x) {
    std::array<std::uint32_t, 3> parts;
    std::uint32_t others = none;
    status_.split(tree_, [&](std::uint32_t s) { return orientation(s, x) > 0; }, parts[0], others);
    status_.split(others, [&](std::uint32_t s) { return orientation(s, x) == 0; }, parts[1], parts[2]);
    return parts;
  }

  void order_starts(std::uint32_t p) {
    const auto at = [&](std::uint32_t i) { return starts_.begin() + i; };
    std::sort(at(begin_[p]), at(begin_[p + 1]),
              [&](std::uint32_t s, std::uint32_t t) { return orientation(s, g_.points[g_.segments[t][1]]) > 0; });
    for (std::uint32_t i = begin_[p] + 1; i < begin_[p + 1]; ++i)
      if (orientation(starts_[i - 1], g_.points[g_.segments[starts_[i]][1]]) == 0)
        core::throw_joined<invalid_argument>({g_.caller, ": segments ", name(std::min(starts_[i - 1], starts_[i])),
                                              " and ", name(std::max(starts_[i - 1], starts_[i])), " overlap"});
  }

  /// Joins a component to the point before it in the region in which it begins.
  void join_regions(std::uint32_t p, std::uint32_t lower) {
    if (is_met_[components_.root(p)]) return;
    is_met_[components_.root(p)] = 1;
    if (lower != none) result_.bridges.push_back({last_[lower], p});
    else if (begin_[p] < begin_[p + 1]) result_.unbounded_below[starts_[begin_[p]]] = 1;
  }

  /// Joins p to the points before it in regions that begin or end at one of both.
  void divide_regions(std::uint32_t p, std::uint32_t lower) {
    const auto join = [&](std::uint32_t s, bool always) {
      if ((*divided_)[s] && (always || is_last_[last_[s]])) result_.bridges.push_back({last_[s], p});
    };
    if (lower != none) join(lower, ending_.empty());
    for (const std::uint32_t s : ending_) join(s, false);
    is_last_[p] = begin_[p] == begin_[p + 1];
  }

  void meet(std::uint32_t p) {
    auto [below, through, above] = divide(g_.points[p]);
    status_.list(through, ending_);
    for (const std::uint32_t s : ending_)
      if (g_.segments[s][1] != p)
        core::throw_joined<invalid_argument>(
            {g_.caller, ": point ", p, " lies on segment ", name(s), "; make it a point of the line"});
    const std::uint32_t lower = status_.last(below), upper = status_.first(above);
    order_starts(p);
    if (divided_) divide_regions(p, lower);
    else join_regions(p, lower);
    if (lower != none) last_[lower] = p;
    bool inside = lower != none && result_.inside_above[lower];
    std::uint32_t previous = lower;
    for (std::uint32_t i = begin_[p]; i < begin_[p + 1]; ++i) {
      const std::uint32_t s = starts_[i];
      inside = inside != (g_.is_outline[s] != 0);
      result_.inside_above[s] = inside;
      last_[s] = p;
      if (previous == lower) check_pair(lower, s);
      previous = s;
      below = status_.merge(below, status_.single(s));
    }
    check_pair(previous, upper);
    tree_ = status_.merge(below, above);
  }

  void locate(std::uint32_t hole) {
    auto [below, through, above] = divide(g_.holes[hole]);
    if (through != none)
      core::throw_joined<invalid_argument>(
          {g_.caller, ": hole point ", hole, " lies on segment ", name(through), "; it must be inside the hole"});
    result_.below_hole[hole] = status_.last(below);
    tree_ = status_.merge(below, above);
  }

 public:
  explicit segment_sweep(const core::planar_segments& g)
      : g_(g), status_(g.segments.size()), last_(g.segments.size(), none), begin_(g.points.size() + 1, 0),
        starts_(g.segments.size()), is_met_(g.points.size(), 0), components_(g.points.size()) {
    result_.inside_above.assign(g.segments.size(), 0);
    result_.unbounded_below.assign(g.segments.size(), 0);
    result_.below_hole.assign(g.holes.size(), none);
    for (const auto& [a, b] : g.segments) {
      ++begin_[a + 1];
      components_.unite(a, b);
    }
    for (std::size_t p = 1; p < begin_.size(); ++p) begin_[p] += begin_[p - 1];
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    for (std::uint32_t s = 0; s < g.segments.size(); ++s) starts_[next[g.segments[s][0]]++] = s;
  }

  core::swept_segments operator()(const std::vector<std::uint8_t>* divided) {
    divided_ = divided;
    if (divided) is_last_.assign(g_.points.size(), 0);
    std::vector<std::uint32_t> events = g_.used;  // and the hole points, which are counted on
    const auto n = static_cast<std::uint32_t>(g_.points.size());
    for (std::uint32_t h = 0; h < g_.holes.size(); ++h) events.push_back(n + h);
    const auto place = [&](std::uint32_t e) -> const vec3& { return e < n ? g_.points[e] : g_.holes[e - n]; };
    std::sort(events.begin(), events.end(), [&](std::uint32_t a, std::uint32_t b) {
      return core::planar_segments::is_before(place(a), place(b)) || (place(a) == place(b) && a < b);
    });
    for (std::size_t i = 0; i < events.size(); ++i) {
      if (events[i] < n) {
        meet(events[i]);
      } else {
        if (i > 0 && events[i - 1] < n && place(events[i]) == place(events[i - 1]))
          core::throw_joined<invalid_argument>({g_.caller, ": hole point ", events[i] - n, " is at the place of point ",
                                                events[i - 1], "; it must be inside the hole"});
        locate(events[i] - n);
      }
    }
    return std::move(result_);
  }
};

}  // namespace concino::detail

namespace concino::core {

CONCINO_INLINE swept_segments sweep(const planar_segments& g) { return detail::segment_sweep(g)(nullptr); }

CONCINO_INLINE std::vector<std::array<std::uint32_t, 2>> monotone_diagonals(const planar_segments& g,
                                                                            const std::vector<std::uint8_t>& above) {
  return detail::segment_sweep(g)(&above).bridges;
}

}  // namespace concino::core
