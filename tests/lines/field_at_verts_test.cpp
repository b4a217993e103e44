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

TEST_CASE("field_at_verts: errors") {
  const auto m = make_grid<trimesh>({.cells = {3, 3}});
  auto h = make_vert_map<vec3>(m);
  CHECK_THROWS_WITH_AS(integral_line(m, field_at_verts(h, -1), vert_id{0}), "integral_line: the step must be finite and at least 0", invalid_argument);
  h[vert_id{3}] = {0, std::numeric_limits<double>::infinity(), 0};
  CHECK_THROWS_WITH_AS(integral_lines(m, field_at_verts(h), verts(m)), "integral_lines: the vector at vert 3 is not finite; give each vert a finite vector", invalid_argument);
}
