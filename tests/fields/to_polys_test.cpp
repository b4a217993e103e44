#include <concino/fields/to_polys.hpp>

#include <concino/concepts/archetypes.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <cmath>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("to_polys: is the integral of linear functions, exactly, and keeps constants to the bit", M, CONCINO_KINDS) {
  const M m(jittered(two_grids_arrays<M>(2), 0.05, VolumeMesh<M>));
  const auto archetype = only_embedded_mesh(m);
  using view = std::remove_cvref_t<decltype(archetype)>;
  auto u = make_vert_map<double>(archetype);
  const auto linear = [](const vec3& x) { return 2 * x.x - 3 * x.y + (VolumeMesh<M> ? x.z : 0) + 1; };
  for (const auto v : verts(archetype)) u[v] = linear(to_vec3(point(archetype, v)));
  const auto q = to_polys(archetype, u);
  for (const poly_t<view> p : polys(archetype)) CHECK(std::abs(q[p] - linear(centroid(archetype, p))) < 1e-12);
  const auto same = to_polys(m, make_vert_map<double>(m, 0.1));
  for (const auto p : polys(m)) CHECK(same[p] == 0.1);
}

TEST_CASE("to_polys: polys without area have the mean, values that are not finite stay in their polys, and empty meshes have none") {
  const polygonmesh m({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}}, {{0, 1, 2, 3}, {0, 1, 4}});
  auto u = make_vert_map<double>(m);
  for (const auto v : verts(m)) u[v] = v.raw();
  CHECK(to_polys(m, u)[poly_id{1}] == doctest::Approx(5.0 / 3));
  u[vert_id{4}] = std::nan("");
  const auto q = to_polys(m, u);
  CHECK(q[poly_id{0}] == doctest::Approx(1.5));
  CHECK(std::isnan(q[poly_id{1}]));
  const hexmesh none;
  CHECK(to_polys(none, make_vert_map<double>(none)).values().empty());
}
