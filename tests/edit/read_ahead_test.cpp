// read_ahead: the same edges in the same order, and the same edits.
#include <concino/edit.hpp>
#include <concino/mesh.hpp>

#include <support/kinds.hpp>
#include <support/soups.hpp>
#include <support/whole_mesh.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <forward_list>
#include <random>
#include <type_traits>
#include <utility>
#include <vector>

namespace cn = concino;
using cn::testing::whole;

namespace {

/// A mesh of triangles whose traits write down what is requested.
struct recording_mesh : cn::trimesh {
  using cn::trimesh::trimesh;
  mutable std::vector<std::pair<cn::edge_id, unsigned>> requests;
};

}  // namespace

template<>
struct concino::mesh_traits<recording_mesh> : concino::mesh_traits<concino::trimesh> {
  static void prefetch_edit(const recording_mesh& m, edge_id e, unsigned round) { m.requests.emplace_back(e, round); }
};

namespace {

/// All edges in random order, some of them twice.
template<class M>
std::vector<cn::edge_t<M>> shuffled_edges(const M& m, unsigned seed) {
  std::vector<cn::edge_t<M>> all;
  for (const auto e : cn::edges(m)) all.push_back(e);
  all.insert(all.end(), all.begin(), all.begin() + static_cast<std::ptrdiff_t>(all.size() / 4));
  std::shuffle(all.begin(), all.end(), std::mt19937(seed));
  return all;
}

/// Edits copies of m at the edges of a list, with requests and without; the results must be the same to the bit.
template<class Edit>
void gives_the_same_mesh(const cn::trimesh& m, const std::vector<cn::edge_id>& list, const Edit& edit) {
  cn::trimesh plain = m, ahead = m;
  for (const cn::edge_id e : list)
    if (cn::contains(plain, e)) edit(plain, e);
  for (const cn::edge_id e : cn::read_ahead(ahead, list))
    if (cn::contains(ahead, e)) edit(ahead, e);
  CHECK(whole(ahead) == whole(plain));
}

constexpr auto flip = [](cn::trimesh& m, cn::edge_id e) { cn::edge_flip(m, e); };
constexpr auto split = [](cn::trimesh& m, cn::edge_id e) { cn::edge_split(m, e); };
constexpr auto collapse = [](cn::trimesh& m, cn::edge_id e) { cn::edge_collapse(m, e); };  // removes edges of the list

}  // namespace

TEST_CASE_TEMPLATE("read_ahead: the edges of a list in their order, on all kinds", M, CONCINO_KINDS) {
  const M m = cn::testing::grid<M>(3);
  const auto all = shuffled_edges(m, 1);
  for (const std::size_t n : {std::size_t{0}, std::size_t{1}, std::size_t{5}, std::size_t{12}, std::size_t{13}, all.size()}) {
    const std::vector<cn::edge_id> list(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(n));
    std::vector<cn::edge_id> seen;
    for (const auto e : cn::read_ahead(m, list)) seen.push_back(e);
    CHECK(seen == list);
  }
}

TEST_CASE("read_ahead: a list that can be read in one direction only, a temporary one, and the edges of the mesh") {
  const auto m = cn::testing::grid<cn::trimesh>(4);
  const auto all = shuffled_edges(m, 2);
  const std::forward_list<cn::edge_id> list(all.begin(), all.end());
  std::vector<cn::edge_id> of_list, of_temporary, of_mesh, expected;
  for (const auto e : cn::read_ahead(m, list)) of_list.push_back(e);
  for (const auto e : cn::read_ahead(m, std::vector<cn::edge_id>(all))) of_temporary.push_back(e);
  for (const auto e : cn::read_ahead(m, cn::edges(m))) of_mesh.push_back(e);
  for (const auto e : cn::edges(m)) expected.push_back(e);
  static_assert(cn::ElementRange<decltype(cn::read_ahead(m, list)), cn::edge_id>);
  CHECK(of_list == all);
  CHECK(of_temporary == all);
  CHECK(of_mesh == expected);
}

TEST_CASE("read_ahead: each edge is requested in three rounds, some edges apart, before it is reached") {
  recording_mesh m;
  for (const std::size_t n : {std::size_t{0}, std::size_t{2}, std::size_t{7}, std::size_t{40}}) {
    std::vector<cn::edge_id> list;
    for (std::size_t i = 0; i < n; ++i) list.emplace_back(i);
    m.requests.clear();
    std::size_t reached = 0;
    for (const cn::edge_id e : cn::read_ahead(m, list)) {
      for (unsigned round = 0; round < 3; ++round) {
        const auto made = std::find(m.requests.begin(), m.requests.end(), std::pair{e, round});
        CHECK(made != m.requests.end());
      }
      ++reached;
    }
    CHECK(reached == n);
    CHECK(m.requests.size() == 3 * n);
    const auto when = [&](std::size_t i, unsigned round) {
      return std::find(m.requests.begin(), m.requests.end(), std::pair{cn::edge_id{i}, round}) - m.requests.begin();
    };
    for (std::size_t i = 0; i < n; ++i) {
      CHECK(when(i, 0) < when(i, 1));
      CHECK(when(i, 1) < when(i, 2));
      if (i + 1 < n) CHECK(when(i + 1, 0) < when(i, 1));  // other edges are requested in between
    }
  }
}

TEST_CASE("read_ahead: edits of triangles give the same mesh to the bit") {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const auto m = cn::testing::grid<cn::trimesh>(9);
    auto list = shuffled_edges(m, seed);
    gives_the_same_mesh(m, list, flip);
    gives_the_same_mesh(m, list, split);
    gives_the_same_mesh(m, list, collapse);
    for (const unsigned i : {1u, 7u, 4'000'000'000u}) list.insert(list.begin() + i % 50, cn::edge_id{cn::edge_index_bound(m) + i});  // edges that do not exist, or not yet
    list.push_back(cn::edge_id{});
    gives_the_same_mesh(m, list, split);
    gives_the_same_mesh(m, list, collapse);
  }
}

TEST_CASE("read_ahead: edges with three triangles and neighbours behind two edges, before and after the first edit") {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    std::mt19937 random(seed);
    cn::trimesh m = cn::testing::random_soup<cn::trimesh>(random, 12, 30).mesh();
    gives_the_same_mesh(m, shuffled_edges(m, seed), flip);
    gives_the_same_mesh(m, shuffled_edges(m, seed), collapse);
    cn::remove_vert(m, cn::add_vert(m, {0, 0, 0}));
    gives_the_same_mesh(m, shuffled_edges(m, seed), split);
    gives_the_same_mesh(m, shuffled_edges(m, seed), collapse);
  }
}

TEST_CASE("read_ahead: a temporary mesh is refused") {
  using edges = std::vector<cn::edge_id>;
  const auto can_read = []<class M>(std::type_identity<M>) { return requires(M&& m, const edges& list) { cn::read_ahead(static_cast<M&&>(m), list); }; };
  CHECK(can_read(std::type_identity<const cn::trimesh&>()));
  CHECK(can_read(std::type_identity<cn::trimesh&>()));
  CHECK_FALSE(can_read(std::type_identity<cn::trimesh>()));
  CHECK_FALSE(can_read(std::type_identity<const cn::trimesh>()));
}
