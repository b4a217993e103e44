#include <concino/generate/grid.hpp>

#include <concino/geometry/bounding_box.hpp>

#include <support/generated.hpp>
#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("make_grid: fills the box with valid cells, for any number", M, CONCINO_ALL_KINDS) {
  for (const std::array<std::size_t, 3> cells : {std::array<std::size_t, 3>{1, 1, 1}, {1, 2, 3}, {2, 1, 1}, {3, 4, 2}, {4, 3, 1}, {5, 5, 2}}) {
    const M m = make_grid<M>({.cells = cells, .min = {-1, 2, 0.5}, .max = {2, 4, 3}});
    check_sound(m, 1);
    CHECK(total_measure(m) == doctest::Approx(SurfaceMesh<M> ? 6 : 15).epsilon(1e-14));
    const box b = bounding_box(m);
    CHECK(b.min == vec3{-1, 2, 0.5});
    CHECK(b.max == vec3{2, 4, SurfaceMesh<M> ? 0.5 : 3});
    if constexpr (SurfaceMesh<M>)
      for (const poly_t<M> p : polys(m)) CHECK(area_vector(m, p).z > 0);
    const std::size_t flat = cells[0] * cells[1];
    if (std::is_same_v<M, trimesh>) CHECK(num_polys(m) == 2 * flat);
    if (std::is_same_v<M, quadmesh>) CHECK(num_polys(m) == flat);
    if (std::is_same_v<M, polygonmesh>) CHECK(num_polys(m) == flat + cells[1] / 2);
    if (std::is_same_v<M, tetmesh>) CHECK(num_polys(m) == 6 * flat * cells[2]);
    if (VolumeMesh<M> && !TetMesh<M>) CHECK(num_polys(m) == flat * cells[2]);
  }
}

TEST_CASE("make_grid: interior polygons are hexagons, and none has a flat corner") {
  const auto m = make_grid<polygonmesh>({.cells = {6, 7}});
  std::size_t sizes[7] = {};
  for (const poly_id p : polys(m)) ++sizes[adj_p2v(m, p).size()];
  CHECK(sizes[6] == 27);
  CHECK(sizes[4] + sizes[5] + sizes[6] == num_polys(m));
}

TEST_CASE_TEMPLATE("make_grid: scales exactly", M, CONCINO_ALL_KINDS) {
  const M m = make_grid<M>({.cells = {3, 3, 2}, .max = {3, 2, 1}});
  for (const double s : {0x1p20, 0x1p-900}) {
    const M t = make_grid<M>({.cells = {3, 3, 2}, .max = {3 * s, 2 * s, s}});
    for (const vert_t<M> v : verts(m)) CHECK(point(t, v) == s * point(m, v));
  }
}

TEST_CASE_TEMPLATE("make_grid: throws if an option is out of range", M, CONCINO_ALL_KINDS) {
  CHECK_THROWS_WITH_AS(make_grid<M>({.cells = {4, 0, 4}}), "make_grid: cells[1] is 0; it must be at least 1", invalid_argument);
  CHECK_THROWS_WITH_AS(make_grid<M>({.cells = {1u << 17, 1u << 17, 1}}), doctest::Contains("make_grid: cells asks for"), invalid_argument);
  CHECK_THROWS_AS(make_grid<M>({.cells = {~std::size_t{0}, ~std::size_t{0}, 1}}), invalid_argument);
  CHECK_THROWS_WITH_AS(make_grid<M>({.min = {0, 2, 0}}), "make_grid: min.y is 2 and max.y is 1; both must be finite, min below max, and their difference finite",
                       invalid_argument);
  CHECK_THROWS_AS(make_grid<M>({.min = {std::nan(""), 0, 0}}), invalid_argument);
  CHECK_THROWS_AS(make_grid<M>({.min = {0, 0, std::nan("")}}), invalid_argument);
  CHECK_THROWS_AS(make_grid<M>({.max = {1, std::numeric_limits<double>::infinity(), 1}}), invalid_argument);
  CHECK_THROWS_AS(make_grid<M>({.min = {-1e308, 0, 0}, .max = {1e308, 1, 1}}), invalid_argument);
  CHECK_THROWS_WITH_AS(make_grid<M>({.min = {1e16, 0, 0}, .max = {1e16 + 8, 1, 1}}), doctest::Contains("too small for double precision"), invalid_argument);
}
