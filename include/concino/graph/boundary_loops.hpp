// The boundary of a surface, as loops of edges.
#pragma once

#include <concino/concepts/facets.hpp>
#include <concino/concepts/oriented_edges.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/graph/disjoint_sets.hpp>
#include <concino/graph/edge_walk.hpp>

#include <limits>
#include <utility>

namespace concino {

template<class M>
struct boundary_loops_result {
  std::size_t count = 0;            // borders: connected components of the graph of boundary edges
  std::vector<edge_walk<M>> loops;  // every boundary edge occurs in exactly one of them
};

namespace detail {

/// Boundary edges with the direction that they have in their only poly, in lists at both of their ends.
template<class M>
class border_edges {
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  struct boundary_edge {
    edge_t<M> edge;
    vert_t<M> from, to;
    std::uint32_t next_out = none, next_in = none;
    bool taken = false;
  };
  const M& m_;
  std::vector<boundary_edge> edges_;
  std::vector<std::uint32_t> out_, in_;  // by vert: the first edge that leaves or enters it; the lists continue in
                                         // next_out, next_in
  std::vector<std::uint32_t> degree_;    // by vert: the number of edges there that are not taken

  void pass_taken(std::uint32_t& i, std::uint32_t boundary_edge::*next) {
    while (i != none && edges_[i].taken) i = edges_[i].*next;
  }

 public:
  explicit border_edges(const M& m) : m_(m) {
    std::vector<unsigned char> on_border(edge_index_bound(m));
    bool any = false;
    for (const edge_t<M> e : edges(m)) {
      if (!is_boundary(m, e)) continue;
      on_border[index_of(m, e)] = 1;
      any = true;
    }
    if (!any) return;
    for (const poly_t<M> p : polys(m)) {
      bool here = false;
      for (const edge_t<M> e : adj_p2e(m, p)) here = here || on_border[index_of(m, e)];
      if (!here) continue;
      for (const auto& [e, from, to] : oriented_edges(m, p))
        if (on_border[index_of(m, e)]) edges_.push_back({e, from, to});
    }
    out_.assign(vert_index_bound(m), none);
    in_ = out_;
    degree_.assign(out_.size(), 0);
    for (std::size_t i = edges_.size(); i-- > 0;) {  // backwards, so that the lists are in ascending order
      edges_[i].next_out = std::exchange(out_[index_of(m, edges_[i].from)], static_cast<std::uint32_t>(i));
      edges_[i].next_in = std::exchange(in_[index_of(m, edges_[i].to)], static_cast<std::uint32_t>(i));
      ++degree_[index_of(m, edges_[i].from)];
      ++degree_[index_of(m, edges_[i].to)];
    }
  }

  std::size_t size() const { return edges_.size(); }
  bool is_taken(std::size_t i) const { return edges_[i].taken; }
  const vert_t<M>& from(std::size_t i) const { return edges_[i].from; }
  const vert_t<M>& to(std::size_t i) const { return edges_[i].to; }
  bool is_odd(const vert_t<M>& v) const { return degree_[index_of(m_, v)] % 2; }

  /// Takes an edge at v and moves v to its other end; an edge that leaves v has priority. False if there is none.
  bool step(vert_t<M>& v, edge_t<M>& e) {
    const std::size_t slot = index_of(m_, v);
    pass_taken(out_[slot], &boundary_edge::next_out);
    const bool forwards = out_[slot] != none;
    if (!forwards) pass_taken(in_[slot], &boundary_edge::next_in);
    const std::uint32_t i = forwards ? out_[slot] : in_[slot];
    if (i == none) return false;
    edges_[i].taken = true;
    --degree_[index_of(m_, edges_[i].from)];
    --degree_[index_of(m_, edges_[i].to)];
    e = edges_[i].edge;
    v = forwards ? edges_[i].to : edges_[i].from;
    return true;
  }

  std::size_t num_components() const {
    disjoint_sets sets(out_.size());
    std::vector<unsigned char> used(out_.size());
    std::size_t n = 0;
    for (const boundary_edge& s : edges_) {
      const std::size_t a = index_of(m_, s.from), b = index_of(m_, s.to);
      n += !std::exchange(used[a], static_cast<unsigned char>(1));
      n += !std::exchange(used[b], static_cast<unsigned char>(1));
      n -= sets.unite(a, b);
    }
    return n;
  }
};

}  // namespace detail

/// The boundary of a surface: its edges with exactly one poly, as loops.
/// Needs:  SurfaceMesh M.
/// Result: loops, together every boundary edge once. A loop is a simple cycle, in the direction that its edges have in
///         their polys; if these are oriented consistently, the surface is on its left. Where borders touch at a vert,
///         each loop passes it once. They are several loops but one border, so `count` may be less than their number.
///         Only if an odd number of boundary edges meet at a vert (an edge with three polys may end there) do open
///         walks remain after the cycles, one for two such verts. The same mesh always gives the same loops.
/// Cost:   O(elements) time and memory.      Errors: none.
template<SurfaceMesh M>
boundary_loops_result<M> boundary_loops(const M& m) {
  boundary_loops_result<M> result;
  detail::border_edges<M> border(m);
  if (border.size() == 0) return result;
  result.count = border.num_components();

  // Walk until a vert is met for the second time, then move the part in between to the result, as a cycle.
  constexpr std::uint32_t nowhere = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> position(vert_index_bound(m), nowhere);
  edge_walk<M> walk;
  const auto go_from = [&](vert_t<M> v) {
    edge_t<M> e{};
    walk.verts.assign(1, v);
    walk.edges.clear();
    position[index_of(m, v)] = 0;
    while (border.step(v, e)) {
      walk.edges.push_back(e);
      const std::size_t back = position[index_of(m, v)];
      if (back == nowhere) {
        position[index_of(m, v)] = static_cast<std::uint32_t>(walk.verts.size());
        walk.verts.push_back(v);
        continue;
      }
      const auto first_vert = walk.verts.begin() + static_cast<std::ptrdiff_t>(back);
      const auto first_edge = walk.edges.begin() + static_cast<std::ptrdiff_t>(back);
      result.loops.push_back({{first_vert, walk.verts.end()}, {first_edge, walk.edges.end()}});
      for (auto it = first_vert + 1; it != walk.verts.end(); ++it) position[index_of(m, *it)] = nowhere;
      walk.verts.erase(first_vert + 1, walk.verts.end());
      walk.edges.erase(first_edge, walk.edges.end());
    }
    for (const vert_t<M>& w : walk.verts) position[index_of(m, w)] = nowhere;
    if (!walk.edges.empty()) result.loops.push_back(walk);
  };
  // A walk from a vert with an odd number of edges left ends at another such vert. After these, all walks return to
  // their start.
  for (std::size_t i = 0; i < border.size(); ++i)
    for (const vert_t<M>& v : {border.from(i), border.to(i)})
      if (!border.is_taken(i) && border.is_odd(v)) go_from(v);
  for (std::size_t i = 0; i < border.size(); ++i)
    if (!border.is_taken(i)) go_from(border.from(i));
  return result;
}

// What to write instead of calls that cannot compile.
template<class... T> void boundary_loops(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()

}  // namespace concino
