#include <concino/adapters/metis_partition.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/mesh/submesh.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

/// The number of connected pieces of all parts.
template<class M>
std::size_t count_pieces(const M& m, const partition_result<M>& r) {
  std::size_t n = 0;
  for (std::size_t k = 0; k < r.sizes.size(); ++k) {
    std::vector<char> seen(poly_index_bound(m));
    for (const auto first : polys(m)) {
      if (r.part[first] != static_cast<int>(k) || seen[index_of(m, first)]) continue;
      ++n;
      std::vector stack{first};
      seen[index_of(m, first)] = 1;
      while (!stack.empty()) {
        const auto p = stack.back();
        stack.pop_back();
        for (const auto q : adj_p2p(m, p)) {
          if (r.part[q] != static_cast<int>(k) || seen[index_of(m, q)]) continue;
          seen[index_of(m, q)] = 1;
          stack.push_back(q);
        }
      }
    }
  }
  return n;
}

template<class M>
void check_figures(const M& m, const partition_result<M>& r) {
  std::vector<std::size_t> sizes(r.sizes.size());
  std::size_t cut = 0;
  for (const auto p : polys(m)) {
    ++sizes[static_cast<std::size_t>(r.part[p])];
    for (const auto q : adj_p2p(m, p)) cut += r.part[p] != r.part[q];
  }
  CHECK(sizes == r.sizes);
  CHECK(cut == 2 * r.cut);
  if (num_polys(m) > 0)
    CHECK(r.balance == static_cast<double>(*std::max_element(sizes.begin(), sizes.end())) * static_cast<double>(sizes.size()) / static_cast<double>(num_polys(m)));
}

}  // namespace

TEST_CASE_TEMPLATE("partition: parts are connected and balanced on all kinds of mesh", M, CONCINO_ALL_KINDS) {
  for (const unsigned size : {1u, 2u, 5u, 8u}) {
    const M m = grid<M>(size);
    for (const std::size_t n : {std::size_t{1}, std::size_t{2}, std::size_t{3}, std::size_t{4}, std::size_t{7}, std::size_t{20}}) {
      const auto r = partition(m, n, metis);
      CAPTURE(n);
      CAPTURE(size);
      check_figures(m, r);
      CHECK(count_pieces(m, r) == std::min(n, num_polys(m)) - static_cast<std::size_t>(std::count(r.sizes.begin(), r.sizes.begin() + static_cast<std::ptrdiff_t>(std::min(n, num_polys(m))), 0u)));
      if (num_polys(m) > 30 * n) CHECK(r.balance < 1.35);
    }
  }
}

TEST_CASE("partition: finds the short cuts of a long strip") {
  const quadmesh m = grid<quadmesh>(16);
  const auto halves = partition(m, 2, metis);
  CHECK(halves.cut <= 20);  // 16 at least
  CHECK(halves.balance <= 1.05);
  CHECK(partition(m, 4, metis).cut <= 40);
}

TEST_CASE("partition: takes views, graphs of polys alone, and meshes with several components") {
  const hexmesh m = two_grids<hexmesh>(3);
  const auto r = partition(m, 4, metis);
  check_figures(m, r);
  CHECK(r.cut <= 40);
  const auto g = dual(m);
  const auto of_graph = partition(g, 4, metis);
  for (const poly_id p : polys(m)) CHECK(of_graph.part[p] == r.part[p]);
  const auto half = submesh(m, [&](poly_id p) { return index_of(m, p) % 2 == 0; });
  check_figures(half, partition(half, 3, metis));
  const auto weakest = only_dual_graph(m);
  CHECK(partition(weakest, 4, metis).cut == r.cut);
}

TEST_CASE("partition: takes more parts than polys, and empty meshes") {
  const trimesh m = grid<trimesh>(1), empty;
  const auto r = partition(m, 5, metis);
  CHECK(r.sizes == std::vector<std::size_t>{1, 1, 0, 0, 0});
  CHECK(r.cut == 1);
  CHECK(r.balance == 2.5);
  CHECK(partition(empty, 3, metis).sizes == std::vector<std::size_t>{0, 0, 0});
  CHECK(partition(empty, 3, metis).balance == 1);
  CHECK_THROWS_WITH_AS(partition(m, 0, metis), doctest::Contains("the number of parts must be 1 or more"), invalid_argument);
}

TEST_CASE("partition: joins the pieces of a part to neighbouring parts") {
  // a path of 9 nodes; parts 0 0 0 1 0 1 1 1 2: the single node of part 1 is joined to part 0, and so is what was cut off
  concino::detail::partition_graph g;
  for (int i = 0; i < 9; ++i) {
    if (i > 0) g.neighbours.push_back(i - 1);
    if (i < 8) g.neighbours.push_back(i + 1);
    g.offsets.push_back(static_cast<int>(g.neighbours.size()));
  }
  std::vector<int> part{0, 0, 0, 1, 0, 1, 1, 1, 2};
  CHECK(concino::detail::join_pieces(g, part, 3) == 1);
  CHECK((part == std::vector<int>{0, 0, 0, 0, 0, 1, 1, 1, 2}));
  CHECK(concino::detail::join_pieces(g, part, 3) == 0);
  g = {{0, 0, 0, 0}, {}};  // no edges: pieces without a neighbour keep their part
  part = {0, 1, 0};
  CHECK(concino::detail::join_pieces(g, part, 2) == 0);
  CHECK((part == std::vector<int>{0, 1, 0}));
}
