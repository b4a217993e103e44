#include <concino/generate/random_points.hpp>
#include <concino/generate/voronoi_polygons.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/validate/check_laws.hpp>
#include <concino/validate/validate.hpp>

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>

using namespace concino;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

box rectangle(vec3 low, vec3 high) {
  box b;
  b.min = low;
  b.max = high;
  return b;
}
const box unit_square = rectangle({0, 0, 0}, {1, 1, 0});

/// Checks that the mesh is conforming, without gaps, convex, and covers the rectangle.
void check_sound(const polygonmesh& m, std::size_t sites, const box& b) {
  REQUIRE(num_polys(m) == sites);
  CHECK(check_laws(m).empty());
  CHECK(static_cast<long>(num_verts(m)) - static_cast<long>(num_edges(m)) + static_cast<long>(num_polys(m)) == 1);
  const vec3 side = b.max - b.min;
  CHECK(total_measure(m) == doctest::Approx(side.x * side.y).epsilon(1e-12));
  bool sound = true;
  for (const auto v : verts(m)) {
    sound = sound && point(m, v).z == b.min.z && adj_v2p(m, v).begin() != adj_v2p(m, v).end();
  }
  for (const auto p : polys(m)) sound = sound && area_vector(m, p).z > 0;
  for (const auto e : edges(m)) {  // edges of one poly are on the boundary of the rectangle only
    int n = 0;
    for ([[maybe_unused]] const auto p : adj_e2p(m, e)) ++n;
    if (n == 2) continue;
    std::vector<vec3> ends;
    for (const auto v : adj_e2v(m, e)) ends.push_back(point(m, v));
    const vec3 x = ends[0], y = ends[1];
    sound = sound && n == 1 && ((x.x == y.x && (x.x == b.min.x || x.x == b.max.x)) || (x.y == y.y && (x.y == b.min.y || x.y == b.max.y)));
  }
  CHECK(sound);
}

/// The largest distance of x beyond an edge of the convex poly p.
double outside(const polygonmesh& m, poly_id p, const vec3& x) {
  std::vector<vec3> loop;
  for (const auto v : adj_p2v(m, p)) loop.push_back(point(m, v));
  double most = -infinity;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const vec3 a = loop[k], d = loop[(k + 1) % loop.size()] - a;
    most = std::max(most, (d.y * (x.x - a.x) - d.x * (x.y - a.y)) / norm(d));
  }
  return most;
}

std::size_t nearest(const std::vector<vec3>& sites, const vec3& x) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < sites.size(); ++i)
    if (std::hypot(sites[i].x - x.x, sites[i].y - x.y) < std::hypot(sites[best].x - x.x, sites[best].y - x.y)) best = i;
  return best;
}

}  // namespace

TEST_CASE("voronoi_polygons: each point lies in the cell of its nearest site") {
  for (const std::size_t n : {1u, 2u, 3u, 10u, 700u}) {
    const box b = rectangle({-3, 10, 2}, {5, 11, 7});
    const auto sites = random_points(n, b, n);
    const polygonmesh m = voronoi_polygons(sites, b);
    check_sound(m, n, b);
    for (const vec3& x : random_points(500, b, 99)) CHECK(outside(m, poly_id{nearest(sites, x)}, x) < 1e-12);
  }
}

TEST_CASE("voronoi_polygons: sites on grids and circles give squares, hexagons and sectors") {
  for (const unsigned n : {2u, 3u, 7u, 10u}) {
    std::vector<vec3> sites;
    for (unsigned j = 0; j < n; ++j)
      for (unsigned i = 0; i < n; ++i) sites.push_back({(i + 0.5) / n, (j + 0.5) / n, 0});
    const polygonmesh m = voronoi_polygons(sites, unit_square);
    check_sound(m, n * n, unit_square);
    CHECK(num_verts(m) == (n + 1) * (n + 1));
    CHECK(num_edges(m) == 2 * n * (n + 1));
    for (const auto p : polys(m)) CHECK(measure(m, p) == doctest::Approx(1.0 / (n * n)).epsilon(1e-12));
    // the same with some sites on the boundary
    sites.clear();
    for (unsigned j = 0; j <= n; ++j)
      for (unsigned i = 0; i <= n; ++i) sites.push_back({double(i) / n, double(j) / n, 0});
    const polygonmesh w = voronoi_polygons(sites, unit_square);
    check_sound(w, (n + 1) * (n + 1), unit_square);
    CHECK(num_verts(w) == (n + 2) * (n + 2));
  }
  for (const unsigned n : {3u, 4u, 12u, 50u}) {
    std::vector<vec3> sites;
    for (unsigned i = 0; i < n; ++i) {
      const double angle = 6.283185307179586 * i / n;
      sites.push_back({0.5 + 0.25 * std::cos(angle), 0.5 + 0.25 * std::sin(angle), 0});
    }
    const polygonmesh m = voronoi_polygons(sites, unit_square);
    check_sound(m, n, unit_square);
    std::size_t in_centre = 0;
    for (const auto v : verts(m))
      if (norm(point(m, v) - vec3{0.5, 0.5, 0}) < 1e-9)
        for ([[maybe_unused]] const auto p : adj_v2p(m, v)) ++in_centre;
    CHECK(in_centre == n);
  }
}

TEST_CASE("voronoi_polygons: accepts sites on a line, in a cluster, in a long box") {
  std::vector<vec3> line;
  for (int i = 0; i < 40; ++i) line.push_back({(i + 0.5) / 40, 0.3, 0});
  check_sound(voronoi_polygons(line, unit_square), 40, unit_square);
  std::vector<vec3> diagonal;
  for (int i = 0; i < 40; ++i) diagonal.push_back({i / 41.0, i / 41.0, 0});
  check_sound(voronoi_polygons(diagonal, unit_square), 40, unit_square);

  auto cluster = random_points(200, rectangle({0.3, 0.3, 0}, {0.3 + 1e-6, 0.3 + 1e-6, 0}), 4);
  for (const vec3& x : random_points(20, unit_square, 5)) cluster.push_back(x);
  const polygonmesh c = voronoi_polygons(cluster, unit_square);
  check_sound(c, 220, unit_square);
  for (const vec3& x : random_points(500, unit_square, 7)) CHECK(outside(c, poly_id{nearest(cluster, x)}, x) < 1e-12);
  const box thin = rectangle({0, 0, 0}, {1000, 1e-3, 0});
  check_sound(voronoi_polygons(random_points(300, thin, 6), thin), 300, thin);
}

TEST_CASE("voronoi_polygons: scales exactly") {
  const auto sites = random_points(50, unit_square, 3);
  const polygonmesh m = voronoi_polygons(sites, unit_square);
  for (const double scale : {0x1p-300, 0x1p-20, 0x1p20, 0x1p300}) {
    auto scaled = sites;
    for (vec3& x : scaled) x *= scale;
    const polygonmesh s = voronoi_polygons(scaled, rectangle({0, 0, 0}, {scale, scale, 0}));
    REQUIRE(num_verts(s) == num_verts(m));
    for (const auto v : verts(m)) CHECK(point(s, v) == scale * point(m, v));
  }
}

TEST_CASE("voronoi_polygons: relaxation makes the sizes of cells more uniform") {
  const auto sites = random_points(100, unit_square, 8);
  const auto spread = [](const polygonmesh& m) {
    double squares = 0;
    for (const auto p : polys(m)) squares += (measure(m, p) - 0.01) * (measure(m, p) - 0.01);
    return squares;
  };
  const polygonmesh relaxed = voronoi_polygons(sites, unit_square, {.relax = 10});
  check_sound(relaxed, 100, unit_square);
  CHECK(spread(relaxed) < 0.1 * spread(voronoi_polygons(sites, unit_square)));
}

TEST_CASE("voronoi_polygons: accepts any container and braces") {
  const std::array<std::array<float, 3>, 2> sites{{{0.25f, 0.5f, 9}, {0.75f, 0.5f, -9}}};
  CHECK(total_measure(voronoi_polygons(sites, unit_square)) == 1);
  const polygonmesh m = voronoi_polygons({{0.25, 0.5, 0}, {0.5, 0.5, 0}, {0.875, 0.5, 0}}, unit_square);
  CHECK(num_verts(m) == 8);
  CHECK(measure(m, poly_id{0}) == 0.375);
}

TEST_CASE("voronoi_polygons: throws if a site or the rectangle is invalid") {
  const auto refused = [](const std::vector<vec3>& sites, const box& b, const char* why) {
    try {
      voronoi_polygons(sites, b);
      FAIL("not refused");
    } catch (const invalid_argument& e) {
      CHECK_MESSAGE(std::string(e.what()).find(why) != std::string::npos, e.what());
    }
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  refused({}, unit_square, "at least one site");
  refused({{0.5, 0.5, 0}, {0.5, 1.5, 0}}, unit_square, "site 1 ");
  refused({{0.5, nan, 0}}, unit_square, "site 0 ");
  refused({{0.1, 0.1, 0}, {0.5, 0.5, 0}, {0.7, 0.7, 0}, {0.5, 0.5, 1}}, unit_square, "sites 1 and 3 ");
  refused({{0, 0, 0}}, rectangle({0, 0, 0}, {1, 0, 0}), "box");
  refused({{0, 0, 0}}, rectangle({0, 0, 0}, {1, infinity, 0}), "box");
  refused({{0, 0, 0}}, rectangle({0, 0, 0}, {1, 1e-12, 0}), "box");
  refused({{0, 0, 0}}, rectangle({0, 0, nan}, {1, 1, 0}), "box");
  refused({{0, 0, 0}}, rectangle({-1.7e308, 0, 0}, {1.7e308, 1, 0}), "box");
  // three collinear sites so close that the cell between them is thinner than rounding errors
  refused({{0.5, 0.5, 0}, {0.5 + 0x1p-45, 0.5, 0}, {0.5 + 0x1p-44, 0.5, 0}}, unit_square, "site 1 ");
}

TEST_CASE("voronoi_polygons: cells in a convex outline fill it") {
  const auto check = [](const std::vector<vec3>& outline, double area, std::size_t corners) {
    box b;
    for (const vec3& x : outline) b.add(x);
    std::vector<vec3> sites;  // those inside
    const polygonmesh whole(outline, std::vector<std::vector<unsigned>>{[&] {
                              std::vector<unsigned> ring(outline.size());
                              for (unsigned k = 0; k < ring.size(); ++k) ring[k] = k;
                              if (area < 0) std::reverse(ring.begin(), ring.end());
                              return ring;
                            }()});
    for (const vec3& x : random_points(300, b, 5))
      if (outside(whole, poly_id{0}, x) < 0) sites.push_back(x);
    REQUIRE(sites.size() > 20);
    sites.push_back(outline[0]);
    for (const unsigned relax : {0u, 2u}) {
      const polygonmesh m = voronoi_polygons(sites, outline, {.relax = relax});
      REQUIRE(num_polys(m) == sites.size());
      CHECK(check_laws(m).empty());
      CHECK(num_verts(m) + num_polys(m) == num_edges(m) + 1);
      CHECK(total_measure(m) == doctest::Approx(std::abs(area)).epsilon(1e-12));
      bool is_convex = true;
      for (const poly_id p : polys(m)) is_convex &= area_vector(m, p).z > 0;
      CHECK(is_convex);
      std::size_t found = 0;
      for (const vert_id v : verts(m)) {
        CHECK(point(m, v).z == outline[0].z);
        if (adj_v2p(m, v).size() > 1) continue;
        for (const vec3& x : outline) found += norm(point(m, v) - vec3{x.x, x.y, outline[0].z}) < 1e-12;
      }
      CHECK(found == corners);
      if (relax == 0)
        for (const vec3& x : random_points(200, b, 6))
          if (outside(whole, poly_id{0}, x) < 0) CHECK(outside(m, poly_id{nearest(sites, x)}, x) < 1e-12);
    }
  };
  check({{0, 0, 2}, {3, 0, 2}, {1, 2, 2}}, 3, 3);
  check({{1, 2, 2}, {3, 0, 2}, {0, 0, 2}}, -3, 3);
  check({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {0, 1, 0}}, 2, 4);  // with points within sides
  std::vector<vec3> circle;
  for (unsigned k = 0; k < 40; ++k) circle.push_back({5 + std::cos(0.15707963267948966 * k), std::sin(0.15707963267948966 * k), 0});
  check(circle, 20 * std::sin(0.15707963267948966), 40);
}

TEST_CASE("voronoi_polygons: a rectangle as an outline gives the same cells, and one site fills the outline") {
  const std::vector<vec3> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const auto sites = random_points(60, unit_square, 3);
  const polygonmesh m = voronoi_polygons(sites, square), same = voronoi_polygons(sites, unit_square);
  REQUIRE(num_edges(m) == num_edges(same));
  for (const poly_id p : polys(m)) CHECK(measure(m, p) == doctest::Approx(measure(same, p)).epsilon(1e-11));
  const polygonmesh one = voronoi_polygons({{0.5, 0.5, 9}}, square);
  CHECK(num_verts(one) == 4);
  CHECK(total_measure(one) == doctest::Approx(1).epsilon(1e-13));
  for (const double y : {1e-13, -1e-13}) CHECK(num_verts(voronoi_polygons({{0.5, 0.5, 9}}, std::vector<vec3>{square[0], {0.5, y, 0}, square[1], square[2], square[3]})) == 4);
}

TEST_CASE("voronoi_polygons: outlines with any directions, repeated points and points within their segments") {
  std::mt19937 random(4);
  for (int round = 0; round < 40; ++round) {
    // Sides in both directions of random vectors, by their angles, are those of a convex polygon.
    std::vector<vec3> sides;
    for (int k = 0; k < 2 + round % 4; ++k) {
      const vec3 d{2 * (static_cast<double>(random() % 9) - 4), 2 * (static_cast<double>(random() % 9) - 4), 0};
      if (d != vec3()) sides.push_back(d), sides.push_back(-d);
    }
    std::sort(sides.begin(), sides.end(), [](const vec3& a, const vec3& b) { return std::atan2(a.y, a.x + 0.0) < std::atan2(b.y, b.x + 0.0); });
    std::vector<vec3> corners, outline;
    vec3 at{100, -50, 0};
    double area = 0;
    for (std::size_t k = 0; k < sides.size(); ++k) {
      if (k == 0 || cross(sides[k], sides[k - 1]) != vec3()) corners.push_back(at);
      outline.push_back(at);
      if (random() % 3 == 0) outline.push_back(at);
      if (random() % 2 == 0) outline.push_back(at + 0.5 * sides[k]);
      area += cross(at - vec3{100, -50, 0}, sides[k]).z / 2;
      at += sides[k];
    }
    if (!(area > 0)) continue;
    std::rotate(outline.begin(), outline.begin() + static_cast<std::ptrdiff_t>(random() % outline.size()), outline.end());
    if (round % 2 == 0) outline.push_back(outline[0]);
    if (round % 3 == 0) std::reverse(outline.begin(), outline.end());
    std::vector<vec3> sites = corners;
    vec3 centre;
    for (const vec3& x : corners) centre += x / static_cast<double>(corners.size());
    for (const vec3& x : corners) sites.push_back(centre + 0.625 * (x - centre));
    const polygonmesh m = voronoi_polygons(sites, outline);
    CHECK(total_measure(m) == doctest::Approx(area).epsilon(1e-12));
    CHECK(num_verts(m) + num_polys(m) == num_edges(m) + 1);
    std::size_t in_one_cell = 0;
    for (const vert_id v : verts(m)) {
      if (adj_v2p(m, v).size() != 1) continue;
      ++in_one_cell;
      CHECK(norm(point(m, v) - corners[nearest(corners, point(m, v))]) < 1e-11);
    }
    CHECK(in_one_cell == corners.size());
    const std::vector<vec3> once = outline;
    outline.insert(outline.end(), once.begin(), once.end());
    CHECK_THROWS_WITH_AS(voronoi_polygons(sites, outline), "Voronoi diagram: the outline is not convex: it winds around its inside more than once", invalid_argument);
  }
}

TEST_CASE("voronoi_polygons: throws if the outline is not convex or a site is outside of it") {
  const auto message = [](const std::vector<vec3>& outline, const std::vector<vec3>& sites = {{0.5, 0.25, 0}}) -> std::string {
    try {
      voronoi_polygons(sites, outline);
    } catch (const invalid_argument& e) {
      return e.what();
    }
    return "";
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(message({}) == "Voronoi diagram: the outline has 0 points; it must have 3 or more");
  CHECK(message({{0, 0, 0}, {1, 0, 0}}) == "Voronoi diagram: the outline has 2 points; it must have 3 or more");
  CHECK(message({{0, 0, nan}, {1, 0, 0}, {0, 1, 0}}) == "Voronoi diagram: point 0 of the outline is not finite");
  CHECK(message({{nan, 0, 0}, {1, 0, 0}, {0, 1, 0}}) == "Voronoi diagram: point 0 of the outline is not finite");
  CHECK(message({{0, 0, 0}, {1, 0, nan}, {0, 1, nan}}, {{0.25, 0.25, nan}}) == "");
  CHECK(message({{0, 0, 0}, {1, nan, 0}, {0, 1, 0}}) == "Voronoi diagram: point 1 of the outline is not finite");
  CHECK(message({{0, 0, 0}, {1, 0, 0}, {0.5, 0, 0}, {0.25, 0, 0}}, {{0.5, 0, 0}}) == "Voronoi diagram: the outline has no area");
  CHECK(message({{0, 0, 0}, {1, 1, 0}, {2, 2 + 1e-13, 0}}, {{1, 1, 0}}) == "Voronoi diagram: the outline has no area");
  CHECK(message({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}).find("Voronoi diagram: ") == 0);
  CHECK(message({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0.6, 0.4, 0}, {0, 1, 0}}) == "Voronoi diagram: the outline is not convex at point 3");
  CHECK(message({{0, 1, 0}, {0.6, 0.4, 0}, {1, 1, 0}, {1, 0, 0}, {0, 0, 0}}) == "Voronoi diagram: the outline is not convex at point 1");
  CHECK(message({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1.5, 0, 0}, {1, 1, 0}}) == "Voronoi diagram: the outline is not convex at point 2");
  std::vector<vec3> star;
  for (const unsigned k : {0u, 2u, 4u, 1u, 3u}) star.push_back({std::cos(1.2566370614359172 * k), std::sin(1.2566370614359172 * k), 0});
  CHECK(message(star, {{0, 0, 0}}) == "Voronoi diagram: the outline is not convex: it winds around its inside more than once");
  CHECK(message({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0.25, 0.25, 0}, {0.75, 0.75, 0}}) == "Voronoi diagram: site 1 lies outside of the outline");
}
