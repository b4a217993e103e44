// Removes triangles that are so flat that nobody would miss them, before a surface is remeshed: their normals mean
// nothing, and splits of their edges make more of them.
//
// A needle, which has one very short edge, vanishes if this edge is collapsed. Otherwise the corner opposite to the
// longest edge lies nearly on that: the edge is flipped, or, on a line, split there and the two verts become one. No
// point moves by more than the height of the triangle or the length of the short edge. All lengths and points are unit
// points.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/edit/edge_collapse.hpp>
#include <concino/edit/edge_flip.hpp>
#include <concino/edit/edge_split.hpp>
#include <concino/remesh/detail/feature_lines.hpp>
#include <concino/remesh/detail/unit_points.hpp>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <vector>

namespace concino::detail {

template<class M>
class flat_triangle_remover {
  static constexpr double thin = 1e-3;          // the height of a flat triangle, as a multiple of its longest edge and
                                                // of the wanted length
  static constexpr double min_cosine = 0.5;     // between the normals of other triangles before and after a collapse
  static constexpr std::size_t max_edits = 20;  // for each triangle that is flat at first, on average

  M& m_;
  const unit_points& unit_;
  feature_lines<M>& lines_;  // what is kept: boundaries, non-manifold edges and those that the caller names
  std::vector<poly_t<M>> found_;

  struct triangle {
    std::array<vert_t<M>, 3> verts;
    std::array<vec3, 3> points;
    unsigned top = 0;     // the corner opposite to the longest edge
    unsigned needle = 0;  // the corner opposite to the shortest edge
    double longest = 0, shortest = 0;

    vec3 area() const { return cross(points[1] - points[0], points[2] - points[0]); }
  };

  bool read(const poly_t<M>& p, triangle& t) const {
    std::size_t n = 0;
    for (const vert_t<M> v : adj_p2v(m_, p)) {
      if (n == 3) return false;
      t.verts[n] = v, t.points[n] = unit_.at(m_, v);
      ++n;
    }
    if (n != 3) return false;
    for (unsigned i = 0; i < 3; ++i) {
      const double length = distance(t.points[(i + 1) % 3], t.points[(i + 2) % 3]);
      if (i == 0 || length > t.longest) t.longest = length, t.top = i;
      if (i == 0 || length < t.shortest) t.shortest = length, t.needle = i;
    }
    return true;
  }
  bool is_flat(const triangle& t, double size) const {
    return norm(t.area()) <= thin * t.longest * std::min(t.longest, size);
  }

  bool edge_opposite_to(const poly_t<M>& p, const vert_t<M>& v, edge_t<M>& found) const {
    for (const edge_t<M> e : adj_p2e(m_, p)) {
      const auto ends = end_verts(m_, e);
      if (ends.first != v && ends.second != v) return found = e, true;
    }
    return false;
  }

  /// Whether a triangle at b that is not flat would turn if b moved to x.
  bool would_turn(const vert_t<M>& b, const vert_t<M>& a, const vec3& x, double size) const {
    for (const poly_t<M> p : adj_v2p(m_, b)) {
      triangle before;
      if (!read(p, before)) return true;
      triangle after = before;
      bool vanishes = false;
      for (unsigned i = 0; i < 3; ++i) {
        vanishes = vanishes || before.verts[i] == a;
        if (before.verts[i] == b) after.points[i] = x;
      }
      if (vanishes || is_flat(before, size)) continue;
      const vec3 u = before.area(), v = after.area();
      if (!(dot(u, v) > min_cosine * norm(u) * norm(v))) return true;
    }
    return false;
  }

  /// Collapses e; the end that may move less stays where it is. What was a line at one of the ends remains one.
  bool collapse(const edge_t<M>& e, double size) {
    const auto [a, b] = end_verts(m_, e);
    const auto of_a = lines_.freedom(m_, a), of_b = lines_.freedom(m_, b);
    const bool is_on_line = lines_.has(m_, e), keeps_b = of_b > of_a;
    const bool both_on_lines = of_a != vert_freedom::surface && of_b != vert_freedom::surface,
               both_fixed = std::min(of_a, of_b) == vert_freedom::none;
    if (both_on_lines && (!is_on_line || both_fixed)) return false;
    const vert_t<M> kept = keeps_b ? b : a, removed = keeps_b ? a : b;
    if (would_turn(removed, kept, unit_.at(m_, kept), size)) return false;
    std::vector<vert_t<M>> on_lines;
    for (const vert_t<M>& v : {a, b})
      for (const edge_t<M> f : adj_v2e(m_, v)) {
        const auto ends = end_verts(m_, f);
        const vert_t<M> other = ends.first == v ? ends.second : ends.first;
        if (!lines_.has(m_, f) || other == a || other == b) continue;
        // two lines would become one
        if (std::find(on_lines.begin(), on_lines.end(), other) != on_lines.end()) return false;
        on_lines.push_back(other);
      }
    const auto r = edge_collapse(m_, e, {.at = keeps_b ? 1.0 : 0.0, .only_simplices = true});
    if (!r) return false;
    lines_.set(m_, r.vert, std::max(of_a, of_b));
    for (const edge_t<M> f : adj_v2e(m_, r.vert)) {
      const auto ends = end_verts(m_, f);
      lines_.set(m_, f,
                 std::find(on_lines.begin(), on_lines.end(), ends.first == r.vert ? ends.second : ends.first) !=
                     on_lines.end());
    }
    ++num_collapses;
    find_at(r.vert);
    return true;
  }

  void find_at(const vert_t<M>& v) {
    for (const poly_t<M> p : adj_v2p(m_, v)) found_.push_back(p);
  }

  bool flip(const edge_t<M>& e, const vert_t<M>& top) {
    const auto r = edge_flip(m_, e);
    if (!r) return false;
    lines_.set(m_, r.edge, false);
    ++num_flips;
    find_at(top);
    return true;
  }

  /// Splits e, the longest edge, at the point nearest to the opposite corner, which becomes one with the new vert. If
  /// that is refused, the split is undone.
  bool split_and_merge(const edge_t<M>& e, const triangle& t, double size) {
    const auto [a, b] = end_verts(m_, e);
    const vec3 x = unit_.at(m_, a), along = unit_.at(m_, b) - x;
    const double whole = dot(along, along), at = whole > 0 ? dot(t.points[t.top] - x, along) / whole : 0;
    if (!(at > 0 && at < 1) || lines_.freedom(m_, t.verts[t.top]) != vert_freedom::surface) return false;
    const bool was_on_line = lines_.has(m_, e);
    const auto r = edge_split(m_, e, at, {.only_simplices = true});
    if (!r) return false;
    lines_.split(m_, was_on_line, r.vert, a, b);
    edge_t<M> back{};
    for (const edge_t<M> f : adj_v2e(m_, r.vert)) {
      const auto ends = end_verts(m_, f);
      const vert_t<M> other = ends.first == r.vert ? ends.second : ends.first;
      if (other == t.verts[t.top] && collapse(f, size)) return ++num_splits, true;
    }
    for (const edge_t<M> f : adj_v2e(m_, r.vert)) {
      const auto ends = end_verts(m_, f);
      if (ends.first == a || ends.second == a) back = f;
    }
    const bool keeps_second = end_verts(m_, back).second == a;
    edge_collapse(m_, back, {.at = keeps_second ? 1.0 : 0.0, .keeps_second = keeps_second, .only_simplices = true});
    for (const edge_t<M> f : adj_v2e(m_, a)) {
      const auto ends = end_verts(m_, f);
      if (ends.first == b || ends.second == b) lines_.set(m_, f, was_on_line);
    }
    return false;
  }

  bool has_needle(const triangle& t, double size) const { return t.shortest <= thin * std::min(t.longest, size); }

  /// Goes from p, which is flat, over its longest edge as long as the next triangle is flat too and has a longer one. A
  /// flip of an edge that is the longest of both its triangles makes a shorter one, so there is an end to flips.
  void go_to_longest(poly_t<M>& p, triangle& t, double size) const {
    for (bool goes_on = true; goes_on;) {
      edge_t<M> e{};
      goes_on = false;
      if (!edge_opposite_to(p, t.verts[t.top], e) || lines_.has(m_, e)) return;
      for (const poly_t<M> q : adj_e2p(m_, e)) {
        triangle next;
        if (q == p || !read(q, next) || !is_flat(next, size) || !(next.longest > t.longest)) continue;
        p = q, t = next, goes_on = true;
        break;
      }
    }
  }

  bool remove(poly_t<M> p, triangle t, double size) {
    edge_t<M> e{};
    if (has_needle(t, size) && edge_opposite_to(p, t.verts[t.needle], e) && collapse(e, size)) return true;
    const poly_t<M> first = p;
    go_to_longest(p, t, size);
    if (!(p == first)) found_.push_back(first);
    if (!(t.longest > 0) || !edge_opposite_to(p, t.verts[t.top], e)) return false;
    return lines_.has(m_, e) ? split_and_merge(e, t, size) : flip(e, t.verts[t.top]);
  }

 public:
  std::size_t num_splits = 0, num_collapses = 0, num_flips = 0;

  flat_triangle_remover(M& m, const unit_points& unit, feature_lines<M>& lines) : m_(m), unit_(unit), lines_(lines) {}

  /// size_at(x): the wanted length of edges at a point.
  template<class F>
  void remove_all(const F& size_at) {
    triangle t;
    for (const poly_t<M> p : polys(m_))
      if (read(p, t) && is_flat(t, t.longest) && is_flat(t, size_at(t.points[0]))) found_.push_back(p);
    for (std::size_t left = max_edits * found_.size(); left > 0 && !found_.empty(); --left) {
      const poly_t<M> p = found_.back();
      found_.pop_back();
      if (!contains(m_, p) || !read(p, t)) continue;
      if (!is_flat(t, t.longest)) continue;
      if (const double size = size_at(t.points[0]); is_flat(t, size)) remove(p, t, size);
    }
  }
};

}  // namespace concino::detail
