// Bodies of flip_out.hpp: makes a path along edges straight by flips of intrinsic triangles.
#pragma once

#include <concino/lines/detail/geodesics/flip_out.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

namespace concino::detail {

class path_straightener {
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr double straight = std::numbers::pi - 1e-9;  // angles above count as straight

  struct segment {
    int half_edge, before, after;  // before, after: segments, -1 at the ends
    bool is_used = true;
    int version = 0;               // counts changes of the joint with the segment after it
  };
  struct joint {
    double angle;
    int segment, version;  // between this segment and the one after it
    bool on_left;
    bool operator<(const joint& o) const { return angle > o.angle; }  // the smallest angle is at the top of the heap
  };

  intrinsic_triangles& t_;
  std::vector<segment> segments_;
  std::vector<joint> heap_;
  std::vector<int> num_uses_;  // by edge: how often the path passes it
  std::vector<int> spokes_, arc_;
  bool is_shorter_ = false;

  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  segment& seg(int i) { return segments_[at(i)]; }

  /// The angle counter-clockwise from half-edge `from` to `to`, which have the same start; infinite if the boundary is
  /// between.
  double angle_between(int from, int to) const {
    double sum = 0;
    for (int h = from; h != to; h = t_.counter_clockwise(h)) {
      if (!t_.has_triangle(h)) return infinity;
      sum += t_.corner_angle(h);
      if (sum > straight) return infinity;  // nothing is to be done there
    }
    return sum;
  }

  /// The half-edges at the joint after segment i between which the angle on that side lies, counter-clockwise.
  std::pair<int, int> range_of(int i, bool on_left) {
    const int back = t_.twin[at(seg(i).half_edge)], on = seg(seg(i).after).half_edge;
    return on_left ? std::pair(on, back) : std::pair(back, on);
  }

  void push(int i) {
    if (i < 0 || seg(i).after < 0 || seg(i).after == i) return;
    ++seg(i).version;
    for (const bool on_left : {false, true}) {
      const auto [from, to] = range_of(i, on_left);
      const double angle = angle_between(from, to);
      if (angle >= straight) continue;
      heap_.push_back({angle, i, seg(i).version, on_left});
      std::push_heap(heap_.begin(), heap_.end());
    }
  }

  void remove(int i) {
    is_shorter_ = true;
    seg(i).is_used = false;
    --num_uses_[at(t_.edge(seg(i).half_edge))];
  }

  /// The path runs back along the edge on which it came: both segments go.
  void remove_spike(int i, int j) {
    const int before = seg(i).before, after = seg(j).after;
    remove(i), remove(j);
    if (before == j) return;  // nothing is left of a closed path
    if (before >= 0) seg(before).after = after;
    if (after >= 0) seg(after).before = before;
    push(before);
  }

  /// Flips edges inside the angle until the arc around it is convex. Returns whether the path may take the arc: no part
  /// of it passes through the angle.
  bool flip_inside(int from, int to) {
    spokes_.clear();
    for (int h = from; h != to; h = t_.counter_clockwise(h)) {
      if (h != from && num_uses_[at(t_.edge(h))] > 0) return false;
      spokes_.push_back(h);
    }
    std::size_t k = 1;
    while (k < spokes_.size()) {
      const int before = spokes_[k - 1], h = spokes_[k];
      const double outside = t_.corner_angle(t_.previous(before)) + t_.corner_angle(t_.next[at(h)]);
      const int other = t_.twin[at(h)];
      const bool is_inside_one_triangle = t_.next[at(h)] == other || t_.previous(h) == other;
      if (outside >= straight || is_inside_one_triangle) {
        ++k;
        continue;
      }
      t_.flip(h);
      spokes_.erase(spokes_.begin() + static_cast<std::ptrdiff_t>(k));
      k = std::max<std::size_t>(k - 1, 1);
    }
    return true;
  }

  double arc_length() const {
    double sum = 0;
    for (const int h : spokes_) sum += t_.length[at(t_.next[at(h)])];
    return sum;
  }

  void replace(int i, int j, bool on_left) {
    arc_.clear();
    for (const int h : spokes_) arc_.push_back(t_.next[at(h)]);
    if (on_left) {  // the arc runs counter-clockwise about the joint, from the end of the path's part to its start
      std::reverse(arc_.begin(), arc_.end());
      for (int& h : arc_) h = t_.twin[at(h)];
    }
    const int before = seg(i).before, after = seg(j).after;
    remove(i), remove(j);
    int last = before == j ? -1 : before;
    const int first = static_cast<int>(segments_.size());
    for (const int h : arc_) {
      const int here = static_cast<int>(segments_.size());
      segments_.push_back({h, last, -1});
      ++num_uses_[at(t_.edge(h))];
      if (last >= 0) seg(last).after = here;
      last = here;
    }
    if (before == j) {  // the closed path had two segments
      seg(last).after = first;
      seg(first).before = last;
    } else {
      seg(last).after = after;
      if (after >= 0) seg(after).before = last;
      push(before);
    }
    for (int k = first; k < static_cast<int>(segments_.size()); ++k) push(k);
  }

  void shorten(const joint& top) {
    const int i = top.segment, j = seg(i).after;
    const auto [from, to] = range_of(i, top.on_left);
    if (from == to) return remove_spike(i, j);
    const double length = t_.length[at(seg(i).half_edge)] + t_.length[at(seg(j).half_edge)];
    if (flip_inside(from, to) && arc_length() < length) replace(i, j, top.on_left);
  }

 public:
  explicit path_straightener(intrinsic_triangles& t) : t_(t), num_uses_(t.start.size()) {}

  std::vector<int> run(const std::vector<int>& path, bool is_closed) {
    const int n = static_cast<int>(path.size());
    for (int i = 0; i < n; ++i) {
      segments_.push_back({path[at(i)], i - 1, i + 1 < n ? i + 1 : -1});
      ++num_uses_[at(t_.edge(path[at(i)]))];
    }
    if (is_closed && n > 0) {
      seg(0).before = n - 1;
      seg(n - 1).after = 0;
    }
    do {  // again, since other parts of the path may have left the angles in which they were
      is_shorter_ = false;
      for (int i = 0; i < static_cast<int>(segments_.size()); ++i)
        if (seg(i).is_used) push(i);
      while (!heap_.empty()) {
        std::pop_heap(heap_.begin(), heap_.end());
        const joint top = heap_.back();
        heap_.pop_back();
        if (seg(top.segment).is_used && seg(top.segment).version == top.version) shorten(top);
      }
    } while (is_shorter_);
    return straight_path(is_closed);
  }

 private:
  std::vector<int> straight_path(bool is_closed) {
    int first = -1;
    for (int i = 0; i < static_cast<int>(segments_.size()) && first < 0; ++i)
      if (seg(i).is_used && (is_closed || seg(i).before < 0)) first = i;
    std::vector<int> r;
    for (int i = first; i >= 0;) {
      r.push_back(seg(i).half_edge);
      i = seg(i).after;
      if (i == first) break;
    }
    return r;
  }
};

CONCINO_INLINE std::vector<int> flip_out(intrinsic_triangles& t, const std::vector<int>& path, bool is_closed) {
  return path_straightener(t).run(path, is_closed);
}

}  // namespace concino::detail
