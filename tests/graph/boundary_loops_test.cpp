#include <concino/graph/boundary_loops.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/io/load.hpp>
#include <concino/mesh/boundary.hpp>

#include <support/closed_surfaces.hpp>
#include <support/corpus_meshes.hpp>
#include <support/random_meshes.hpp>
#include <support/user_mesh.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

using namespace concino;
using namespace concino::testing;

namespace {

template<class M>
std::vector<edge_t<M>> edges_with_one_poly(const M& m) {
  std::vector<edge_t<M>> r;
  for (const auto e : edges(m)) {
    int n = 0;
    for ([[maybe_unused]] const auto p : adj_e2p(m, e)) ++n;
    if (n == 1) r.push_back(e);
  }
  return r;
}

template<class M>
bool joins(const M& m, const edge_t<M>& e, const vert_t<M>& a, const vert_t<M>& b) {
  int n = 0;
  bool yes = !(a == b);
  for (const auto v : adj_e2v(m, e)) {
    ++n;
    yes = yes && (v == a || v == b);
  }
  return yes && n == 2;
}

/// The number of borders, by naive propagation of labels.
template<class M>
std::size_t count_borders(const M& m) {
  std::map<std::size_t, std::size_t> label;
  const auto border = edges_with_one_poly(m);
  for (const auto& e : border)
    for (const auto v : adj_e2v(m, e)) label[index_of(m, v)] = index_of(m, v);
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& e : border) {
      std::size_t least = ~std::size_t{0};
      for (const auto v : adj_e2v(m, e)) least = std::min(least, label[index_of(m, v)]);
      for (const auto v : adj_e2v(m, e))
        if (label[index_of(m, v)] != least) {
          label[index_of(m, v)] = least;
          changed = true;
        }
    }
  }
  std::set<std::size_t> different;
  for (const auto& [v, l] : label) different.insert(l);
  return different.size();
}

/// The area inside a planar loop; negative if it is clockwise.
template<class M>
double area_inside(const M& m, const edge_walk<M>& loop) {
  double twice = 0;
  for (std::size_t i = 0; i < loop.verts.size(); ++i) {
    const vec3 p = point(m, loop.verts[i]), q = point(m, loop.verts[(i + 1) % loop.verts.size()]);
    twice += p.x * q.y - q.x * p.y;
  }
  return twice / 2;
}

template<class M>
void check_borders(const M& m) {
  const auto b = boundary_loops(m);
  CHECK(b.count == count_borders(m));
  const auto border = edges_with_one_poly(m);
  std::map<std::size_t, int> met, degree;
  for (const auto& e : border)
    for (const auto v : adj_e2v(m, e)) ++degree[index_of(m, v)];
  int odd = 0;
  for (const auto& [v, n] : degree) odd += n % 2;
  int open = 0;
  std::size_t total = 0;
  for (const auto& loop : b.loops) {
    std::set<std::size_t> different;
    for (const auto& v : loop.verts) different.insert(index_of(m, v));
    CHECK(different.size() == loop.verts.size());  // no vert is repeated
    const std::size_t n = loop.verts.size();
    REQUIRE(loop.edges.size() == (loop.is_closed() ? n : n - 1));
    open += !loop.is_closed();
    for (std::size_t i = 0; i < loop.edges.size(); ++i) {
      CHECK(joins(m, loop.edges[i], loop.verts[i], loop.verts[(i + 1) % n]));
      CHECK(++met[index_of(m, loop.edges[i])] == 1);
    }
    total += loop.edges.size();
  }
  for (const auto& e : border) CHECK(met[index_of(m, e)] == 1);
  CHECK(total == border.size());
  CHECK(2 * open == odd);
  CHECK(b.loops.size() >= b.count);
}

}  // namespace

TEST_CASE_TEMPLATE("boundary_loops: the boundary of a grid has the surface on its left", M, CONCINO_SURFACE_KINDS) {
  for (const unsigned n : {1u, 2u, 5u}) {
    const M m = grid<M>(n);
    check_borders(m);
    const auto b = boundary_loops(m);
    REQUIRE(b.count == 1);
    REQUIRE(b.loops.size() == 1);
    CHECK(area_inside(m, b.loops[0]) == doctest::Approx(1.0));
  }
}

TEST_CASE_TEMPLATE("boundary_loops: closed and empty surfaces have none, two grids have two", M, CONCINO_SURFACE_KINDS) {
  CHECK(boundary_loops(M()).count == 0);
  const M torus = from_quads<M>(rolled_grid(5, 4));
  CHECK(boundary_loops(torus).count == 0);
  CHECK(boundary_loops(torus).loops.empty());
  const M two = two_grids<M>(3);
  check_borders(two);
  CHECK(boundary_loops(two).count == 2);
}

TEST_CASE("boundary_loops: follow the orientation of polygons, in any order of the polygons") {
  std::mt19937 random(8);
  for (int round = 0; round < 50; ++round) {
    const surface_arrays grid = with_offsets(polygon_grid(3));
    std::vector<std::vector<unsigned>> polygons;
    for (std::size_t p = 0; p < grid.num_polys(); ++p) {
      polygons.emplace_back();
      for (auto i = grid.offsets[p]; i < grid.offsets[p + 1]; ++i) polygons.back().push_back(grid.verts[i].raw());
      std::rotate(polygons.back().begin(), polygons.back().begin() + static_cast<int>(random() % 4), polygons.back().end());
    }
    for (std::size_t i = polygons.size(); i > 1; --i) std::swap(polygons[i - 1], polygons[random() % i]);
    const polygonmesh m(grid.points, polygons);
    const auto b = boundary_loops(m);
    REQUIRE(b.loops.size() == 1);
    CHECK(area_inside(m, b.loops[0]) == doctest::Approx(1.0));
  }
}

TEST_CASE("boundary_loops: two triangles that share a vert have two loops and one border") {
  const trimesh bow({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 3, 4}});
  check_borders(bow);
  const auto b = boundary_loops(bow);
  CHECK(b.count == 1);
  CHECK(b.loops.size() == 2);
  const trimesh turned({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 4, 3}});
  check_borders(turned);
  CHECK(boundary_loops(turned).loops.size() == 2);
}

TEST_CASE("boundary_loops: three triangles at an edge may give a walk that is not closed") {
  const trimesh fan({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, -1, 0}}, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}});
  check_borders(fan);
  const auto b = boundary_loops(fan);
  CHECK(b.count == 1);
  REQUIRE(b.loops.size() == 2);
  CHECK(b.loops[0].is_closed() != b.loops[1].is_closed());
}

TEST_CASE_TEMPLATE("boundary_loops: are right on 1,000 random meshes, also non-manifold ones", M, CONCINO_SURFACE_KINDS) {
  std::mt19937 random(3);
  int walks = 0, touching = 0;
  for (int round = 0; round < 1000; ++round) {
    const M m = random_mesh<M>(random);
    check_borders(m);
    const auto b = boundary_loops(m);
    touching += b.loops.size() > b.count;
    for (const auto& loop : b.loops) walks += !loop.is_closed();
  }
  CHECK(walks > 30);
  CHECK(touching > 100);
}

TEST_CASE_TEMPLATE("boundary_loops: run on the archetype of a surface and on users' meshes", M, CONCINO_SURFACE_KINDS) {
  const M m = two_grids<M>(2);
  const auto s = only_surface_mesh(m);
  check_borders(s);
  const auto b = boundary_loops(m);
  const auto stripped = boundary_loops(s);
  REQUIRE(stripped.loops.size() == b.loops.size());
  for (std::size_t i = 0; i < b.loops.size(); ++i)
    for (std::size_t k = 0; k < b.loops[i].verts.size(); ++k) CHECK(s.base(stripped.loops[i].verts[k]) == b.loops[i].verts[k]);
}

TEST_CASE("boundary_loops: run on a user's mesh; the boundary of a volume has none") {
  check_borders(user_mesh::surface_example());
  const hexmesh cube = grid<hexmesh>(2);
  CHECK(boundary_loops(boundary(cube)).count == 0);
}

TEST_CASE("boundary_loops: have the known numbers on every surface of the corpus") {
  const auto rows = corpus_meshes();
  if (rows.empty()) return skip("no corpus");
  std::size_t surfaces = 0;
  for (const auto& row : rows) {
    if (row.column.at("boundary_loops") == "n/a") continue;  // a volume
    ++surfaces;
    INFO(row.name);
    const auto m = load<polygonmesh>(row.file.string());
    const auto b = boundary_loops(m);
    CHECK(std::to_string(b.count) == row.column.at("boundary_loops"));
    std::size_t in_loops = 0;
    for (const auto& loop : b.loops) in_loops += loop.edges.size();
    CHECK(in_loops == edges_with_one_poly(m).size());
    const auto said = row.column.at("facts").find("boundary_edges=");
    if (said != std::string::npos) CHECK(in_loops == std::stoul(row.column.at("facts").substr(said + 15)));
  }
  CHECK(surfaces > 20);
}
