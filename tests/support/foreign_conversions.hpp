// Conversions between this library's surfaces and a foreign mesh type F, there and back, for the tests of adapters.
#pragma once

#include <concino/convert.hpp>
#include <concino/mesh.hpp>

#include <support/corpus_meshes.hpp>
#include <support/soups.hpp>

#include <doctest/doctest.h>

#include <set>
#include <vector>

namespace concino::testing {

template<class F, class M>
void there_and_back(const M& m) {
  const auto there = convert_with_correspondence<F>(m);
  REQUIRE(num_verts(there.mesh) == num_verts(m));
  REQUIRE(num_edges(there.mesh) == num_edges(m));
  REQUIRE(num_polys(there.mesh) == num_polys(m));
  const auto back = convert_with_correspondence<M>(there.mesh);
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

/// Converts grids with a hole, an isolated vert and a second component, and meshes that a half-edge mesh must refuse.
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

  // transfer() copies the values of maps
  const auto m = testing::grid<trimesh>(3);
  const auto c = convert_with_correspondence<Polygons>(m);
  auto values = make_vert_map<double>(m);
  for (const auto v : verts(m)) values[v] = 0.25 * v.raw();
  auto taken = make_vert_map<double>(c.mesh, -1);
  c.transfer(values, taken);
  for (const auto v : verts(m)) CHECK(taken[c.vert_of(v)] == values[v]);
}

/// Converts every surface of the corpus that an F can hold; others must be refused.
template<class F>
void corpus_there_and_back() {
  const auto rows = corpus_meshes();
  if (rows.empty()) return skip("no corpus");
  std::size_t held = 0, refused = 0;
  for (const auto& row : rows) {
    INFO(row.name);
    if (row.file.extension() == ".hedra") continue;
    const auto any = load_any(row.file.string());
    std::visit(
        [&](const auto& m) {
          using M = std::remove_cvref_t<decltype(m)>;
          if constexpr (SurfaceMesh<M>) {
            if (arity_v<F> != 0 && arity_v<F> != arity_v<M>) return;
            try {
              const auto there = convert_with_correspondence<F>(m);
              const auto back = convert_with_correspondence<M>(there.mesh);
              std::size_t wrong = num_verts(back.mesh) != num_verts(m) || num_edges(back.mesh) != num_edges(m) || num_polys(back.mesh) != num_polys(m);
              for (const auto v : verts(m)) wrong += !(point(back.mesh, back.vert_of(there.vert_of(v))) == point(m, v));
              for (const auto p : polys(m)) {
                std::size_t sum = 0, mirrored = 0;
                for (const auto v : adj_p2v(m, p)) sum += back.vert_of(there.vert_of(v)).raw() * std::size_t{2654435761};
                for (const auto v : adj_p2v(back.mesh, back.poly_of(there.poly_of(p)))) mirrored += v.raw() * std::size_t{2654435761};
                wrong += sum != mirrored;
              }
              CHECK(wrong == 0);
              ++held;
            } catch (const unsupported& e) {
              CHECK(std::string(e.what()).find("poly ") != std::string::npos);
              ++refused;
            }
          }
        },
        any);
  }
  CHECK(held > 10);
  CHECK(refused > 0);  // the corpus has edges of three polys
}

}  // namespace concino::testing
