#include <concino/lines/starts_around.hpp>

#include <concino/core/error.hpp>
#include <concino/generate/grid.hpp>
#include <concino/lines/integral_line.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <variant>

using namespace concino;

TEST_CASE_TEMPLATE("starts_around: a bundle of lines from the corners of a poly", M, CONCINO_KINDS) {
  const M m = make_grid<M>({.cells = {3, 3, 3}});
  auto g = make_poly_map<vec3>(m);
  for (const auto p : polys(m)) g[p] = {1, 0.2, dimension_v<M> == 2 ? 0 : 0.1};
  for (const auto p : polys(m)) {
    const auto starts = starts_around(m, p, 0.25);
    vec3 sum;
    std::size_t n = 0;
    for (const auto v : adj_p2v(m, p)) sum += to_vec3(point(m, v)), ++n;
    REQUIRE(starts.size() == n);
    vec3 mean;
    for (const auto& x : starts) {
      CHECK(std::get<poly_t<M>>(x.element) == p);
      mean += x.position / static_cast<double>(n);
    }
    CHECK(distance(mean, 0.75 * centroid(m, p) + 0.25 * sum / static_cast<double>(n)) < 1e-14);
    const auto bundle = integral_lines(m, g, starts);
    REQUIRE(bundle.size() == n);
    for (std::size_t i = 0; i < n; ++i) {
      CHECK(bundle[i].points.front().position == starts[i].position);
      CHECK(bundle[i].polys.front() == p);
      CHECK(bundle[i].stopped_by == line_end::boundary);
    }
  }
}

TEST_CASE("starts_around: errors") {
  const auto m = make_grid<trimesh>({.cells = {2, 2}});
  CHECK_THROWS_WITH_AS(starts_around(m, poly_id{99}), "starts_around: poly 99 is no poly of the mesh", invalid_mesh);
  CHECK_THROWS_WITH_AS(starts_around(m, poly_id{0}, 1), "starts_around: part is 1; it must be between 0 and 1", invalid_argument);
}
