#include <concino/adapters/cgal_triangulate.hpp>
#include <concino/generate/triangulate.hpp>
#include <concino/geometry/corner_angles.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/validate/check_laws.hpp>

#include <doctest/doctest.h>
#include <support/corpus.hpp>
#include <support/profiled.hpp>

#include <numbers>
#include <random>

using namespace concino;
using namespace concino::testing;

namespace {

using loop = std::vector<vec3>;
using plane_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

loop square(double x, double y, double half) { return {{x - half, y - half, 0}, {x + half, y - half, 0}, {x + half, y + half, 0}, {x - half, y + half, 0}}; }

planar_graph plate(std::mt19937& random) {
  planar_graph g(square(0, 0, 10));
  std::uniform_real_distribution<double> part(0.5, 1);
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y) {
      loop hole;
      for (int i = 0; i < 12; ++i) {
        const double r = 2.5 * part(random);
        hole.push_back({6 * x + r * std::cos(i * std::numbers::pi / 6), 6 * y + r * std::sin(i * std::numbers::pi / 6), 0});
      }
      g.add_outline(hole);
    }
  g.add_line(loop{{-3, -9, 0}, {3, -9.5, 0}});
  g.add_isolated({3, 3.25, 0});
  return g;
}

double smallest_angle(const trimesh& m, poly_id p) {
  double least = 180;
  for (const vert_id v : adj_p2v(m, p)) least = std::min(least, corner_angle(m, p, v) * 180 / std::numbers::pi);
  return least;
}

double signed_area(const trimesh& m) {
  double sum = 0;
  for (const poly_id p : polys(m)) {
    const auto v = adj_p2v(m, p);
    sum += cross(point(m, v[1]) - point(m, v[0]), point(m, v[2]) - point(m, v[0])).z / 2;
  }
  return sum;
}

// Checks that segments are chains of edges, and that other edges are Delaunay edges.
void check_constrained_delaunay(const planar_graph& g, const planar_triangulation& t) {
  REQUIRE(check_laws(t.mesh).empty());
  const auto segments = g.segments();
  REQUIRE(t.segment_ends.size() == segments.size());
  for (std::size_t s = 0; s < segments.size(); ++s) {
    vert_id at = t.vert_of[segments[s][0]];
    double length = 0;
    for (const edge_id e : t.edges_of(s)) {
      const auto [u, v] = end_verts(t.mesh, e);
      REQUIRE((u == at || v == at));
      at = u == at ? v : u;
      length += distance(point(t.mesh, u), point(t.mesh, v));
      CHECK(std::binary_search(t.constraints.begin(), t.constraints.end(), e));
    }
    if (t.edges_of(s).empty()) continue;
    CHECK(at == t.vert_of[segments[s][1]]);
    CHECK(length == doctest::Approx(distance(g.points[segments[s][0]], g.points[segments[s][1]])));
  }
  bool delaunay = true, ccw = true;
  const auto in_plane = [&](vert_id v) { return plane_kernel::Point_2(point(t.mesh, v).x, point(t.mesh, v).y); };
  for (const poly_id p : polys(t.mesh)) {
    const auto v = adj_p2v(t.mesh, p);
    ccw = ccw && CGAL::orientation(in_plane(v[0]), in_plane(v[1]), in_plane(v[2])) == CGAL::LEFT_TURN;
    for (const edge_id e : adj_p2e(t.mesh, p))
      if (!std::binary_search(t.constraints.begin(), t.constraints.end(), e))
        for (const poly_id q : other_polys(t.mesh, p, e))
          for (const vert_id w : adj_p2v(t.mesh, q)) delaunay = delaunay && CGAL::side_of_oriented_circle(in_plane(v[0]), in_plane(v[1]), in_plane(v[2]), in_plane(w)) != CGAL::ON_POSITIVE_SIDE;
  }
  CHECK(ccw);
  CHECK(delaunay);
}

std::string error_of(const planar_graph& g, const cgal_triangulate_options& options = {}) {
  try {
    triangulate(g, cgal, options);
  } catch (const invalid_argument& e) {
    return e.what();
  }
  return "";
}

}  // namespace

TEST_CASE("triangulate with cgal: constrained Delaunay triangulations fill what those without new points fill") {
  std::mt19937 random(3);
  for (int round = 0; round < 5; ++round) {
    const planar_graph g = plate(random);
    const auto t = triangulate(g, cgal), other = triangulate(g);
    check_constrained_delaunay(g, t);
    CHECK(t.vert_of == other.vert_of);
    CHECK(num_polys(t.mesh) == num_polys(other.mesh));
    CHECK(t.constraints.size() == other.constraints.size());
    CHECK(signed_area(t.mesh) == doctest::Approx(signed_area(other.mesh)).epsilon(1e-12));
    for (const vert_id v : verts(t.mesh)) CHECK(point(t.mesh, v) == point(other.mesh, v));
    CHECK(t.small_angles.empty());
  }
}

TEST_CASE("triangulate with cgal: holes, islands and hulls") {
  planar_graph g(square(0, 0, 5));
  g.add_outline(square(-2, 0, 1));
  g.add_outline(square(2, 0, 1));
  g.add_outline(square(2, 0, 0.5));
  CHECK(signed_area(triangulate(g, cgal).mesh) == doctest::Approx(100 - 8 + 1));
  CHECK(signed_area(triangulate(g, cgal, {.holes = {{-2, 0.5, 0}}}).mesh) == doctest::Approx(96));
  const auto t = triangulate(g, cgal, {.holes = {{-2, 0.5, 0}, {0, 0, 0}}, .max_area = 0.1});
  check_constrained_delaunay(g, t);
  CHECK(signed_area(t.mesh) == doctest::Approx(4));
  CHECK(t.vert_of[0].is_none());
  CHECK(t.edges_of(0).empty());
  CHECK(t.edges_of(8).size() > 1);
  planar_graph points;
  for (int i = 0; i < 5; ++i) points.add_isolated({std::cos(i * 0.4 * std::numbers::pi), std::sin(i * 0.4 * std::numbers::pi), 0});
  points.add_isolated({0, 0, 0});
  CHECK(num_polys(triangulate(points, cgal).mesh) == 0);
  CHECK(num_polys(triangulate(points, cgal, {.convex_hull = true}).mesh) == 5);
  const auto fine = triangulate(points, cgal, {.convex_hull = true, .max_length = 0.25});
  CHECK(signed_area(fine.mesh) == doctest::Approx(2.5 * std::sin(0.4 * std::numbers::pi)));
  const planar_graph open_corner(loop{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1.5, 0.5, 0}});
  CHECK(signed_area(triangulate(open_corner, cgal, {.convex_hull = true}).mesh) == doctest::Approx(2));
  CHECK(num_polys(triangulate({}, cgal, {.convex_hull = true, .min_angle_deg = 20}).mesh) == 0);
  planar_graph line;
  line.add_line(loop{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
  CHECK(num_verts(triangulate(line, cgal, {.convex_hull = true, .min_angle_deg = 20}).mesh) == 0);
  line.add_isolated({1, 1, 0});
  CHECK(num_polys(triangulate(line, cgal, {.convex_hull = true}).mesh) == 2);
  CHECK(error_of(g, {.holes = {{6, 0, 0}}}) == "triangulate: hole point 0 lies in no bounded region");
  CHECK(error_of({}, {.holes = {{6, 0, 0}}}) == "triangulate: hole point 0 lies in no bounded region");
}

TEST_CASE("triangulate with cgal: refinement meets its bounds, except at small angles, which are listed") {
  std::mt19937 random(4);
  const planar_graph g = plate(random);
  const double whole = signed_area(triangulate(g).mesh);
  for (const double angle : {0.0, 20.0, 25.0, 30.0}) {
    const auto t = triangulate(g, cgal, {.min_angle_deg = angle, .max_area = 2, .max_length = 3});
    check_constrained_delaunay(g, t);
    CHECK(signed_area(t.mesh) == doctest::Approx(whole).epsilon(1e-9));
    for (const poly_id p : polys(t.mesh)) {
      CHECK(area(t.mesh, p) <= 2);
      for (const edge_id e : adj_p2e(t.mesh, p)) CHECK(distance(point(t.mesh, end_verts(t.mesh, e).first), point(t.mesh, end_verts(t.mesh, e).second)) <= 3);
      if (!std::binary_search(t.small_angles.begin(), t.small_angles.end(), p)) CHECK(smallest_angle(t.mesh, p) >= angle - 1e-6);
    }
    CHECK(t.small_angles.size() * 20 <= num_polys(t.mesh));
    for (std::size_t i = 0; i < g.points.size(); ++i) CHECK(t.vert_of[i] == vert_id{i});
  }
  const planar_graph wedge(loop{{0, 0, 0}, {10, 0, 0}, {10, 1, 0}});
  const auto sharp = triangulate(wedge, cgal, {.min_angle_deg = 25});
  REQUIRE(!sharp.small_angles.empty());
  for (const poly_id p : sharp.small_angles) CHECK(smallest_angle(sharp.mesh, p) < 25);
  for (const poly_id p : polys(sharp.mesh))
    if (!std::binary_search(sharp.small_angles.begin(), sharp.small_angles.end(), p)) CHECK(smallest_angle(sharp.mesh, p) >= 25 - 1e-6);
  CHECK(sharp.small_angles.size() < 5);
}

TEST_CASE("triangulate with cgal: outlines and lines that touch, with collinear points") {
  std::mt19937 random(11);
  unsigned filled = 0;
  for (unsigned round = 0; round < (long_run() ? 20000u : 1500u); ++round) {
    planar_graph g;
    for (auto k = 1 + random() % 4; k-- > 0;) {
      loop p;
      for (auto i = 3 + random() % 2; i-- > 0;) p.push_back({static_cast<int>(random() % 4), static_cast<int>(random() % 4), 0});
      g.add_line(p, random() % 4 != 0);
    }
    const std::vector<vec3> holes = random() % 2 ? std::vector<vec3>{} : std::vector<vec3>{{1.28, 1.37, 0}};
    planar_triangulation t;
    try {
      t = triangulate(g, {.holes = holes, .merge_points = true});
    } catch (const invalid_argument& e) {
      CHECK(error_of(g, {.holes = holes, .merge_points = true}) == e.what());
      continue;
    }
    const auto c = triangulate(g, cgal, {.holes = holes, .merge_points = true});
    REQUIRE(c.vert_of == t.vert_of);
    REQUIRE(num_polys(c.mesh) == num_polys(t.mesh));
    REQUIRE(c.segment_ends == t.segment_ends);
    REQUIRE(signed_area(c.mesh) == doctest::Approx(signed_area(t.mesh)));
    filled += num_polys(t.mesh) > 0;
    if (round % 8 != 0) continue;
    const auto fine = triangulate(g, cgal, {.holes = holes, .min_angle_deg = 20.7, .merge_points = true, .max_verts = 100'000});
    check_constrained_delaunay(g, fine);
    CHECK(signed_area(fine.mesh) == doctest::Approx(signed_area(t.mesh)));
  }
  CHECK(filled > 50);
}

TEST_CASE("triangulate with cgal: a sizing function, at any scale") {
  for (const double scale : {1.0, 1e-6, 1e6}) {
    planar_graph g(square(0, 0, 4));
    for (vec3& p : g.points) p *= scale;
    const auto size = [&](const vec3& x) { return scale * 0.1 + 0.3 * norm(x); };
    const auto t = triangulate(g, cgal, {.min_angle_deg = 20, .size = size});
    check_constrained_delaunay(g, t);
    for (const poly_id p : polys(t.mesh)) {
      vec3 centre;
      double longest = 0;
      for (const vert_id v : adj_p2v(t.mesh, p)) centre += point(t.mesh, v) / 3;
      for (const edge_id e : adj_p2e(t.mesh, p)) longest = std::max(longest, distance(point(t.mesh, end_verts(t.mesh, e).first), point(t.mesh, end_verts(t.mesh, e).second)));
      CHECK(longest <= size(centre) * (1 + 1e-9));
    }
    CHECK(num_polys(t.mesh) > 200);
    CHECK(num_polys(t.mesh) < 2000);
  }
}

TEST_CASE("triangulate with cgal: heights of new verts, seen from any direction") {
  const auto height = [](const vec3& p) { return 0.25 * p.x - 0.5 * p.y + 3; };
  planar_graph g(square(0, 0, 4));
  g.add_outline(square(0, 0, 1));
  for (vec3& p : g.points) p.z = height(p);
  const auto t = triangulate(g, cgal, {.max_length = 0.5});
  check_constrained_delaunay(g, t);
  CHECK(num_verts(t.mesh) > 400);
  for (const vert_id v : verts(t.mesh)) CHECK(point(t.mesh, v).z == doctest::Approx(height(point(t.mesh, v))));
  planar_graph turned = g;
  for (vec3& p : turned.points) p = {p.z, p.x, p.y};
  const auto side = triangulate(turned, cgal, {.max_length = 0.5, .seen_from = {2, 0, 0}});
  REQUIRE(num_verts(side.mesh) == num_verts(t.mesh));
  for (const vert_id v : verts(t.mesh)) CHECK(norm(point(side.mesh, v) - vec3{point(t.mesh, v).z, point(t.mesh, v).x, point(t.mesh, v).y}) < 1e-12);
  planar_graph roof(loop{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}});
  roof.add_line(loop{{0.5, 1, 1}, {1.5, 1, 1}});
  const auto tiles = triangulate(roof, cgal, {.max_length = 0.2});
  double top = 0;
  for (const vert_id v : verts(tiles.mesh)) top = std::max(top, point(tiles.mesh, v).z);
  CHECK(top == 1);
  for (const edge_id e : tiles.edges_of(4)) CHECK(point(tiles.mesh, end_verts(tiles.mesh, e).first).z == 1);
}

TEST_CASE("triangulate with cgal: outlines may repeat their first point at the end") {
  loop outer = square(0, 0, 4);
  outer.push_back(outer.front());
  planar_graph g(outer);
  const auto t = triangulate(g, cgal);
  check_constrained_delaunay(g, t);
  CHECK(num_verts(t.mesh) == 4);
  CHECK(t.vert_of[4] == t.vert_of[0]);
  g.add_line(loop{{-5, 0, 0}, {5, 0, 0}});
  const auto divided = triangulate(g, cgal, {.divide_segments = true});
  CHECK(signed_area(divided.mesh) == doctest::Approx(64));
  CHECK(divided.edges_of(3).size() == 2);
}

TEST_CASE("triangulate with cgal: segments that meet are divided if asked for") {
  // a bow tie: two triangles, and a vert where its diagonals cross
  const planar_graph bow(loop{{0, 0, 0}, {2, 2, 4}, {2, 0, 0}, {0, 2, 0}});
  const auto t = triangulate(bow, cgal, {.divide_segments = true});
  REQUIRE(num_polys(t.mesh) == 2);
  REQUIRE(num_verts(t.mesh) == 5);
  CHECK(point(t.mesh, vert_id{4}) == vec3{1, 1, 2});  // with the height of the first diagonal
  CHECK(t.vert_of == std::vector<vert_id>{vert_id{0}, vert_id{1}, vert_id{2}, vert_id{3}});
  REQUIRE(t.segment_ends.size() == 4);
  for (std::size_t s = 0; s < 4; ++s) CHECK(t.edges_of(s).size() == (s % 2 == 0 ? 2 : 1));
  for (const std::size_t s : {0u, 2u}) {  // in order along the segment
    const auto [a, b] = end_verts(t.mesh, t.edges_of(s)[0]);
    CHECK((a == vert_id{s} || b == vert_id{s}));
  }

  // a square with a line through it, one along a part of a side, one from a point in a side, and a point on a line
  planar_graph g(square(0, 0, 2));
  g.add_line(loop{{-3, 0.5, 0}, {3, 0.5, 0}});
  g.add_line(loop{{-1, -2, 0}, {1, -2, 0}});
  g.add_line(loop{{-2, -1, 0}, {1, -1, 0}});
  g.add_isolated({1.5, 0.5, 0});
  CHECK(error_of(g) != "");
  for (const double bound : {100.0, 0.4}) {
    const auto divided = triangulate(g, cgal, {.max_length = bound, .divide_segments = true});
    CHECK(check_laws(divided.mesh).empty());
    CHECK(total_measure(divided.mesh) == doctest::Approx(16).epsilon(1e-14));
    REQUIRE(divided.segment_ends.size() == 7);
    const auto length = [&](std::size_t s) {
      double sum = 0;
      for (const edge_id e : divided.edges_of(s)) sum += measure(divided.mesh, e);
      return sum;
    };
    CHECK(length(0) == doctest::Approx(4));
    CHECK(length(4) == doctest::Approx(4));  // the part inside
    CHECK(length(5) == doctest::Approx(2));
    CHECK(length(6) == doctest::Approx(3));
  }

  // random segments in a square, seen along an axis and aslant
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-2, 2);
  for (const vec3& from : {vec3{0, 0, 1}, vec3{0.3, -0.2, 1}})
    for (int i = 0; i < (long_run() ? 200 : 3); ++i) {
      planar_graph many(square(0, 0, 2));
      for (int k = 0; k < 30; ++k) many.add_line(loop{{place(random), place(random), 0}, {place(random), place(random), 0}});
      const auto m = triangulate(many, cgal, {.seen_from = from, .divide_segments = true}).mesh;
      CHECK(check_laws(m).empty());
      CHECK(total_measure(m) == doctest::Approx(16).epsilon(1e-12));
    }
}

TEST_CASE("triangulate with cgal: errors") {
  const planar_graph g(square(0, 0, 4));
  const double nan = std::nan("");
  CHECK(error_of(g, {.min_angle_deg = 34}) == "triangulate: options.min_angle_deg must be from 0 to 33, because larger angles are rarely reached, but is 34");
  CHECK(error_of(g, {.min_angle_deg = nan}).find("min_angle_deg") != std::string::npos);
  CHECK(error_of(g, {.max_area = 0}) == "triangulate: options.max_area must be above 0, but is 0");
  CHECK(error_of(g, {.max_length = -1}) == "triangulate: options.max_length must be above 0, but is -1");
  CHECK(error_of(g, {.size = [](const vec3& x) { return x.x; }}).find("triangulate: options.size is ") == 0);
  CHECK(error_of(g, {.max_length = 0.001, .max_verts = 1000}) ==
        "triangulate: refinement needs more than options.max_verts = 1000 verts; allow more, larger triangles, or smaller angles (it is known to end up to 20.7 degrees)");
  CHECK(error_of(loop{{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}}) == "triangulate: segments 0 (points 0 and 1) and 2 (points 3 and 2) cross; divide them by a common point");
  CHECK_THROWS_AS(triangulate(g, cgal, {.max_length = 0.01, .progress = [](double, const char*) { return false; }}), cancelled);
  profiler p;
  triangulate(g, cgal, {.max_length = 0.5, .profiler = &p});
  CHECK(names_of(p).at(0) == "triangulate");
}
