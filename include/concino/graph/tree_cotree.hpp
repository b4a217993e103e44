// Tree-cotree decomposition: a tree of verts and a tree of polys that share no edge, and the few edges of a closed
// surface that are in neither.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/core/number_text.hpp>
#include <concino/graph/detail/bounded_fifo.hpp>
#include <concino/graph/detail/corners.hpp>

#include <algorithm>
#include <string>
#include <utility>

namespace concino {

template<class M>
struct tree_cotree_result {
  std::vector<edge_t<M>> tree;    // a breadth-first tree of verts per component
  std::vector<edge_t<M>> cotree;  // the edges that a tree of polys per component crosses
  std::vector<edge_t<M>> rest;    // all others
};

namespace detail {

template<SurfaceMesh M>
void expect_closed_manifold(const M& m, const char* caller) {
  const auto refuse = [&](const std::string& what) { core::throw_joined<invalid_mesh>({caller, ": ", what}); };
  for (const edge_t<M> e : edges(m)) {
    const std::size_t n = num_elements(adj_e2p(m, e));
    if (n == 2) continue;
    refuse(core::joined({"edge ", index_of(m, e), " has ", n, n == 1 ? " poly" : " polys",
                           n < 2 ? "; the surface must be closed, fill its borders (boundary_loops) first"
                                 : "; the surface must be manifold, with two polys at every edge"}));
  }
  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  corner_classes<M> corners(m, [](std::size_t) { return false; });
  std::vector<std::size_t> class_of(vert_index_bound(m), none);
  for (const poly_t<M> p : polys(m)) {
    std::size_t corner = corners.first[index_of(m, p)];
    for (const vert_t<M> v : adj_p2v(m, p)) {
      std::size_t& known = class_of[index_of(m, v)];
      const std::size_t here = corners.classes.root(corner++);
      if (known == none) known = here;
      else if (known != here)
        refuse(core::joined({"the polys at vert ", index_of(m, v),
                               " form several fans; the surface must be manifold, with one fan at every vert"}));
    }
  }
}

/// The decomposition, with the parents of the tree.
template<SurfaceMesh M>
struct tree_cotree_tables : tree_cotree_result<M> {
  static constexpr std::uint32_t unreached = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> hops, component;  // by vert: steps to the root, and the number of the root
  std::vector<edge_t<M>> up_edge;              // by vert: the edge towards the root
  std::vector<vert_t<M>> up_vert;

  tree_cotree_tables(const M& m, const char* caller) {
    expect_closed_manifold(m, caller);
    grow_tree(m);
    grow_cotree(m);
  }

  std::pair<vert_t<M>, vert_t<M>> ends(const M& m, const edge_t<M>& e) const {
    vert_t<M> end[2] = {vert_t<M>(), vert_t<M>()};
    std::size_t n = 0;
    for (const vert_t<M> v : adj_e2v(m, e))
      if (n < 2) end[n++] = v;
    return {end[0], end[1]};
  }

 private:
  std::vector<unsigned char> in_tree_;

  /// A separate search: with bfs_forest, whose visitor and maps are type-erased, tree_cotree takes a tenth to a fifth
  /// longer in all.
  void grow_tree(const M& m) {
    const auto bound = vert_index_bound(m);
    hops.assign(bound, unreached);
    component.assign(bound, 0);
    up_edge.resize(bound);
    up_vert.resize(bound);
    in_tree_.assign(edge_index_bound(m), 0);
    bounded_fifo<vert_t<M>> queue(bound);
    std::uint32_t roots = 0;
    for (const vert_t<M> root : verts(m)) {
      if (hops[index_of(m, root)] != unreached) continue;
      hops[index_of(m, root)] = 0;
      component[index_of(m, root)] = roots++;
      queue.push(root);
      while (!queue.empty()) {
        const vert_t<M> v = queue.pop();
        const std::size_t at = index_of(m, v);
        for (const edge_t<M> e : adj_v2e(m, v)) {
          const auto [a, b] = ends(m, e);
          const vert_t<M>& w = a == v ? b : a;
          const std::size_t slot = index_of(m, w);
          if (hops[slot] != unreached) continue;
          hops[slot] = hops[at] + 1;
          component[slot] = component[at];
          up_edge[slot] = e;
          up_vert[slot] = v;
          in_tree_[index_of(m, e)] = 1;
          this->tree.push_back(e);
          queue.push(w);
        }
      }
    }
  }

  /// Builds the tree of polys whose edges close the longest loops, so that the loops of the remaining edges are as
  /// short as possible.
  void grow_cotree(const M& m) {
    std::vector<std::size_t> begins_at;  // loops by number of steps: where their edges begin in a list from long to
                                         // short
    const auto steps = [&](const edge_t<M>& e) {
      const auto [a, b] = ends(m, e);
      return std::size_t{hops[index_of(m, a)]} + hops[index_of(m, b)];
    };
    std::size_t candidates = 0;
    for (const edge_t<M> e : edges(m)) {
      if (in_tree_[index_of(m, e)]) continue;
      const std::size_t n = steps(e);
      if (begins_at.size() <= n) begins_at.resize(n + 1);
      ++begins_at[n];
      ++candidates;
    }
    for (std::size_t n = begins_at.size(), before = 0; n-- > 0;) before += std::exchange(begins_at[n], before);
    std::vector<edge_t<M>> sorted(candidates);
    for (const edge_t<M> e : edges(m))
      if (!in_tree_[index_of(m, e)]) sorted[begins_at[steps(e)]++] = e;

    disjoint_sets sets(poly_index_bound(m));
    for (const edge_t<M>& e : sorted) {
      std::size_t ends[2] = {0, 0}, n = 0;
      for (const poly_t<M> p : adj_e2p(m, e))
        if (n < 2) ends[n++] = index_of(m, p);
      (sets.unite(ends[0], ends[1]) ? this->cotree : this->rest).push_back(e);
    }
    std::reverse(this->rest.begin(), this->rest.end());
  }
};

}  // namespace detail

/// Partitions the edges of a closed surface: those in a spanning tree of the verts, those crossed by a spanning tree of
/// the polys, and the rest. The rest are 2 - chi per component: 2g if it is orientable and of genus g. Without the
/// edges of tree and rest the surface is a disk.
/// Needs:  SurfaceMesh M that is closed and manifold: two polys at every edge, one fan of polys at every vert (or
///         none). It need not be orientable, and may have several components.
/// Result: edges. The tree is breadth-first, from the first vert of each component; rest is sorted by the number of
///         steps of the loops that its edges close through the tree, shortest first. The same mesh always gives the
///         same trees.
/// Cost:   O(elements) time, but for the union of polys, and memory.
/// Errors: invalid_mesh that names the first edge or vert where the surface is not closed or not manifold.
/// Source: Eppstein 2003, "Dynamic generators of topologically embedded graphs"; the choice of trees: Erickson,
///         Whittlesey 2005.
template<SurfaceMesh M>
tree_cotree_result<M> tree_cotree(const M& m) {
  return detail::tree_cotree_tables<M>(m, "tree_cotree");
}

// What to write instead of calls that cannot compile.
template<class... T> void tree_cotree(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()

}  // namespace concino
