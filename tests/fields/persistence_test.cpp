#include <concino/fields/persistence.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/mesh/element_map.hpp>

#include <support/corpus.hpp>
#include <support/kinds.hpp>
#include <support/random_meshes.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <random>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// {extremum, saddle or -1} of all pairs, by indices, from a reduction of the boundary matrix of the edges. Signs of values are changed for maxima.
template<class M, class U>
std::vector<std::array<long, 2>> pairs_by_reduction(const M& m, const U& u, bool of_maxima) {
  std::vector<std::size_t> order;
  for (const auto v : verts(m)) order.push_back(index_of(m, v));
  std::vector<double> value(vert_index_bound(m));
  for (const auto v : verts(m)) value[index_of(m, v)] = u[v];
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return value[a] < value[b] || (value[a] == value[b] && a < b); });
  if (of_maxima) std::reverse(order.begin(), order.end());
  std::vector<std::size_t> place(value.size());
  for (std::size_t k = 0; k < order.size(); ++k) place[order[k]] = k;

  std::vector<std::array<std::size_t, 2>> columns;  // later end, earlier end
  for (const auto v : verts(m))
    for (const auto w : adj_v2v(m, v))
      if (place[index_of(m, w)] < place[index_of(m, v)]) columns.push_back({place[index_of(m, v)], place[index_of(m, w)]});
  std::sort(columns.begin(), columns.end());
  std::vector<std::array<long, 2>> pairs;
  std::vector<std::vector<std::size_t>> reduced(order.size());  // by last entry
  std::vector<bool> ends(order.size());
  for (const auto& [later, earlier] : columns) {
    std::vector<std::size_t> column{earlier, later};
    while (!column.empty() && !reduced[column.back()].empty()) {
      std::vector<std::size_t> sum;
      const auto& other = reduced[column.back()];
      std::set_symmetric_difference(column.begin(), column.end(), other.begin(), other.end(), std::back_inserter(sum));
      column = sum;
    }
    if (column.empty()) continue;
    const std::size_t born = column.back();
    reduced[born] = column;
    ends[born] = true;
    if (born != later) pairs.push_back({static_cast<long>(order[born]), static_cast<long>(order[later])});
  }
  for (std::size_t k = 0; k < order.size(); ++k)
    if (!ends[k]) pairs.push_back({static_cast<long>(order[k]), -1});
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

template<class M, class U, class Pairs>
void check_pairs(const M& m, const U& u, bool of_maxima, const Pairs& found) {
  std::vector<std::array<long, 2>> ours;
  double last = infinite;
  for (const auto& p : found) {
    ours.push_back({static_cast<long>(index_of(m, p.extremum)), p.saddle ? static_cast<long>(index_of(m, *p.saddle)) : -1});
    CHECK(p.persistence == (p.saddle ? std::abs(u[*p.saddle] - u[p.extremum]) : infinite));
    CHECK(p.persistence <= last);
    last = p.persistence;
  }
  std::sort(ours.begin(), ours.end());
  CHECK(ours == pairs_by_reduction(m, u, of_maxima));
}

}  // namespace

TEST_CASE_TEMPLATE("persistence: pairs are those of a reduced boundary matrix, on random meshes", M, polygonmesh, tetmesh) {
  std::mt19937 random(1);
  for (unsigned round = 0; round < num_random_meshes() / 2; ++round) {
    CAPTURE(round);
    const M m = random_mesh<M>(random);
    const unsigned different = 1 + static_cast<unsigned>(random() % 12);
    auto u = make_vert_map<double>(m);
    for (const auto v : verts(m)) u[v] = static_cast<double>(random() % different);
    const auto pairs = persistence(m, u);
    check_pairs(m, u, false, pairs.minima);
    check_pairs(m, u, true, pairs.maxima);
  }
}

TEST_CASE("persistence: two valleys, of which the shallow one ends at the pass, and two hills") {
  const auto m = grid<quadmesh>(4);  // points (i, j) / 4 at vert 5 j + i
  auto u = make_vert_map<double>(m, 5.0);
  const double profile[] = {0, 4, 1, 6, 3};
  for (const auto v : verts(m)) u[v] = profile[v.raw() % 5] + 0.01 * (v.raw() / 5);
  const auto pairs = persistence(m, u);
  REQUIRE(pairs.minima.size() == 3);
  CHECK(pairs.minima[0].extremum == vert_id{0});
  CHECK(!pairs.minima[0].saddle);
  CHECK(pairs.minima[0].persistence == infinite);
  CHECK(pairs.minima[1].extremum == vert_id{2});
  CHECK(*pairs.minima[1].saddle == vert_id{1});
  CHECK(pairs.minima[1].persistence == 3);
  CHECK(pairs.minima[2].extremum == vert_id{4});
  CHECK(pairs.minima[2].persistence == 3);
  REQUIRE(pairs.maxima.size() == 2);
  CHECK(pairs.maxima[0].extremum == vert_id{23});
  CHECK(pairs.maxima[1].extremum == vert_id{21});
  CHECK(*pairs.maxima[1].saddle == vert_id{22});
  CHECK(pairs.maxima[1].persistence == doctest::Approx(3));
}

TEST_CASE("persistence: runs on the archetype of a graph and on empty meshes, and rejects values that are not finite") {
  const auto m = two_grids<trimesh>(2);
  const auto g = only_primal_graph(m);
  auto u = make_vert_map<double>(g, 2.0);
  const auto pairs = persistence(g, u);
  CHECK(pairs.minima.size() == 3);  // two grids and a vert alone, without ties within a grid
  CHECK(pairs.maxima.size() == 3);
  check_pairs(g, u, false, pairs.minima);
  const trimesh none;
  CHECK(persistence(none, make_vert_map<double>(none)).minima.empty());
  auto wrong = make_vert_map<double>(m);
  wrong[vert_id{3}] = -infinite;
  CHECK_THROWS_WITH_AS(persistence(m, wrong), doctest::Contains("persistence: the value at vert 3 is not finite"), invalid_argument);
}
