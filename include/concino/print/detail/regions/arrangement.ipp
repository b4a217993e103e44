// Defines arrangement.hpp.
#pragma once

#include <concino/core/error.hpp>
#include <concino/print/detail/regions/arrangement.hpp>
#include <concino/print/detail/regions/segment_cuts.hpp>

#include <algorithm>

namespace concino::detail {

/// Cuts segments in rounds.
class segment_cutter {
  using pair = numbered_segment;
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
    for (const auto& [segment, point] : detail::find_cuts(a_.points, edges_)) cuts_.push_back({edges_[segment], point});
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

CONCINO_INLINE bool meet(const lattice_paths& paths) {
  std::vector<snapped_point> points = paths.points;
  std::vector<numbered_segment> segments;
  for (std::uint32_t i = 0, first = 0; i < paths.size(); ++i) {
    const auto last = static_cast<std::uint32_t>(paths.ends[i]) - 1;
    if (last < first + 2) return true;
    for (std::uint32_t p = first; p <= last; ++p) segments.push_back({p, p == last ? first : p + 1});
    first = last + 1;
  }
  std::sort(points.begin(), points.end());
  if (std::adjacent_find(points.begin(), points.end()) != points.end()) return true;
  points = paths.points;
  return !detail::find_cuts(points, segments, true).empty();
}

}  // namespace concino::detail
