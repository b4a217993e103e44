#include <concino/geometry/outer_polygons.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/geometry/measure.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <array>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("for_each_outer_polygon: visits the polys of a surface or the boundary of a volume", M, CONCINO_KINDS) {
  const M m(jittered(grid_arrays<M>(2), 0.05, VolumeMesh<M>));
  const auto weak = only_embedded_mesh(m);
  std::size_t met = 0, met_stripped = 0, at_verts = 0, corners = 0;
  vec3 sum;
  for_each_outer_polygon(m, [&](const poly_id& p, const auto& loop, bool is_outward) {
    ++met;
    corners += num_elements(loop);
    CHECK(contains(m, p));
    const vec3 a = area_vector_of(m, loop);
    sum += is_outward ? a : -a;
    if (SurfaceMesh<M>) CHECK(is_outward);
  });
  std::size_t expected = 0;
  if constexpr (SurfaceMesh<M>) expected = num_polys(m);  // here the dimension itself is tested
  else for (const auto f : faces(m)) expected += is_boundary(m, f);
  CHECK(met == expected);
  CHECK(norm(sum - (SurfaceMesh<M> ? vec3{0, 0, total_measure(m)} : vec3{})) < 1e-14);
  for_each_outer_polygon(weak, [&](const auto& p, const auto& loop, bool) {
    ++met_stripped;
    for (const auto v : loop) CHECK(contains(m, weak.base(v)));
    CHECK(contains(m, weak.base(p)));
  });
  CHECK(met_stripped == met);
  for (const auto v : verts(m))
    for_each_outer_polygon(m, v, [&](const poly_id&, const auto& loop, bool) {
      ++at_verts;
      bool here = false;
      for (const auto w : loop) here = here || w == v;
      CHECK(here);
    });
  CHECK(at_verts == corners);
}

TEST_CASE("for_each_outer_polygon: reports faces that are clockwise as seen from outside") {
  auto arrays = polyhedra_grid(1);
  for (auto& out : arrays.outward) out = !out;
  const polyhedralmesh m(arrays), n(polyhedra_grid(1));
  std::array<std::size_t, 2> outward{}, inward{};
  for_each_outer_polygon(m, [&](const auto&, const auto&, bool is_outward) { ++(is_outward ? outward : inward)[0]; });
  for_each_outer_polygon(n, [&](const auto&, const auto&, bool is_outward) { ++(is_outward ? outward : inward)[1]; });
  CHECK(outward[0] == inward[1]);
  CHECK(inward[0] == outward[1]);
  CHECK(outward[0] != inward[0]);
}
