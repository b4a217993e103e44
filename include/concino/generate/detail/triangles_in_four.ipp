// Defines triangles_in_four.hpp.
#pragma once

#include <concino/generate/detail/triangles_in_four.hpp>

#include <utility>
#include <vector>

namespace concino::detail {

/// The triangles of the result, and which edge is where. Corner c of the triangles before is corner c % 3 of triangle c / 3. Triangle 4 p + k, at vert k of
/// triangle p, consists of this vert and of the middles of edge k and of the edge before it, k - 1. The middles of edges 0, 1 and 2 are the verts of triangle 4 p + 3. So
/// new edges are halves of edges, and edges that join two middles, which cut off a vert.
class four_triangles {
  static constexpr std::uint32_t none = ~0u;
  struct cut {
    std::uint32_t k, other;  // vert k of a triangle is cut off by an edge from one middle to that of edge `other`
  };
  /// Of each edge of a triangle: the two edges from its middle to others.
  static constexpr cut cuts[3][2] = {{{0, 2}, {1, 1}}, {{1, 0}, {2, 2}}, {{0, 0}, {2, 1}}};
  /// Of each edge of a triangle: the three triangles of four at its middle.
  static constexpr std::uint32_t at_middle[3][3] = {{0, 1, 3}, {1, 2, 3}, {0, 2, 3}};

  struct split_edge {
    std::uint32_t corners[2] = {none, none};  // where it begins in its triangles
    std::uint32_t start = none, end = none;   // as in the first triangle
    std::uint32_t halves[2] = {none, none};   // the new edges at its start and at its end
    std::uint32_t last = 0;                   // where the next edge of its middle will be listed
  };

  const numbered_triangles& in_;
  const std::uint32_t num_verts_, num_edges_, num_polys_;
  core::flat_array<split_edge> edges_;
  std::uint32_t num_used_ = 0;  // edges with triangles
  bool has_boundary_ = false;

  static std::uint32_t next(std::uint32_t c) { return c % 3 == 2 ? c - 2 : c + 1; }
  static std::uint32_t previous(std::uint32_t c) { return c % 3 == 0 ? c + 2 : c - 1; }

 public:
  explicit four_triangles(const numbered_triangles& in)
      : in_(in), num_verts_(static_cast<std::uint32_t>(in.num_verts)), num_edges_(static_cast<std::uint32_t>(in.num_edges)),
        num_polys_(static_cast<std::uint32_t>(in.corners.size() / 3)), edges_(in.num_edges, split_edge{}) {}

  /// Finds the triangles of each edge. Returns whether each has at most two, which agree on its ends, no two triangles have two edges in common, and the tables
  /// are not too large.
  bool find_triangles() {
    for (std::uint32_t c = 0; c < 3 * num_polys_; ++c) {
      const std::uint32_t from = in_.corners[c].vert, to = in_.corners[next(c)].vert;
      split_edge& e = edges_[in_.corners[c].edge];
      if (e.corners[0] == none) {
        e.corners[0] = c, e.start = from, e.end = to;
        ++num_used_;
      } else if (e.corners[1] == none && ((e.start == from && e.end == to) || (e.start == to && e.end == from))) {
        e.corners[1] = c;
      } else {
        return false;
      }
    }
    for (std::uint32_t p = 0; p < num_polys_; ++p) {
      std::uint32_t behind[3];
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t c = 3 * p + k;
        const split_edge& e = edges_[in_.corners[c].edge];
        const std::uint32_t other = e.corners[e.corners[0] == c ? 1 : 0];
        has_boundary_ = has_boundary_ || other == none;
        behind[k] = other == none ? none - k : other / 3;
        if (behind[k] == p || e.start == e.end) return false;
      }
      if (behind[0] == behind[1] || behind[1] == behind[2] || behind[2] == behind[0]) return false;
    }
    return 4 * std::uint64_t{num_used_} + 6 * std::uint64_t{num_polys_} < none;
  }

  surface_adjacency<3> tables() {
    surface_adjacency<3> a(in_.num_verts + in_.num_edges, 2 * std::size_t{num_used_} + 3 * std::size_t{num_polys_}, 4 * std::size_t{num_polys_});
    list_verts(a.p2v.data());
    list_at_verts(a);
    const std::uint32_t half_count = number_halves(a);
    number_cuts(a, half_count);
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
  /// Counts the edges and polys at each vert, and lists the polys.
  void list_at_verts(surface_adjacency<3>& a) {
    std::uint32_t* const edges = a.first_edge.data() + 1;
    core::flat_array<std::uint32_t> polys(num_verts_, 0);  // later: where the next poly is listed
    for (const numbered_triangles::corner& c : in_.corners) ++polys[c.vert];
    for (std::uint32_t j = 0; j < num_edges_; ++j) {
      const split_edge& e = edges_[j];
      if (e.corners[0] == none) continue;
      ++edges[e.start], ++edges[e.end];
      edges[num_verts_ + j] = e.corners[1] == none ? 4 : 6;
    }
    if (has_boundary_ || !std::equal(polys.begin(), polys.end(), edges)) {
      a.first_poly = core::large_vector(a.first_edge.size(), 0u);
      std::copy(polys.begin(), polys.end(), a.first_poly.data() + 1);
      for (std::uint32_t j = 0; j < num_edges_; ++j) a.first_poly[num_verts_ + j + 1] = edges_[j].corners[0] == none ? 0 : edges_[j].corners[1] == none ? 3 : 6;
    }
    for (std::vector<std::uint32_t>* const counts : {&a.first_edge, &a.first_poly}) {
      std::uint32_t sum = 0;
      for (std::uint32_t& x : *counts) x = sum += x;
    }
    const std::vector<std::uint32_t>& first = a.first_poly.empty() ? a.first_edge : a.first_poly;
    std::copy_n(first.data(), num_verts_, polys.data());
    for (std::uint32_t p = 0; p < num_polys_; ++p)
      for (std::uint32_t k = 0; k < 3; ++k) a.v2p[polys[in_.corners[3 * p + k].vert]++] = poly_id{4 * p + k};
    poly_id* at = a.v2p.data() + first[num_verts_];
    for (const split_edge& e : edges_)
      for (const std::uint32_t c : e.corners)
        if (c != none)
          for (const std::uint32_t k : at_middle[c % 3]) *at++ = poly_id{c / 3 * 4 + k};
    for (std::uint32_t j = 0; j < num_edges_; ++j) edges_[j].last = a.first_edge[num_verts_ + j];
  }

  /// Numbers the halves of edges: those at each vert in the order in which its triangles list them. Returns their number.
  std::uint32_t number_halves(surface_adjacency<3>& a) {
    const std::vector<std::uint32_t>& first = a.first_poly.empty() ? a.first_edge : a.first_poly;
    std::uint32_t count = 0;
    for (std::uint32_t v = 0; v < num_verts_; ++v) {
      std::uint32_t at = a.first_edge[v];
      const auto add = [&](std::uint32_t c, std::uint32_t fine) {
        const std::uint32_t j = in_.corners[c].edge;
        split_edge& e = edges_[j];
        std::uint32_t& half = e.halves[e.start == v ? 0 : 1];
        if (half == none) {
          half = count++;
          add_edge(a, half, {v, at++, num_verts_ + j, e.last++}, fine);
          a.p2p[fine] = {};
        } else {
          const std::uint32_t before = a.first_corner[half];
          a.p2p[fine].raw = before / 3;
          a.p2p[before].raw = fine / 3;
        }
        a.p2e[fine] = edge_id{half};
      };
      for (std::uint32_t i = first[v]; i < first[v + 1]; ++i) {
        const std::uint32_t f = a.v2p[i].raw(), c = f / 4 * 3 + f % 4;
        add(c, 3 * f);
        add(previous(c), 3 * f + 2);
      }
    }
    return count;
  }

  /// Numbers the edges between two middles, in the order in which the triangles at the first one list them.
  void number_cuts(surface_adjacency<3>& a, std::uint32_t count) {
    for (std::uint32_t j = 0; j < num_edges_; ++j)
      for (const std::uint32_t c : edges_[j].corners) {
        if (c == none) continue;
        for (const cut& x : cuts[c % 3]) {
          const std::uint32_t p = c / 3, other = in_.corners[3 * p + x.other].edge;
          if (other < j) continue;
          const std::uint32_t f = 4 * p + x.k, middle = 4 * p + 3, fine = 3 * f + 1, fine_of_middle = previous(3 * middle + x.k);
          add_edge(a, count, {num_verts_ + j, edges_[j].last++, num_verts_ + other, edges_[other].last++}, fine);
          a.p2e[fine] = a.p2e[fine_of_middle] = edge_id{count++};
          a.p2p[fine].raw = middle, a.p2p[fine_of_middle].raw = f;
        }
      }
  }

  /// The ends of an edge, and where it is listed among their edges.
  struct ends_of_edge {
    std::uint32_t a, at_a, b, at_b;
  };
  static void add_edge(surface_adjacency<3>& a, std::uint32_t e, const ends_of_edge& x, std::uint32_t fine) {
    a.first_corner[e] = fine;
    a.e2v[2 * std::size_t{e}] = a.v2v[x.at_b] = vert_id{x.a};
    a.e2v[2 * std::size_t{e} + 1] = a.v2v[x.at_a] = vert_id{x.b};
    a.v2e[x.at_a] = a.v2e[x.at_b] = edge_id{e};
  }
};

CONCINO_INLINE surface_tables<3> triangles_in_four(numbered_triangles triangles) {
  four_triangles four(triangles);
  if (four.find_triangles()) return surface_tables<3>(four.tables());
  std::vector<vert_id> lists = core::large_vector(4 * triangles.corners.size(), vert_id{});
  four.list_verts(lists.data());
  return surface_tables<3>(triangles.num_verts + triangles.num_edges, std::move(lists));
}

}  // namespace concino::detail
