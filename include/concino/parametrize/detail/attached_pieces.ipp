// Bodies of disk_embedding.hpp: Tutte's map of a disk, and the pieces of it that two verts separate from the boundary,
// from flat arrays.
#pragma once

#include <concino/parametrize/detail/disk_embedding.hpp>

#include <algorithm>
#include <numeric>
#include <utility>

namespace concino::detail {

/// Two verts separate a piece from the boundary if two polys have both of them, and the edge that joins them, if there
/// is one, is not that between these polys. Such pairs are cycles of length 4 in the graph of verts and their polys.
/// Interior verts of two edges are left out there: chains of them stand for edges.
/// Source: cycles as Chiba, Nishizeki 1985, "Arboricity and subgraph listing algorithms", in linear time.
class piece_finder {
  using index = std::uint32_t;
  static constexpr index none = static_cast<index>(-1);
  struct neighbour {
    index node;        // of a poly: a vert, of a vert: a poly
    index other_poly;  // of a poly: that of the chain from this vert to the next
  };
  const flat_disk& f_;
  std::vector<std::vector<index>> linked_;        // by vert, along edges
  std::vector<unsigned char> on_boundary_, is_in_chain_;
  std::vector<std::vector<neighbour>> incident_;  // verts, then polys
  std::vector<std::array<index, 2>> candidates_;
  std::vector<flat_piece> found_;

  index poly_node(index p) const { return static_cast<index>(f_.points.size()) + p; }

  void find_chains() {
    linked_.resize(f_.points.size());
    for (const auto& [a, b] : f_.edges) {
      linked_[a].push_back(b);
      linked_[b].push_back(a);
    }
    on_boundary_.assign(f_.points.size(), 0);
    for (const index v : f_.loop) on_boundary_[v] = 1;
    is_in_chain_.assign(f_.points.size(), 0);
    const auto has_two_edges = [&](index v) { return !on_boundary_[v] && linked_[v].size() == 2; };
    for (index v = 0; v < f_.points.size(); ++v) {
      if (!has_two_edges(v) || is_in_chain_[v]) continue;
      flat_piece piece{{}, {v}};
      is_in_chain_[v] = 1;
      for (std::size_t k = 0; k < 2; ++k) {
        index before = v, at = linked_[v][k];
        while (has_two_edges(at) && !is_in_chain_[at]) {
          is_in_chain_[at] = 1;
          piece.verts.push_back(at);
          const index next = linked_[at][0] == before ? linked_[at][1] : linked_[at][0];
          before = std::exchange(at, next);
        }
        piece.at[k] = at;
      }
      found_.push_back(std::move(piece));
    }
  }

  void join_polys_and_verts() {
    incident_.resize(f_.points.size() + f_.num_polys());
    for (index p = 0; p < f_.num_polys(); ++p)
      for (index c = f_.first[p]; c < f_.first[p + 1]; ++c) {
        const index v = f_.corners[c];
        if (is_in_chain_[v]) continue;
        incident_[poly_node(p)].push_back({v, f_.other_poly[c]});
        incident_[v].push_back({poly_node(p), none});
      }
  }

  // Whether poly p has an edge from a to b, or from b to a, that separates it from poly q.
  bool is_edge_between(index p, index q, index a, index b) const {
    const auto& ring = incident_[p];
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const index here = ring[i].node, next = ring[(i + 1) % ring.size()].node;
      if (((here == a && next == b) || (here == b && next == a)) && ring[i].other_poly != flat_disk::no_poly &&
          poly_node(ring[i].other_poly) == q)
        return true;
    }
    return false;
  }

  void find_candidates() {
    std::vector<index> order(incident_.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](index a, index b) {
      return incident_[a].size() != incident_[b].size() ? incident_[a].size() > incident_[b].size() : a < b;
    });
    std::vector<unsigned char> is_done(incident_.size());
    std::vector<std::vector<index>> common(incident_.size());
    std::vector<index> met;
    for (const index x : order) {
      met.clear();
      for (const neighbour& y : incident_[x]) {
        if (is_done[y.node]) continue;
        for (const neighbour& z : incident_[y.node]) {
          if (z.node == x || is_done[z.node]) continue;
          if (common[z.node].empty()) met.push_back(z.node);
          common[z.node].push_back(y.node);
        }
      }
      for (const index z : met) {
        take(x, z, common[z]);
        common[z].clear();
      }
      is_done[x] = 1;
    }
  }

  // x and z are two verts with common polys, or two polys with common verts, in the order of x.
  void take(index x, index z, const std::vector<index>& shared) {
    const std::size_t k = shared.size();
    if (k < 2) return;
    if (x < f_.points.size()) {
      if (k > 2 || !is_edge_between(shared[0], shared[1], x, z)) add(x, z);
      return;
    }
    for (std::size_t i = 0; i < (k == 2 ? 1 : k); ++i) {
      const index a = shared[i], b = shared[(i + 1) % k];
      if (k > 2 || !is_edge_between(x, z, a, b)) add(a, b);
    }
  }
  void add(index a, index b) {
    if (a != b) candidates_.push_back({std::min(a, b), std::max(a, b)});
  }

  void keep_separating_pairs() {
    std::sort(candidates_.begin(), candidates_.end());
    candidates_.erase(std::unique(candidates_.begin(), candidates_.end()), candidates_.end());
    std::vector<index> last_met(f_.points.size(), none), waiting;
    for (index round = 0; round < candidates_.size(); ++round) {
      const auto& at = candidates_[round];
      std::size_t count = 2;
      last_met[at[0]] = last_met[at[1]] = round;
      waiting.clear();
      const auto meet = [&](index v) {
        if (last_met[v] == round) return;
        last_met[v] = round;
        ++count;
        waiting.push_back(v);
      };
      for (const index v : f_.loop) meet(v);
      while (!waiting.empty()) {
        const index v = waiting.back();
        waiting.pop_back();
        for (const index w : linked_[v]) meet(w);
      }
      if (count == f_.points.size()) continue;
      flat_piece piece{at, {}};
      for (index v = 0; v < f_.points.size(); ++v)
        if (last_met[v] != round) piece.verts.push_back(v);
      // A chain between the two verts, alone, is known.
      if (!std::all_of(piece.verts.begin(), piece.verts.end(), [&](index v) { return is_in_chain_[v]; }))
        found_.push_back(std::move(piece));
    }
  }

 public:
  explicit piece_finder(const flat_disk& f) : f_(f) {
    find_chains();
    join_polys_and_verts();
    find_candidates();
    keep_separating_pairs();
  }
  std::vector<flat_piece> found() && { return std::move(found_); }
};

CONCINO_INLINE std::vector<flat_piece> attached_pieces(const flat_disk& f) { return piece_finder(f).found(); }

}  // namespace concino::detail
