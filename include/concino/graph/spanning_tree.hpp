// Minimum spanning trees: the shortest arcs that connect each component.
#pragma once

#include <concino/core/message.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/graph/disjoint_sets.hpp>
#include <concino/graph/detail/lengths.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <queue>
#include <string>
#include <utility>
#include <vector>

namespace concino {

enum class tree_method {
  kruskal,  // takes arcs from the shortest to the longest, unless their ends are connected already
  prim      // grows one tree per component, one after the other, each from its first node
};

/// Node is a vert (primal graph) or a poly (dual graph). Crossed is what lies between two of them, void if the mesh has
/// no access to it.
template<class Node, class Crossed = void>
struct spanning_tree_options {
  using arc = std::pair<Node, Node>;
  tree_method method = tree_method::kruskal;         // both give the same tree
  function_ref<bool(arc, arc)> before = nullptr;     // a strict weak order of preference of arcs (empty: shorter ones
                                                     // first); ends by index_of
  function_ref<bool(Node)> may_enter = nullptr;      // false: the tree does not contain this node (empty: it contains
                                                     // all)
  detail::may_cross_t<Crossed> may_cross = nullptr;  // false: the tree does not cross this edge or face (empty: it may
                                                     // cross all)
};

/// The result of spanning_tree. `edges`, the mesh edge of each arc, exists for the primal graph of a mesh that has
/// edges.
template<class Node, class Edge = void>
struct spanning_tree_result {
  std::vector<std::pair<Node, Node>> arcs;
  std::vector<Edge> edges;
  double weight = 0;  // the sum of the lengths
};
template<class Node>
struct spanning_tree_result<Node, void> {
  std::vector<std::pair<Node, Node>> arcs;
  double weight = 0;
};

namespace detail {

template<class G> struct tree_edge { using type = void; };
template<class M> struct tree_edge<primal_graph<M>> { using type = crossed_t<primal_graph<M>>; };
struct no_edge {};

template<class G>
class tree_builder {
  using node = typename G::node;
  using edge = typename tree_edge<G>::type;
  static constexpr bool has_edges = !std::is_void_v<edge>;
  using stored_edge = std::conditional_t<has_edges, edge, no_edge>;

  struct candidate {
    double length;
    std::size_t low, high;
    std::pair<node, node> ends;  // of smaller and of larger index
    bool upward;                 // found from the node of smaller index
    stored_edge via;
  };

  const G& g_;
  const spanning_tree_options<node, crossed_t<G>>& options_;
  spanning_tree_result<node, edge> tree_;

  /// A total order, so that there is one minimum tree: of equivalent arcs, the one of smaller indices comes first.
  bool less(const candidate& a, const candidate& b) const {
    if (options_.before) {
      if (options_.before(a.ends, b.ends)) return true;
      if (options_.before(b.ends, a.ends)) return false;
    } else if (a.length != b.length) {
      return a.length < b.length;
    }
    return a.low != b.low ? a.low < b.low : a.high < b.high;
  }

  bool may_enter(const node& v) const { return !options_.may_enter || options_.may_enter(v); }

  template<class L, class F>
  void for_each_candidate(const L& lengths, const node& v, bool only_upward, const F& visit) const {
    const std::size_t i = g_.index(v);
    const auto consider = [&](const node& w, const stored_edge& via) {
      const std::size_t j = g_.index(w);
      const bool upward = i < j;
      if (only_upward && !upward) return;
      const auto& from = upward ? v : w;
      const auto& to = upward ? w : v;
      const double length = lengths.from(from)(to, std::numeric_limits<double>::infinity());
      if (!(length > -std::numeric_limits<double>::infinity()))
        core::throw_joined<invalid_mesh>({"spanning_tree: the length from ", name_of(g_, from), " to ", name_of(g_, to),
                                          " is ", length < 0 ? "-inf" : "not a number",
                                          "; lengths must be numbers, +inf for no arc"});
      if (length < std::numeric_limits<double>::infinity())
        visit(candidate{length, std::min(i, j), std::max(i, j), {from, to}, upward, via});
    };
    if constexpr (has_edges) {
      for_each_crossing(g_, v, [&](const node& w, const edge& e) {
        if ((!options_.may_cross || options_.may_cross(e)) && may_enter(w)) consider(w, e);
      });
    } else {
      for_each_open_neighbour(g_, v, options_.may_enter, options_.may_cross,
                              [&](const node& w) { consider(w, no_edge{}); });
    }
  }

  void take(const candidate& c, bool turned) {
    tree_.arcs.push_back(turned ? std::pair(c.ends.second, c.ends.first) : c.ends);
    if constexpr (has_edges) tree_.edges.push_back(c.via);
    tree_.weight += c.length;
  }

 public:
  tree_builder(const G& g, const spanning_tree_options<node, crossed_t<G>>& options) : g_(g), options_(options) {}

  template<class L>
  auto kruskal(const L& lengths) {
    std::vector<candidate> candidates;
    for (const node v : g_.nodes())
      if (may_enter(v)) for_each_candidate(lengths, v, true, [&](const candidate& c) { candidates.push_back(c); });
    std::sort(candidates.begin(), candidates.end(),
              [this](const candidate& a, const candidate& b) { return less(a, b); });
    disjoint_sets sets(g_.bound());
    for (const candidate& c : candidates)
      if (sets.unite(c.low, c.high)) take(c, false);
    return std::move(tree_);
  }

  template<class L>
  auto prim(const L& lengths) {
    std::vector<unsigned char> in_tree(g_.bound());
    const auto later = [this](const candidate& a, const candidate& b) { return less(b, a); };
    std::priority_queue<candidate, std::vector<candidate>, decltype(later)> queue(later);
    const auto add = [&](const node& v) {
      in_tree[g_.index(v)] = 1;
      for_each_candidate(lengths, v, false, [&](const candidate& c) {
        if (!in_tree[c.upward ? c.high : c.low]) queue.push(c);
      });
    };
    for (const node s : g_.nodes()) {
      if (in_tree[g_.index(s)] || !may_enter(s)) continue;
      add(s);
      while (!queue.empty()) {
        const candidate c = queue.top();
        queue.pop();
        if (in_tree[c.upward ? c.high : c.low]) continue;
        take(c, !c.upward);
        add(c.upward ? c.ends.second : c.ends.first);
      }
    }
    return std::move(tree_);
  }
};

template<class G, class L>
auto spanning_tree(const G& g, const L& lengths, const spanning_tree_options<typename G::node, crossed_t<G>>& options) {
  tree_builder<G> builder(g, options);
  return options.method == tree_method::prim ? builder.prim(lengths) : builder.kruskal(lengths);
}

}  // namespace detail

namespace requirement {

template<class M>
concept has_default_lengths = Embedded<concino::detail::base_mesh_t<std::remove_cvref_t<M>>> &&
                              (AnyMesh<concino::detail::base_mesh_t<std::remove_cvref_t<M>>> || PrimalGraph<M>);

}  // namespace requirement

/// The minimum spanning tree of each component of the verts of a mesh, or of its polys if the argument is dual(m); or
/// the tree that prefers arcs by another order. Without a length function, an arc has the Euclidean length between the
/// verts, or between the means of the verts of the polys.
/// Needs:  PrimalGraph M, or dual(m) of a DualGraph m; length(v, w) is called from smaller to larger index_of, may be
///         negative, and is +inf for no arc. Without a length: Embedded, and AnyMesh for polys. may_cross needs the
///         edges or faces of an AnyMesh.
/// Result: st.arcs: pairs of nodes, as many as nodes minus components; st.edges: their edges, for verts of a mesh with
///         edges; st.weight. By Kruskal in the order taken, smaller index first; by Prim as the trees grow, outward.
///         Both take the same arcs: of equivalent arcs first those whose smaller index, then whose larger index is
///         smaller.
/// Cost:   O(E log E) time, O(V + E) memory.
/// Errors: invalid_mesh if a length is not a number or -inf.
/// Source: Kruskal 1956; Prim 1957; paper section 2.1, "Architecture".
template<class M>
  requires requirement::is_graph<M> && requirement::has_default_lengths<M>
auto spanning_tree(const M& m,  // may_cross: not of a bare graph
                   const spanning_tree_options<detail::default_node_of<M>,
                                               detail::crossed_t<detail::default_graph_of<M>>>& options = {}) {
  const detail::default_graph_of<M> g{m};
  return detail::spanning_tree(g, detail::default_lengths(g), options);
}

template<class M, class L>
  requires requirement::is_graph<M> && requirement::is_length<L, detail::default_node_of<M>>
auto spanning_tree(const M& m, const L& length,  // may_cross: not of a bare graph
                   const spanning_tree_options<detail::default_node_of<M>,
                                               detail::crossed_t<detail::default_graph_of<M>>>& options = {}) {
  return detail::spanning_tree(detail::default_graph_of<M>{m}, detail::input_lengths<L>{length}, options);
}

// What to write instead of calls that cannot compile.
template<class... T> void spanning_tree(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void spanning_tree(mistake::polys_alone<mistake::name_dual>, ...) = delete;  // of a graph of polys alone write spanning_tree(dual(m))
template<class... T> void spanning_tree(mistake::no_points<"the mesh has no points (Embedded), so its edges have no lengths: pass a callable that returns lengths, spanning_tree(m, length)">, ...) = delete;

}  // namespace concino
