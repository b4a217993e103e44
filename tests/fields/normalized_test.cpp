#include <concino/fields/normalized.hpp>

#include <concino/concepts/archetypes.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace concino;
using namespace concino::testing;

TEST_CASE("normalized: values at verts and polys go to the range, at any scale; constants to its low end") {
  const auto m = grid<quadmesh>(2);
  const auto g = only_primal_graph(m);
  auto u = make_vert_map<double>(g);
  for (const double scale : {1.0, 1e-300, 2e307}) {
    for (const auto v : verts(g)) u[v] = scale * (static_cast<double>(index_of(g, v)) - 4);
    const auto n = normalized(g, u);
    for (const auto v : verts(g)) CHECK(n[v] == doctest::Approx(static_cast<double>(index_of(g, v)) / 8));
  }
  auto q = make_poly_map<double>(m);
  for (const auto p : polys(m)) q[p] = p.raw();
  q[poly_id{2}] = std::numeric_limits<double>::infinity();
  const auto r = normalized(m, q, {.low = 5, .high = -1});
  CHECK(r[poly_id{0}] == 5);
  CHECK(r[poly_id{1}] == doctest::Approx(3));
  CHECK(!std::isfinite(r[poly_id{2}]));
  CHECK(r[poly_id{3}] == -1);
  CHECK(normalized(m, make_vert_map<double>(m, 7.0), {.low = 2, .high = 3})[vert_id{1}] == 2);
}

TEST_CASE("normalized: vectors become unit vectors, of any length; 0 stays") {
  const auto m = grid<trimesh>(1);
  auto field = make_poly_map<vec3>(m);
  for (const double scale : {1.0, 4e-308, 1e308, 5e-324}) {
    field[poly_id{0}] = {0, scale, scale};
    const auto n = normalized(m, field);
    CHECK(norm(n[poly_id{0}]) == doctest::Approx(1));
    CHECK(n[poly_id{0}].y == doctest::Approx(std::sqrt(0.5)));
    CHECK(n[poly_id{1}] == vec3());
  }
  field[poly_id{0}].x = std::nan("");
  CHECK(!is_finite(normalized(m, field)[poly_id{0}]));
}

TEST_CASE("normalized: empty meshes, and ranges that are not finite") {
  const trimesh none;
  CHECK(normalized(none, make_vert_map<double>(none)).values().empty());
  CHECK_THROWS_WITH_AS(normalized(none, make_vert_map<double>(none), {.low = std::nan("")}), doctest::Contains("normalized: the range ends at nan"), invalid_argument);
}
