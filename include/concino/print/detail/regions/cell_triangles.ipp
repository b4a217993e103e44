// Defines cell_triangles.hpp.
#pragma once

#include <concino/concepts/facets.hpp>
#include <concino/concepts/oriented_edges.hpp>
#include <concino/generate/triangulate.hpp>
#include <concino/geometry/orientation.hpp>
#include <concino/print/detail/regions/cell_triangles.hpp>
#include <concino/print/detail/regions/segment_cuts.hpp>

#include <algorithm>
#include <utility>

namespace concino::detail {

/// The triangles of a box around an arrangement, and the values in them.
class cell_filler {
  const planar_arrangement& a_;
  std::vector<std::uint32_t> number_of_, point_of_;  // by point of a: its number in the graph, and by number its point
  std::vector<std::uint32_t> edge_of_;               // by segment of the graph: the edge of a, behind those of the box
  std::uint32_t box_[4] = {0, 0, 0, 0};
  planar_triangulation all_;
  std::vector<std::uint32_t> point_of_vert_, step_at_;  // by edge of the triangulation: the edge of a, or none

  planar_graph graph() {
    planar_graph g;
    snapped_point low = a_.points[a_.edges[0].low], high = low;
    number_of_.assign(a_.points.size(), cell_triangles::none);
    const auto number = [&](std::uint32_t p) {
      if (number_of_[p] == cell_triangles::none) {
        number_of_[p] = g.add_point(as_vec3(a_.points[p]));
        point_of_.push_back(p);
        for (const std::size_t k : {0u, 1u})
          low[k] = std::min(low[k], a_.points[p][k]), high[k] = std::max(high[k], a_.points[p][k]);
      }
      return number_of_[p];
    };
    for (std::uint32_t i = 0; i < a_.edges.size(); ++i) {
      const auto& e = a_.edges[i];
      if (e.step[0] == 0 && e.step[1] == 0) continue;
      g.add_line_through(std::array{number(e.low), number(e.high)});
      edge_of_.push_back(i);
    }
    const std::int64_t margin = 1 + std::max(high[0] - low[0], high[1] - low[1]) / 8;
    const snapped_point corners[4] = {{low[0] - margin, low[1] - margin},
                                      {high[0] + margin, low[1] - margin},
                                      {high[0] + margin, high[1] + margin},
                                      {low[0] - margin, high[1] + margin}};
    for (std::size_t k = 0; k < 4; ++k) box_[k] = g.add_point(as_vec3(corners[k]));
    g.add_line_through(box_, true);
    return g;
  }

  /// Walks from the box over all triangles.
  std::vector<std::array<std::int64_t, 2>> values() const {
    const trimesh& m = all_.mesh;
    std::vector<std::array<std::int64_t, 2>> value(num_polys(m), {0, 0});
    std::vector<std::uint8_t> is_known(num_polys(m), 0);
    std::vector<poly_id> open;
    for (const poly_id p : adj_v2p(m, all_.vert_of[box_[0]])) {
      is_known[p.raw()] = 1;
      open.push_back(p);
    }
    while (!open.empty()) {
      const poly_id p = open.back();
      open.pop_back();
      for (const auto& [e, from, to] : oriented_edges(m, p))
        for (const poly_id q : other_polys(m, p, e)) {
          if (std::exchange(is_known[q.raw()], 1)) continue;
          value[q.raw()] = value[p.raw()];
          if (const std::uint32_t s = step_at_[e.raw()]; s != cell_triangles::none)  // p is on the left side
            for (const std::size_t k : {0u, 1u})
              value[q.raw()][k] +=
                  point_of_vert_[from.raw()] == a_.edges[s].low ? -a_.edges[s].step[k] : a_.edges[s].step[k];
          open.push_back(q);
        }
    }
    return value;
  }

 public:
  explicit cell_filler(const planar_arrangement& a) : a_(a) {
    all_ = triangulate(graph());
    point_of_vert_.assign(num_verts(all_.mesh), cell_triangles::none);
    for (std::uint32_t i = 0; i < point_of_.size(); ++i) point_of_vert_[all_.vert_of[i].raw()] = point_of_[i];
    step_at_.assign(num_edges(all_.mesh), cell_triangles::none);
    for (std::size_t i = 0; i < edge_of_.size(); ++i)
      for (const edge_id e : all_.edges_of(i)) step_at_[e.raw()] = edge_of_[i];
  }

  cell_triangles result() const {
    const trimesh& m = all_.mesh;
    const auto value = values();
    cell_triangles c;
    std::vector<std::uint32_t> number(value.size(), cell_triangles::none);
    for (const poly_id p : polys(m)) {
      if (value[p.raw()][0] == 0 && value[p.raw()][1] == 0) continue;
      number[p.raw()] = static_cast<std::uint32_t>(c.triangles.size());
      c.values.push_back(value[p.raw()]);
      auto& t = c.triangles.emplace_back();
      std::size_t k = 0;
      for (const vert_id v : adj_p2v(m, p)) t[k++] = point_of_vert_[v.raw()];
    }
    for (const poly_id p : polys(m)) {
      if (number[p.raw()] == cell_triangles::none) continue;
      auto& next = c.neighbours.emplace_back(std::array{c.none, c.none, c.none});
      std::size_t k = 0;
      for (const edge_id e : adj_p2e(m, p)) {
        for (const poly_id q : other_polys(m, p, e)) next[k] = number[q.raw()];
        ++k;
      }
    }
    return c;
  }
};

/// Flips sides of triangles with the same values until the triangles are Delaunay within each cell.
class cell_flipper {
  cell_triangles& c_;
  const std::vector<snapped_point>& points_;
  std::vector<std::array<std::uint32_t, 2>> open_;  // triangle and side

  vec3 at(std::uint32_t p) const { return as_vec3(points_[p]); }

  /// The number of the side of a triangle that begins at a point.
  std::uint32_t side_from(std::uint32_t t, std::uint32_t p) const {
    const auto& corners = c_.triangles[t];
    return corners[0] == p ? 0 : corners[1] == p ? 1 : 2;
  }

  /// Whether the angles at c and d, across the side from a to b, are more than two right ones, and the side may be
  /// flipped.
  bool is_bad(const vec3& a, const vec3& b, const vec3& c, const vec3& d) const {
    const vec3 ac = a - c, bc = b - c, ad = a - d, bd = b - d;
    const double sine_c = ac.x * bc.y - ac.y * bc.x, cosine_c = dot(ac, bc), sine_d = bd.x * ad.y - bd.y * ad.x,
                 cosine_d = dot(bd, ad);
    const double lengths = norm(ac) * norm(bc) * norm(ad) * norm(bd);
    return sine_c * cosine_d + cosine_c * sine_d < -1e-12 * lengths && orient2d(c, a, d) > 0 && orient2d(d, b, c) > 0;
  }

  void set_neighbour(std::uint32_t t, std::uint32_t from, std::uint32_t to) {
    if (t != c_.none) c_.neighbours[t][side_from(t, from)] = to;
  }

  void test(std::uint32_t t, std::uint32_t k) {
    const std::uint32_t u = c_.neighbours[t][k];
    if (u == c_.none || c_.values[u] != c_.values[t]) return;
    const std::uint32_t a = c_.triangles[t][k], b = c_.triangles[t][(k + 1) % 3], c = c_.triangles[t][(k + 2) % 3],
                        j = side_from(u, b), d = c_.triangles[u][(j + 2) % 3];
    if (!is_bad(at(a), at(b), at(c), at(d))) return;
    const std::uint32_t ca = c_.neighbours[t][(k + 2) % 3], bc = c_.neighbours[t][(k + 1) % 3],
                        ad = c_.neighbours[u][(j + 1) % 3], db = c_.neighbours[u][(j + 2) % 3];
    c_.triangles[t] = {c, a, d};
    c_.neighbours[t] = {ca, ad, u};
    c_.triangles[u] = {d, b, c};
    c_.neighbours[u] = {db, bc, t};
    set_neighbour(ad, d, t);
    set_neighbour(bc, c, u);
    open_.insert(open_.end(), {{t, 0}, {t, 1}, {u, 0}, {u, 1}});
  }

 public:
  cell_flipper(cell_triangles& c, const std::vector<snapped_point>& points) : c_(c), points_(points) {}

  void run() {
    for (std::uint32_t t = 0; t < c_.triangles.size(); ++t)
      for (std::uint32_t k = 0; k < 3; ++k) {
        open_.push_back({t, k});
        while (!open_.empty()) {
          const auto [triangle, side] = open_.back();
          open_.pop_back();
          test(triangle, side);
        }
      }
  }
};

CONCINO_INLINE cell_triangles triangulate_cells(const planar_arrangement& a) {
  if (std::all_of(a.edges.begin(), a.edges.end(), [](const auto& e) { return e.step[0] == 0 && e.step[1] == 0; }))
    return {};
  cell_triangles result = cell_filler(a).result();
  cell_flipper(result, a.points).run();
  return result;
}

}  // namespace concino::detail
