#include <concino/generate/triangulate.hpp>

#include <concino/generate/grid.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/geometry/orientation.hpp>
#include <concino/io/slices.hpp>
#include <concino/level_sets/isolines.hpp>
#include <concino/mesh/quadmesh.hpp>
#include <concino/validate/check_laws.hpp>

#include <support/corpus.hpp>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

using namespace concino;
using namespace concino::testing;

namespace {

using loop = std::vector<vec3>;

double signed_area(const loop& p) {
  double doubled = 0;
  for (std::size_t i = 1; i + 1 < p.size(); ++i) doubled += cross(p[i] - p[0], p[i + 1] - p[0]).z;
  return doubled / 2;
}

loop square(double x, double y, double half) { return {{x - half, y - half, 0}, {x + half, y - half, 0}, {x + half, y + half, 0}, {x - half, y + half, 0}}; }

loop star_shape(double x, double y, double radius, std::size_t n, std::mt19937& random) {
  std::uniform_real_distribution<double> part(0.5, 1);
  loop p;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n), r = radius * part(random);
    p.push_back({x + r * std::cos(angle), y + r * std::sin(angle), 0});
  }
  if (random() % 2) std::reverse(p.begin(), p.end());
  return p;
}

int euler(const trimesh& m) { return static_cast<int>(num_verts(m)) - static_cast<int>(num_edges(m)) + static_cast<int>(num_polys(m)); }

// Checks what holds for all graphs: counter-clockwise triangles, the area, segments that are edges.
void check_triangles(const planar_graph& g, const planar_triangulation& t, double expected_area) {
  CHECK(check_laws(t.mesh).empty());
  bool ccw = true;
  double sum = 0;
  for (const poly_id p : polys(t.mesh)) {
    const auto v = adj_p2v(t.mesh, p);
    ccw = ccw && orient2d(point(t.mesh, v[0]), point(t.mesh, v[1]), point(t.mesh, v[2])) > 0;
    sum += cross(point(t.mesh, v[1]) - point(t.mesh, v[0]), point(t.mesh, v[2]) - point(t.mesh, v[0])).z / 2;
  }
  CHECK(ccw);
  CHECK(sum == doctest::Approx(expected_area).epsilon(1e-12));
  const auto segments = g.segments();
  REQUIRE(t.segment_ends.size() == segments.size());
  bool joined = true;
  for (std::size_t s = 0; s < segments.size(); ++s)
    for (const edge_id e : t.edges_of(s)) {
      const auto [u, v] = end_verts(t.mesh, e);
      const vert_id a = t.vert_of[segments[s][0]], b = t.vert_of[segments[s][1]];
      joined = joined && ((u == a && v == b) || (u == b && v == a));
    }
  CHECK(joined);
}

// All outlines are in the mesh: one outer outline with holes that do not touch.
void check_region(const planar_graph& g, const planar_triangulation& t, double expected_area) {
  check_triangles(g, t, expected_area);
  const std::size_t n = g.points.size(), h = g.num_lines() - 1;
  REQUIRE(num_verts(t.mesh) == n);
  for (std::size_t i = 0; i < n; ++i) {
    CHECK(t.vert_of[i] == vert_id{i});
    CHECK(point(t.mesh, t.vert_of[i]) == g.points[i]);
  }
  CHECK(num_polys(t.mesh) == n + 2 * h - 2);
  CHECK(euler(t.mesh) == 1 - static_cast<int>(h));
  CHECK(t.constraints.size() == n);
  CHECK(t.segment_edges.size() == n);
  std::size_t boundary_edges = 0;
  for (const edge_id e : edges(t.mesh)) boundary_edges += is_boundary(t.mesh, e);
  CHECK(boundary_edges == n);
}

std::string error_of(const planar_graph& g, const triangulate_options& options = {}) {
  try {
    triangulate(g, options);
  } catch (const invalid_argument& e) {
    return e.what();
  }
  return "";
}

}  // namespace

TEST_CASE("triangulate: one outline, of any orientation, with heights") {
  const planar_graph g{{0, 0, 5}, {0, 2, 1}, {1, 1, 2}, {2, 2, 3}, {2, 0, 4}};
  check_region(g, triangulate(g), 3);
  check_region(loop{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, triangulate(loop{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), 0.5);
  const auto none = triangulate({});
  CHECK(num_verts(none.mesh) == 0);
  CHECK(none.vert_of.empty());
}

TEST_CASE("triangulate: a square with square holes") {
  planar_graph g(square(0, 0, 4));
  double expected = 64;
  for (const double x : {-2.0, 0.0, 2.0})
    for (const double y : {-2.0, 0.0, 2.0}) {
      g.add_outline(square(x, y, 0.5));
      expected -= 1;
    }
  check_region(g, triangulate(g), expected);
}

TEST_CASE("triangulate: star-shaped outlines with star-shaped holes") {
  std::mt19937 random(5);
  for (unsigned round = 0; round < (long_run() ? 2000u : 100u); ++round) {
    planar_graph g;
    loop outer = star_shape(0, 0, 10, 3 + random() % 60, random);
    for (vec3& p : outer) p = p * 4;  // its smallest radius is 20, if it has many points
    double expected = std::abs(signed_area(outer));
    g.add_outline(outer);
    if (outer.size() >= 12)
      for (std::size_t k = random() % 20; k-- > 0;) {
        const loop hole = star_shape(-8 + 4.0 * static_cast<double>(k % 5), -6 + 4.0 * static_cast<double>(k / 5), 1.9, 3 + random() % 20, random);
        expected -= std::abs(signed_area(hole));
        g.add_outline(hole);
      }
    check_region(g, triangulate(g), expected);
  }
}

TEST_CASE("triangulate: points of a small lattice, with many on common lines") {
  std::mt19937 random(7);
  unsigned refused = 0, filled = 0;
  for (unsigned round = 0; round < (long_run() ? 20000u : 2000u); ++round) {
    planar_graph g;
    for (std::size_t k = 1 + random() % 3; k-- > 0;) {
      loop p;
      for (std::size_t i = 3 + random() % 3; i-- > 0;) p.push_back({static_cast<int>(random() % 4), static_cast<int>(random() % 4), 0});
      g.add_outline(p);
    }
    try {
      const auto t = triangulate(g, {.merge_points = true});
      double covered = 0;  // by a count of outlines around the centres of small cells
      for (int x = 0; x < 24; ++x)
        for (int y = 0; y < 24; ++y) {
          const vec3 c{x / 8.0 + 0.0312345, y / 8.0 + 0.0467891, 0};
          bool inside = false, in_mesh = false;
          for (const auto& [a, b] : g.segments()) {
            const vec3 &p = g.points[a], &q = g.points[b];
            if ((p.y > c.y) != (q.y > c.y)) inside = inside != ((orient2d(p, q, c) > 0) == (q.y > p.y));
          }
          for (const poly_id f : polys(t.mesh)) {
            const auto v = adj_p2v(t.mesh, f);
            in_mesh = in_mesh || (orient2d(point(t.mesh, v[0]), point(t.mesh, v[1]), c) > 0 && orient2d(point(t.mesh, v[1]), point(t.mesh, v[2]), c) > 0 && orient2d(point(t.mesh, v[2]), point(t.mesh, v[0]), c) > 0);
          }
          covered += inside;
          if (inside != in_mesh) FAIL("cell ", x, " ", y, " of graph ", round);
        }
      check_triangles(g, t, total_measure(t.mesh));
      filled += covered > 0;
    } catch (const invalid_argument&) {
      ++refused;
    }
  }
  MESSAGE(filled, " graphs filled, ", refused, " refused");
  CHECK(filled > 100);
}

TEST_CASE("triangulate: large regions") {
  std::mt19937 random(9);
  planar_graph g(star_shape(0, 0, 100, 1500, random));
  double expected = std::abs(signed_area(g.points));
  for (int x = -2; x <= 2; ++x)
    for (int y = -2; y <= 2; ++y) {
      const loop hole = star_shape(15 * x, 15 * y, 7, 20, random);
      expected -= std::abs(signed_area(hole));
      g.add_outline(hole);
    }
  check_region(g, triangulate(g), expected);
  for (const bool upright : {false, true}) {  // combs whose teeth end on one line, with lines and points between them
    loop comb;
    for (int i = 0; i <= 1000; ++i) comb.push_back({i, i % 2 ? 1 : 5 + static_cast<int>(random() % 5), 0});
    comb.push_back({1000, 0, 0});
    comb.push_back({0, 0, 0});
    planar_graph c(comb);
    for (int i = 0; i < 1000; i += 2) c.add_isolated({i + 0.25, 0.5 + 0.25 * (i % 8), 0});
    for (int i = 1; i < 1000; i += 10) c.add_line(loop{{i + 0.5, 0.5, 0}, {i + 0.75, 0.25, 0}, {i + 1.5, 0.25, 0}});
    for (vec3& p : c.points)
      if (upright) p = {-p.y, p.x, 0};
    const auto t = triangulate(c);
    check_triangles(c, t, std::abs(signed_area(comb)));
    CHECK(num_verts(t.mesh) == c.points.size());
    CHECK(num_polys(t.mesh) == 2 * c.points.size() - comb.size() - 2);
    CHECK(t.segment_edges.size() == c.segments().size());
    CHECK(num_polys(triangulate(c, {.holes = {}}).mesh) == num_polys(t.mesh));
  }
}

TEST_CASE("triangulate: large regions with hole points") {
  loop circle;
  for (int i = 0; i < 1200; ++i) circle.push_back({std::cos(i * std::numbers::pi / 600), std::sin(i * std::numbers::pi / 600), 0});
  planar_graph g(circle);
  for (vec3& p : circle) p *= 0.5;
  g.add_outline(circle);
  const auto whole = triangulate(g, {.holes = {{0.75, 0, 0}}}), ring = triangulate(g, {.holes = {{0, 0, 0}}});
  check_triangles(g, whole, std::abs(signed_area(circle)));
  CHECK(num_polys(whole.mesh) == 1198);
  check_region(g, ring, 3 * std::abs(signed_area(circle)));
}

TEST_CASE("triangulate: islands within holes") {
  planar_graph g(square(0, 0, 5));
  g.add_outline(square(0, 0, 4));
  g.add_outline(square(0, 0, 3));
  g.add_outline(square(0, 0, 1));
  g.add_outline(square(20, 0, 1));
  const auto t = triangulate(g);
  check_triangles(g, t, 100 - 64 + 36 - 4 + 4);
  CHECK(euler(t.mesh) == 0 + 0 + 1);
  CHECK(num_polys(t.mesh) == 8 + 8 + 2);
}

TEST_CASE("triangulate: hole points instead of nested outlines") {
  planar_graph g(square(0, 0, 5));
  g.add_outline(square(-2, 0, 1));
  g.add_outline(square(2, 0, 1));
  auto t = triangulate(g, {.holes = {{-2, 0.5, 7}}});
  check_triangles(g, t, 96);
  CHECK(num_polys(t.mesh) == 16);
  CHECK(num_verts(t.mesh) == 12);
  CHECK(t.constraints.size() == 12);
  t = triangulate(g, {.holes = {{-2, 0.5, 7}, {2, 0, 0}, {1.5, 0, 0}}});
  check_triangles(g, t, 92);
  t = triangulate(g, {.holes = {{0, 0, 0}}});
  check_triangles(g, t, 8);
  CHECK(t.vert_of[0].is_none());
  CHECK(t.edges_of(0).empty());
  CHECK(t.edges_of(4).size() == 1);
  CHECK(error_of(g, {.holes = {{-2, 0, 0}, {6, 0, 0}}}) == "triangulate: hole point 1 lies in no bounded region");
  CHECK(error_of(g, {.holes = {{0, 5, 0}}}) == "triangulate: hole point 0 lies on segment 2 (points 3 and 2); it must be inside the hole");
  CHECK(error_of(g, {.holes = {{5, 5, 0}}}) == "triangulate: hole point 0 is at the place of point 2; it must be inside the hole");
  CHECK(error_of(g, {.holes = {{0, std::nan(""), 0}}}) == "triangulate: hole point 0 is not finite");
}

TEST_CASE("triangulate: holes that touch the outline or one another at a point") {
  planar_graph g(loop{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 2, 0}});
  g.add_outline(loop{{1, 1, 0}, {2, 2, 0}, {1, 3, 0}});
  const std::vector<std::uint32_t> touching{4, 5, 7};
  g.add_line_through(touching, true);  // touches the outline and, twice, the other hole: the holes share a segment
  const auto t = triangulate(g);
  check_triangles(g, t, 16 - 1 - 1);
  CHECK(num_polys(t.mesh) == 7);
  planar_graph bow(loop{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}});
  bow.add_outline(loop{{0, 0, 0}, {2, 1, 0}, {1, 2, 0}});
  CHECK(error_of(bow) == "triangulate: points 0 and 4 are at the same place; options.merge_points makes one vert of them");
  const auto merged = triangulate(bow, {.merge_points = true});
  check_triangles(bow, merged, 16 - 1.5);
  CHECK(merged.vert_of[4] == merged.vert_of[0]);
  CHECK(num_verts(merged.mesh) == 6);
  CHECK(num_polys(merged.mesh) == 5);
}

TEST_CASE("triangulate: open lines and isolated points") {
  planar_graph g(square(0, 0, 4));
  g.add_line(loop{{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}});
  g.add_line(loop{{-4, -4, 0}, {-3, -3, 0}});
  g.add_line(loop{{10, 0, 0}, {12, 0, 0}});
  const std::uint32_t inside = g.add_isolated({2, -2, 0}), outside = g.add_isolated({9, 9, 0}), unused = g.add_point({2, 2, 0});
  const std::uint32_t from_outline[]{0, 4};
  g.add_line_through(from_outline);
  CHECK(error_of(g).find("points") != std::string::npos);
  g.points[8] = {-3, -2, 0};
  g.points[9] = {-3, -2.5, 0};
  const auto t = triangulate(g);
  check_triangles(g, t, 64);
  CHECK(num_verts(t.mesh) == 4 + 4 + 2 + 1);
  CHECK(num_polys(t.mesh) == 2 * 11 - 4 - 2);
  CHECK(!t.vert_of[inside].is_none());
  CHECK(t.vert_of[outside].is_none());
  CHECK(t.vert_of[unused].is_none());
  CHECK(t.edges_of(4 + 3).size() == 1);
  CHECK(t.edges_of(4 + 3 + 1).empty());
}

TEST_CASE("triangulate: points on one line") {
  planar_graph g;
  loop comb;
  for (int i = 0; i <= 10; ++i) comb.push_back({0, i, 0});
  for (int i = 10; i >= 0; --i) comb.push_back({1, i, 0});
  g.add_outline(comb);
  check_region(g, triangulate(g), 10);
  planar_graph flat_;
  flat_.add_outline(loop{{0, 0, 0}, {0, 1, 0}, {0, 2, 0}});
  CHECK(error_of(flat_).find("overlap") != std::string::npos);
}

TEST_CASE("triangulate: seen from any direction") {
  planar_graph g(square(0, 0, 2));
  g.add_outline(square(0.25, 0, 1));
  for (const vec3& n : {vec3{1, 0, 0}, vec3{0, 1, 0}, vec3{0, 0, -1}, vec3{0, -2, 0}, vec3{1, 2, 3}, vec3{-3, 1, 1e-3}}) {
    planar_graph turned = g;
    const vec3 u = n / norm(n), b0 = cross(u, std::abs(u.z) < 0.9 ? vec3{0, 0, 1} : vec3{1, 0, 0}), b = b0 / norm(b0), a = cross(b, u);
    for (vec3& p : turned.points) p = p.x * a + p.y * b + 10 * u;
    const auto t = triangulate(turned, {.seen_from = n});
    CHECK(num_polys(t.mesh) == 8);
    vec3 sum;
    for (const poly_id p : polys(t.mesh)) {
      const auto v = adj_p2v(t.mesh, p);
      const vec3 part = cross(point(t.mesh, v[1]) - point(t.mesh, v[0]), point(t.mesh, v[2]) - point(t.mesh, v[0])) / 2;
      CHECK(dot(part, u) > 0);
      sum += part;
    }
    CHECK(dot(sum, u) == doctest::Approx(12).epsilon(1e-12));
  }
  CHECK(error_of(g, {.seen_from = {0, 0, 0}}) == "triangulate: seen_from must be finite and not 0");
  CHECK(error_of(g, {.seen_from = {1, 0, 0}}).find("at the same place") != std::string::npos);
}

TEST_CASE("triangulate: tiny, huge and far away") {
  for (const double scale : {1e-200, 1e-5, 1e5, 1e200}) {
    planar_graph g(square(0, 0, 4));
    g.add_outline(square(0, 0, 1));
    for (vec3& p : g.points) p *= scale;
    const auto t = triangulate(g);
    CHECK(num_polys(t.mesh) == 8);
  }
  planar_graph g(square(0, 0, 4));
  g.add_outline(square(0, 0, 1));
  for (vec3& p : g.points) p += vec3{0x1p50, 0x1p50, 0};
  check_region(g, triangulate(g), 60);
}

TEST_CASE("triangulate: slices and closed level lines are outlines") {
  slice_layer layer;
  layer.z = 0.5;
  const std::vector<slice_point> outer{{0, 0}, {3, 0}, {3, 3}, {0, 3}}, inner{{1, 1}, {1, 2}, {2, 2}, {2, 1}};
  layer.outer.push_back(outer);
  layer.inner.push_back(inner);
  planar_graph g;
  for (const auto* lines : {&layer.outer, &layer.inner})
    for (std::size_t i = 0; i < lines->size(); ++i) g.add_outline((*lines)[i], layer.z);
  check_region(g, triangulate(g), 8);
  CHECK(g.points[0].z == 0.5);
  planar_graph flat_;
  flat_.add_outline(outer);
  check_region(flat_, triangulate(flat_), 9);

  const quadmesh m = make_grid<quadmesh>({.cells = {20, 20}});
  auto u = make_vert_map<double>(m);
  for (const auto v : verts(m)) {
    const vec3 x = point(m, v) - vec3{0.5, 0.5, 0};
    u[v] = x.x * x.x + x.y * x.y;
  }
  planar_graph ring;
  for (const auto& line : isolines(m, u, {0.04, 0.16})) ring.add_line(line.points, line.closed);
  REQUIRE(ring.num_lines() == 2);
  check_region(ring, triangulate(ring), std::abs(signed_area({ring.points.begin() + static_cast<std::ptrdiff_t>(ring.line_ends[0]), ring.points.end()})) -
                                            std::abs(signed_area({ring.points.begin(), ring.points.begin() + static_cast<std::ptrdiff_t>(ring.line_ends[0])})));
}

TEST_CASE("triangulate: outlines may repeat their first point at the end") {
  loop outer = square(0, 0, 4), inner = square(0, 0, 1);
  outer.push_back(outer.front());
  inner.push_back(inner.front());
  planar_graph g(outer);
  g.add_outline(inner);
  const auto t = triangulate(g);
  check_triangles(g, t, 60);
  CHECK(num_verts(t.mesh) == 8);
  CHECK(g.segments().size() == 8);
  CHECK(t.constraints.size() == 8);
  CHECK(t.vert_of[4] == t.vert_of[0]);
  CHECK(t.vert_of[9] == t.vert_of[5]);
  CHECK(num_polys(triangulate(planar_graph(outer)).mesh) == 2);

  planar_graph by_numbers;
  for (const vec3& p : square(0, 0, 4)) by_numbers.add_point(p);
  const std::uint32_t ring[]{0, 1, 2, 3, 0};
  by_numbers.add_line_through(ring, true);
  check_triangles(by_numbers, triangulate(by_numbers), 64);
  CHECK(by_numbers.segments().size() == 4);

  CHECK(error_of(loop{{0, 0, 0}, {1, 0, 0}, {0, 0, 0}}) == "triangulate: line 0: an outline needs 3 points, but has 2");
  CHECK(error_of(loop{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) ==
        "triangulate: points 0 and 3 are at the same place; options.merge_points makes one vert of them");
}

TEST_CASE("triangulate: errors name lines, segments and points") {
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  CHECK(error_of(loop{{0, 0, 0}, {1, 0, 0}}) == "triangulate: line 0: an outline needs 3 points, but has 2");
  CHECK(error_of(loop{{0, 0, 0}, {1, 0, 0}, {nan, 1, 0}}) == "triangulate: point 2 is not finite");
  CHECK(error_of(loop{{0, 0, 0}, {1, 0, 0}, {0, 1, inf}}) == "triangulate: point 2 is not finite");
  CHECK(error_of(loop{{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}}) == "triangulate: segments 0 (points 0 and 1) and 2 (points 3 and 2) cross; divide them by a common point");
  CHECK(error_of(loop{{0, 0, 0}, {2, 0, 0}, {1, 2, 0}, {1, 0, 0}}) == "triangulate: segments 0 (points 0 and 1) and 3 (points 0 and 3) overlap");
  CHECK(error_of(loop{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 0, 0}, {1, 1, 0}}) == "triangulate: points 1 and 3 are at the same place; options.merge_points makes one vert of them");
  planar_graph g(square(0, 0, 4));
  g.add_line(loop{{0, 0, 0}});
  CHECK(error_of(g) == "triangulate: line 1: an open line needs 2 points, but has 1");
  g = planar_graph(square(0, 0, 4));
  const std::uint32_t wrong[]{0, 1, 7}, twice[]{0, 1, 1, 2}, diagonals[]{0, 2};
  g.add_line_through(wrong);
  CHECK(error_of(g) == "triangulate: line 1 names point 7, but there are 4");
  g = planar_graph(square(0, 0, 4));
  g.add_line_through(twice);
  CHECK(error_of(g) == "triangulate: segment 5 (points 1 and 1) has no length");
  g = planar_graph(square(0, 0, 4));
  g.add_line_through(diagonals);
  CHECK(num_polys(triangulate(g).mesh) == 2);
  g.isolated.push_back(4);
  CHECK(error_of(g) == "triangulate: isolated[0] names point 4, but there are 4");
  g = planar_graph(square(0, 0, 4));
  const std::uint32_t over[]{0, g.add_point({0, 0, 0})};
  g.add_line_through(diagonals);
  g.add_line_through(over);
  CHECK(error_of(g) == "triangulate: segments 4 (points 0 and 2) and 5 (points 0 and 4) overlap");
  g = planar_graph(square(0, 0, 4));
  g.line_closed.clear();
  CHECK(error_of(g) == "triangulate: line_closed has 0 entries for 1 lines");
  g = planar_graph(square(0, 0, 4));
  g.line_ends[0] = 5;
  CHECK(error_of(g) == "triangulate: line_ends[0] is 5; it must not be below the one before, and there are 4 line_points");
  g = planar_graph(square(0, 0, 4));
  g.add_isolated({4, 0, 0});
  CHECK(error_of(g) == "triangulate: point 4 lies on segment 1 (points 1 and 2); make it a point of the line");
}
