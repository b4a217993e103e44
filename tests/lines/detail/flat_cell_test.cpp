#include <concino/lines/detail/flat_cell.hpp>

#include <concino/generate/dual_mesh.hpp>
#include <concino/generate/grid.hpp>
#include <concino/lines/integral_line.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
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
