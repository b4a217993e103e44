// The lines along which verts slide: chains of edges between corners, and closed ones. A vert moves by a length along
// the line of the input, and never past its neighbours.
#pragma once

#include <concino/core/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace concino::detail {

/// Pairs of numbers of verts.
using vert_pairs = std::vector<std::pair<unsigned, unsigned>>;

class feature_polylines {
  static constexpr unsigned none = std::numeric_limits<unsigned>::max();

  struct line {
    unsigned begin, end;  // its places; a closed line ends with its first vert
    bool is_closed;
  };
  std::vector<vec3> points_;         // of the input, by place
  std::vector<double> input_, now_;  // how far along its line the vert at each place was and is
  std::vector<unsigned> line_of_;    // by place
  std::vector<line> lines_;
  std::vector<unsigned> place_of_;  // by vert, of those that slide

  double length(const line& l) const { return input_[l.end - 1]; }

  /// x in the range of the line; that of a closed one repeats.
  double wrapped(const line& l, double x) const { return l.is_closed ? x - std::floor(x / length(l)) * length(l) : x; }

  /// The place where the segment with x begins.
  unsigned segment(const line& l, double x) const {
    const auto at = std::upper_bound(input_.begin() + l.begin + 1, input_.begin() + l.end - 1, x);
    return static_cast<unsigned>(at - input_.begin()) - 1;
  }

  vec3 direction(unsigned place) const {
    const vec3 d = points_[place + 1] - points_[place];
    return d / norm(d);
  }

  void add_place(const std::vector<vec3>& points, unsigned v) {
    const bool is_first = line_of_.empty() || line_of_.back() != lines_.size();
    input_.push_back(is_first ? 0 : input_.back() + norm(points[v] - points_.back()));
    points_.push_back(points[v]);
    line_of_.push_back(static_cast<unsigned>(lines_.size()));
  }

 public:
  /// edges: of the lines. stays: by vert, whether it may not move. A vert slides if two edges meet there whose
  /// directions differ by no more than the angle of this cosine.
  feature_polylines(const std::vector<vec3>& points, vert_pairs edges, const std::vector<bool>& stays,
                    double least_cosine)
      : place_of_(points.size(), none) {
    const std::size_t num_named = edges.size();
    for (std::size_t i = 0; i < num_named; ++i) edges.emplace_back(edges[i].second, edges[i].first);
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    std::vector<std::size_t> first(points.size() + 1);
    for (const auto& e : edges) ++first[e.first + 1];
    for (std::size_t v = 0; v < points.size(); ++v) first[v + 1] += first[v];
    const auto slides = [&](unsigned v) {
      if (stays[v] || first[v + 1] - first[v] != 2) return false;
      const vec3 a = points[edges[first[v]].second] - points[v], b = points[edges[first[v] + 1].second] - points[v];
      const double la = norm(a), lb = norm(b);
      return la > 0 && lb > 0 && dot(a / la, b / lb) <= -least_cosine;
    };
    const auto walk = [&](unsigned begin, unsigned second) {
      const auto first_place = static_cast<unsigned>(points_.size());
      unsigned before = begin, v = second;
      add_place(points, begin);
      while (v != begin && slides(v)) {
        place_of_[v] = static_cast<unsigned>(points_.size());
        add_place(points, v);
        const unsigned next = edges[first[v] + (edges[first[v]].second == before)].second;
        before = v, v = next;
      }
      add_place(points, v);
      lines_.push_back({first_place, static_cast<unsigned>(points_.size()), v == begin && slides(begin)});
    };
    for (const auto& [a, b] : edges)
      if (!slides(a) && slides(b) && place_of_[b] == none) walk(a, b);
    for (const auto& [a, b] : edges)
      if (slides(a) && place_of_[a] == none) place_of_[a] = static_cast<unsigned>(points_.size()), walk(a, b);
    now_ = input_;
  }

  bool has(unsigned v) const { return place_of_[v] != none; }

  /// The direction of the line at v, the mean of two where the line bends.
  vec3 tangent(unsigned v) const {
    const unsigned place = place_of_[v];
    const line& l = lines_[line_of_[place]];
    const double x = wrapped(l, now_[place]);
    const unsigned i = segment(l, x);
    const vec3 d = direction(i);
    if (x != input_[i] || (i == l.begin && !l.is_closed)) return d;
    const vec3 sum = d + direction(i == l.begin ? l.end - 2 : i - 1);
    const double size = norm(sum);
    return size > 0 ? sum / size : d;
  }

  /// How far along its line v is if it moves by `step`, and whether it stays between its neighbours.
  std::pair<double, bool> moved(unsigned v, double step) const {
    const unsigned place = place_of_[v];
    const line& l = lines_[line_of_[place]];
    const double x = now_[place] + step;
    const bool wraps_before = l.is_closed && place == l.begin, wraps_after = l.is_closed && place + 2 == l.end;
    const double before = wraps_before ? now_[l.end - 2] - length(l) : now_[place - 1],
                 after = wraps_after ? now_[l.begin] + length(l) : now_[place + 1];
    return {x, before < x && x < after};
  }

  vec3 point(unsigned v, double along) const {
    const line& l = lines_[line_of_[place_of_[v]]];
    const double x = wrapped(l, along);
    const unsigned i = segment(l, x);
    const double t = (x - input_[i]) / (input_[i + 1] - input_[i]);
    return t == 0 ? points_[i] : points_[i] + t * (points_[i + 1] - points_[i]);
  }

  void set(unsigned v, double along) { now_[place_of_[v]] = along; }
};

}  // namespace concino::detail
