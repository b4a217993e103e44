#include <concino/edit/connected_verts.hpp>

#include <concino/concepts/end_verts.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("are_joined: two verts are, if they are the ends of an edge", M, CONCINO_KINDS) {
  const auto m = grid<M>(2);
  std::set<std::array<std::size_t, 2>> ends_of_edges;
  for (const auto e : edges(m)) {
    const auto [a, b] = end_verts(m, e);
    ends_of_edges.insert({index_of(m, a), index_of(m, b)});
    ends_of_edges.insert({index_of(m, b), index_of(m, a)});
  }
  for (const auto a : verts(m))
    for (const auto b : verts(m)) CHECK(are_joined(m, a, b) == (ends_of_edges.count({index_of(m, a), index_of(m, b)}) > 0));
}

TEST_CASE_TEMPLATE("are_joined: three verts are, if they are those of a triangle", M, tetmesh, hexmesh, polyhedralmesh) {
  const auto m = grid<M>(1);
  std::set<std::vector<std::size_t>> triangles;
  for (const auto f : faces(m)) {
    std::vector<std::size_t> corners;
    for (const auto v : adj_f2v(m, f)) corners.push_back(index_of(m, v));
    std::sort(corners.begin(), corners.end());
    if (corners.size() == 3) triangles.insert(corners);
  }
  for (const auto a : verts(m))
    for (const auto b : verts(m))
      for (const auto c : verts(m)) {
        std::vector<std::size_t> corners{index_of(m, a), index_of(m, b), index_of(m, c)};
        std::sort(corners.begin(), corners.end());
        CHECK(are_joined(m, a, b, c) == (triangles.count(corners) > 0));
      }
}
