// Counts what the verts of a mesh add to the topology of {u <= t} as t grows: the homology of the cells whose highest
// vert each of them is.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/compiled.hpp>
#include <concino/fields/detail/topology/vert_order.hpp>
#include <concino/graph/disjoint_sets.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// A face of a polyhedron, both with the same highest vert.
struct lower_face {
  std::uint32_t vert, poly, face;
};

/// Adds to cycles[v], for each vert v of `incidences`, the number of independent sets of polyhedra that have each face
/// twice, or any even number of times.
/// Cost:   O(k^3) for k polyhedra at one vert, in the worst case.
void count_cycles(std::vector<lower_face> incidences, std::vector<std::uint32_t>& cycles);

[[noreturn]] void throw_not_closed_below(std::size_t vert);

/// The cells whose highest vert is v have a lower link: a vert for each edge, an edge for each polygon and a polygon
/// for each polyhedron. With n0, n1 and n2 of them and Betti numbers b0, b1 and b2, n0 - n1 + n2 = b0 - b1 + b2. b0 is
/// found by union of the edges of v through its polygons, b2 by union of the polyhedra of v through its faces, since a
/// set of polyhedra without boundary is one whose faces all have two of them. One set of arrays serves all verts.
template<AnyMesh M>
class lower_links {
  static constexpr std::uint32_t none = 0xffffffffu;

  const M& m_;
  const vert_order& order_;
  std::vector<std::array<std::uint32_t, 4>> count_;  // of edges, polygons, unions of edges and polyhedra, by vert; then
                                                     // multiplicities
  std::vector<std::uint32_t> cycles_;                // b2 by vert, of volumes

  struct highest_corner {
    std::size_t vert, place, size;
  };

  template<class Loop>
  highest_corner find_highest(const Loop& loop) const {
    highest_corner h{none, 0, 0};
    for (const vert_t<M> v : loop) {
      const std::size_t i = index_of(m_, v);
      if (h.size == 0 || order_.is_below(h.vert, i)) h.vert = i, h.place = h.size;
      ++h.size;
    }
    return h;
  }

  void count_edges() {
    for (const edge_t<M> e : edges(m_)) ++count_[find_highest(adj_e2v(m_, e)).vert][0];
  }

  /// The two edges of a polygon at its highest vert; edge k joins verts k and k + 1.
  template<class Loop, class Edges>
  void add_polygon(const Loop& loop, const Edges& sides, disjoint_sets& sets) {
    const highest_corner h = find_highest(loop);
    const std::size_t before = h.place == 0 ? h.size - 1 : h.place - 1;
    std::size_t first = none, second = none, k = 0;
    for (const edge_t<M> e : sides) {
      if (k == before) first = index_of(m_, e);
      if (k == h.place) second = index_of(m_, e);
      ++k;
    }
    ++count_[h.vert][1];
    count_[h.vert][2] += sets.unite(first, second);
  }

  void count_cells() {
    std::vector<std::uint32_t> top(poly_index_bound(m_), none);
    for (const poly_t<M> p : polys(m_)) {
      const std::size_t highest = find_highest(adj_p2v(m_, p)).vert;
      top[index_of(m_, p)] = static_cast<std::uint32_t>(highest);
      ++count_[highest][3];
    }
    disjoint_sets sets(poly_index_bound(m_));
    std::vector<unsigned char> is_open(poly_index_bound(m_)), is_non_manifold(vert_index_bound(m_));
    bool any_non_manifold = false;
    for (const face_t<M> f : faces(m_)) {
      const std::size_t highest = find_highest(adj_f2v(m_, f)).vert;
      std::size_t n = 0, first = 0;
      for (const poly_t<M> p : adj_f2p(m_, f)) {
        const std::size_t i = index_of(m_, p);
        if (top[i] != highest) continue;
        if (n == 0) first = i;
        else sets.unite(first, i);
        ++n;
      }
      if (n == 1) is_open[first] = 1;
      if (n > 2) is_non_manifold[highest] = 1, any_non_manifold = true;
    }
    for (std::size_t i = 0; i < top.size(); ++i)
      if (is_open[i]) is_open[sets.root(i)] = 1;
    for (std::size_t i = 0; i < top.size(); ++i)
      if (top[i] != none && sets.root(i) == i && !is_open[i] && !is_non_manifold[top[i]]) ++cycles_[top[i]];
    if (any_non_manifold) count_non_manifold(top, is_non_manifold);
  }

  /// The verts at whose faces three or more polyhedra meet below them.
  void count_non_manifold(const std::vector<std::uint32_t>& top, const std::vector<unsigned char>& is_non_manifold) {
    std::vector<lower_face> incidences;
    for (const face_t<M> f : faces(m_)) {
      const std::size_t highest = find_highest(adj_f2v(m_, f)).vert;
      if (!is_non_manifold[highest]) continue;
      for (const poly_t<M> p : adj_f2p(m_, f)) {
        const std::size_t i = index_of(m_, p);
        if (top[i] == highest)
          incidences.push_back({static_cast<std::uint32_t>(highest), static_cast<std::uint32_t>(i),
                                static_cast<std::uint32_t>(index_of(m_, f))});
      }
    }
    count_cycles(std::move(incidences), cycles_);
  }

 public:
  lower_links(const M& m, const vert_order& order) : m_(m), order_(order), count_(vert_index_bound(m)) {
    disjoint_sets sets(edge_index_bound(m));
    count_edges();
    if constexpr (dimension_v<M> == 2) {  // the polygons of a surface are its polys, those of a volume its faces
      for (const poly_t<M> p : polys(m)) add_polygon(adj_p2v(m, p), adj_p2e(m, p), sets);
    } else {
      cycles_.resize(vert_index_bound(m));
      for (const face_t<M> f : faces(m)) add_polygon(adj_f2v(m, f), adj_f2e(m, f), sets);
      count_cells();
    }
  }

  /// The reduced Betti numbers of the lower link of vert i: of index k that of dimension k - 1.
  /// Errors: invalid_mesh if the loops of polygons are fewer than what the polyhedra fill, which happens only if a
  ///         polyhedron is not closed.
  std::array<std::uint32_t, 4> multiplicity(std::size_t i) const {
    const auto [edges, polygons, unions, cells] = count_[i];
    if (edges == 0) return {1, 0, 0, 0};
    const std::uint32_t cycles = cycles_.empty() ? 0 : cycles_[i];
    if (polygons - unions < cells - cycles) throw_not_closed_below(i);
    return {0, edges - unions - 1, polygons - unions + cycles - cells, cycles};
  }
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/fields/detail/topology/lower_links.ipp>
#endif
