#include <concino/lines/field_at_verts.hpp>

#include <concino/core/error.hpp>
#include <concino/generate/grid.hpp>
#include <concino/generate/jitter.hpp>
#include <concino/lines/integral_line.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

using namespace concino;
using namespace concino::testing;

namespace {

template<class M, class F>
auto at_verts(const M& m, const F& f) {
  auto h = make_vert_map<vec3>(m);
  for (const auto v : verts(m)) h[v] = f(to_vec3(point(m, v)));
  return h;
}

}  // namespace

TEST_CASE_TEMPLATE("field_at_verts: a field linear in space is followed with order 4 inside polys", M, CONCINO_KINDS) {
  M m = make_grid<M>({.cells = {4, 4, 4}, .min = {-1, -1, -1}, .max = {1, 1, 1}});
  jitter(m, 0.1);
  // circles about (c, c) where the boundary is far
  const vec3 c(0.05, 0.03, dimension_v<M> == 2 ? -1 : 0.02);
  const auto h = at_verts(m, [&](const vec3& x) { return vec3{-(x.y - c.y), x.x - c.x, 0}; });
  auto p = *polys(m).begin();
  for (const auto q : polys(m))
    if (std::abs(norm(centroid(m, q) - c) - 0.5) < std::abs(norm(centroid(m, p) - c) - 0.5)) p = q;
  const vec3 start = centroid(m, p);
  const double r = std::hypot(start.x - c.x, start.y - c.y);
  double off[2];
  for (const double step : {0.2, 0.1}) {
    const auto line = integral_line(m, field_at_verts(h, step), p, {.max_length = 6});
    CHECK(line.stopped_by == line_end::max_length);
    CHECK(line.length == 6);
    double& worst = off[step < 0.15];
    worst = 0;
    for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
      if (!std::holds_alternative<poly_t<M>>(line.points[i].element)) continue;  // the ends of steps; other points are between them, on a chord
      worst = std::max(worst, std::abs(std::hypot(line.points[i].position.x - c.x, line.points[i].position.y - c.y) - r));
    }
  }
  CHECK(off[1] < 1e-3);
  CHECK(off[1] < off[0] / 12);
}

TEST_CASE_TEMPLATE("field_at_verts: constant fields, sinks and zeros", M, CONCINO_KINDS) {
  const M m = make_grid<M>({.cells = {3, 3, 3}});
  const vec3 g = dimension_v<M> == 2 ? vec3(0.7, 0.31, 0) : vec3(0.7, 0.31, 0.23);
  const auto h = at_verts(m, [&](const vec3&) { return g; });
  for (const auto& line : integral_lines(m, field_at_verts(h), polys(m), {.both_ways = true})) {
    CHECK(line.stopped_by == line_end::boundary);
    CHECK(line.began_by == line_end::boundary);
    const vec3 d = line.points.back().position - line.points.front().position;
    CHECK(norm(cross(d, g)) < 1e-12);
  }
  const vec3 middle = dimension_v<M> == 2 ? vec3(0.47, 0.52, 0) : vec3(0.47, 0.52, 0.55);
  const auto to_middle = at_verts(m, [&](const vec3& x) { return middle - x; });
  for (const auto p : polys(m)) {
    const auto line = integral_line(m, field_at_verts(to_middle, 0.05), p);
    CHECK((line.stopped_by == line_end::sink || line.stopped_by == line_end::zero));
    CHECK(distance(line.points.back().position, middle) < 0.05);
  }
  const auto none = at_verts(m, [](const vec3&) { return vec3(); });
  CHECK(integral_line(m, field_at_verts(none), *verts(m).begin()).stopped_by == line_end::zero);
}

TEST_CASE_TEMPLATE("field_at_verts: only the directions of the vectors matter, and how their lengths compare", M, polygonmesh, tetmesh) {
  const M m = make_grid<M>({.cells = {3, 3, 3}});
  const auto turned = [](const vec3& x) { return vec3{0.3 - x.y, x.x + 0.1, 0}; };
  const auto h = at_verts(m, turned);
  const auto p = *polys(m).begin();
  const auto line = integral_line(m, field_at_verts(h, 0.05), p);
  REQUIRE(line.points.size() > 10);
  for (const int exponent : {-1000, 1000}) {
    const auto scaled = at_verts(m, [&](const vec3& x) { return std::ldexp(1.0, exponent) * turned(x); });
    const auto other = integral_line(m, field_at_verts(scaled, 0.05), p);
    REQUIRE(other.points.size() == line.points.size());
    for (std::size_t i = 0; i < line.points.size(); ++i) CHECK(other.points[i].position == line.points[i].position);
  }
}

TEST_CASE_TEMPLATE("field_at_verts: a step is a quarter of the poly, or the length asked for, and begins with the field there", M, trimesh, hexmesh) {
  const M m = make_grid<M>({.cells = {2, 2, 2}});
  const auto constant = at_verts(m, [](const vec3&) { return vec3{1, 0, 0}; });
  const auto p = *polys(m).begin();
  const double size = dimension_v<M> == 2 ? std::sqrt(0.5) : std::sqrt(0.75);  // the diagonal of a square or cube of side 1/2
  for (const double step : {0.0, 0.03}) {
    const auto line = integral_line(m, field_at_verts(constant, step), p);
    std::size_t end = 1;  // of the first step; it may cross sides before
    while (end < line.points.size() && !std::holds_alternative<poly_t<M>>(line.points[end].element)) ++end;
    REQUIRE(end < line.points.size());
    CHECK(distance(line.points[0].position, line.points[end].position) == doctest::Approx(step > 0 ? step : size / 4));
  }
  const auto turned = at_verts(m, [](const vec3& x) { return vec3{2 * x.x + 0.25, x.x + x.y - 1, 0}; });
  std::size_t met = 0;
  for (const auto e : edges(m)) {
    const auto [a, b] = end_verts(m, e);
    const vec3 along = to_vec3(point(m, b)) - to_vec3(point(m, a));
    if (std::abs(along.x) < 0.1) continue;
    const auto line = integral_line(m, field_at_verts(turned, 1e-4), mesh_point<M>{edge_point<M>{e, 0.25}, 0.75 * to_vec3(point(m, a)) + 0.25 * to_vec3(point(m, b))}, {.max_length = 1e-4});
    if (line.points.size() < 2) continue;
    const vec3 expected = 0.75 * turned[a] + 0.25 * turned[b], found = line.points[1].position - line.points[0].position;
    CHECK(norm(cross(found / norm(found), expected / norm(expected))) < 1e-3);
    ++met;
  }
  CHECK(met > 1);
}

TEST_CASE("field_at_verts: errors") {
  const auto m = make_grid<trimesh>({.cells = {3, 3}});
  auto h = make_vert_map<vec3>(m);
  CHECK_THROWS_WITH_AS(integral_line(m, field_at_verts(h, -1), vert_id{0}), "integral_line: the step must be finite and at least 0", invalid_argument);
  CHECK_THROWS_AS(integral_line(m, field_at_verts(h, std::numeric_limits<double>::infinity()), vert_id{0}), invalid_argument);
  h[vert_id{3}] = {0, std::numeric_limits<double>::infinity(), 0};
  CHECK_THROWS_WITH_AS(integral_lines(m, field_at_verts(h), verts(m)), "integral_lines: the vector at vert 3 is not finite; give each vert a finite vector", invalid_argument);
}
