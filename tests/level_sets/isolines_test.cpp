#include <concino/level_sets/isolines.hpp>

#include <concino/core/error.hpp>
#include <concino/generate/icosphere.hpp>
#include <concino/generate/torus.hpp>

#include <support/kinds.hpp>
#include <support/level_sets.hpp>
#include <support/random_meshes.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

template<class Lines>
double total_length(const Lines& lines) {
  double sum = 0;
  for (const auto& line : lines) sum += length_of(line);
  return sum;
}

/// The length of {u = value} from the definition: of each triangle the segment between its parts; and each edge on the level set between a triangle that
/// has no smaller values and one that has no larger ones.
template<class U>
double length_by_definition(const trimesh& m, const U& u, double value) {
  double sum = 0;
  const auto at = [&](vert_id v) { return u[v] - value; };
  for (const auto p : polys(m)) {
    bool below = false, above = false;
    for (const auto v : adj_p2v(m, p)) below |= at(v) < 0, above |= at(v) > 0;
    if (!below || !above) continue;
    std::vector<vec3> ends;
    for (const auto v : adj_p2v(m, p))
      if (at(v) == 0) ends.push_back(point(m, v));
    for (const auto e : adj_p2e(m, p)) {
      const auto [a, b] = end_verts(m, e);
      if (at(a) * at(b) < 0) ends.push_back(point(m, a) + at(a) / (at(a) - at(b)) * (point(m, b) - point(m, a)));
    }
    REQUIRE(ends.size() == 2);
    sum += norm(ends[1] - ends[0]);
  }
  for (const auto e : edges(m)) {
    const auto [a, b] = end_verts(m, e);
    if (at(a) != 0 || at(b) != 0) continue;
    std::size_t polys_here = 0, below = 0;
    for (const auto p : adj_e2p(m, e)) {
      ++polys_here;
      for (const auto v : adj_p2v(m, p)) below += at(v) < 0;
    }
    if (polys_here == 2 && below == 1) sum += norm(point(m, a) - point(m, b));
  }
  return sum;
}

}  // namespace

TEST_CASE_TEMPLATE("isolines: every interior point is used by two segments", M, CONCINO_SURFACE_KINDS) {
  std::mt19937 random(1);
  std::size_t lines = 0, closed = 0;
  for (int i = 0; i < 1000; ++i) {
    const M m = mesh_to_cut<M>(random);
    const auto u = random_values(m, random, i % 2 == 0);
    const auto found = isolines(m, u, 1.0);
    INFO("mesh " << i);
    check_level_lines(m, found);
    lines += found.size();
    for (const auto& line : found) closed += line.closed;
  }
  CHECK(closed > 20);
  CHECK(lines - closed > 100);
}

TEST_CASE_TEMPLATE("isolines: on surfaces that are not manifold, lines end at edges with three polys or more", M, CONCINO_SURFACE_KINDS) {
  std::mt19937 random(4);
  for (int i = 0; i < 300; ++i) {
    const M m = random_mesh<M>(random);
    INFO("mesh " << i);
    check_level_lines(m, isolines(m, random_values(m, random, i % 2 == 0), 1.0));
  }
}

TEST_CASE("isolines: the length on triangles is that of the segments of each triangle") {
  std::mt19937 random(2);
  for (int i = 0; i < 200; ++i) {
    auto m = make_grid<trimesh>({.cells = {5, 5, 1}});
    jitter(m, 0.3, {.seed = random()});
    const auto u = random_values(m, random, i % 2 == 0);
    const double expected = length_by_definition(m, u, 1);
    CHECK(total_length(isolines(m, u, 1.0)) == doctest::Approx(expected).epsilon(1e-12));
  }
}

TEST_CASE_TEMPLATE("isolines: of a linear function they are straight, with larger values on their left", M, CONCINO_SURFACE_KINDS) {
  const vec3 direction{0.3, 0.9, 0};
  const M m = make_grid<M>({.cells = {7, 6, 1}});
  auto u = make_vert_map<double>(m);
  for (const auto v : verts(m)) u[v] = dot(direction, point(m, v));
  const std::vector<double> values{0.7, 0.1, 0.4, 0.4};
  const auto lines = isolines(m, u, values);
  REQUIRE(lines.size() == 3);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& line = lines[k];
    CHECK(line.value == std::vector{0.1, 0.4, 0.7}[k]);
    CHECK(!line.closed);
    CHECK(line.edge_points.size() == line.points.size());
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      CHECK(std::abs(dot(direction, line.points[i]) - line.value) <= 1e-12);
      const auto ends = end_verts(m, line.edge_points[i].edge);
      const vec3 at = point(m, ends.first) + line.edge_points[i].parameter * (point(m, ends.second) - point(m, ends.first));
      CHECK(norm(at - line.points[i]) <= 1e-12);
      if (i > 0) CHECK(dot(cross(vec3{0, 0, 1}, line.points[i] - line.points[i - 1]), direction) > 0);
    }
  }
}

namespace {

/// How far the length of a circle of radius 0.3 as a level set is from its circumference.
template<class M>
double error_of_circle(const M& m) {
  const vec3 centre{0.5, 0.5, 0};
  auto u = make_vert_map<double>(m);
  for (const auto v : verts(m)) u[v] = dot(point(m, v) - centre, point(m, v) - centre);
  const auto lines = isolines(m, u, 0.09);
  REQUIRE(lines.size() == 1);
  CHECK(lines[0].closed);
  return std::abs(total_length(lines) - 2 * 3.14159265358979324 * 0.3);
}

}  // namespace

TEST_CASE_TEMPLATE("isolines: the circumference of a circle is of order 2", M, CONCINO_SURFACE_KINDS) {
  const double coarse = error_of_circle(make_grid<M>({.cells = {16, 16, 1}})), fine = error_of_circle(make_grid<M>({.cells = {64, 64, 1}}));
  CHECK(coarse < 0.04);
  CHECK(fine < coarse / 8);
}

TEST_CASE("isolines: the circumference of a circle on polygons of random shapes") {
  double coarse = 0, fine = 0;  // means over random polygons; a single mesh may be right by chance
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto error = [&](std::uint32_t n) {
      const auto m = make_grid<polygonmesh>({.cells = {n, n, 1}});
      return error_of_circle(agglomerate(m, random_labels(m, 3, seed)));
    };
    coarse += error(16) / 20;
    fine += error(64) / 20;
  }
  CHECK(coarse < 0.04);
  CHECK(fine < coarse / 4);
}

TEST_CASE("isolines: on closed surfaces all lines are closed") {
  std::mt19937 random(3);
  const auto sphere = icosphere(2);
  const auto torus = make_torus<quadmesh>();
  for (int i = 0; i < 20; ++i) {
    for (const auto& line : isolines(sphere, random_values(sphere, random, i % 2 == 0), {0.5, 1.0, 1.5})) CHECK(line.closed);
    for (const auto& line : isolines(torus, random_values(torus, random, i % 2 == 0), 1.0)) CHECK(line.closed);
  }
}

TEST_CASE("isolines: where nothing is crossed there is no line") {
  const auto m = make_grid<quadmesh>({.cells = {3, 3, 1}});
  auto u = make_vert_map<double>(m);
  for (const auto v : verts(m)) u[v] = point(m, v).x;
  CHECK(isolines(m, u, -1.0).empty());
  CHECK(isolines(m, u, 2.0).empty());
  CHECK(isolines(m, u, 0.0).empty());  // touches the boundary
  CHECK(isolines(m, u, 1.0).empty());
  CHECK(isolines(m, u, std::vector<double>{}).empty());
  CHECK(isolines(m, u, std::numeric_limits<double>::infinity()).empty());
  const polygonmesh none;
  CHECK(isolines(none, make_vert_map<double>(none), 0.0).empty());
}

TEST_CASE("isolines: at a reflex corner the line follows the triangles of the polygon, and a diagonal has places without an edge") {
  // An L whose reflex corner alone is below.
  const polygonmesh m(surface_arrays{.points = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}},
                                     .offsets = {0, 6},
                                     .verts = {vert_id(0), vert_id(1), vert_id(2), vert_id(3), vert_id(4), vert_id(5)}});
  auto u = make_vert_map<double>(m, 1.0);
  u[vert_id(3)] = 0;
  const auto lines = isolines(m, u, 0.5);
  REQUIRE(lines.size() == 1);
  CHECK(!lines[0].closed);
  CHECK(lines[0].points.size() > 2);
  CHECK(lines[0].edge_points.size() == 2);
  for (const auto& x : lines[0].points) CHECK((x.x <= 1 || x.y <= 1));  // inside the L
}

TEST_CASE("isolines: errors name the vert, the map and the value") {
  const auto m = make_grid<trimesh>({.cells = {3, 3, 1}});
  const auto larger = make_grid<trimesh>({.cells = {4, 3, 1}});
  auto u = make_vert_map<double>(m, 1.0);
  CHECK_THROWS_AS((void)isolines(m, u, std::nan("")), invalid_argument);
  CHECK_THROWS_AS((void)isolines(larger, u, 1.0), invalid_argument);
  u[vert_id(5)] = std::nan("");
  const auto message = [&] {
    try {
      (void)isolines(m, u, 1.0);
    } catch (const invalid_argument& e) {
      return std::string(e.what());
    }
    return std::string();
  }();
  CHECK(message.find("vert 5") != std::string::npos);
}
