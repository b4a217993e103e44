#include <concino/lines/detail/cells/flat_cell.hpp>

#include <concino/generate/dual_mesh.hpp>
#include <concino/generate/grid.hpp>
#include <concino/lines/integral_line.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

using namespace concino;

namespace {

/// The triangles of a face as points, from the corner that comes first in `lies_before` towards the earlier one of its neighbours.
std::vector<std::array<vec3, 3>> triangles_of(std::vector<vec3> ring) {
  std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end(), detail::lies_before), ring.end());
  if (detail::lies_before(ring.back(), ring[1])) std::reverse(ring.begin() + 1, ring.end());
  std::vector<std::array<vec3, 3>> all;
  polygon_triangulator cut;
  for (const polygon_triangle& t : cut(ring)) all.push_back({ring[t[0]], ring[t[1]], ring[t[2]]});
  return all;
}

bool same_points(std::array<vec3, 3> a, std::array<vec3, 3> b) {
  std::sort(a.begin(), a.end(), detail::lies_before);
  std::sort(b.begin(), b.end(), detail::lies_before);
  return a == b;
}

}  // namespace

TEST_CASE("flat_cell: faces are cut into the triangles of polygon_triangulator, convex ones, concave ones and those that are not planar") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(0, 1);
  std::size_t fans = 0, total = 0;
  for (int round = 0; round < 600; ++round) {
    const std::size_t n = 4 + random() % 6;
    const double depth = round % 3 == 0 ? 0 : 0.8, height = round % 2 ? 0.3 : 0, flatness = round % 5 == 0 ? 1e-9 : 1;  // flatness: needles
    std::vector<vec3> ring;
    std::vector<std::uint32_t> corners;
    for (std::size_t i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * (static_cast<double>(i) + 0.5 * any(random)) / static_cast<double>(n), r = 1 - depth * any(random);
      ring.push_back({r * std::cos(angle), flatness * r * std::sin(angle), height * any(random)});
      corners.push_back(static_cast<std::uint32_t>(i));
    }
    detail::flat_cell cell;
    cell.points = ring;
    cell.add_face(corners, true);
    cell.cut_face(0);
    const auto expected = triangles_of(ring);
    REQUIRE(cell.triangles.size() == expected.size());
    bool all_same = true, from_one = true;
    for (std::size_t t = 0; t < expected.size(); ++t) {
      const auto& c = cell.triangles[t].corner;
      all_same = all_same && same_points(expected[t], {ring[c[0]], ring[c[1]], ring[c[2]]});
      from_one = from_one && expected[t][0] == expected[0][0];
    }
    CHECK(all_same);
    fans += n > 4 && from_one;
    ++total;
  }
  CHECK(fans > total / 10);  // both ways to cut are tested
  CHECK(fans < total * 9 / 10);
}

TEST_CASE("flat_cell: a line through a prism of many sides leaves it where the nearest plane says") {
  constexpr std::uint32_t n = 12;
  detail::flat_cell cell;
  std::vector<std::uint32_t> low, high;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    cell.points.push_back({std::cos(angle), std::sin(angle), 0});
    low.push_back(i);
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    cell.points.push_back(cell.points[i] + vec3{0, 0, 1});
    high.push_back(n + i);
  }
  std::mt19937 random(5);
  std::normal_distribution<double> any(0, 1);
  for (int round = 0; round < 300; ++round) {
    auto lines_from = cell;
    lines_from.add_face(low, false);
    lines_from.add_face(high, true);
    for (std::uint32_t i = 0; i < n; ++i) lines_from.add_face(std::array{i, (i + 1) % n, n + (i + 1) % n, n + i}, true);
    const vec3 x = {0.2 * any(random) / 4, 0.2 * any(random) / 4, 0.5}, g = {any(random), any(random), any(random)};
    double t = g.z > 0 ? 0.5 / g.z : -0.5 / g.z;
    for (std::uint32_t i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * (i + 0.5) / n;
      const vec3 out = {std::cos(angle), std::sin(angle), 0};
      if (dot(out, g) > 0) t = std::min(t, (std::cos(std::numbers::pi / n) - dot(out, x)) / dot(out, g));
    }
    const detail::cell_exit exit = lines_from.leave(x, g, {});
    REQUIRE(exit.at != detail::cell_exit::kind::none);
    CHECK(distance(exit.position, x + t * g) < 1e-12);
  }
}

TEST_CASE("flat_cell: a constant field is straight through cells of many faces") {
  const auto m = dual_mesh(make_grid<tetmesh>({.cells = {3, 3, 3}}));
  using mesh = std::remove_cvref_t<decltype(m)>;
  std::size_t most = 0;
  for (const auto p : polys(m)) {
    std::size_t count = 0;
    for ([[maybe_unused]] const auto v : adj_p2v(m, p)) ++count;
    most = std::max(most, count);
  }
  CHECK(most > 20);
  auto field = make_poly_map<vec3>(m);
  const vec3 g = {0.7, 0.31, 0.23};
  for (const auto p : polys(m)) field[p] = g;
  for (const field_line<mesh>& line : integral_lines(m, field, polys(m))) {
    CHECK(line.stopped_by == line_end::boundary);
    for (const mesh_point<mesh>& x : line.points) CHECK(norm(cross(x.position - line.points[0].position, g)) < 1e-12);
  }
}

namespace {

detail::flat_cell unit_cube() {
  detail::flat_cell cube;
  for (int i = 0; i < 8; ++i) cube.points.push_back({i & 1, i >> 1 & 1, i >> 2});
  const std::array<std::array<std::uint32_t, 4>, 6> faces = {{{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};  // -z z -y y -x x
  for (const auto& f : faces) cube.add_face(f, true);
  return cube;
}

/// A cell above a polygon, with the two caps first.
detail::flat_cell prism(const std::vector<vec3>& ring) {
  const auto n = static_cast<std::uint32_t>(ring.size());
  detail::flat_cell cell;
  cell.points = ring;
  std::vector<std::uint32_t> low(n), high(n);
  for (std::uint32_t i = 0; i < n; ++i) {
    cell.points.push_back(ring[i] + vec3{0, 0, 1});
    low[i] = i;
    high[i] = n + i;
  }
  cell.add_face(low, false);
  cell.add_face(high, true);
  for (std::uint32_t i = 0; i < n; ++i) cell.add_face(std::array{i, (i + 1) % n, n + (i + 1) % n, n + i}, true);
  return cell;
}

/// How far along g from x the nearest triangle lies that the line crosses.
double nearest_crossing(detail::flat_cell cell, std::uint32_t num_faces, const vec3& x, const vec3& g) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::uint32_t f = 0; f < num_faces; ++f) cell.cut_face(f);
  for (const detail::cell_triangle& t : cell.triangles) {
    const vec3 &a = cell.points[t.corner[0]], &b = cell.points[t.corner[1]], &c = cell.points[t.corner[2]], n = cross(b - a, c - a);
    const double along = dot(n, a - x) / dot(n, g);
    const vec3 y = x + along * g;
    if (along > 0 && dot(cross(b - a, y - a), n) >= 0 && dot(cross(c - b, y - b), n) >= 0 && dot(cross(a - c, y - c), n) >= 0) nearest = std::min(nearest, along);
  }
  return nearest;
}

}  // namespace

TEST_CASE("flat_cell: a line leaves a cell inside a triangle, at an edge, at a diagonal of a face, or at a corner") {
  using kind = detail::cell_exit::kind;
  const vec3 middle = {0.5, 0.5, 0.5};
  auto cube = unit_cube();
  const auto towards = [&](const vec3& y) { return cube.leave(middle, y - middle, {}); };
  CHECK(towards({1, 0.25, 0.5}).at == kind::triangle);
  CHECK(towards({1, 0.25, 0.5}).position == vec3{1, 0.25, 0.5});
  CHECK(towards({0, 0.75, 0.625}).position == vec3{0, 0.75, 0.625});
  CHECK(towards({1, 1, 0.25}).at == kind::side);
  CHECK(towards({1, 1, 0.25}).position == vec3{1, 1, 0.25});
  const detail::cell_exit at_diagonal = towards({1, 0.5, 0.5});
  CHECK(at_diagonal.at == kind::side);
  CHECK(cube.triangles[at_diagonal.triangle].is_diagonal(at_diagonal.k));
  CHECK(at_diagonal.parameter == 0.5);
  const detail::cell_exit at_edge = towards({1, 1, 0.25});
  CHECK_FALSE(cube.triangles[at_edge.triangle].is_diagonal(at_edge.k));
  CHECK((at_edge.parameter == 0.25 || at_edge.parameter == 0.75));
  CHECK(towards({0, 1, 0}).at == kind::corner);
  CHECK(towards({0, 1, 0}).position == vec3{0, 1, 0});
}

TEST_CASE("flat_cell: exact signs decide by which of two faces a line leaves, however near to their edge") {
  for (const double off : {-0x1p-50, -0x1p-53, 0x1p-52, 0x1p-50}) {
    auto cube = unit_cube();
    const detail::cell_exit exit = cube.leave({0.5, 0.5, 0.5}, {0.5, 0.125, 0.5 + off}, {});
    REQUIRE(exit.at == detail::cell_exit::kind::triangle);
    CHECK(cube.triangles[exit.triangle].face == (off < 0 ? 5 : 1));
  }
}

TEST_CASE("flat_cell: a line leaves a cell that is not convex where it crosses its surface first") {
  const std::vector<vec3> u_shape = {{0, 0, 0}, {3, 0, 0}, {3, 2, 0}, {2, 2, 0}, {2, 0.5, 0}, {1, 0.5, 0}, {1, 2, 0}, {0, 2, 0}};
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(0, 1);
  std::size_t over_the_gap = 0;
  for (int round = 0; round < 200; ++round) {
    auto cell = prism(u_shape);
    const vec3 x = {0.1 + 0.8 * any(random), 0.6 + 1.3 * any(random), 0.1 + 0.8 * any(random)}, g = {any(random), any(random) - 0.5, 0.2 * (any(random) - 0.5)};
    const double expected = nearest_crossing(cell, 10, x, g);
    const detail::cell_exit exit = cell.leave(x, g, {});
    REQUIRE(exit.at != detail::cell_exit::kind::none);
    CHECK(distance(exit.position, x + expected * g) < 1e-12);
    over_the_gap += std::abs(exit.position.x - 1) < 1e-12;
  }
  CHECK(over_the_gap > 50);
}

TEST_CASE("flat_cell: a face that another cell has cut is added with the same triangles, turned round if it points the other way") {
  auto one = unit_cube();
  one.cut_face(5);
  std::vector<vec3> ring(4);
  for (const detail::cell_triangle& t : one.triangles)
    for (std::size_t k = 0; k < 3; ++k) ring[t.ring[k]] = one.points[t.corner[k]];
  for (const bool same_way : {false, true}) {
    detail::flat_cell two;
    two.add_face();
    two.add_cut_face(0, ring, one.triangles, same_way);
    CHECK(two.is_cut(0));
    REQUIRE(two.triangles.size() == 2);
    for (std::size_t t = 0; t < 2; ++t) {
      std::array<vec3, 3> a, b;
      for (std::size_t k = 0; k < 3; ++k) {
        a[k] = one.points[one.triangles[t].corner[k]];
        b[k] = two.points[two.triangles[t].corner[k]];
        CHECK(b[k] == ring[two.triangles[t].ring[k]]);
      }
      CHECK(same_points(a, b));
      CHECK(dot(cross(a[1] - a[0], a[2] - a[0]), cross(b[1] - b[0], b[2] - b[0])) * (same_way ? 1 : -1) > 0);
      CHECK(two.triangles[t].number == one.triangles[t].number);
      CHECK(two.triangles[t].ring_size == 4);
    }
    for (std::uint32_t c = 0; c < 4; ++c) CHECK(two.has_corner(0, c));
  }
}

TEST_CASE("tet_crossing: a line leaves a tet where flat_cell says, or leaves the decision to exact signs") {
  const auto m = make_grid<tetmesh>({.cells = {1, 1, 1}});
  std::mt19937 random(9);
  std::normal_distribution<double> any(0, 1);
  std::size_t certain = 0, led_in = 0;
  for (int round = 0; round < 500; ++round) {
    std::vector<vec3> points;
    for (int i = 0; i < 4; ++i) points.push_back({any(random), any(random), any(random)});
    if (dot(cross(points[1] - points[0], points[2] - points[0]), points[3] - points[0]) < 0) std::swap(points[0], points[1]);
    detail::flat_cell cell;
    cell.points = points;
    for (const auto& f : {std::array<std::uint32_t, 3>{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}) cell.add_face(f, true);
    const std::array<std::uint32_t, 3> entry = {0, 2, 1};
    const std::vector<vert_id> names = {vert_id{0}, vert_id{1}, vert_id{2}, vert_id{3}};
    detail::tet_crossing<tetmesh> tet;
    tet.set(poly_id{0}, names, points, entry);
    tet.field = {any(random), any(random), any(random)};
    const bool leads_in = dot(tet.field, cross(points[2] - points[0], points[1] - points[0])) < 0;
    CHECK(tet.leads_in() == leads_in);
    led_in += leads_in;
    if (!leads_in) continue;
    const double a = std::abs(any(random)) + 0.01, b = std::abs(any(random)) + 0.01, c = std::abs(any(random)) + 0.01;
    const vec3 x = (a * points[0] + b * points[1] + c * points[2]) / (a + b + c);
    const auto exit = tet.leave(x);
    const detail::cell_exit expected = cell.leave(x, tet.field, entry);
    if (!exit) continue;
    ++certain;
    REQUIRE(expected.at == detail::cell_exit::kind::triangle);
    CHECK(distance(exit->position, expected.position) < 1e-12 * (1 + norm(expected.position)));
    CHECK_FALSE(cell.has_corner(cell.triangles[expected.triangle].face, tet.corners[exit->left_out]));
  }
  CHECK(led_in > 200);
  CHECK(certain > led_in * 9 / 10);

  const std::vector<vec3> corner = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};  // what rounded values cannot decide
  const std::vector<vert_id> names = {vert_id{0}, vert_id{1}, vert_id{2}, vert_id{3}};
  detail::tet_crossing<tetmesh> tet;
  tet.set(poly_id{0}, names, corner, std::array<std::uint32_t, 3>{0, 2, 1});
  tet.field = {1, 0, 0};
  CHECK_FALSE(tet.leads_in());
  tet.field = {-0.25, -0.25, 1};
  CHECK_FALSE(tet.leave({0.25, 0.25, 0}));  // at the corner
  tet.field = {0.25, -0.25, 0.5};
  CHECK_FALSE(tet.leave({0.25, 0.25, 0}));  // at an edge
  tet.field = {0.125, 0, 1};
  CHECK(tet.leave({0.25, 0.25, 0}));
  tet.field = {-1.5, 0, 1};
  CHECK_FALSE(tet.leave({2, 2, 0}));  // it misses the tet
  for (const auto p : polys(m)) {
    const auto v = adj_p2v(m, p);
    for (std::uint32_t k = 0; k < 4; ++k)
      for (const vert_id w : adj_f2v(m, detail::opposite_face(m, p, v[k]))) CHECK(w != v[k]);
  }
}
