#include <concino/fields/heat_geodesics.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/edit/elements.hpp>

#include <support/geodesic_errors.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("heat_geodesics: have the same result on an archetype", M, CONCINO_KINDS) {
  const M m = square_or_cube<M>(2);
  const auto weak = only_embedded_mesh(m);
  const auto d = heat_geodesics(m, vert_id{0});
  const auto e = heat_geodesics(weak, weak.vert(vert_id{0}));
  for (const auto v : verts(weak)) CHECK(e[v] == doctest::Approx(d[weak.base(v)]).epsilon(1e-9));
}

TEST_CASE_TEMPLATE("heat_geodesics: work with gaps in the indices and on empty meshes", M, CONCINO_KINDS) {
  M m(jittered(grid_arrays<M>(4), 0.02, VolumeMesh<M>));
  remove_vert(m, vert_id{static_cast<unsigned>(num_verts(m) / 2)});
  const auto d = heat_geodesics(m, vert_id{0});
  for (const auto v : verts(m)) CHECK(d[v] >= distance(point(m, v), point(m, vert_id{0})) * 0.7);
  const M empty;
  CHECK_THROWS_AS(heat_geodesics(empty, vert_id{0}), invalid_mesh);
}
