// Region growing: regions grow from seeds by adding adjacent elements.
#pragma once

#include <concino/core/message.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/graph/detail/lengths.hpp>

#include <cstddef>
#include <limits>
#include <queue>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino {

enum class growth {
  accumulated,  // the smallest total cost from the seed comes next: each node goes to the seed from which it is
                // cheapest
  step          // the smallest cost of the last step comes next, however far the region has grown already
};

/// Node is a vert (primal graph) or a poly (dual graph). Crossed is what lies between two of them, void if the mesh has
/// no access to it.
template<class Node, class Crossed = void>
struct grow_regions_options {
  growth priority = growth::accumulated;             // which element is added next
  function_ref<bool(Node)> may_enter = nullptr;      // false: the node belongs to no region (empty: any may). Seeds are
                                                     // exempt.
  detail::may_cross_t<Crossed> may_cross = nullptr;  // false: no region grows across this edge or face (empty: across
                                                     // all)
  double max_cost = std::numeric_limits<double>::infinity();  // >= 0; elements with a larger cost, total or of one step
                                                              // as priority says, are left out
};

namespace detail {

/// The cost of the step from v to w; cost returns a number or, if it returns bool, whether the step is allowed.
template<class G, class C>
double cost_of_step(const G& g, const C& cost, const typename G::node& v, const typename G::node& w) {
  if constexpr (std::is_same_v<std::remove_cvref_t<decltype(cost(v, w))>, bool>) {
    return cost(v, w) ? 1 : std::numeric_limits<double>::infinity();
  } else {
    const auto step = static_cast<double>(cost(v, w));
    if (!(step >= 0))
      core::throw_joined<invalid_mesh>({"grow_regions: the cost from ", name_of(g, v), " to ", name_of(g, w), " is ",
                                        step < 0 ? core::number_text(step) : std::string("not a number"),
                                        "; costs must be 0 or more; +inf keeps regions out"});
    return step;
  }
}

/// A node that a region may take. Claims of equal cost and label are served in the order in which they were made.
template<class Node>
struct region_claim {
  double cost;
  int label;
  std::size_t number;
  Node on;

  struct is_later {
    bool operator()(const region_claim& a, const region_claim& b) const {
      if (a.cost != b.cost) return a.cost > b.cost;
      return a.label != b.label ? a.label > b.label : a.number > b.number;
    }
  };
};

template<class G, class S, class C>
auto grow_regions(const G& g, const S& seeds, const C& cost,
                  const grow_regions_options<typename G::node, crossed_t<G>>& options) {
  using node = typename G::node;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (!(options.max_cost >= 0)) throw invalid_argument("grow_regions: max_cost must be 0 or more");
  const bool summed = options.priority == growth::accumulated;
  using claim = region_claim<node>;
  std::priority_queue<claim, std::vector<claim>, typename claim::is_later> queue;
  std::size_t number = 0;

  auto labels = make_node_map<int>(g, -1);
  int* const label = labels.data();
  struct offer { double cost; int label; };
  auto best = std::vector<offer>(summed ? g.bound() : 0, offer{infinity, 0});  // the best claims on nodes in the queue

  const auto conquer = [&](const node& v, int l, double so_far) {
    for_each_open_neighbour(g, v, options.may_enter, options.may_cross, [&](const node& w) {
      const std::size_t slot = g.index(w);
      if (label[slot] >= 0) return;
      const double step = cost_of_step(g, cost, v, w);
      const double total = summed ? so_far + step : step;
      if (total == infinity || total > options.max_cost) return;
      if (summed) {
        offer& known = best[slot];
        if (!(total < known.cost || (total == known.cost && l < known.label))) return;
        known = {total, l};
      }
      queue.push({total, l, number++, w});
    });
  };

  std::vector<std::pair<node, int>> starts;
  int next = 0;
  for_each_source(
      g, seeds, "grow_regions",
      [&](const node& s) {
        int& l = label[g.index(s)];
        if (l < 0) {
          l = next;
          starts.emplace_back(s, next);
        }
        ++next;
      },
      "seed");
  for (const auto& [s, l] : starts) conquer(s, l, 0);
  while (!queue.empty()) {
    const claim c = queue.top();
    queue.pop();
    int& l = label[g.index(c.on)];
    if (l >= 0) continue;
    l = c.label;
    conquer(c.on, c.label, c.cost);
  }
  return labels;
}

}  // namespace detail

namespace requirement {

/// A function that returns the cost of the step from one node to another, or whether the step is allowed.
template<class C, class N> concept is_cost = is_length<C, N>;

}  // namespace requirement

/// Regions around seeds (verts, or polys). In each step one region takes an adjacent element: the one that costs least
/// among all regions. If cost is a predicate (returns bool), only steps for which it is true are allowed, and all steps
/// cost 1: the regions grow ring by ring.
/// Needs:  PrimalGraph M for verts, DualGraph M for polys; cost(from, to) >= 0, +inf for never, `from` in the region
///         and `to` in none. may_cross needs the edges or faces of an AnyMesh.
/// Result: a map of int: rg[x] is the position of the region's seed among the seeds, -1 for elements in no region. The
///         first of equal seeds counts. If several regions reach an element at equal cost, that of the earlier seed
///         takes it.
/// Cost:   O(E log E) time, O(V + E) memory.
/// Errors: invalid_mesh if a seed is not an element of m, or if a cost that is read is negative or not a number;
///         invalid_argument if there is no seed, or max_cost is negative or not a number.
/// Source: Adams, Bischof 1994 (growth::step); Erwig 2000, graph Voronoi diagrams (growth::accumulated); paper section
///         2.1, "Architecture".
template<class M, class S, class C>
  requires requirement::is_lvalue_or_view<M> && requirement::is_source<M, S> &&
      requirement::is_cost<C, detail::node_of<M, S>>
auto grow_regions(M&& m, const S& seeds, const C& cost,  // may_cross: not of a bare graph
                  const grow_regions_options<detail::node_of<M, S>, detail::crossed_of<M, S>>& options = {}) {
  return detail::grow_regions(detail::graph_of<M, S>{m}, seeds, cost, options);
}

template<class M, class S, class C>
  requires requirement::is_lvalue_or_view<M> && requirement::is_source<M, S> &&
      requirement::is_cost<C, detail::node_of<M, S>>
auto grow_regions(M&& m, std::initializer_list<S> seeds, const C& cost,  // may_cross: not of a bare graph
                  const grow_regions_options<detail::node_of<M, S>, detail::crossed_of<M, S>>& options = {}) {
  return detail::grow_regions(detail::graph_of<M, S>{m}, seeds, cost, options);
}

// What to write instead of calls that cannot compile.
template<class... T> void grow_regions(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void grow_regions(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void grow_regions(mistake::any_mesh, mistake::number<mistake::name_the_element>, ...) = delete;  // elements have types: vert_id{0}, poly_id{0} ..., not 0

}  // namespace concino
