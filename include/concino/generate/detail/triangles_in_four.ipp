// Defines triangles_in_four.hpp.
#pragma once

#include <concino/generate/detail/triangles_in_four.hpp>

#include <utility>
#include <vector>

namespace concino::detail {

/// The triangles of the result, and which edge is where. Corner c of the triangles before is corner c % 3 of triangle c / 3. Triangle 4 p + k, at vert k of
/// triangle p, consists of this vert and of the middles of edge k and of the edge before it, k - 1. The middles of edges 0, 1 and 2 are the verts of triangle 4 p + 3. So
/// new edges are halves of edges, and cuts, which join two middles and cut off a vert.
class four_triangles {
  static constexpr std::uint32_t none = ~0u;
  struct cut {
    std::uint32_t k, other;  // vert k of a triangle is cut off by an edge from one middle to that of edge `other`
  };
  /// Of each edge of a triangle: the cuts from its middle to others.
  static constexpr cut cuts_at[3][2] = {{{0, 2}, {1, 1}}, {{1, 0}, {2, 2}}, {{0, 0}, {2, 1}}};
  /// Of each edge of a triangle: the three triangles of four at its middle.
  static constexpr std::uint32_t polys_at[3][3] = {{0, 1, 3}, {1, 2, 3}, {0, 2, 3}};

  struct split_edge {
    std::uint32_t corners[2] = {none, none};  // where it begins in its triangles
    std::uint32_t start = none, end = none;   // as in the first triangle
    std::uint32_t halves[2] = {none, none};   // the new edges at its start and at its end
    std::uint32_t is_same_way = 0;            // whether it has the same start in both triangles
    std::uint32_t unused = 0;                 // so that it is on one cache line
  };

  const numbered_triangles& in_;
  const std::uint32_t num_verts_, num_edges_, num_polys_;
  core::flat_array<split_edge> edges_;
  core::flat_array<std::uint32_t> cuts_;  // cuts_[3 p + k] cuts off vert k of triangle p
  std::uint32_t num_used_ = 0;            // edges with triangles

  static std::uint32_t next(std::uint32_t c) { return c % 3 == 2 ? c - 2 : c + 1; }
  static std::uint32_t previous(std::uint32_t c) { return c % 3 == 0 ? c + 2 : c - 1; }
  /// The triangle of four at a corner.
  static std::uint32_t poly_at(std::uint32_t c) { return c / 3 * 4 + c % 3; }

 public:
  explicit four_triangles(const numbered_triangles& in)
      : in_(in), num_verts_(static_cast<std::uint32_t>(in.num_verts)), num_edges_(static_cast<std::uint32_t>(in.num_edges)),
        num_polys_(static_cast<std::uint32_t>(in.corners.size() / 3)), edges_(in.num_edges, split_edge{}), cuts_(in.corners.size()) {}

  /// Finds the triangles of each edge. Returns whether each has at most two, which agree on its ends, no two triangles have two edges in common, and the tables
  /// are not too large.
  bool find_triangles() {
    for (std::uint32_t p = 0; p < num_polys_; ++p) {
      std::uint32_t before[3];  // the triangles with smaller numbers at its edges
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t c = 3 * p + k, from = in_.corners[c].vert, to = in_.corners[next(c)].vert;
        split_edge& e = edges_[in_.corners[c].edge];
        before[k] = none - k;
        if (from == to) return false;
        if (e.corners[0] == none) {
          e.corners[0] = c, e.start = from, e.end = to;
          ++num_used_;
        } else {
          e.is_same_way = e.start == from;
          if (e.corners[1] != none || (e.is_same_way ? e.end != to : e.start != to || e.end != from)) return false;
          e.corners[1] = c;
          before[k] = e.corners[0] / 3;
        }
      }
      if (before[0] == before[1] || before[1] == before[2] || before[2] == before[0]) return false;
    }
    return 4 * std::uint64_t{num_used_} + 6 * std::uint64_t{num_polys_} < none;
  }

  surface_adjacency<3> tables() {
    surface_adjacency<3> a(in_.num_verts + in_.num_edges, 2 * std::size_t{num_used_} + 3 * std::size_t{num_polys_}, 4 * std::size_t{num_polys_});
    list_polys_at_verts(a);
    list_halves(a);
    list_edges_of_middles(a);
    list_verts(a.p2v.data());
    list_edges_and_neighbours(a);
    a.shrink_to_fit();
    return a;
  }

  /// The verts of all triangles of the result.
  void list_verts(vert_id* v) const {
    for (const numbered_triangles::corner* c = in_.corners.begin(); c != in_.corners.end(); c += 3) {
      const vert_id a{c[0].vert}, b{c[1].vert}, d{c[2].vert}, ab{num_verts_ + c[0].edge}, bd{num_verts_ + c[1].edge}, da{num_verts_ + c[2].edge};
      for (const vert_id x : {a, ab, da, b, bd, ab, d, da, bd, ab, bd, da}) *v++ = x;
    }
  }

 private:
  static const std::vector<std::uint32_t>& first_polys(const surface_adjacency<3>& a) { return a.first_poly.empty() ? a.first_edge : a.first_poly; }

  /// Counts the edges and polys at each vert, and lists the polys.
  void list_polys_at_verts(surface_adjacency<3>& a) const {
    std::uint32_t* const edges = a.first_edge.data() + 1;
    core::flat_array<std::uint32_t> polys(num_verts_, 0);  // later: where the next poly is listed
    for (const numbered_triangles::corner& c : in_.corners) ++polys[c.vert];
    for (std::uint32_t j = 0; j < num_edges_; ++j) {
      const split_edge& e = edges_[j];
      if (e.corners[0] == none) continue;
      ++edges[e.start], ++edges[e.end];
      edges[num_verts_ + j] = e.corners[1] == none ? 4 : 6;
    }
    if (2 * std::size_t{num_used_} != in_.corners.size()) {  // with two polys at each edge, each vert has as many edges as polys
      a.first_poly = core::large_vector(a.first_edge.size(), 0u);
      std::copy(polys.begin(), polys.end(), a.first_poly.data() + 1);
      for (std::uint32_t j = 0; j < num_edges_; ++j) a.first_poly[num_verts_ + j + 1] = edges_[j].corners[0] == none ? 0 : edges_[j].corners[1] == none ? 3 : 6;
    }
    for (std::vector<std::uint32_t>* const counts : {&a.first_edge, &a.first_poly}) {
      std::uint32_t sum = 0;
      for (std::uint32_t& x : *counts) x = sum += x;
    }
    const std::vector<std::uint32_t>& first = first_polys(a);
    std::copy_n(first.data(), num_verts_, polys.data());
    for (std::uint32_t c = 0; c < 3 * num_polys_; ++c) a.v2p[polys[in_.corners[c].vert]++] = poly_id{poly_at(c)};
    poly_id* at = a.v2p.data() + first[num_verts_];
    for (const split_edge& e : edges_)
      for (const std::uint32_t c : e.corners)
        if (c != none)
          for (const std::uint32_t k : polys_at[c % 3]) *at++ = poly_id{c / 3 * 4 + k};
  }

  /// Numbers the halves of edges, those at each vert in the order in which its triangles list them, and lists them there.
  void list_halves(surface_adjacency<3>& a) {
    const std::vector<std::uint32_t>& first = first_polys(a);
    std::uint32_t count = 0;
    for (std::uint32_t v = 0; v < num_verts_; ++v) {
      const auto meet = [&](std::uint32_t c, std::uint32_t corner_of_result) {
        const std::uint32_t j = in_.corners[c].edge;
        split_edge& e = edges_[j];
        std::uint32_t& half = e.halves[e.start == v ? 0 : 1];
        if (half != none) return;
        half = count++;
        add_edge(a, half, v, num_verts_ + j, corner_of_result);
        a.v2v[half] = vert_id{num_verts_ + j};  // each half is at one vert, so these lists are those of all halves
        a.v2e[half] = edge_id{half};
      };
      for (std::uint32_t i = first[v]; i < first[v + 1]; ++i) {
        const std::uint32_t f = a.v2p[i].raw(), c = f / 4 * 3 + f % 4;
        meet(c, 3 * f);
        meet(previous(c), 3 * f + 2);
      }
    }
  }

  /// Numbers the cuts, those at each middle in the order in which the triangles there list them, and lists the edges of the middles.
  void list_edges_of_middles(surface_adjacency<3>& a) {
    std::uint32_t count = 2 * num_used_, at = count;
    for (std::uint32_t j = 0; j < num_edges_; ++j) {
      const split_edge& e = edges_[j];
      if (e.corners[0] == none) continue;
      const auto list = [&](std::uint32_t edge, std::uint32_t vert) {
        std::uint32_t i = at++;
        for (; a.v2e[i - 1].raw() > edge && i > a.first_edge[num_verts_ + j]; --i) a.v2e[i] = a.v2e[i - 1], a.v2v[i] = a.v2v[i - 1];
        a.v2e[i] = edge_id{edge}, a.v2v[i] = vert_id{vert};
      };
      list(e.halves[0], e.start);
      list(e.halves[1], e.end);
      for (const std::uint32_t c : e.corners) {
        if (c == none) continue;
        const std::uint32_t p = c / 3;
        for (const cut& x : cuts_at[c % 3]) {
          const std::uint32_t other = in_.corners[3 * p + x.other].edge;
          if (other > j) add_edge(a, cuts_[3 * p + x.k] = count++, num_verts_ + j, num_verts_ + other, 3 * (4 * p + x.k) + 1);
          list(cuts_[3 * p + x.k], num_verts_ + other);
        }
      }
    }
  }

  static void add_edge(surface_adjacency<3>& a, std::uint32_t e, std::uint32_t from, std::uint32_t to, std::uint32_t first_corner) {
    a.first_corner[e] = first_corner;
    a.e2v[2 * std::size_t{e}] = vert_id{from};
    a.e2v[2 * std::size_t{e} + 1] = vert_id{to};
  }

  void list_edges_and_neighbours(surface_adjacency<3>& a) const {
    for (std::uint32_t p = 0; p < num_polys_; ++p) {
      edge_id* const edges = a.p2e.data() + 12 * std::size_t{p};
      auto* const behind = a.p2p.data() + 12 * std::size_t{p};
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t c = 3 * p + k, at_end = 3 * (k == 2 ? 0 : k + 1) + 2, in_middle = 9 + (k == 0 ? 2 : k - 1);
        const split_edge& e = edges_[in_.corners[c].edge];
        const bool is_first = e.corners[0] == c, is_turned = !is_first && !e.is_same_way;
        edges[3 * k] = edge_id{e.halves[is_turned ? 1 : 0]};
        edges[at_end] = edge_id{e.halves[is_turned ? 0 : 1]};
        edges[3 * k + 1] = edges[in_middle] = edge_id{cuts_[c]};
        behind[3 * k + 1].raw = 4 * p + 3, behind[in_middle].raw = 4 * p + k;
        const std::uint32_t other = e.corners[is_first ? 1 : 0];
        const std::uint32_t at_its_start = other == none ? none : poly_at(other), at_its_end = other == none ? none : poly_at(next(other));
        behind[3 * k].raw = e.is_same_way ? at_its_start : at_its_end;
        behind[at_end].raw = e.is_same_way ? at_its_end : at_its_start;
      }
    }
  }
};

CONCINO_INLINE surface_tables<3> triangles_in_four(numbered_triangles triangles) {
  four_triangles four(triangles);
  if (four.find_triangles()) return surface_tables<3>(four.tables());
  std::vector<vert_id> lists = core::large_vector(4 * triangles.corners.size(), vert_id{});
  four.list_verts(lists.data());
  return surface_tables<3>(triangles.num_verts + triangles.num_edges, std::move(lists));
}

CONCINO_INLINE bool has_derived_tables(const numbered_triangles& triangles) { return four_triangles(triangles).find_triangles(); }

}  // namespace concino::detail
