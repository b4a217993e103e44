#include <concino/fields/critical_points.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/generate/torus.hpp>

#include <support/corpus_meshes.hpp>
#include <support/kinds.hpp>
#include <support/random_meshes.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

template<class M>
std::ptrdiff_t euler_characteristic(const M& m) {
  auto chi = static_cast<std::ptrdiff_t>(num_verts(m)) - static_cast<std::ptrdiff_t>(num_edges(m));
  if constexpr (VolumeMesh<M>) chi += static_cast<std::ptrdiff_t>(num_faces(m)) - static_cast<std::ptrdiff_t>(num_polys(m));
  else chi += static_cast<std::ptrdiff_t>(num_polys(m));
  return chi;
}

template<class C>
std::ptrdiff_t alternating_sum(const C& c) {
  const auto n = [&](std::size_t k) { return static_cast<std::ptrdiff_t>(c.count[k]); };
  return n(0) - n(1) + n(2) - n(3);
}

/// Values of few different numbers, so that there are ties.
template<class M>
vert_map<M, double> random_values(const M& m, std::mt19937& random, unsigned different) {
  auto u = make_vert_map<double>(m);
  for (const auto v : verts(m)) u[v] = static_cast<double>(random() % different);
  return u;
}

/// Boundary matrices modulo 2 between cells with one highest vert, and their ranks, by elimination.
std::size_t rank_of(std::vector<std::vector<bool>> rows) {
  std::size_t rank = 0;
  for (std::size_t c = 0; !rows.empty() && c < rows[0].size() && rank < rows.size(); ++c) {
    std::size_t pivot = rank;
    while (pivot < rows.size() && !rows[pivot][c]) ++pivot;
    if (pivot == rows.size()) continue;
    std::swap(rows[rank], rows[pivot]);
    for (std::size_t r = 0; r < rows.size(); ++r)
      if (r != rank && rows[r][c])
        for (std::size_t k = 0; k < rows[r].size(); ++k) rows[r][k] = rows[r][k] != rows[rank][k];
    ++rank;
  }
  return rank;
}

/// The multiplicities of one vert from the ranks of these matrices.
template<class M, class U>
std::array<std::uint32_t, 4> multiplicities_by_ranks(const M& m, const U& u, const vert_t<M>& v) {
  const auto is_highest = [&](const auto& some) {
    bool has = false, above = false;
    for (const auto w : some) {
      if (w == v) has = true;
      else if (u[w] > u[v] || (u[w] == u[v] && index_of(m, w) > index_of(m, v))) above = true;
    }
    return has && !above;
  };
  std::vector<edge_t<M>> edges_below;
  for (const auto e : edges(m))
    if (is_highest(adj_e2v(m, e))) edges_below.push_back(e);
  const auto row = [](const auto& cells, const auto& some) {
    std::vector<bool> entries(cells.size());
    for (const auto x : some)
      for (std::size_t i = 0; i < cells.size(); ++i)
        if (cells[i] == x) entries[i] = !entries[i];
    return entries;
  };
  std::vector<std::vector<bool>> of_polygons, of_cells;
  if constexpr (VolumeMesh<M>) {
    std::vector<face_t<M>> faces_below;
    for (const auto f : faces(m))
      if (is_highest(adj_f2v(m, f))) {
        faces_below.push_back(f);
        of_polygons.push_back(row(edges_below, adj_f2e(m, f)));
      }
    for (const auto p : polys(m))
      if (is_highest(adj_p2v(m, p))) of_cells.push_back(row(faces_below, adj_p2f(m, p)));
  } else {
    for (const auto p : polys(m))
      if (is_highest(adj_p2v(m, p))) of_polygons.push_back(row(edges_below, adj_p2e(m, p)));
  }
  const std::size_t r1 = edges_below.empty() ? 0 : 1, r2 = rank_of(of_polygons), r3 = rank_of(of_cells);
  const auto number = [](std::size_t n) { return static_cast<std::uint32_t>(n); };
  return {number(1 - r1), number(edges_below.size() - r1 - r2), number(of_polygons.size() - r2 - r3), number(of_cells.size() - r3)};
}

}  // namespace

TEST_CASE_TEMPLATE("critical_points: are the ranks of homology of random meshes, open and non-manifold too; their alternating sum is chi", M, CONCINO_KINDS) {
  std::mt19937 random(1);
  const unsigned rounds = long_run() ? 1000 : 60;
  for (unsigned round = 0; round < rounds; ++round) {
    CAPTURE(round);
    const M m = std::same_as<M, polyhedralmesh> ? random_holes<M>(random) : random_mesh<M>(random);  // random polyhedra are not closed
    const auto u = random_values(m, random, 1 + static_cast<unsigned>(random() % 12));
    const auto c = critical_points(m, u);
    CHECK(alternating_sum(c) == euler_characteristic(m));
    std::size_t not_regular = 0;
    for (const auto v : verts(m)) {
      CHECK(c[v] == multiplicities_by_ranks(m, u, v));
      not_regular += c[v] != std::array<std::uint32_t, 4>{};
    }
    CHECK(not_regular == c.verts.size());
  }
}

TEST_CASE("critical_points: three polyhedra at a face, and cavities below a vert") {
  const tetmesh m({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}, {1, 1, 1}}, {{0, 1, 2, 3}, {0, 1, 2, 4}, {0, 1, 2, 5}});
  for (unsigned order = 0; order < 720; order += 7) {
    std::vector<double> value{0, 1, 2, 3, 4, 5};
    for (unsigned k = 0; k < order; ++k) std::next_permutation(value.begin(), value.end());
    auto u = make_vert_map<double>(m);
    for (const auto v : verts(m)) u[v] = value[v.raw()];
    const auto c = critical_points(m, u);
    for (const auto v : verts(m)) CHECK(c[v] == multiplicities_by_ranks(m, u, v));
    CHECK(alternating_sum(c) == 1);
  }
}

TEST_CASE("critical_points: a torus on its side has a minimum, two saddles and a maximum") {
  const auto m = make_torus<quadmesh>({.cells = {24, 12}});
  auto u = make_vert_map<double>(m);
  for (const auto v : verts(m)) u[v] = point(m, v)[0] + 1e-3 * point(m, v)[1] + 1e-4 * point(m, v)[2];
  const auto c = critical_points(m, u);
  CHECK(c.count == std::array<std::size_t, 4>{1, 2, 1, 0});
  CHECK(c.verts.size() == 4);
  CHECK(alternating_sum(c) == 0);
}

TEST_CASE("critical_points: a saddle of three valleys has multiplicity 2, and a vert can have two indices") {
  std::vector<vec3> points{{0, 0, 0}};
  std::vector<std::vector<unsigned>> triangles;
  for (unsigned k = 0; k < 6; ++k) {
    points.push_back({std::cos(k * 1.0471975512), std::sin(k * 1.0471975512), 0});
    triangles.push_back({0, 1 + k, 1 + (k + 1) % 6});
  }
  const polygonmesh m(points, triangles);
  auto u = make_vert_map<double>(m);
  for (const auto v : verts(m)) u[v] = v.raw() == 0 ? 0 : v.raw() % 2 ? 1 : -1;
  CHECK(critical_points(m, u)[vert_id{0}] == std::array<std::uint32_t, 4>{0, 2, 0, 0});

  const auto cells = grid<tetmesh>(2);  // what is left of a sphere without two parts has a loop
  auto below = make_vert_map<double>(cells, -1.0);
  vert_id middle;
  for (const auto v : verts(cells)) {
    const vec3 x = to_vec3(point(cells, v));
    if (x == vec3{0.5, 0.5, 0.5}) middle = v, below[v] = 0;
    if (x == vec3{0, 0.5, 0.5} || x == vec3{1, 0.5, 0.5}) below[v] = 1;
  }
  CHECK(critical_points(cells, below)[middle] == std::array<std::uint32_t, 4>{0, 0, 1, 0});

  // Two fans around one vert: of one the whole link is below, of the other two separate parts.
  std::vector<vec3> two = points;
  auto both = triangles;
  for (unsigned k = 0; k < 4; ++k) {
    two.push_back({std::cos(k * 1.57), std::sin(k * 1.57), 1});
    both.push_back({0, 7 + k, 7 + (k + 1) % 4});
  }
  const polygonmesh cone(two, both);
  auto w = make_vert_map<double>(cone, -1.0);
  w[vert_id{0}] = 0, w[vert_id{7}] = 1, w[vert_id{9}] = 1;
  CHECK(critical_points(cone, w)[vert_id{0}] == std::array<std::uint32_t, 4>{0, 2, 1, 0});
}

TEST_CASE("critical_points: of a ball of tets, by the distance from its centre") {
  const auto m = grid<tetmesh>(4);
  auto u = make_vert_map<double>(m);
  for (const auto v : verts(m)) u[v] = distance(to_vec3(point(m, v)), vec3{0.5, 0.5, 0.5});
  const auto c = critical_points(m, u);
  CHECK(c.count[0] == 1);
  CHECK(alternating_sum(c) == 1);
  for (const auto v : verts(m)) u[v] = -u[v];
  const auto d = critical_points(m, u);
  CHECK(d.count[3] == 1);
  CHECK(alternating_sum(d) == 1);
}

TEST_CASE("critical_points: the alternating sum is chi on all meshes of the corpus, for random functions") {
  const auto rows = corpus_meshes();
  if (rows.empty()) return skip("no corpus");
  std::mt19937 random(2);
  for (const auto& row : rows) {
    if (!long_run() && std::filesystem::file_size(row.file) > 100000) continue;
    INFO(row.name);
    const auto check = [&](const auto& m) {
      for (const unsigned different : {1u, 10u, 1000000u}) CHECK(alternating_sum(critical_points(m, random_values(m, random, different))) == euler_characteristic(m));
    };
    if (row.column.at("boundary_loops") != "n/a") check(load<polygonmesh>(row.file.string()));
    else check(load<polyhedralmesh>(row.file.string()));
  }
}

TEST_CASE("critical_points: run on archetypes and empty meshes, do not depend on points, and reject values that are not finite") {
  const auto m = grid<polygonmesh>(3);
  std::mt19937 random(3);
  const auto u = random_values(m, random, 5);
  const auto archetype = only_surface_mesh(m);
  auto same = make_vert_map<double>(archetype);
  std::vector<double> by_index(vert_index_bound(m));
  for (const auto v : verts(m)) by_index[index_of(m, v)] = u[v];
  for (const auto v : verts(archetype)) same[v] = by_index[index_of(archetype, v)];
  CHECK(critical_points(archetype, same).count == critical_points(m, u).count);
  const trimesh none;
  CHECK(critical_points(none, make_vert_map<double>(none)).verts.empty());
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    auto wrong = u;
    wrong[vert_id{7}] = bad;
    CHECK_THROWS_WITH_AS(critical_points(m, wrong), doctest::Contains("critical_points: the value at vert 7 is not finite"), invalid_argument);
  }
  const polyhedralmesh open({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, {{{0, true}}});
  CHECK_THROWS_WITH_AS(critical_points(open, make_vert_map<double>(open)), doctest::Contains("vert 2 has faces that are not closed"), invalid_mesh);
}
