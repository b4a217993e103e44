// segment_polys and segment_verts: a label for each element, so that costs of labels and of different neighbours are
// small together.
// Not part of <concino/graph.hpp>: without concino::compiled it includes the maximum flow of Boost.Graph, which takes
// as long to compile as all of that.
#pragma once

#include <concino/core/message.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/core/profiler.hpp>
#include <concino/graph/detail/cuts/labels.hpp>
#include <concino/graph/detail/for_each.hpp>
#include <concino/graph/detail/graph_of.hpp>

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino {

/// Node is a vert (primal graph) or a poly (dual graph).
template<class M, class Node>
struct segmentation {
  element_map<M, Node, int> label;  // 0, 1 ... labels - 1
  double energy = 0;                // the sum of all costs
  std::vector<double> rounds;       // the energy at the start, where each element has its cheapest label, and after
                                    // each round that reduced it
  int scale_exponent = 0;           // energies are sums of costs rounded to multiples of 2^-scale_exponent
};

namespace detail {

/// The pairwise costs of smoothness alone.
struct no_pairwise_costs {};

template<class G, class C, class W>
auto find_segments(const G& g, const char* caller, const C& cost, const W& pairwise,
                   const segment_options& input_options) {
  const core::profiled_options profiled(input_options, caller);
  const segment_options& options = *profiled;
  using node = typename G::node;
  label_problem problem{caller, G::element_name, {}, {}, {}, {}};
  std::vector<node> nodes;
  std::vector<std::uint32_t> number(g.bound());
  for (const node x : g.nodes()) {
    number[g.index(x)] = static_cast<std::uint32_t>(nodes.size());
    nodes.push_back(x);
    problem.index.push_back(g.index(x));
    for (int l = 0; l < options.labels; ++l) problem.costs.push_back(static_cast<double>(cost(x, l)));
  }
  for (const node x : g.nodes())
    detail::for_each(g.neighbours(x), [&](const node& y) {
      if (g.index(x) < g.index(y)) problem.edges.push_back({number[g.index(x)], number[g.index(y)]});
    });
  const auto pairwise_cost = [&]([[maybe_unused]] std::size_t edge, [[maybe_unused]] int a, [[maybe_unused]] int b) {
    if constexpr (std::is_same_v<W, no_pairwise_costs>) return 0.0;
    else return static_cast<double>(pairwise(nodes[problem.edges[edge][0]], nodes[problem.edges[edge][1]], a, b));
  };
  if constexpr (!std::is_same_v<W, no_pairwise_costs>) problem.pairwise = pairwise_cost;
  element_labels found = find_labels(problem, options);
  segmentation<typename G::mesh, node> result{make_node_map<int>(g, 0), found.rounds.back(), std::move(found.rounds),
                                              found.scale_exponent};
  for (std::size_t i = 0; i < nodes.size(); ++i) result.label[nodes[i]] = found.label[i];
  return result;
}

template<class M> using dual_graph_of = dual_graph<std::remove_cvref_t<M>>;
template<class M> using primal_graph_of = primal_graph<std::remove_cvref_t<M>>;

}  // namespace detail

namespace requirement {

/// A function that returns the cost of a label for a node.
template<class C, class N> concept is_label_cost = requires(const C& cost, const N& x) {
  static_cast<double>(cost(x, 0));
};

/// A function that returns the cost of two labels at two adjacent nodes.
template<class W, class N> concept is_pairwise_cost = requires(const W& pairwise, const N& x) {
  static_cast<double>(pairwise(x, x, 0, 0));
};

}  // namespace requirement

/// A label for each poly, with small costs: the energy is the sum of cost(p, label of p) over all polys, and of
/// pairwise(p, q, label of p, label of q) over all pairs of adjacent polys, once for each. Without `pairwise`, a pair
/// with different labels costs options.smoothness.
/// Needs:  DualGraph M; cost(p, label) finite, or +inf for a label that p must not have;
///         pairwise(p, q, a, b) finite, 0 or more, and equal to pairwise(q, p, b, a).
///         For two labels: pairwise costs of equal labels are no larger than those of different ones, in sum:
///         pairwise(p, q, 0, 0) + pairwise(p, q, 1, 1) <= pairwise(p, q, 0, 1) + pairwise(p, q, 1, 0).
///         For three or more: the same for any two, and if label_moves::expansion is used, the triangle inequality
///         pairwise(p, q, a, a) + pairwise(p, q, b, c) <= pairwise(p, q, a, c) + pairwise(p, q, b, a) for all a, b, c.
/// Result: a segmentation. Two labels: the smallest energy, by one cut; of several optima the one in which the fewest
///         elements have label 0. Three labels or more: a local optimum, which no move reduces. By
///         expansion its energy is at most 2 c times the smallest, where c is the ratio of the largest to the smallest
///         cost of different neighbours (1 for smoothness), if costs are 0 or more. The energy decreases in each round.
///         Costs are exact if they are integers or other multiples of 2^-scale_exponent, else rounded to those, about
///         2^-60 of the sum of the largest costs.
/// Cost:   one minimum cut for each label (expansion) or each pair of labels (swap) in a round, as of min_cut; a few
///         rounds, as a rule. E L^3 operations to check pairwise costs. O(V L + E) memory.
/// Errors: invalid_argument that names an option out of its range, an element whose cost is not a number or whose
///         labels are all forbidden, or a pair of elements with a cost that is not allowed; cancelled.
/// Source: Boykov, Veksler, Zabih 2001, "Fast approximate energy minimization via graph cuts"; Kolmogorov, Zabih 2004.
template<class M, class C>
  requires requirement::is_lvalue_or_view<M> && DualGraph<M> && requirement::is_label_cost<C, poly_t<M>>
auto segment_polys(M&& m, const C& cost, const segment_options& options = {}) {
  return detail::find_segments(detail::dual_graph_of<M>{m}, "segment_polys", cost, detail::no_pairwise_costs(),
                               options);
}
template<class M, class C, class W>
  requires requirement::is_lvalue_or_view<M> && DualGraph<M> && requirement::is_label_cost<C, poly_t<M>> &&
      requirement::is_pairwise_cost<W, poly_t<M>>
auto segment_polys(M&& m, const C& cost, const W& pairwise, const segment_options& options = {}) {
  return detail::find_segments(detail::dual_graph_of<M>{m}, "segment_polys", cost, pairwise, options);
}

/// A label for each vert, with small costs, as segment_polys: adjacent verts are joined by edges.
/// Needs:  PrimalGraph M; costs as of segment_polys.
/// Result: a segmentation, as of segment_polys.
/// Cost:   as of segment_polys.
/// Errors: those of segment_polys, which name verts.
template<class M, class C>
  requires requirement::is_lvalue_or_view<M> && PrimalGraph<M> && requirement::is_label_cost<C, vert_t<M>>
auto segment_verts(M&& m, const C& cost, const segment_options& options = {}) {
  return detail::find_segments(detail::primal_graph_of<M>{m}, "segment_verts", cost, detail::no_pairwise_costs(),
                               options);
}
template<class M, class C, class W>
  requires requirement::is_lvalue_or_view<M> && PrimalGraph<M> && requirement::is_label_cost<C, vert_t<M>> &&
      requirement::is_pairwise_cost<W, vert_t<M>>
auto segment_verts(M&& m, const C& cost, const W& pairwise, const segment_options& options = {}) {
  return detail::find_segments(detail::primal_graph_of<M>{m}, "segment_verts", cost, pairwise, options);
}

// What to write instead of calls that cannot compile.
template<class... T> void segment_polys(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void segment_polys(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void segment_verts(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void segment_verts(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;

}  // namespace concino
