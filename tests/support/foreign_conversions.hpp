// Conversions between this library's surfaces and a foreign mesh type F, there and back, for the tests of adapters.
#pragma once

#include <concino/convert.hpp>
#include <concino/mesh.hpp>

#include <support/soups.hpp>

#include <doctest/doctest.h>

#include <set>
#include <vector>

namespace concino::testing {

template<class F, class M>
void there_and_back(const M& m) {
  const auto there = convert<F>(m);
  REQUIRE(num_verts(there.mesh) == num_verts(m));
  REQUIRE(num_edges(there.mesh) == num_edges(m));
  REQUIRE(num_polys(there.mesh) == num_polys(m));
  const auto back = convert<M>(there.mesh);
  for (const auto v : verts(m)) CHECK(to_vec3(point(back.mesh, back.vert_of(there.vert_of(v)))) == to_vec3(point(m, v)));
  for (const auto p : polys(m)) {
    std::vector<vert_id> expected, found;
    for (const auto v : adj_p2v(m, p)) expected.push_back(back.vert_of(there.vert_of(v)));
    for (const auto v : adj_p2v(back.mesh, back.poly_of(there.poly_of(p)))) found.push_back(v);
    const auto first = std::find(found.begin(), found.end(), expected[0]);  // the cycle may begin elsewhere
    REQUIRE(first != found.end());
    std::rotate(found.begin(), first, found.end());
    CHECK(found == expected);
  }
  for (const auto e : edges(m)) {
    std::set<std::size_t> expected, found;
    for (const auto v : adj_e2v(m, e)) expected.insert(index_of(there.mesh, there.vert_of(v)));
    for (const auto v : adj_e2v(there.mesh, there.edge_of(e))) found.insert(index_of(there.mesh, v));
    CHECK(found == expected);
  }
}

/// Grids with a hole, an isolated vert and a second piece, and what a half-edge mesh must refuse.
template<class Triangles, class Polygons>
void conversions_of_half_edge_meshes() {
  trimesh t = testing::grid<trimesh>(4);
  remove_poly(t, poly_id{9});
  remove_vert(t, vert_id{0});
  add_vert(t, {7, 7, 7});
  there_and_back<Triangles>(t);
  there_and_back<Polygons>(t);
  there_and_back<Polygons>(testing::grid<quadmesh>(4));
  there_and_back<Polygons>(testing::grid<polygonmesh>(4));
  const trimesh crowded({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}}, {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}});
  CHECK_THROWS_WITH_AS(convert<Polygons>(crowded), doctest::Contains("poly 1"), unsupported);
  const trimesh turned({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 1, 3}});
  CHECK_THROWS_WITH_AS(convert<Polygons>(turned), doctest::Contains("poly 1"), unsupported);

  // values of a map come along by carry()
  const auto m = testing::grid<trimesh>(3);
  const auto c = convert<Polygons>(m);
  auto values = make_vert_map<double>(m);
  for (const auto v : verts(m)) values[v] = 0.25 * v.raw();
  auto taken = make_vert_map<double>(c.mesh, -1);
  c.carry(values, taken);
  for (const auto v : verts(m)) CHECK(taken[c.vert_of(v)] == values[v]);
}

}  // namespace concino::testing
