// Bounds of distances: straight lines through space from below; ways along edges and straight across triangles or tets from above. Works on flat
// arrays, independent of the type of the mesh.
#pragma once

#include <concino/core/indexed_heap.hpp>
#include <concino/core/vec3.hpp>
#include <concino/fields/detail/straight_distance.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace concino::detail {

/// Edges, and triangles or tets inside the polys, whose corners are verts. Sizes are near 1.
///
/// A front that has come straight from a source to two corners of a triangle, or three of a tet, comes to the last one from the place that is as far
/// from those as they are from the source, if the line from there passes between them: on a plane and in space that is exact. On other surfaces the
/// front is also curved as the Gaussian curvature on its way makes it.
class distance_graph {
  struct neighbour {
    double length;
    int vert;
  };
  /// Of a triangle, seen from one of its corners.
  struct corner {
    int ends[2];  // the other corners
    double lengths[2];
    double cosine, sine;  // of the angle between
  };
  /// Of a tet: the plane of three corners a, b and c, with a at the origin and b at (length, 0), and in it the foot of the last corner.
  struct side {
    double length;
    double cx, cy;
    double x, y, height;
  };

  std::size_t corners_;  // of a simplex
  std::vector<vec3> place_;
  std::vector<std::size_t> neighbour_begin_;  // of each vert
  std::vector<neighbour> neighbour_;
  std::vector<std::size_t> simplex_begin_;  // of each vert
  std::vector<corner> corner_;              // of triangles at each vert
  std::vector<double> curvature_;           // Gaussian, at each vert of a surface; 0 on the boundary
  std::vector<int> tet_at_;                 // each vert
  std::vector<int> tet_;                    // its corners
  std::vector<side> side_;                  // of each tet, that without the first corner first

  static constexpr double infinity = std::numeric_limits<double>::infinity();

  /// Where the list of each vert begins that counts how often it is named.
  static std::vector<std::size_t> count(std::size_t size, const std::vector<int>& verts) {
    std::vector<std::size_t> begin(size + 1);
    for (const int v : verts) ++begin[static_cast<std::size_t>(v) + 1];
    for (std::size_t i = 0; i < size; ++i) begin[i + 1] += begin[i];
    return begin;
  }

  corner seen_from(int vert, int end, int other) const {
    const auto at = [&](int v) { return place_[static_cast<std::size_t>(v)]; };
    const vec3 a = at(end) - at(vert), b = at(other) - at(vert), normal = cross(a, b);
    const double x = std::sqrt(dot(a, a)), y = std::sqrt(dot(b, b));
    const bool is_point = !(x > 0 && y > 0);
    return {{end, other}, {x, y}, is_point ? 0 : dot(a, b) / x / y, is_point ? 0 : std::sqrt(dot(normal, normal)) / x / y};
  }

  void add_triangles(const std::vector<int>& triangles) {
    corner_.resize(triangles.size());
    std::vector<std::size_t> next = simplex_begin_;
    for (std::size_t i = 0; i < triangles.size(); i += 3)
      for (std::size_t k = 0; k < 3; ++k) {
        const int v = triangles[i + k];
        corner_[next[static_cast<std::size_t>(v)]++] = seen_from(v, triangles[i + (k + 1) % 3], triangles[i + (k + 2) % 3]);
      }
    find_curvature();
  }

  void find_curvature() {
    constexpr double turn = 6.28318530717958647692;
    curvature_.assign(place_.size(), 0.0);
    std::vector<std::uint32_t> times(place_.size());  // that a vert was met around this one
    for (std::size_t v = 0; v < place_.size(); ++v) {
      double angle = 0, area = 0;
      bool is_inside = true;
      const auto for_each_end = [&](const auto& f) {
        for (std::size_t k = simplex_begin_[v]; k < simplex_begin_[v + 1]; ++k)
          for (const int w : corner_[k].ends) f(times[static_cast<std::size_t>(w)]);
      };
      for (std::size_t k = simplex_begin_[v]; k < simplex_begin_[v + 1]; ++k) {
        const corner& c = corner_[k];
        angle += std::atan2(c.sine, c.cosine);
        area += c.lengths[0] * c.lengths[1] * c.sine / 6;
      }
      for_each_end([](std::uint32_t& n) { ++n; });
      for_each_end([&](std::uint32_t n) { is_inside = is_inside && n == 2; });
      for_each_end([](std::uint32_t& n) { n = 0; });
      if (is_inside && area > 0) curvature_[v] = (turn - angle) / area;
    }
  }

  side seen_from(const vec3& a, const vec3& b, const vec3& c, const vec3& last) const {
    const vec3 ab = b - a, ac = c - a, to = last - a, normal = cross(ab, ac);
    const double length = std::sqrt(dot(ab, ab)), area = std::sqrt(dot(normal, normal));
    if (!(area > 0)) return {};
    const vec3 e = ab / length, f = cross(normal, e) / area;
    return {length, dot(ac, e), dot(ac, f), dot(to, e), dot(to, f), std::abs(dot(to, normal)) / area};
  }

  void add_tets() {
    tet_at_.resize(tet_.size());
    side_.resize(tet_.size());
    std::vector<std::size_t> next = simplex_begin_;
    for (std::size_t i = 0; i < tet_.size(); ++i) {
      tet_at_[next[static_cast<std::size_t>(tet_[i])]++] = static_cast<int>(i);
      const std::size_t first = i / 4 * 4, last = i - first;
      const auto at = [&](std::size_t k) { return place_[static_cast<std::size_t>(tet_[first + k])]; };
      side_[i] = seen_from(at(others[last][0]), at(others[last][1]), at(others[last][2]), at(last));
    }
  }

  static constexpr std::size_t others[4][3] = {{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}};

  /// A way straight across a triangle, seen from one of its corners, to the last of its ends from a source that is `near` away from the other end.
  struct crossing {
    const corner* triangle;
    std::size_t last;  // which of the ends
    double near;
    double bend;  // how much less the front is curved than on a plane: it is so much further behind between the two corners
    double way;   // from the source, if that is seen between the two
    bool is_seen;

    /// from: how far the corner is from the source. Has no branches: they would be hard to predict, and without them several crossings overlap.
    void find_way(double from) {
      const double length = triangle->lengths[1 - last], to = triangle->lengths[last];
      const double along = to * triangle->cosine, up = to * triangle->sine;
      const double x = (length + (from - near) * (from + near) / length) / 2, y2 = (from - x) * (from + x), y = std::sqrt(std::max(y2, 0.0));
      constexpr double least = std::numeric_limits<double>::min();  // 0 divided by it is 0
      const double height = up + y, through = x + y / std::max(height, least) * (along - x);
      const double square = (along - x) * (along - x) + height * height;
      way = std::sqrt(square) + bend * through * (length - through) * (height * height / std::max(square, least)) / 2;
      // A front that comes together within about the length of the edge, as on the far side of a ball, is not known well enough.
      const bool is_wide = bend * length < 0.5;
      is_seen = is_wide & (y2 >= -1e-9 * from * from) & (through >= -1e-9 * length) & (through <= (1 + 1e-9) * length);
    }
  };

  /// How far the last corner of a tet is from the source that is da, db and dc away from the others, if it is seen between these; +inf if that is
  /// more than `most` for sure.
  static double across(const side& s, double da, double db, double dc, double most) {
    if (!(s.length > 0)) return infinity;
    const double x = (s.length + (da - db) * (da + db) / s.length) / 2;
    const double y = (s.cx * s.cx + s.cy * s.cy - 2 * s.cx * x + (da - dc) * (da + dc)) / (2 * s.cy);
    if (da * da + s.x * (s.x - 2 * x) + s.y * (s.y - 2 * y) + s.height * s.height > most * most) return infinity;
    const double z2 = (da - x) * (da + x) - y * y;
    if (!(z2 >= -1e-9 * da * da)) return infinity;
    const double z = std::sqrt(std::max(z2, 0.0)), height = z + s.height, part = height > 0 ? z / height : 0;
    const double px = x + part * (s.x - x), py = y + part * (s.y - y);  // where it passes
    const double of_c = py / s.cy, of_b = (px - of_c * s.cx) / s.length, least = -1e-9;
    if (!(of_c >= least && of_b >= least && of_b + of_c <= 1 - least)) return infinity;
    return std::sqrt((s.x - x) * (s.x - x) + (s.y - y) * (s.y - y) + height * height);
  }

  struct node {
    double way = infinity;
    double before = 0;
    double bend = 0;  // 1 / distance minus the curvature of the front: 0 on a plane; where step is not 0, as it was a step before
    double radius = 0, step = 0;
    double mean_curvature = 0;  // on that step
    double curvature = 0;
    int source = -1;
    std::uint8_t state = 0;  // 1: reached for good but for ways found later, of which a vert takes few
    bool is_settled() const { return state & 1; }

    /// Riccati's equation c' = -c^2 - K for the curvature c of a front, with c = 1 / radius - bend; a front that is as narrow as a step is not
    /// known.
    void find_bend() {
      if (!(step > 0)) return;
      const double rate = mean_curvature - 2 * bend / std::max(radius, step) + bend * bend, most = 1 / step;
      bend = std::clamp(bend + step * rate, -most, most);
      step = 0;
    }
  };

 public:
  /// edges: two verts each, and lines within polys that are no edges. simplices: of triangles (corners 3) or tets (4).
  distance_graph(std::vector<vec3> place, const std::vector<int>& edges, std::vector<int> simplices, std::size_t corners)
      : corners_(corners), place_(std::move(place)), neighbour_begin_(count(place_.size(), edges)), neighbour_(edges.size()),
        simplex_begin_(count(place_.size(), simplices)) {
    std::vector<std::size_t> next = neighbour_begin_;
    for (std::size_t i = 0; i < edges.size(); i += 2) {
      const int v = edges[i], w = edges[i + 1];
      const double length = distance(place_[static_cast<std::size_t>(v)], place_[static_cast<std::size_t>(w)]);
      neighbour_[next[static_cast<std::size_t>(v)]++] = {length, w};
      neighbour_[next[static_cast<std::size_t>(w)]++] = {length, v};
    }
    if (corners_ == 3) {
      add_triangles(simplices);
    } else {
      tet_ = std::move(simplices);
      add_tets();
    }
  }

  const vec3& place(std::size_t v) const { return place_[v]; }

  /// The lengths of ways to each vert from the given verts, whose distances are given; +inf where none leads. Ways longer than `longest` may be
  /// left out.
  /// Verts with the same source share its number.
  struct start {
    int vert, source;
    double distance;  // from the source, 0 or more
    double before;    // at the source
  };
  std::vector<double> ways_from(const std::vector<start>& starts, double longest) const;

 private:
  class search;
};

/// One search for shortest ways.
class distance_graph::search {
  static constexpr std::uint8_t most_changes = 64;

  const distance_graph& graph_;
  const double longest_;
  std::vector<node> node_;
  std::vector<double> waiting_;  // the ways to those in the queue
  core::indexed_heap<int> queue_;
  std::vector<int> offered_;         // since the last vert left the queue
  std::vector<crossing> crossings_;
  std::vector<std::uint8_t> known_;  // of each tet: bits of corners that are settled

  node& at(int v) { return node_[static_cast<std::size_t>(v)]; }
  const node& at(int v) const { return node_[static_cast<std::size_t>(v)]; }

  void offer(int vert, double length, const node& from) {
    node& n = at(vert);
    n.way = length;
    n.source = from.source;
    n.before = from.before;
    offered_.push_back(vert);
  }
  void offer(int vert, double length, const node& from, double bend, double radius, double step) {
    offer(vert, length, from);
    node& n = at(vert);
    n.bend = bend;
    n.radius = radius;
    n.step = step;
    n.mean_curvature = (from.curvature + n.curvature) / 2;
    if (n.is_settled()) n.find_bend();
  }
  void queue_offered() {
    for (const int v : offered_) {
      const auto i = static_cast<std::size_t>(v);
      if (node_[i].way < waiting_[i] && node_[i].way <= longest_) queue_.lower(v, i, node_[i].way);
    }
    offered_.clear();
  }

  /// Whether a way across to a vert is much better than the one that is known; it may be changed once more then.
  static bool improves(node& n, double way) {
    if (!(n.way - way > 1e-14 * std::abs(way))) return false;
    if (n.is_settled()) n.state = static_cast<std::uint8_t>(n.state + 2);
    return true;
  }

  /// Whether the front may have come to the end of the triangle that is `last` through the other one, which is then told.
  bool may_cross(const node& from, const corner& triangle, std::size_t last, crossing& c) const {
    const node &other = at(triangle.ends[1 - last]), &to = at(triangle.ends[last]);
    c.triangle = &triangle;
    c.last = last;
    c.near = other.way - from.before;
    c.bend = (from.bend + other.bend) / 2;
    const bool is_known = other.is_settled(), may_change = to.state < most_changes;
    const bool is_ahead = to.way > std::min(from.way, other.way);  // else the front has been there before
    return is_known & may_change & is_ahead & (other.source == from.source);
  }

  void cross_triangles(std::size_t v) {
    const node& from = node_[v];
    const std::size_t first = graph_.simplex_begin_[v], end = graph_.simplex_begin_[v + 1];
    if (crossings_.size() < 2 * (end - first)) crossings_.resize(2 * (end - first));
    std::size_t n = 0;
    for (std::size_t k = first; k < end; ++k) {
      const corner& triangle = graph_.corner_[k];
      const node &a = at(triangle.ends[0]), &b = at(triangle.ends[1]);
      const std::size_t farther = b.way > a.way, nearer = 1 - farther;
      n += may_cross(from, triangle, farther, crossings_[n]);
      if (std::min(a.way, b.way) > from.way && at(triangle.ends[farther]).is_settled()) n += may_cross(from, triangle, nearer, crossings_[n]);
    }
    const double there = from.before;
    for (std::size_t i = 0; i < n; ++i) crossings_[i].find_way(from.way - there);
    bool is_stale = false;
    for (std::size_t i = 0; i < n; ++i) {
      crossing& c = crossings_[i];
      if (is_stale) {
        if (!may_cross(from, *c.triangle, c.last, c)) continue;
        c.find_way(from.way - there);
      }
      const int vert = c.triangle->ends[c.last];
      if (!c.is_seen || !improves(at(vert), there + c.way)) continue;
      is_stale = is_stale || at(vert).is_settled();
      const double way = there + c.way, mean = (from.way - there + c.near) / 2;
      offer(vert, way, from, c.bend, mean, std::max(c.way - mean, 0.25 * c.triangle->lengths[c.last]));
    }
  }

  void cross(const node& from, const int* corners, const side& s, std::size_t last) {
    const node &a = at(corners[others[last][0]]), &b = at(corners[others[last][1]]), &c = at(corners[others[last][2]]);
    node& to = at(corners[last]);
    if (a.source != from.source || b.source != from.source || c.source != from.source || to.state >= most_changes) return;
    if (to.way <= std::min({a.way, b.way, c.way})) return;
    const double there = from.before;
    const double way = there + across(s, a.way - there, b.way - there, c.way - there, to.way - there);
    if (improves(to, way)) offer(corners[last], way, from);
  }

  void visit_triangles(std::size_t v) {
    const node& from = node_[v];
    for (std::size_t k = graph_.neighbour_begin_[v]; k < graph_.neighbour_begin_[v + 1]; ++k) {
      const neighbour& n = graph_.neighbour_[k];
      const double way = from.way + n.length;
      if (way < at(n.vert).way) offer(n.vert, way, from, from.bend, from.way - from.before, n.length);
    }
    cross_triangles(v);
  }

  void visit_tets(std::size_t v) {
    const node& from = node_[v];
    for (std::size_t k = graph_.neighbour_begin_[v]; k < graph_.neighbour_begin_[v + 1]; ++k) {
      const neighbour& n = graph_.neighbour_[k];
      const double way = from.way + n.length;
      if (way < at(n.vert).way) offer(n.vert, way, from);
    }
    for (std::size_t k = graph_.simplex_begin_[v]; k < graph_.simplex_begin_[v + 1]; ++k) {
      const auto i = static_cast<std::size_t>(graph_.tet_at_[k]), first = i / 4 * 4;
      std::uint8_t& known = known_[i / 4];
      known = static_cast<std::uint8_t>(known | 1u << (i - first));
      for (std::size_t last = 0; last < 4; ++last)
        if (first + last != i && (known | 1u << last) == 15) cross(from, &graph_.tet_[first], graph_.side_[first + last], last);
    }
  }

 public:
  search(const distance_graph& graph, double longest)
      : graph_(graph), longest_(longest), node_(graph.place_.size()), waiting_(node_.size(), infinity), queue_(waiting_),
        known_(graph.tet_.size() / 4) {
    for (std::size_t i = 0; i < graph.curvature_.size(); ++i) node_[i].curvature = graph.curvature_[i];
  }

  std::vector<double> ways_from(const std::vector<start>& starts) {
    for (const start& s : starts) {
      node& n = at(s.vert);
      if (!(s.before + s.distance < n.way)) continue;
      n.way = s.before + s.distance;
      n.source = s.source;
      n.before = s.before;
      offered_.push_back(s.vert);
    }
    queue_offered();
    while (!queue_.empty()) {
      const std::size_t v = queue_.pop().slot;
      waiting_[v] = infinity;
      node_[v].find_bend();
      node_[v].state |= 1;
      if (graph_.corners_ == 3) visit_triangles(v);
      else visit_tets(v);
      queue_offered();
    }
    for (std::size_t i = 0; i < node_.size(); ++i) waiting_[i] = node_[i].way;
    return std::move(waiting_);
  }
};

inline std::vector<double> distance_graph::ways_from(const std::vector<start>& starts, double longest) const {
  return search(*this, longest).ways_from(starts);
}

}  // namespace concino::detail
