// Regions on random meshes with barriers agree with Boost's distances and with a naive implementation.
#include <concino/graph/grow_regions.hpp>

#include <concino/graph/components.hpp>

#include <support/barred_graph.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr auto freely = [](const auto&, const auto&) { return true; };

/// Three nodes, which may be equal.
template<class G>
auto some_seeds(const G& g) {
  const auto nodes = g.nodes();
  std::vector<typename G::node> seeds;
  for (unsigned i = 0; i < 3 && !nodes.empty(); ++i) seeds.push_back(nodes[(g.salt >> (8 * i)) % nodes.size()]);
  return seeds;
}

/// A cost that is different for all steps, so that there is always one cheapest step.
template<class G>
auto distinct_cost(const G& g) {
  return [&g](auto a, auto b) { return double((index_of(g.m, a) * 64 + index_of(g.m, b)) * 2654435761u % 65536) + 1; };
}

/// A naive implementation: takes the cheapest of all steps from a region to a free node, again and again.
template<class G, class C>
std::vector<int> grown_by_step(const G& g, const std::vector<typename G::node>& seeds, const C& cost) {
  std::vector<int> label(g.bound(), -1);
  for (std::size_t s = 0; s < seeds.size(); ++s)
    if (int& l = label[index_of(g.m, seeds[s])]; l < 0) l = static_cast<int>(s);
  const auto arcs = g.arcs(cost);
  for (;;) {
    const arc* best = nullptr;
    for (const arc& a : arcs)
      if (label[a.from] >= 0 && label[a.to] < 0 && (!best || a.length < best->length)) best = &a;
    if (!best) return label;
    label[best->to] = label[best->from];
  }
}

}  // namespace

TEST_CASE_TEMPLATE("grow_regions: assigns the nearest seed by Boost's distances, on random meshes", M, CONCINO_KINDS) {
  for_random_graphs<M>(num_random_meshes(), [](const auto& g) {
    const auto seeds = some_seeds(g);
    if (seeds.empty()) return;
    for (const double least_step : {1.0, 0.0}) {
      const auto cost = [&g, least_step](auto a, auto b) { return g.length()(a, b) + least_step; };
      const auto boost = make_boost_graph(g.bound(), g.arcs(cost));
      std::vector<std::vector<double>> distance;
      for (const auto s : seeds) distance.push_back(boost_distances(boost, index_of(g.m, s)));
      const auto rg = grow_regions(g.m, seeds, cost, {.may_enter = g.enter(), .may_cross = g.cross()});
      const auto near = grow_regions(g.m, seeds, cost, {.may_enter = g.enter(), .may_cross = g.cross(), .max_cost = 3});
      for (const auto x : g.nodes()) {
        const auto at_x = [&](std::size_t s) { return distance[s][index_of(g.m, x)]; };
        const std::size_t nearest = at_x(0) <= std::min(at_x(1), at_x(2)) ? 0 : at_x(1) <= at_x(2) ? 1 : 2;
        REQUIRE((rg[x] == -1) == (at_x(nearest) == inf));
        REQUIRE(near[x] == (at_x(nearest) <= 3 ? rg[x] : -1));
        if (rg[x] == -1) continue;
        if (least_step > 0) REQUIRE(rg[x] == static_cast<int>(nearest));
        else REQUIRE(at_x(static_cast<std::size_t>(rg[x])) == at_x(nearest));  // a region cannot grow through the seed of another one
      }
    }
  });
}

TEST_CASE_TEMPLATE("grow_regions: always takes the cheapest step, on random meshes with barriers", M, CONCINO_KINDS) {
  for_random_graphs<M>(num_random_meshes(), [](const auto& g) {
    const auto seeds = some_seeds(g);
    if (seeds.empty()) return;
    const auto cost = distinct_cost(g);
    const auto rg = grow_regions(g.m, seeds, cost, {.priority = growth::step, .may_enter = g.enter(), .may_cross = g.cross()});
    const auto expected = grown_by_step(g, seeds, cost);
    for (const auto x : g.nodes()) REQUIRE(rg[x] == expected[index_of(g.m, x)]);
  });
}

TEST_CASE_TEMPLATE("grow_regions: obeys a predicate; one seed per component gives the components", M, CONCINO_KINDS) {
  for_random_graphs<M>(200, [](const auto& g) {
    using side = typename std::remove_cvref_t<decltype(g)>::side;
    const auto cc = connected_components(side::view(g.m), {.may_cross = g.cross()});
    std::vector<typename std::remove_cvref_t<decltype(g)>::node> seeds;
    for (const auto x : g.nodes())
      if (cc[x] == static_cast<int>(seeds.size())) seeds.push_back(x);
    if (seeds.empty()) return;  // an empty mesh has no seeds
    const auto rg = grow_regions(g.m, seeds, freely, {.may_cross = g.cross()});
    for (const auto x : g.nodes()) REQUIRE(rg[x] == cc[x]);

    const auto uphill = [&g](auto a, auto b) { return index_of(g.m, a) < index_of(g.m, b); };
    const auto as_cost = [&g](auto a, auto b) { return index_of(g.m, a) < index_of(g.m, b) ? 1.0 : inf; };
    const auto by_test = grow_regions(g.m, some_seeds(g), uphill);
    const auto by_cost = grow_regions(g.m, some_seeds(g), as_cost);
    for (const auto x : g.nodes()) REQUIRE(by_test[x] == by_cost[x]);
  });
}
