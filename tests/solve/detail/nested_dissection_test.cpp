#include <concino/solve/detail/nested_dissection.hpp>

#include <concino/solve/detail/ordered.hpp>
#include <concino/solve/detail/sparse_factor.hpp>
#include <concino/solve/ldlt.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

#include <support/systems.hpp>

using namespace concino;
using namespace systems;

namespace {

using step = std::array<int, 3>;

/// A grid of n[0] x n[1] x n[2] rows, each coupled with those at these steps, and definite. Each row stands for `unknowns` rows.
sparse stencil(const step& n, const std::vector<step>& steps, int unknowns = 1) {
  std::vector<Eigen::Triplet<double>> entries;
  const auto number = [&](int x, int y, int z) { return x + n[0] * (y + n[1] * z); };
  const auto couple = [&](int i, int j) {
    for (int k = 0; k < unknowns; ++k)
      for (int l = 0; l < unknowns; ++l)
        if (i != j || l <= k) entries.emplace_back(unknowns * std::max(i, j) + k, unknowns * std::min(i, j) + l, i == j && k == l ? 30.0 * unknowns : -1.0);
  };
  for (int z = 0; z < n[2]; ++z)
    for (int y = 0; y < n[1]; ++y)
      for (int x = 0; x < n[0]; ++x) {
        couple(number(x, y, z), number(x, y, z));
        for (const auto& [dx, dy, dz] : steps)
          if (const int u = x + dx, v = y + dy, w = z + dz; u >= 0 && v >= 0 && w >= 0 && u < n[0] && v < n[1] && w < n[2])
            couple(number(x, y, z), number(u, v, w));
      }
  const int rows = n[0] * n[1] * n[2] * unknowns;
  return from(rows, rows, entries);
}

sparse triangles(int n, int unknowns = 1) { return stencil({n, n, 1}, {{1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, unknowns); }
sparse tets(int n) { return stencil({n, n, n}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}}); }
sparse hexes(int n) {
  std::vector<step> steps{{1, 0, 0}, {-1, 1, 0}, {0, 1, 0}, {1, 1, 0}};
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x) steps.push_back({x, y, 1});
  return stencil({n, n, n}, steps);
}

/// A graph by its edges, as a lower triangle.
sparse graph(int n, const std::vector<std::array<int, 2>>& edges) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < n; ++i) entries.emplace_back(i, i, 2.0 * n);
  for (const auto& [i, j] : edges) entries.emplace_back(std::max(i, j), std::min(i, j), 1.0);
  return from(n, n, entries);
}

std::vector<int> dissected(const sparse& a) {
  detail::elimination_order by_degree;
  by_degree.find(a);
  return detail::nested_dissection_order(detail::elimination_order::symmetric_pattern(a), by_degree.row);
}

bool is_permutation(std::vector<int> order, Eigen::Index n) {
  std::sort(order.begin(), order.end());
  std::vector<int> all(static_cast<std::size_t>(n));
  std::iota(all.begin(), all.end(), 0);
  return order == all;
}

struct factor_cost {
  std::int64_t entries, multiplications;
};

factor_cost cost_of(const detail::elimination_order& order, const sparse& a) {
  detail::sparse_factor factor;
  REQUIRE(factor.analyse(order(a), std::numeric_limits<std::int64_t>::max()));
  return {factor.lower().nonZeros(), factor.num_multiplications()};
}

factor_cost cost_by_dissection(const sparse& a) {
  detail::elimination_order order;
  order.keep(dissected(a));
  REQUIRE(is_permutation(order.row, a.cols()));
  return cost_of(order, a);
}

factor_cost cost_by_degree(const sparse& a) {
  detail::elimination_order order;
  order.find(a);
  return cost_of(order, a);
}

/// The number of rows in the largest component after the last `removed` rows of the order are removed.
int largest_component(const sparse& a, const std::vector<int>& order, int removed) {
  const auto n = static_cast<std::size_t>(a.cols());
  std::vector<int> root(n), size(n, 1);
  std::iota(root.begin(), root.end(), 0);
  std::vector<char> is_removed(n);
  for (std::size_t i = n - static_cast<std::size_t>(removed); i < n; ++i) is_removed[static_cast<std::size_t>(order[i])] = 1;
  const auto find = [&](int i) {
    while (root[static_cast<std::size_t>(i)] != i) i = root[static_cast<std::size_t>(i)] = root[static_cast<std::size_t>(root[static_cast<std::size_t>(i)])];
    return static_cast<std::size_t>(i);
  };
  for (int c = 0; c < a.outerSize(); ++c)
    for (sparse::InnerIterator e(a, c); e; ++e) {
      const std::size_t i = find(static_cast<int>(e.row())), j = find(c);
      if (is_removed[static_cast<std::size_t>(e.row())] || is_removed[static_cast<std::size_t>(c)] || i == j) continue;
      root[i] = static_cast<int>(j);
      size[j] += size[i];
    }
  int largest = 0;
  for (std::size_t i = 0; i < n; ++i)
    if (!is_removed[i]) largest = std::max(largest, size[find(static_cast<int>(i))]);
  return largest;
}

sparse shuffled(const sparse& a, unsigned seed) {
  std::vector<int> to(static_cast<std::size_t>(a.cols()));
  std::iota(to.begin(), to.end(), 0);
  std::mt19937 random(seed);
  for (std::size_t i = to.size(); i > 1; --i) std::swap(to[i - 1], to[random() % i]);
  std::vector<Eigen::Triplet<double>> entries;
  for (int c = 0; c < a.outerSize(); ++c)
    for (sparse::InnerIterator e(a, c); e; ++e) {
      const int i = to[static_cast<std::size_t>(e.row())], j = to[static_cast<std::size_t>(c)];
      entries.emplace_back(std::max(i, j), std::min(i, j), e.value());
    }
  return from(static_cast<int>(a.rows()), static_cast<int>(a.cols()), entries);
}

}  // namespace

TEST_CASE("nested_dissection_order: needs fewer multiplications than minimum degree in volumes, and few more on small surfaces") {
  const sparse in_random_order = shuffled(tets(18), 1);
  for (const auto& [a, share] :
       {std::pair{triangles(120), 1.1}, {triangles(60, 3), 1.25}, {tets(18), 0.75}, {hexes(16), 0.75}, {in_random_order, 0.75}}) {
    const factor_cost by_dissection = cost_by_dissection(a), by_degree = cost_by_degree(a);
    CHECK(static_cast<double>(by_dissection.multiplications) < share * static_cast<double>(by_degree.multiplications));
    CHECK(static_cast<double>(by_dissection.entries) < 1.15 * static_cast<double>(by_degree.entries));
  }
}

TEST_CASE("nested_dissection_order: separators come last, and separate") {
  const sparse line = stencil({2000, 4, 1}, {{1, 0, 0}, {0, 1, 0}});  // each cut takes 4 rows
  CHECK(largest_component(line, dissected(line), 4) <= 0.7 * 8000);
  const sparse square = triangles(50), cube = hexes(15);
  CHECK(largest_component(square, dissected(square), 75) <= 0.7 * 2500);
  CHECK(largest_component(cube, dissected(cube), 400) <= 0.7 * 3375);
}

TEST_CASE("nested_dissection_order: a neck between two squares is the separator") {
  std::vector<Eigen::Triplet<double>> entries;
  const sparse square = triangles(20);
  for (int c = 0; c < square.outerSize(); ++c)
    for (sparse::InnerIterator e(square, c); e; ++e)
      for (const int shift : {0, 401}) entries.emplace_back(static_cast<int>(e.row()) + shift, c + shift, e.value());
  entries.emplace_back(400, 400, 30.0);
  entries.emplace_back(400, 399, -1.0);
  entries.emplace_back(401, 400, -1.0);
  const sparse a = from(801, 801, entries);
  const std::vector<int> order = dissected(a);
  REQUIRE(is_permutation(order, 801));
  CHECK(largest_component(a, order, 1) <= 401);
}

TEST_CASE("nested_dissection_order: depends only on the pattern") {
  const sparse a = tets(12), b = sparse(a * 3.0);
  CHECK(dissected(a) == dissected(a));
  CHECK(dissected(a) == dissected(b));
  CHECK(dissected(a) == dissected(a.transpose()));
  CHECK(dissected(a) == dissected(sparse(a.selfadjointView<Eigen::Lower>())));
}

TEST_CASE("nested_dissection_order: is empty where nothing can be cut") {
  CHECK(dissected(sparse(0, 0)).empty());
  CHECK(dissected(graph(1, {})).empty());
  CHECK(dissected(from(1, 1, {})).empty());
  CHECK(dissected(triangles(14)).empty());  // small
  std::vector<std::array<int, 2>> all;
  for (int i = 0; i < 300; ++i)
    for (int j = 0; j < i; ++j) all.push_back({i, j});
  CHECK(is_permutation(dissected(graph(300, all)), 300));  // all rows are dense
  std::mt19937 random(5);
  std::vector<std::array<int, 2>> any;
  for (int k = 0; k < 20'000; ++k) any.push_back({static_cast<int>(random() % 2000), static_cast<int>(random() % 2000)});
  CHECK(dissected(graph(2000, any)).empty());  // an expander
}

TEST_CASE("nested_dissection_order: is a permutation of rows without edges, of many components, and of dense rows") {
  CHECK(is_permutation(dissected(from(5000, 5000, {})), 5000));  // not even a diagonal
  CHECK(is_permutation(dissected(graph(100'000, {})), 100'000));
  std::vector<std::array<int, 2>> path, star, pairs, cliques, arrow;
  for (int i = 1; i < 50'000; ++i) {
    path.push_back({i, i - 1});
    star.push_back({i, 0});
    if (i % 2) pairs.push_back({i, i - 1});
    if (i < 5000)
      for (int j = i / 50 * 50; j < i; ++j) cliques.push_back({i, j});
    arrow.push_back({i, i - 1});
    if (i < 49'990)
      for (int j = 49'990; j < 50'000; ++j) arrow.push_back({i, j});
  }
  for (const auto* edges : {&path, &star, &pairs, &arrow}) {
    const sparse a = graph(50'000, *edges);
    CHECK(cost_by_dissection(a).entries <= 3 * cost_by_degree(a).entries);
  }
  CHECK(is_permutation(dissected(graph(5000, cliques)), 5000));
  const std::vector<int> order = dissected(graph(50'000, star));
  CHECK(order.back() == 0);
  std::vector<std::array<int, 2>> large_and_small = path;  // one component with most rows, and rows without edges on both sides of it
  large_and_small.erase(large_and_small.begin(), large_and_small.begin() + 9000);
  large_and_small.erase(large_and_small.end() - 2000, large_and_small.end());
  CHECK(is_permutation(dissected(graph(50'000, large_and_small)), 50'000));
}

TEST_CASE("nested_dissection_order: is a permutation on random patterns, symmetric or not") {
  std::mt19937 random(9);
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  for (int round = 0; round < 60; ++round) {
    const int n = 1 + below(2500), range = 1 + below(60);
    std::vector<Eigen::Triplet<double>> entries;
    for (int k = below(8 * n); k > 0; --k) {
      const int i = below(n);
      entries.emplace_back(i, std::clamp(i + below(2 * range + 1) - range, 0, n - 1), 1.0);
    }
    const std::vector<int> order = dissected(from(n, n, entries));
    CHECK((order.empty() || is_permutation(order, n)));
  }
}

TEST_CASE("ldlt: solves large systems in the order by nested dissection, which it keeps for matrices of the same pattern") {
  const sparse a = hexes(16), full = a.selfadjointView<Eigen::Lower>();
  REQUIRE(cost_by_dissection(a).multiplications < cost_by_degree(a).multiplications);
  const Eigen::VectorXd x = random_vector(a.cols());
  ldlt solver, other;
  CHECK(!solver.factorize_within(a, cost_by_degree(a).entries - 1));  // the limit is compared with the order by minimum degree
  CHECK(solver.factorize_within(a, cost_by_degree(a).entries));
  CHECK(distance(solver.solve(full * x), x) < 1e-11);
  const Eigen::VectorXd first = solver.solve(x);
  CHECK(solver.factorize_within(a, cost_by_dissection(a).entries));  // the order is known
  CHECK(solver.solve(x) == first);
  other.use_order_of(solver);
  CHECK(other.factorize_within(sparse(2 * a), cost_by_dissection(a).entries));
  CHECK(distance(other.solve(2 * x), first) < 1e-11);
  ldlt again;
  again.factorize(full);
  CHECK(again.solve(x) == first);
}
