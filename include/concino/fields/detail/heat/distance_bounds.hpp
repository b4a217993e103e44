// Upper bounds of distances: shortest paths along edges and straight across triangles or tets.
#pragma once

#include <concino/core/indexed_heap.hpp>
#include <concino/fields/detail/heat/distance_graph.hpp>
#include <concino/fields/detail/heat/distance_node.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace concino::detail {

/// One search for shortest paths, as in Dijkstra's algorithm. It is not `dijkstra` because a step may cross a triangle
/// or a tet from several verts at once, and its graph is flat arrays of corners.
class distance_graph::search {
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr std::uint8_t max_changes = 64;

  /// A straight path to the end `last` of a triangle, between the corner and the other end. `near` is the distance of
  /// the other end from the source.
  struct crossing {
    const corner* triangle;
    std::size_t last;  // index in triangle->ends
    double near;
    double curvature_deficit;  // curvature of a front on a plane minus that of this one; the front lags behind between
                               // the two corners accordingly
    double path_length;   // from the source, if the straight line passes between the two corners
    bool is_seen;

    /// from: the distance of the corner from the source. Has no branches: they would be hard to predict, and without
    /// them several crossings overlap.
    void find_path_length(double from) {
      const double length = triangle->lengths[1 - last], to = triangle->lengths[last];
      const double along = to * triangle->cosine, up = to * triangle->sine;
      const double x = (length + (from - near) * (from + near) / length) / 2, y2 = (from - x) * (from + x),
                   y = std::sqrt(std::max(y2, 0.0));
      constexpr double least = std::numeric_limits<double>::min();  // 0 / least is 0
      const double height = up + y, through = x + y / std::max(height, least) * (along - x);
      const double square = (along - x) * (along - x) + height * height;
      path_length = std::sqrt(square) +
                    curvature_deficit * through * (length - through) * (height * height / std::max(square, least)) / 2;
      // A front that converges within about the length of the edge, as on the far side of a ball, is too uncertain.
      const bool is_wide = curvature_deficit * length < 0.5;
      is_seen = is_wide & (y2 >= -1e-9 * from * from) & (through >= -1e-9 * length) & (through <= (1 + 1e-9) * length);
    }
  };

  /// The distance of the last corner of a tet from the source, if the straight line passes between the other corners,
  /// whose distances are da, db and dc; otherwise +inf. Also +inf if it certainly exceeds `most`.
  static double unfolded_distance(const local_tet& s, double da, double db, double dc, double most) {
    if (!(s.length > 0)) return infinity;
    const double x = (s.length + (da - db) * (da + db) / s.length) / 2;
    const double y = (s.cx * s.cx + s.cy * s.cy - 2 * s.cx * x + (da - dc) * (da + dc)) / (2 * s.cy);
    if (da * da + s.x * (s.x - 2 * x) + s.y * (s.y - 2 * y) + s.height * s.height > most * most) return infinity;
    const double z2 = (da - x) * (da + x) - y * y;
    if (!(z2 >= -1e-9 * da * da)) return infinity;
    const double z = std::sqrt(std::max(z2, 0.0)), height = z + s.height, part = height > 0 ? z / height : 0;
    const double px = x + part * (s.x - x), py = y + part * (s.y - y);  // where the line passes through the plane
    const double of_c = py / s.cy, of_b = (px - of_c * s.cx) / s.length, least = -1e-9;
    if (!(of_c >= least && of_b >= least && of_b + of_c <= 1 - least)) return infinity;
    return std::sqrt((s.x - x) * (s.x - x) + (s.y - y) * (s.y - y) + height * height);
  }

  const distance_graph& graph_;
  const double longest_;
  std::vector<distance_node> nodes_;
  std::vector<double> waiting_;  // path lengths of the verts in the queue
  core::indexed_heap<int> queue_;
  std::vector<int> offered_;         // verts improved since the last vert left the queue
  std::vector<crossing> crossings_;
  std::vector<std::pair<int, double>> tet_paths_;  // verts, and lengths of paths to them
  std::vector<std::uint8_t> known_;  // of each tet: bits of its settled corners

  distance_node& at(int v) { return nodes_[static_cast<std::size_t>(v)]; }
  const distance_node& at(int v) const { return nodes_[static_cast<std::size_t>(v)]; }
  const vec3& position(int v) const { return graph_.positions_[static_cast<std::size_t>(v)]; }

  void relax(int vert, double length, const distance_node& from) {
    distance_node& n = at(vert);
    n.path_length = length;
    n.source = from.source;
    n.before = from.before;
    offered_.push_back(vert);
  }
  void relax(int vert, double length, const distance_node& from, double curvature_deficit, double radius, double step) {
    relax(vert, length, from);
    distance_node& n = at(vert);
    n.curvature_deficit = curvature_deficit;
    n.radius = radius;
    n.step = step;
    n.mean_curvature = (from.curvature + n.curvature) / 2;
    if (n.is_settled()) n.update_curvature_deficit();
  }
  void queue_offered() {
    for (const int v : offered_) {
      const auto i = static_cast<std::size_t>(v);
      if (!(nodes_[i].path_length < waiting_[i] && nodes_[i].path_length <= longest_)) continue;
      if (nodes_[i].is_settled() && waiting_[i] == infinity)
        nodes_[i].state = static_cast<std::uint8_t>(std::min(nodes_[i].state + 2, 255));
      queue_.decrease_key(v, i, nodes_[i].path_length);
    }
    offered_.clear();
  }

  /// Whether a path across to a vert is shorter, by more than rounding, than the known one.
  static bool improves(const distance_node& n, double path_length) {
    return n.path_length - path_length > 1e-12 * std::abs(path_length);
  }

  /// Whether the front may have reached the end `last` of the triangle through the other end. Fills in c, except for
  /// its path length.
  bool may_cross(const distance_node& from, const corner& triangle, std::size_t last, crossing& c) const {
    const distance_node &other = at(triangle.ends[1 - last]), &to = at(triangle.ends[last]);
    c.triangle = &triangle;
    c.last = last;
    c.near = other.path_length - from.before;
    c.curvature_deficit = (from.curvature_deficit + other.curvature_deficit) / 2;
    const bool is_known = other.is_settled(), may_change = to.state < max_changes;
    // otherwise the front has already been there
    const bool is_ahead = to.path_length > std::min(from.path_length, other.path_length);
    return is_known & may_change & is_ahead & (other.source == from.source);
  }

  /// All paths are found before any is offered, so that they do not depend on the order of the triangles.
  void cross_triangles(std::size_t v) {
    const distance_node& from = nodes_[v];
    const std::size_t first = graph_.simplex_begin_[v], end = graph_.simplex_begin_[v + 1];
    if (crossings_.size() < 2 * (end - first)) crossings_.resize(2 * (end - first));
    std::size_t n = 0;
    for (std::size_t k = first; k < end; ++k) {
      const corner& triangle = graph_.corner_[k];
      const distance_node &a = at(triangle.ends[0]), &b = at(triangle.ends[1]);
      const std::size_t farther = b.path_length > a.path_length, nearer = 1 - farther;
      n += may_cross(from, triangle, farther, crossings_[n]);
      if (std::min(a.path_length, b.path_length) > from.path_length && at(triangle.ends[farther]).is_settled())
        n += may_cross(from, triangle, nearer, crossings_[n]);
    }
    const double there = from.before;
    for (std::size_t i = 0; i < n; ++i) crossings_[i].find_path_length(from.path_length - there);
    for (std::size_t i = 0; i < n; ++i) {
      const crossing& c = crossings_[i];
      const int vert = c.triangle->ends[c.last];
      if (!c.is_seen || !improves(at(vert), there + c.path_length)) continue;
      const double path_length = there + c.path_length, mean = (from.path_length - there + c.near) / 2;
      relax(vert, path_length, from, c.curvature_deficit, mean,
            std::max(c.path_length - mean, 0.25 * c.triangle->lengths[c.last]));
    }
  }

  void cross(const distance_node& from, const int* corners, std::size_t last) {
    const int at_a = corners[others[last][0]], at_b = corners[others[last][1]], at_c = corners[others[last][2]];
    const distance_node &a = at(at_a), &b = at(at_b), &c = at(at_c);
    const distance_node& to = at(corners[last]);
    if (a.source != from.source || b.source != from.source || c.source != from.source || to.state >= max_changes)
      return;
    if (to.path_length <= std::min({a.path_length, b.path_length, c.path_length})) return;
    const double there = from.before;
    const local_tet s = seen_from(position(at_a), position(at_b), position(at_c), position(corners[last]));
    const double path_length = there + unfolded_distance(s, a.path_length - there, b.path_length - there,
                                                         c.path_length - there, to.path_length - there);
    if (improves(to, path_length)) tet_paths_.emplace_back(corners[last], path_length);
  }

  void visit_triangles(std::size_t v) {
    const distance_node& from = nodes_[v];
    for (std::size_t k = graph_.neighbour_begin_[v]; k < graph_.neighbour_begin_[v + 1]; ++k) {
      const neighbour& n = graph_.neighbour_[k];
      const double path_length = from.path_length + n.length;
      if (path_length < at(n.vert).path_length)
        relax(n.vert, path_length, from, from.curvature_deficit, from.path_length - from.before, n.length);
    }
    cross_triangles(v);
  }

  void visit_tets(std::size_t v) {
    const distance_node& from = nodes_[v];
    for (std::size_t k = graph_.neighbour_begin_[v]; k < graph_.neighbour_begin_[v + 1]; ++k) {
      const neighbour& n = graph_.neighbour_[k];
      const double path_length = from.path_length + n.length;
      if (path_length < at(n.vert).path_length) relax(n.vert, path_length, from);
    }
    for (std::size_t k = graph_.simplex_begin_[v]; k < graph_.simplex_begin_[v + 1]; ++k) {
      const auto i = static_cast<std::size_t>(graph_.tet_at_[k]), first = i / 4 * 4;
      std::uint8_t& known = known_[i / 4];
      known = static_cast<std::uint8_t>(known | 1u << (i - first));
      for (std::size_t last = 0; last < 4; ++last)
        if (first + last != i && (known | 1u << last) == 15) cross(from, &graph_.tet_[first], last);
    }
    for (const auto& [to, path_length] : tet_paths_)  // only now, so that they do not depend on the order of the tets
      if (improves(at(to), path_length)) relax(to, path_length, from);
    tet_paths_.clear();
  }

 public:
  search(const distance_graph& graph, double longest)
      : graph_(graph), longest_(longest), nodes_(graph.positions_.size()), waiting_(nodes_.size(), infinity),
        queue_(waiting_), known_(graph.tet_.size() / 4) {
    for (std::size_t i = 0; i < graph.curvature_.size(); ++i) nodes_[i].curvature = graph.curvature_[i];
  }

  std::vector<double> path_lengths_from(const std::vector<start>& starts) {
    for (const start& s : starts) {
      distance_node& n = at(s.vert);
      if (!(s.before + s.distance < n.path_length)) continue;
      n.path_length = s.before + s.distance;
      n.source = s.source;
      n.before = s.before;
      offered_.push_back(s.vert);
    }
    queue_offered();
    while (!queue_.empty()) {
      const std::size_t v = queue_.pop().slot;
      waiting_[v] = infinity;
      nodes_[v].update_curvature_deficit();
      nodes_[v].state |= 1;
      if (graph_.corners_ == 3) visit_triangles(v);
      else visit_tets(v);
      queue_offered();
    }
    for (std::size_t i = 0; i < nodes_.size(); ++i) waiting_[i] = nodes_[i].path_length;
    return std::move(waiting_);
  }
};

inline std::vector<double> distance_graph::path_lengths_from(const std::vector<start>& starts, double longest) const {
  return search(*this, longest).path_lengths_from(starts);
}

}  // namespace concino::detail
