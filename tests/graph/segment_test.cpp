#include <concino/graph/segment.hpp>

#include <support/corpus.hpp>
#include <support/random_graph.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

/// Random costs of labels on a graph, all multiples of 1/4, so that sums are exact.
struct random_costs {
  list_graph graph;
  int labels;
  std::vector<double> unary, weight;  // by vert and label; by pair of verts

  random_costs(std::mt19937& random, unsigned n, int num_labels) : graph(random_graph(random, n, 15 + static_cast<unsigned>(random() % 30))), labels(num_labels) {
    const auto some = [&] { return static_cast<double>(random() % 40) / 4; };
    for (unsigned i = 0; i < n * static_cast<unsigned>(labels); ++i) unary.push_back(some());
    for (unsigned i = 0; i < n * n; ++i) weight.push_back(some() / 4);
  }
  double cost(vert_id v, int l) const { return unary[v.raw() * static_cast<unsigned>(labels) + static_cast<unsigned>(l)]; }
  double weight_of(vert_id a, vert_id b) const { return weight[std::min(a.raw(), b.raw()) * graph.nodes.size() + std::max(a.raw(), b.raw())]; }

  /// The change of energy if v takes label l.
  template<class W>
  double change(const std::vector<int>& label, vert_id v, int l, const W& pairwise) const {
    const int old = label[v.raw()];
    double sum = cost(v, l) - cost(v, old);
    for (const vert_id w : graph.neighbours[v.raw()]) sum += pairwise(v, w, l, label[w.raw()]) - pairwise(v, w, old, label[w.raw()]);
    return sum;
  }
  template<class L, class W>
  double energy(const L& label, const W& pairwise) const {
    double sum = 0;
    for (const vert_id v : graph.nodes) {
      sum += cost(v, label(v));
      for (const vert_id w : graph.neighbours[v.raw()])
        if (v < w) sum += pairwise(v, w, label(v), label(w));
    }
    return sum;
  }

  /// The smallest energy of all labellings, which are visited so that one label changes by 1 at a time.
  template<class W>
  double smallest(const W& pairwise) const {
    std::vector<int> label(graph.nodes.size()), step(graph.nodes.size(), 1);
    double e = energy([](vert_id) { return 0; }, pairwise), best = e;
    for (std::size_t i = 0; i < label.size();) {
      if (label[i] + step[i] < 0 || label[i] + step[i] == labels) {
        step[i] = -step[i];
        ++i;
        continue;
      }
      const vert_id v = graph.nodes[i];
      e += change(label, v, label[i] + step[i], pairwise);
      label[i] += step[i];
      best = std::min(best, e);
      i = 0;
    }
    return best;
  }
};

/// Checks that the energy is that of the labels, and falls in each round.
template<class R, class W>
void check_energy(const random_costs& c, const R& result, const W& pairwise) {
  REQUIRE(result.energy == c.energy([&](vert_id v) { return result.label[v]; }, pairwise));
  REQUIRE(result.rounds.back() == result.energy);
  for (std::size_t i = 1; i < result.rounds.size(); ++i) REQUIRE(result.rounds[i] < result.rounds[i - 1]);
}

}  // namespace

TEST_CASE("segment_verts: two labels are optimal on random graphs of 16 nodes") {
  std::mt19937 random(16);
  for (int round = 0; round < (long_run() ? 500 : 50); ++round) {
    const random_costs c(random, 16, 2);
    const auto cost = [&](vert_id v, int l) { return c.cost(v, l); };
    // Different labels cost more in one direction than in the other, and equal ones cost something too.
    const auto pairwise = [&](vert_id a, vert_id b, int l, int k) {
      const double w = c.weight_of(a, b);
      return l != k ? (l < k) == (a < b) ? 2 * w : w : l * w / 2 + 1;
    };
    const auto even = [&](vert_id a, vert_id b, int l, int k) { return std::max(pairwise(a, b, l, k), 1.5); };
    const auto found = segment_verts(c.graph, cost, even);
    check_energy(c, found, even);
    REQUIRE(found.energy == c.smallest(even));
    const auto potts = segment_verts(c.graph, cost, {.smoothness = 0.75});
    const auto smooth = [](vert_id, vert_id, int l, int k) { return l == k ? 0 : 0.75; };
    check_energy(c, potts, smooth);
    REQUIRE(potts.energy == c.smallest(smooth));
  }
}

TEST_CASE("segment_verts: three labels by expansion are within twice the optimum, and no single label improves them") {
  std::mt19937 random(8);
  int optimal = 0;
  for (int round = 0; round < 500; ++round) {
    const random_costs c(random, 8, 3);
    const auto cost = [&](vert_id v, int l) { return c.cost(v, l); };
    const auto smooth = [&](vert_id a, vert_id b, int l, int k) { return l == k ? 0 : c.weight_of(a, b); };
    const double best = c.smallest(smooth);
    for (const label_moves moves : {label_moves::expansion, label_moves::swap}) {
      const auto found = segment_verts(c.graph, cost, smooth, {.labels = 3, .moves = moves});
      check_energy(c, found, smooth);
      REQUIRE(found.energy >= best);
      if (moves == label_moves::swap) continue;
      REQUIRE(found.energy <= 2 * best);
      optimal += found.energy == best;
      std::vector<int> label;
      for (const vert_id v : c.graph.nodes) label.push_back(found.label[v]);
      for (const vert_id v : c.graph.nodes)
        for (int l = 0; l < 3; ++l) REQUIRE(c.change(label, v, l, smooth) >= 0);
    }
  }
  CHECK(optimal > 450);
}

TEST_CASE("segment_verts: swaps reduce squared differences, which expansions refuse") {
  std::mt19937 random(4);
  const auto squares = [](vert_id, vert_id, int l, int k) { return (l - k) * (l - k) / 4.0; };
  for (int round = 0; round < 100; ++round) {
    random_costs c(random, 7, 4);
    c.graph.add_edge(0, 6);
    const auto cost = [&](vert_id v, int l) { return c.cost(v, l); };
    const auto found = segment_verts(c.graph, cost, squares, {.labels = 4, .moves = label_moves::swap});
    check_energy(c, found, squares);
    REQUIRE(found.energy >= c.smallest(squares));
    CHECK_THROWS_WITH_AS(segment_verts(c.graph, cost, squares, {.labels = 4}), doctest::Contains("expansions need the triangle inequality; label_moves::swap does not"),
                         invalid_argument);
  }
}
