#include <concino/generate/random_points.hpp>
#include <concino/generate/voronoi_polyhedra.hpp>

#include <concino/validate/check_laws.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>

using namespace concino;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

box construct_from_arrays(vec3 low, vec3 high) {
  box b;
  b.min = low;
  b.max = high;
  return b;
}
const box unit_cube = construct_from_arrays({0, 0, 0}, {1, 1, 1});

/// The largest distance of x beyond a face of the convex poly p.
double outside(const polyhedralmesh& m, poly_id p, const vec3& x) {
  double most = -infinity;
  for (const auto f : adj_p2f(m, p)) {
    const polygon_shape s = shape_of(m, adj_f2v(m, f));
    most = std::max(most, (face_is_outward(m, p, f) ? 1 : -1) * dot(x - s.mean, s.area) / norm(s.area));
  }
  return most;
}

/// Checks that the mesh is conforming, without gaps, fills the box, and has planar faces; boundary faces are on the boundary of the box.
void check_sound(const polyhedralmesh& m, std::size_t sites, const box& b) {
  REQUIRE(num_polys(m) == sites);
  CHECK(check_laws(m).empty());
  CHECK(static_cast<long>(num_verts(m) + num_faces(m)) - static_cast<long>(num_edges(m) + num_polys(m)) == 1);
  const vec3 side = b.max - b.min;
  CHECK(total_measure(m) == doctest::Approx(side.x * side.y * side.z).epsilon(1e-12));
  bool positive = true, on_walls = true, flat = true, closed = true;
  for (const auto p : polys(m)) {
    positive = positive && volume(m, p) > 0;
    vec3 sum;
    std::size_t v = 0, e = 0, f = 0;
    for ([[maybe_unused]] const auto x : adj_p2v(m, p)) ++v;
    for ([[maybe_unused]] const auto x : adj_p2e(m, p)) ++e;
    for (const auto x : adj_p2f(m, p)) sum += (face_is_outward(m, p, x) ? 1 : -1) * area_vector(m, x), ++f;
    closed = closed && v + f == e + 2 && norm(sum) < 1e-14 * dot(side, side);
  }
  for (const auto f : faces(m)) {
    int n = 0;
    for ([[maybe_unused]] const auto p : adj_f2p(m, f)) ++n;
    bool on_wall = false;
    for (std::size_t k = 0; k < 3; ++k)
      for (const double wall : {b.min[k], b.max[k]}) {
        bool all = true;
        for (const auto v : adj_f2v(m, f)) all = all && point(m, v)[k] == wall;
        on_wall = on_wall || all;
      }
    on_walls = on_walls && (n == 1) == on_wall && (n == 1 || n == 2);
    const polygon_shape s = shape_of(m, adj_f2v(m, f));
    const double tolerance = 1e-13 * norm(side) * dot(side, side);  // not relative to the area, as normals of slivers are inaccurate
    for (const auto v : adj_f2v(m, f)) flat = flat && std::abs(dot(point(m, v) - s.mean, s.area)) <= tolerance;
  }
  CHECK(positive);
  CHECK(on_walls);
  CHECK(flat);
  CHECK(closed);
}

std::size_t nearest(const std::vector<vec3>& sites, const vec3& x) {
  const auto nearer = [&](const vec3& a, const vec3& b) { return dot(a - x, a - x) < dot(b - x, b - x); };
  return static_cast<std::size_t>(std::min_element(sites.begin(), sites.end(), nearer) - sites.begin());
}

std::vector<vec3> grid_of_sites(unsigned n, double offset, double scale) {
  std::vector<vec3> sites;
  for (unsigned k = 0; k < n; ++k)
    for (unsigned j = 0; j < n; ++j)
      for (unsigned i = 0; i < n; ++i) sites.push_back({(i + offset) / scale, (j + offset) / scale, (k + offset) / scale});
  return sites;
}

}  // namespace

TEST_CASE("voronoi_polyhedra: each point lies in the cell of its nearest site") {
  for (const std::size_t n : {1u, 2u, 3u, 10u, 200u}) {
    const box b = construct_from_arrays({-3, 10, 2}, {5, 11, 7});
    const auto sites = random_points(n, b, n);
    const polyhedralmesh m = voronoi_polyhedra(sites, b);
    check_sound(m, n, b);
    for (const vec3& x : random_points(300, b, 99)) CHECK(outside(m, poly_id{nearest(sites, x)}, x) < 1e-12);
  }
}

TEST_CASE("voronoi_polyhedra: sites on grids give bricks") {
  for (const unsigned n : {2u, 3u, 5u}) {
    const polyhedralmesh m = voronoi_polyhedra(grid_of_sites(n, 0.5, n), unit_cube);
    check_sound(m, n * n * n, unit_cube);
    CHECK(num_verts(m) == (n + 1) * (n + 1) * (n + 1));
    CHECK(num_edges(m) == 3 * n * (n + 1) * (n + 1));
    CHECK(num_faces(m) == 3 * n * n * (n + 1));
    for (const auto p : polys(m)) CHECK(volume(m, p) == doctest::Approx(1.0 / (n * n * n)).epsilon(1e-12));
    const polyhedralmesh w = voronoi_polyhedra(grid_of_sites(n, 0, n - 1), unit_cube);  // some sites are on the boundary of the cube
    check_sound(w, n * n * n, unit_cube);
    CHECK(num_faces(w) == 3 * n * n * (n + 1));
  }
}

TEST_CASE("voronoi_polyhedra: cubic lattices give truncated octahedra and rhombic dodecahedra") {
  const unsigned n = 4;
  auto body = grid_of_sites(n, 0.25, n), face = body;
  for (const vec3& x : grid_of_sites(n, 0.75, n)) body.push_back(x);
  check_sound(voronoi_polyhedra(body, unit_cube), body.size(), unit_cube);
  const auto shift = [&](double x, double y, double z) {
    for (const vec3& s : grid_of_sites(n, 0.25, n)) face.push_back(s + vec3{x, y, z} / n);
  };
  shift(0.5, 0.5, 0), shift(0.5, 0, 0.5), shift(0, 0.5, 0.5);
  check_sound(voronoi_polyhedra(face, unit_cube), face.size(), unit_cube);
  // checks the cell in the middle
  const auto inside = [&](const std::vector<vec3>& sites, std::size_t nf, std::size_t nv, double share) {
    const polyhedralmesh m = voronoi_polyhedra(sites, unit_cube);
    const poly_id p{nearest(sites, {0.5 - 1.0 / n / 4, 0.5 - 1.0 / n / 4, 0.5 - 1.0 / n / 4})};
    std::size_t f = 0, v = 0;
    for ([[maybe_unused]] const auto x : adj_p2f(m, p)) ++f;
    for ([[maybe_unused]] const auto x : adj_p2v(m, p)) ++v;
    CHECK(f == nf);
    CHECK(v == nv);
    CHECK(volume(m, p) == doctest::Approx(share / (n * n * n)).epsilon(1e-12));
  };
  inside(body, 14, 24, 0.5);
  inside(face, 12, 14, 0.25);
}

TEST_CASE("voronoi_polyhedra: accepts sites on a sphere, in a plane, on a line, in a cluster") {
  std::vector<vec3> on_sphere{{0.5, 0.5, 0.5}};
  for (const vec3& x : random_points(60, unit_cube, 5)) {
    const vec3 d = x - vec3{0.5, 0.5, 0.5};
    on_sphere.push_back(vec3{0.5, 0.5, 0.5} + 0.3 / norm(d) * d);
  }
  check_sound(voronoi_polyhedra(on_sphere, unit_cube), 61, unit_cube);
  on_sphere.erase(on_sphere.begin());
  check_sound(voronoi_polyhedra(on_sphere, unit_cube), 60, unit_cube);

  std::vector<vec3> in_plane, on_line;
  for (const vec3& x : random_points(40, unit_cube, 6)) in_plane.push_back({x.x, x.y, 0.5}), on_line.push_back({x.x, x.x, x.x});
  check_sound(voronoi_polyhedra(in_plane, unit_cube), 40, unit_cube);
  check_sound(voronoi_polyhedra(on_line, unit_cube), 40, unit_cube);

  auto cluster = random_points(60, construct_from_arrays({0.3, 0.3, 0.3}, {0.3 + 1e-5, 0.3 + 1e-5, 0.3 + 1e-5}), 4);
  for (const vec3& x : random_points(20, unit_cube, 5)) cluster.push_back(x);
  const polyhedralmesh c = voronoi_polyhedra(cluster, unit_cube);
  check_sound(c, 80, unit_cube);
  for (const vec3& x : random_points(300, unit_cube, 7)) CHECK(outside(c, poly_id{nearest(cluster, x)}, x) < 1e-12);
  const box flat = construct_from_arrays({0, 0, 0}, {100, 100, 1e-2});
  check_sound(voronoi_polyhedra(random_points(100, flat, 6), flat), 100, flat);
}

TEST_CASE("voronoi_polyhedra: merges verts of nearly regular grids within the tolerance only") {
  for (const double off : {0.0, 1e-16, 1e-14, 1e-12, 1e-11})
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      detail::random_stream random(seed);
      std::vector<vec3> sites;
      for (const vec3& x : grid_of_sites(4, 0, 3)) {
        vec3 moved;
        for (std::size_t k = 0; k < 3; ++k) moved[k] = std::min(1.0, x[k] + off * random.unit());
        if (random.unit() < 0.1 * static_cast<double>(seed)) sites.push_back(moved);
      }
      check_sound(voronoi_polyhedra(sites, unit_cube), sites.size(), unit_cube);
    }
}

TEST_CASE("voronoi_polyhedra: scales exactly") {
  const auto sites = random_points(30, unit_cube, 3);
  const polyhedralmesh m = voronoi_polyhedra(sites, unit_cube);
  for (const double scale : {0x1p-300, 0x1p-20, 0x1p20, 0x1p300}) {
    auto scaled = sites;
    for (vec3& x : scaled) x *= scale;
    const polyhedralmesh s = voronoi_polyhedra(scaled, construct_from_arrays({0, 0, 0}, {scale, scale, scale}));
    REQUIRE(num_verts(s) == num_verts(m));
    for (const auto v : verts(m)) CHECK(point(s, v) == scale * point(m, v));
  }
}

TEST_CASE("voronoi_polyhedra: relaxation makes the sizes of cells more uniform") {
  const auto sites = random_points(60, unit_cube, 8);
  const auto spread = [](const polyhedralmesh& m) {
    double squares = 0;
    for (const auto p : polys(m)) squares += (measure(m, p) - 1.0 / 60) * (measure(m, p) - 1.0 / 60);
    return squares;
  };
  const polyhedralmesh relaxed = voronoi_polyhedra(sites, unit_cube, {.relax = 8});
  check_sound(relaxed, 60, unit_cube);
  CHECK(spread(relaxed) < 0.2 * spread(voronoi_polyhedra(sites, unit_cube)));
}

TEST_CASE("voronoi_polyhedra: 256-bit integer arithmetic is exact") {
  using detail::int128;
  using detail::int256;
  detail::random_stream random(5);
  for (int i = 0; i < 200; ++i) {
    const auto a = static_cast<std::int64_t>(random.next()) >> random.next() % 60, b = static_cast<std::int64_t>(random.next()) >> random.next() % 60;
    const int128 wide = static_cast<int128>(a) * b;
    CHECK(int256(a) * int256(b) == int256(wide));
    CHECK((int256(a) + int256(b)) - int256(b) == int256(a));
    CHECK((int256(a) - int256(b)).sign() == (a > b) - (a < b));
    const auto x = static_cast<double>(a), y = static_cast<double>(b);
    CHECK((int256(wide) * int256(b)).to_double() == doctest::Approx(x * y * y).epsilon(1e-15));
    CHECK(int256(wide) * int256(wide) - int256(a) * int256(a) * int256(b) * int256(b) == int256());
  }
}

TEST_CASE("voronoi_polyhedra: accepts braces, and throws if a site or the box is invalid") {
  CHECK(total_measure(voronoi_polyhedra({{0.25, 0.5, 0.5}, {0.75, 0.5, 0.5}}, unit_cube)) == 1);
  const auto refused = [](const std::vector<vec3>& sites, const box& b, const char* why) {
    try {
      voronoi_polyhedra(sites, b);
      FAIL("not refused");
    } catch (const invalid_argument& e) {
      CHECK_MESSAGE(std::string(e.what()).find(why) != std::string::npos, e.what());
    }
  };
  refused({}, unit_cube, "at least one site");
  refused({{0.5, 0.5, 0.5}, {0.5, 0.5, 1.5}}, unit_cube, "site 1 ");
  refused({{0.5, 0.5, -infinity}}, unit_cube, "site 0 ");
  refused({{0.1, 0.1, 0}, {0.5, 0.5, 0}, {0.7, 0.7, 0}, {0.5, 0.5, 0}}, unit_cube, "sites 1 and 3 ");
  refused({{0, 0, 0}}, construct_from_arrays({0, 0, 0}, {1, 1, 0}), "box");
  refused({{0.5, 0.5, 0.5}, {0.5 + 0x1p-45, 0.5, 0.5}, {0.5 + 0x1p-44, 0.5, 0.5}}, unit_cube, "site 1 ");
}
