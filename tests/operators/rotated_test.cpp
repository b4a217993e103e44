#include <concino/operators/rotated.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/operators/divergence.hpp>
#include <concino/operators/gradient.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("rotated: keeps lengths, is orthogonal, and is minus the field if done twice", M, CONCINO_SURFACE_KINDS) {
  const M m(jittered(two_grids_arrays<M>(3), 0.05, false));
  auto u = make_vert_map<double>(m);
  for (const auto v : verts(m)) u[v] = std::sin(3 * point(m, v)[0]) + point(m, v)[1];
  const auto g = gradient(m, u), r = rotated(m, g), back = rotated(m, r);
  for (const auto p : polys(m)) {
    CHECK(std::abs(dot(g[p], r[p])) < 1e-13);
    CHECK(std::abs(norm(g[p]) - norm(r[p])) < 1e-13);
    CHECK(distance(back[p], -g[p]) < 1e-13);
    CHECK(distance(r[p], {-g[p].y, g[p].x, 0}) < 1e-13);
  }
  const auto archetype = only_embedded_mesh(m);
  auto same = make_vert_map<double>(archetype);
  for (const auto v : verts(archetype)) same[v] = std::sin(3 * point(archetype, v)[0]) + point(archetype, v)[1];
  const auto field = gradient(archetype, same), turned = rotated(archetype, field);
  for (const auto p : polys(archetype)) CHECK(distance(turned[p], {-field[p].y, field[p].x, 0}) < 1e-13);
}

TEST_CASE("rotated: gradients have no divergence at inner verts once they are rotated; normal parts are lost") {
  const trimesh m(jittered(triangle_grid(4), 0.02, true));
  auto u = make_vert_map<double>(m);
  for (const auto v : verts(m)) u[v] = point(m, v)[0] * point(m, v)[1] + std::cos(5 * point(m, v)[1]);
  const auto d = divergence(m, rotated(m, gradient(m, u)));
  for (const auto v : verts(m)) {
    const auto x = to_vec3(point(m, v));
    if (std::min({x.x, x.y, 1 - x.x, 1 - x.y}) > 0.1) CHECK(std::abs(d[v]) < 1e-13);
  }
  const trimesh flat({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  CHECK(rotated(flat, make_poly_map<vec3>(flat, vec3{1, 2, 9}))[poly_id{0}] == vec3{-2, 1, 0});
}

TEST_CASE("rotated: empty meshes, values that are not finite, and errors that name the poly") {
  const trimesh none;
  CHECK(rotated(none, make_poly_map<vec3>(none)).values().empty());
  const polygonmesh m({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}}, {{0, 1, 2, 3}, {0, 1, 4}});
  CHECK_THROWS_WITH_AS(rotated(m, make_poly_map<vec3>(m)), doctest::Contains("rotated: poly 1 has no area"), invalid_mesh);
  const auto quads = grid<quadmesh>(2);
  auto g = make_poly_map<vec3>(quads, vec3{1, 0, 0});
  g[poly_id{1}].x = std::nan("");
  const auto r = rotated(quads, g);
  for (const auto p : polys(quads)) CHECK(is_finite(r[p]) == (p != poly_id{1}));
  const trimesh broken({{0, 0, 0}, {1, 0, 0}, {0, std::nan(""), 0}}, {{0, 1, 2}});
  CHECK_THROWS_AS(rotated(broken, make_poly_map<vec3>(broken)), invalid_mesh);
}
