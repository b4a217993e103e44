#include <concino/geometry/bounding_box.hpp>

#include <concino/concepts/archetypes.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("bounding_box: is right for grids and empty meshes", M, CONCINO_KINDS) {
  const box b = bounding_box(grid<M>(2));
  CHECK(b.min == vec3{0, 0, 0});
  CHECK(b.max == vec3{1, 1, SurfaceMesh<M> ? 0 : 1});
  CHECK_FALSE(b.is_empty());
  CHECK(b.centre() == vec3{0.5, 0.5, SurfaceMesh<M> ? 0.0 : 0.5});
  CHECK(b.diagonal() == doctest::Approx(std::sqrt(SurfaceMesh<M> ? 2.0 : 3.0)));
  const box none = bounding_box(M());
  CHECK(none.is_empty());
  CHECK(none.diagonal() == 0);
}

TEST_CASE("bounding_box: contains isolated verts and negative coordinates") {
  const trimesh m({{-3, -2, -1}, {-4, -5, -6}}, {});
  CHECK(bounding_box(m).min == vec3{-4, -5, -6});
  CHECK(bounding_box(m).max == vec3{-3, -2, -1});
}

TEST_CASE_TEMPLATE("bounding_box: the boxes of polys, faces and edges together give that of the mesh", M, CONCINO_KINDS) {
  const M m(jittered(grid_arrays<M>(2), 0.1));
  const auto g = only_embedded_mesh(m);
  box all;
  const auto check = [&](const box& b, const box& stripped, const auto& around) {
    box expected;
    for (const auto v : around) expected.add(point(m, v));
    CHECK(b.min == expected.min);
    CHECK(b.max == expected.max);
    CHECK(stripped.min == b.min);
    CHECK(stripped.max == b.max);
  };
  for (const auto p : polys(m)) {
    check(bounding_box(m, p), bounding_box(g, g.poly(p)), adj_p2v(m, p));
    all.add(bounding_box(m, p).min);
    all.add(bounding_box(m, p).max);
  }
  for (const auto e : edges(m)) check(bounding_box(m, e), bounding_box(g, g.edge(e)), adj_e2v(m, e));
  if constexpr (VolumeMesh<M>)
    for (const auto f : faces(m)) check(bounding_box(m, f), bounding_box(g, g.face(f)), adj_f2v(m, f));
  CHECK(all.min == bounding_box(m).min);
  CHECK(all.max == bounding_box(m).max);
}
