// Bodies of graph_lines.hpp: divides the edges of a graph into lines, so that few tubes draw them.
#pragma once

#include <concino/render/detail/shapes/graph_lines.hpp>

#include <algorithm>

namespace concino::detail {

/// The edges at each vert that no line has taken yet.
class free_edges {
  const flat_graph& g_;
  std::vector<std::uint32_t> first_, last_, edges_;  // vert v has those of edges_ from first_[v] to last_[v]; taken
                                                     // ones may be among them
  std::vector<std::uint8_t> taken_;

  void drop_taken(std::uint32_t v) {
    while (last_[v] > first_[v] && taken_[edges_[last_[v] - 1]]) --last_[v];
  }

 public:
  explicit free_edges(const flat_graph& g)
      : g_(g), first_(g.points.size() + 1, 0), edges_(2 * g.edges.size()), taken_(g.edges.size(), 0) {
    for (const auto& e : g.edges) ++first_[e[0] + 1], ++first_[e[1] + 1];
    for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
    last_.assign(first_.begin(), first_.end() - 1);
    for (std::size_t i = g.edges.size(); i-- > 0;)  // backwards, so that the last of a vert, which is taken first, is
                                                    // the first edge
      for (const std::uint32_t v : g.edges[i]) edges_[last_[v]++] = static_cast<std::uint32_t>(i);
  }

  bool is_odd(std::uint32_t v) const { return (first_[v + 1] - first_[v]) % 2 == 1; }
  bool has_none(std::uint32_t v) const { return first_[v + 1] == first_[v]; }

  /// Whether there is an edge at v; if so takes the one that continues a direction best, and moves v to its other end.
  bool step(std::uint32_t& v, const vec3& direction) {
    constexpr int most = 16;
    drop_taken(v);
    if (last_[v] == first_[v]) return false;
    std::uint32_t best = edges_[last_[v] - 1];
    double straightest = -2;
    int seen = 0;
    for (std::uint32_t k = last_[v]; k-- > first_[v] && seen < most;) {
      const std::uint32_t e = edges_[k];
      if (taken_[e]) continue;
      ++seen;
      const vec3 along = g_.points[other(e, v)] - g_.points[v];
      const double length = norm(along), cosine = length > 0 ? dot(along, direction) / length : 1;
      if (cosine > straightest) straightest = cosine, best = e;
    }
    taken_[best] = 1;
    v = other(best, v);
    return true;
  }

  std::uint32_t other(std::uint32_t e, std::uint32_t v) const {
    return g_.edges[e][0] == v ? g_.edges[e][1] : g_.edges[e][0];
  }
};

CONCINO_INLINE void graph_lines::end_line(const flat_graph& g, bool closed) {
  for (std::size_t i = lines.points.size(); i < verts.size(); ++i) lines.points.push_back(g.points[verts[i]]);
  lines.end_line(closed);
}

CONCINO_INLINE graph_lines graph_lines_of(const flat_graph& g) {
  graph_lines t;
  free_edges free(g);
  const auto n = static_cast<std::uint32_t>(g.points.size());
  const auto follow = [&](std::uint32_t start) {
    std::uint32_t v = start;
    vec3 direction;
    const std::size_t first = t.verts.size();
    while (true) {
      const std::uint32_t before = v;
      if (!free.step(v, direction)) break;
      if (before == start && t.verts.size() == first) t.verts.push_back(start);
      t.verts.push_back(v);
      const vec3 along = g.points[v] - g.points[before];
      const double length = norm(along);
      if (length > 0) direction = along / length;
    }
    if (t.verts.size() == first) return false;
    const bool closed = t.verts.size() > first + 3 && t.verts.back() == start;
    if (closed) t.verts.pop_back();
    t.end_line(g, closed);
    return true;
  };
  for (std::uint32_t v = 0; v < n; ++v)
    if (free.is_odd(v)) follow(v);
  for (std::uint32_t v = 0; v < n; ++v) {
    while (follow(v)) {}
    if (g.lone_verts && free.has_none(v)) {
      t.verts.push_back(v);
      t.end_line(g, false);
    }
  }
  return t;
}

CONCINO_INLINE drawable tubes_of(const flat_graph& g, const tube_options& options, const char* caller) {
  const graph_lines t = graph_lines_of(g);
  tube_options by_point = options;
  const auto for_line_points = [&](std::span<const double> by_vert, const char* what) {
    std::vector<double> all;
    if (by_vert.empty()) return all;
    if (by_vert.size() != g.points.size())
      core::throw_joined<invalid_argument>(
          {caller, ": ", by_vert.size(), what, g.points.size(), " verts: give one for each vert"});
    all.reserve(t.verts.size());
    for (const std::uint32_t v : t.verts) all.push_back(by_vert[v]);
    return all;
  };
  const std::vector<double> values = for_line_points(options.values, " values for "),
                            radii = for_line_points(options.radii, " radii for ");
  by_point.values = values;
  by_point.radii = radii;
  return tubes_along(t.lines, by_point, caller);
}

}  // namespace concino::detail
