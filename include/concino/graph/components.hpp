// Connected components: a label for every element, and the number of components.
#pragma once

#include <concino/core/function_ref.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/graph/detail/crossings.hpp>
#include <concino/graph/disjoint_sets.hpp>
#include <concino/graph/detail/for_each.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace concino {

/// Node is a vert (primal graph) or a poly (dual graph). Crossed is what lies between two of them, void if the mesh has
/// no access to it.
template<class Node, class Crossed = void>
struct connected_components_options {
  function_ref<bool(Node)> may_enter = nullptr;      // false: the node belongs to no component (empty: all do)
  detail::may_cross_t<Crossed> may_cross = nullptr;  // false: this edge or face does not connect its two nodes (empty:
                                                     // all do)
};

/// cc[x] is the number of the component of x, -1 if may_enter(x) is false. Components are numbered from 0 in the order
/// in which an iteration over all nodes meets them.
template<class Map>
struct component_labels {
  int count = 0;
  Map labels;

  template<class X>
    requires requires(const Map& map, const X& x) { map[x]; }
  int operator[](const X& x) const { return labels[x]; }
};

namespace detail {

/// Unites each node with its neighbours of smaller index. Nodes with similar indices are close in memory, so the mesh
/// and the labels are read almost in order, while a search would jump. A separate function, so that its loop can use
/// all registers.
template<class G>
void unite_neighbours(G g, disjoint_sets& sets) {
  for (const auto v : g.nodes()) {
    const std::size_t i = g.index(v);
    std::size_t root = sets.root(i);
    for_each_with_repeats(g.neighbours(v), [&](const typename G::node& w) {
      const std::size_t j = g.index(w);
      if (j >= i) return;
      if (const std::size_t other_root = sets.root(j); other_root != root) root = sets.unite_roots(root, other_root);
    });
  }
}

template<class G>
auto connected_components(const G& g, const connected_components_options<typename G::node, crossed_t<G>>& options) {
  using node = typename G::node;
  auto labels = make_node_map<int>(g, -1);
  int* const label = labels.data();
  const auto may_enter = options.may_enter;
  disjoint_sets sets(g.bound());

  const bool barred = may_enter || options.may_cross;
  if (barred) {
    for (const node v : g.nodes()) {
      if (may_enter && !may_enter(v)) continue;
      const std::size_t i = g.index(v);
      label[i] = 0;  // may be entered
      for_each_open_neighbour(g, v, nullptr, options.may_cross, [&](const node& w) {
        if (const std::size_t j = g.index(w); label[j] == 0) sets.unite(i, j);
      });
    }
  } else {
    unite_neighbours(g, sets);
  }

  auto of_root = std::vector<int>(barred ? g.bound() : 0, -1);
  int* const number = barred ? of_root.data() : label;
  int count = 0;
  for (const node v : g.nodes()) {
    const std::size_t i = g.index(v);
    if (barred && label[i] < 0) continue;
    int& n = number[sets.root(i)];
    if (n < 0) n = count++;
    label[i] = n;
  }
  return component_labels<decltype(labels)>{count, std::move(labels)};
}

}  // namespace detail

/// The connected components of the verts of a mesh, or of its polys if the argument is dual(m). may_enter excludes
/// nodes and may_cross excludes arcs, which can divide components further.
/// Needs:  PrimalGraph M, or dual(m) of a DualGraph m; may_cross needs the edges or faces of an AnyMesh.
/// Result: cc.count; cc[x] is 0 .. cc.count - 1, numbered by the first element in the order of iteration; -1 for
///         excluded nodes.
/// Cost:   O(V + E) up to an inverse Ackermann factor in time, O(V) memory.
/// Errors: none of its own.
/// Source: Galler, Fisher 1964; paper section 2.1, "Architecture".
template<class M>
  requires requirement::is_lvalue_or_view<M> && requirement::is_graph<M>
auto connected_components(  // may_cross: not of a bare graph
    M&& m, const connected_components_options<detail::default_node_of<M>,
                                              detail::crossed_t<detail::default_graph_of<M>>>& options = {}) {
  return detail::connected_components(detail::default_graph_of<M>{m}, options);
}

// What to write instead of calls that cannot compile.
template<class... T> void connected_components(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void connected_components(mistake::polys_alone<mistake::name_dual>, ...) = delete;  // of a graph of polys alone write connected_components(dual(m))
template<class... T> void connected_components(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;

}  // namespace concino
