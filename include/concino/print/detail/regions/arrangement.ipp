// Defines arrangement.hpp.
#pragma once

#include <concino/core/error.hpp>
#include <concino/geometry/orientation.hpp>
#include <concino/print/detail/regions/arrangement.hpp>
#include <concino/print/detail/regions/segment_tree.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace concino::detail {

/// Cuts segments in rounds.
class segment_cutter {
  using pair = std::array<std::uint32_t, 2>;
  struct cut {
    pair edge;
    std::uint32_t point;
    friend bool operator==(const cut&, const cut&) = default;
  };

  planar_arrangement& a_;
  std::vector<pair> edges_;
  std::vector<std::array<std::int64_t, 2>> steps_;
  std::vector<cut> cuts_;

  vec3 at(std::uint32_t p) const { return as_vec3(a_.points[p]); }
  static pair sorted(std::uint32_t p, std::uint32_t q) { return p < q ? pair{p, q} : pair{q, p}; }

  /// Whether point p is at most half a unit away from the inner part of an edge.
  bool is_near(const pair& e, std::uint32_t p) const {
    const vec3 a = at(e[0]), step = at(e[1]) - a, x = at(p) - a;
    const double along = dot(x, step), length2 = dot(step, step);
    if (!(along > 0 && along < length2)) return false;
    const double across = step.x * x.y - step.y * x.x;
    return across * across <= 0.25 * length2;
  }
  bool cross(const pair& e, const pair& f) const {
    const vec3 a = at(e[0]), b = at(e[1]), c = at(f[0]), d = at(f[1]);
    return orient2d(a, b, c) * orient2d(a, b, d) < 0 && orient2d(c, d, a) * orient2d(c, d, b) < 0;
  }
  snapped_point crossing(const pair& e, const pair& f) const {
    const vec3 a = at(e[0]), u = at(e[1]) - a, c = at(f[0]), v = at(f[1]) - c, w = c - a;
    const double t = std::clamp((w.x * v.y - w.y * v.x) / (u.x * v.y - u.y * v.x), 0.0, 1.0);
    return {static_cast<std::int64_t>(std::nearbyint(a.x + t * u.x)),
            static_cast<std::int64_t>(std::nearbyint(a.y + t * u.y))};
  }

  void list_edges() {
    edges_.clear();
    std::size_t begin = 0;
    for (const std::size_t end : a_.chain_ends) {
      for (std::size_t k = begin + 1; k < end; ++k)
        edges_.push_back(sorted(a_.chain_points[k - 1], a_.chain_points[k]));
      begin = end;
    }
    std::sort(edges_.begin(), edges_.end());
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
  }

  void find_cuts() {
    cuts_.clear();
    std::vector<lattice_segment> segments;
    segments.reserve(edges_.size());
    for (const pair& e : edges_) segments.push_back({a_.points[e[0]], a_.points[e[1]]});
    segment_tree(segments).for_each_pair([&](std::uint32_t i, std::uint32_t j) {
      const pair &e = edges_[i], &f = edges_[j];
      for (const std::uint32_t p : f)
        if (p != e[0] && p != e[1] && is_near(e, p)) cuts_.push_back({e, p});
      for (const std::uint32_t p : e)
        if (p != f[0] && p != f[1] && is_near(f, p)) cuts_.push_back({f, p});
      if (cross(e, f)) {
        const auto p = static_cast<std::uint32_t>(a_.points.size());
        a_.points.push_back(crossing(e, f));
        cuts_.push_back({e, p});
        cuts_.push_back({f, p});
      }
      return true;
    });
  }

  /// The cuts of an edge in the direction from p to q.
  void cut_between(std::uint32_t p, std::uint32_t q, std::vector<std::uint32_t>& to) const {
    const pair e = sorted(p, q);
    const auto first =
        std::lower_bound(cuts_.begin(), cuts_.end(), e, [](const cut& c, const pair& x) { return c.edge < x; });
    auto last = first;
    while (last != cuts_.end() && last->edge == e) ++last;
    const auto add = [&](std::uint32_t x) {
      if (to.back() != x) to.push_back(x);
    };
    if (p == e[0])
      for (auto c = first; c != last; ++c) add(c->point);
    else
      for (auto c = last; c != first;) add((--c)->point);
    add(q);
  }

  void apply_cuts() {
    unite_points();
    for (cut& c : cuts_) c.point = a_.point_of[c.point];
    const auto along = [&](const cut& c) { return dot(at(c.point) - at(c.edge[0]), at(c.edge[1]) - at(c.edge[0])); };
    std::sort(cuts_.begin(), cuts_.end(), [&](const cut& x, const cut& y) {
      if (x.edge != y.edge) return x.edge < y.edge;
      const double s = along(x), t = along(y);
      return s < t || (s == t && x.point < y.point);
    });
    std::vector<std::uint32_t> points;
    std::size_t begin = 0;
    for (std::size_t& end : a_.chain_ends) {
      points.push_back(a_.chain_points[begin]);
      for (std::size_t k = begin + 1; k < end; ++k) cut_between(a_.chain_points[k - 1], a_.chain_points[k], points);
      begin = end;
      end = points.size();
    }
    a_.chain_points = std::move(points);
  }

  /// Makes points at one place one point, the first; point_of says which.
  void unite_points() {
    std::vector<std::uint32_t> order(a_.points.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
      return a_.points[i] != a_.points[j] ? a_.points[i] < a_.points[j] : i < j;
    });
    a_.point_of.resize(a_.points.size());
    for (std::size_t k = 0; k < order.size(); ++k)
      a_.point_of[order[k]] =
          k > 0 && a_.points[order[k]] == a_.points[order[k - 1]] ? a_.point_of[order[k - 1]] : order[k];
  }

  void sum_steps(const stepped_segments& s) {
    steps_.assign(edges_.size(), {0, 0});
    for (std::size_t i = 0; i < s.segments.size(); ++i) {
      const auto chain = a_.chain(i);
      for (std::size_t k = 1; k < chain.size(); ++k) {
        const pair e = sorted(chain[k - 1], chain[k]);
        auto& step =
            steps_[static_cast<std::size_t>(std::lower_bound(edges_.begin(), edges_.end(), e) - edges_.begin())];
        for (const std::size_t c : {0u, 1u})
          step[c] += chain[k - 1] == e[0] ? s.segments[i].step[c] : -s.segments[i].step[c];
      }
    }
  }

 public:
  explicit segment_cutter(planar_arrangement& a) : a_(a) {}

  void run(const char* caller, const stepped_segments& s) {
    a_.points = s.points;
    unite_points();
    for (const stepped_segments::segment& x : s.segments) {
      a_.chain_points.push_back(a_.point_of[x.from]);
      if (a_.point_of[x.to] != a_.point_of[x.from]) a_.chain_points.push_back(a_.point_of[x.to]);
      a_.chain_ends.push_back(a_.chain_points.size());
    }
    for (int round = 0;; ++round) {
      list_edges();
      find_cuts();
      if (cuts_.empty()) break;
      if (round == 100)
        core::throw_joined<unsupported>({caller, ": the contours could not be cut where they meet; scale them"});
      apply_cuts();
    }
    sum_steps(s);
    a_.edges.reserve(edges_.size());
    for (std::size_t i = 0; i < edges_.size(); ++i) a_.edges.push_back({edges_[i][0], edges_[i][1], steps_[i]});
  }
};

CONCINO_INLINE planar_arrangement arrange(const char* caller, const stepped_segments& s) {
  planar_arrangement result;
  segment_cutter(result).run(caller, s);
  return result;
}

/// Whether segments a b and c d have a common point.
inline bool segments_meet(const vec3& a, const vec3& b, const vec3& c, const vec3& d) {
  const int ac = orient2d(a, b, c), ad = orient2d(a, b, d);
  if (ac != 0 || ad != 0) return ac * ad <= 0 && orient2d(c, d, a) * orient2d(c, d, b) <= 0;
  return std::max(std::min(a.x, b.x), std::min(c.x, d.x)) <= std::min(std::max(a.x, b.x), std::max(c.x, d.x)) &&
         std::max(std::min(a.y, b.y), std::min(c.y, d.y)) <= std::min(std::max(a.y, b.y), std::max(c.y, d.y));
}

CONCINO_INLINE bool meet(const lattice_paths& paths) {
  std::vector<lattice_segment> segments;
  std::vector<std::uint32_t> next;  // by segment: the next one of its path
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const auto path = paths[i];
    const auto first = static_cast<std::uint32_t>(segments.size());
    for (std::size_t k = 0; k < path.size(); ++k) {
      segments.push_back({path[k], path[(k + 1) % path.size()]});
      next.push_back(k + 1 < path.size() ? static_cast<std::uint32_t>(segments.size()) : first);
    }
  }
  bool found = false;
  segment_tree(segments).for_each_pair([&](std::uint32_t i, std::uint32_t j) {
    const vec3 a = as_vec3(segments[i][0]), b = as_vec3(segments[i][1]), c = as_vec3(segments[j][0]),
               d = as_vec3(segments[j][1]);
    if (next[i] == j) found = orient2d(a, b, d) == 0 && dot(a - b, d - b) > 0;  // doubled back
    else if (next[j] == i) found = orient2d(a, b, c) == 0 && dot(b - a, c - a) > 0;
    else found = segments_meet(a, b, c, d);
    return !found;
  });
  return found;
}

}  // namespace concino::detail
