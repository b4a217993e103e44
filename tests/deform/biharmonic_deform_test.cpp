#include <concino/deform/biharmonic_deform.hpp>

#include <concino/concepts/archetypes.hpp>

#include <support/kinds.hpp>
#include <support/motions.hpp>

#include <doctest/doctest.h>

#include <limits>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("biharmonic_deform: reproduces rigid motions, and handles are exact", M, CONCINO_ALL_KINDS) {
  const M m(grid_arrays<M>(3));
  std::vector<std::pair<vert_t<M>, vec3>> pairs;
  for (const auto v : verts(m))
    if (const vec3 x = to_vec3(point(m, v)); x.x == 0 || x.x == 1) pairs.push_back({v, rotated(x) + vec3{1, 2, 3}});
  const auto x = biharmonic_deform(m, pairs);
  for (const auto v : verts(m)) CHECK(distance(x[v], rotated(to_vec3(point(m, v))) + vec3{1, 2, 3}) < 1e-10);
  for (auto& [v, p] : pairs) p = to_vec3(point(m, v)) + vec3{0, 0, point(m, v)[0]};
  const auto y = biharmonic_deform(m, pairs), z = biharmonic_deform(m, pairs, {.exponent = 1});
  for (const auto& [v, p] : pairs) {
    CHECK(y[v] == p);
    CHECK(z[v] == p);
  }
  const auto g = only_embedded_mesh(m);
  std::vector<std::pair<vert_t<decltype(g)>, vec3>> same;
  for (const auto v : verts(g))
    for (const auto& [u, p] : pairs)
      if (index_of(g, v) == index_of(m, u)) same.push_back({v, p});
  const auto w = biharmonic_deform(g, same);
  for (const auto v : verts(m)) CHECK(distance(w.values()[index_of(m, v)], y[v]) < 1e-10);
}

TEST_CASE("biharmonic_deform: bad input") {
  const trimesh m(triangle_grid(2));
  constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH_AS((void)biharmonic_deform(m, std::vector<std::pair<vert_id, vec3>>{}), "biharmonic_deform: there are no handles", invalid_argument);
  CHECK_THROWS_WITH_AS((void)biharmonic_deform(m, {{vert_id{0}, {not_a_number, 0, 0}}}), "biharmonic_deform: the position of vert 0 has a coordinate that is not finite", invalid_argument);
  CHECK_THROWS_AS((void)biharmonic_deform(m, {{vert_id{99}, {0, 0, 0}}}), invalid_mesh);
  CHECK_THROWS_AS((void)biharmonic_deform(m, {{vert_id{0}, {0, 0, 0}}, {vert_id{0}, {0, 0, 1}}}), invalid_argument);
  CHECK_THROWS_AS((void)biharmonic_deform(m, {{vert_id{0}, {0, 0, 0}}}, {.exponent = 0}), invalid_argument);
  const trimesh two(two_grids_arrays<trimesh>(2));
  CHECK_THROWS_AS((void)biharmonic_deform(two, {{vert_id{0}, {0, 0, 0}}}), solver_error);
  auto bad = m;
  set_point(bad, vert_id{4}, vec3{not_a_number, 0, 0});
  CHECK_THROWS_AS((void)biharmonic_deform(bad, {{vert_id{0}, {0, 0, 0}}}), invalid_mesh);
}
