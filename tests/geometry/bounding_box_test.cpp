#include <concino/geometry/bounding_box.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("bounding_box: of a grid and of nothing", M, CONCINO_ALL_KINDS) {
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

TEST_CASE("bounding_box: a vert of no poly counts, negative coordinates too") {
  const trimesh m({{-3, -2, -1}, {-4, -5, -6}}, {});
  CHECK(bounding_box(m).min == vec3{-4, -5, -6});
  CHECK(bounding_box(m).max == vec3{-3, -2, -1});
}
