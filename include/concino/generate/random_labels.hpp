// Random labels that partition a mesh into pieces, mostly concave, that agglomerate() can merge.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/generate/detail/common/merged_boundary.hpp>
#include <concino/generate/detail/common/random.hpp>
#include <concino/graph/disjoint_sets.hpp>
#include <concino/mesh/element_map.hpp>

#include <cstdint>
#include <queue>
#include <utility>
#include <vector>

namespace concino {

namespace detail {

/// Whether a disk or ball remains one if a poly is added: they must share exactly a path of edges, or a disk of faces.
template<AnyMesh M>
class link_condition {
  const M& m_;
  const int* label_;  // by index of the poly
  stamped_array<std::uint32_t> face_at_edge_;
  stamped_array<unsigned char> shared_vert_;
  disjoint_sets sets_;  // of shared faces that are connected through edges

  template<class R>
  bool holds(const R& polys, int label) const {
    for (const poly_t<M> p : polys)
      if (label_[index_of(m_, p)] == label) return true;
    return false;
  }

 public:
  link_condition(const M& m, const int* label)
      : m_(m), label_(label), face_at_edge_(dimension_v<M> == 3 ? edge_index_bound(m) : 0),
        shared_vert_(vert_index_bound(m)) {}

  bool operator()(const poly_t<M>& p, int label) {
    shared_vert_.clear();
    std::ptrdiff_t chi = 0;  // Euler characteristic of the shared elements
    std::size_t pieces = 0;
    if constexpr (SurfaceMesh<M>) {  // the shared elements have one dimension less: edges of a surface, faces of a
                                     // volume
      for (const edge_t<M> e : adj_p2e(m_, p)) {
        if (!holds(adj_e2p(m_, e), label)) continue;
        --chi, ++pieces;
        for (const vert_t<M> v : adj_e2v(m_, e)) chi += shared_vert_.add(index_of(m_, v), 1);
      }
      if (pieces == 0) return false;
    } else {
      face_at_edge_.clear();
      sets_.clear();
      for (const face_t<M> f : adj_p2f(m_, p)) {
        if (!holds(adj_f2p(m_, f), label)) continue;
        ++chi, ++pieces;
        const auto k = static_cast<std::uint32_t>(sets_.add());
        for (const edge_t<M> e : adj_f2e(m_, f)) {
          const std::size_t i = index_of(m_, e);
          if (face_at_edge_.add(i, k)) --chi;
          else pieces -= sets_.unite(face_at_edge_[i], k);
        }
        for (const vert_t<M> v : adj_f2v(m_, f)) chi += shared_vert_.add(index_of(m_, v), 1);
      }
      if (pieces != 1) return false;
      for (const edge_t<M> e : adj_p2e(m_, p))
        if (!face_at_edge_.has(index_of(m_, e)) && holds(adj_e2p(m_, e), label)) return false;
    }
    if (chi != 1) return false;
    for (const vert_t<M> v : adj_p2v(m_, p))
      if (!shared_vert_.has(index_of(m_, v)) && holds(adj_v2p(m_, v), label)) return false;
    return true;
  }
};

/// Divides each piece that has no single boundary into its polys. On meshes that are not manifold, the test of one poly
/// after another is not sufficient.
template<class M>
void divide_pieces_that_cannot_merge(const M& m, std::vector<std::vector<poly_t<M>>>& pieces, int* label) {
  merged_boundary<M> border(m);
  for (std::size_t l = 0, grown = pieces.size(); l < grown; ++l) {
    if (!border.read(pieces[l])) continue;
    for (std::size_t k = 1; k < pieces[l].size(); ++k)
      label[index_of(m, pieces[l][k])] = static_cast<int>(pieces.size() + k - 1);
    pieces.resize(pieces.size() + pieces[l].size() - 1);
  }
}

}  // namespace detail

/// Partitions m into random pieces of about `size` polys each, ragged and mostly concave. Each piece is a disk
/// (surfaces) or a ball (volumes).
/// Needs:  AnyMesh, not a temporary; size of 1 or more.
/// Result: a map of int, from 0 to the number of pieces minus one, for agglomerate(m, labels). Pieces grow from random
///         polys by steps of random length. A poly that would close a ring, or make a piece touch itself, is not added;
///         the remaining polys form smaller pieces. Where polys are not manifold or not oriented consistently, pieces
///         are single polys. The same seed gives the same labels on every machine.
/// Cost:   O(E log E) time, times the polys at a vert; O(elements) memory.
/// Errors: invalid_argument if size is 0.
/// Source: first-passage percolation: Eden 1961; Hammersley, Welsh 1965.
template<class M>
  requires requirement::is_lvalue_or_view<M> && AnyMesh<M>
poly_map<M, int> random_labels(M&& m, std::size_t size, std::uint64_t seed = 1) {
  using mesh = std::remove_cvref_t<M>;
  using poly = poly_t<mesh>;
  if (size == 0) throw invalid_argument("random_labels: size is 0; it must be at least 1");
  auto labels = make_poly_map<int>(m, -1);
  int* const label = labels.values().data();
  std::vector<poly> order;
  for (const poly p : polys(m)) order.push_back(p);
  detail::random_stream random(seed);
  for (std::size_t n = order.size(); n > 1; --n)
    std::swap(order[n - 1], order[static_cast<std::size_t>(random.unit() * static_cast<double>(n))]);

  struct claim {
    double time;
    std::size_t number;
    int label;
    poly on;
  };
  // Not grow_regions: a claim that is refused because the piece would touch itself may be allowed later, so all claims
  // on a poly are queued.
  const auto later = [](const claim& a, const claim& b) {
    return a.time != b.time ? a.time > b.time : a.number > b.number;
  };
  std::priority_queue<claim, std::vector<claim>, decltype(later)> queue(later);
  std::vector<std::vector<poly>> pieces;
  std::size_t number = 0;
  const auto take = [&](const poly& p, int l, double time) {
    label[index_of(m, p)] = l;
    pieces[static_cast<std::size_t>(l)].push_back(p);
    for (const poly q : adj_p2p(m, p))
      if (label[index_of(m, q)] < 0) queue.push({time + random.unit(), number++, l, q});
  };
  detail::link_condition<mesh> may_join(m, label);
  const auto grow = [&] {
    while (!queue.empty()) {
      const claim c = queue.top();
      queue.pop();
      if (label[index_of(m, c.on)] >= 0 || pieces[static_cast<std::size_t>(c.label)].size() / 2 >= size) continue;
      if (may_join(c.on, c.label)) take(c.on, c.label, c.time);
    }
  };
  const auto begin_piece = [&](const poly& p) {
    pieces.emplace_back();
    take(p, static_cast<int>(pieces.size()) - 1, 0);
  };
  for (std::size_t i = 0; i < order.size(); i += size) begin_piece(order[i / size]);
  grow();
  for (const poly& p : order) {
    if (label[index_of(m, p)] >= 0) continue;
    begin_piece(p);
    grow();
  }

  detail::divide_pieces_that_cannot_merge(m, pieces, label);
  return labels;
}

// What to write instead of calls that cannot compile.
template<class... T> void random_labels(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void random_labels(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;

}  // namespace concino
