// Segments cut where they meet: concino/print/detail/regions.
#include <doctest/doctest.h>
#include <concino/geometry/orientation.hpp>
#include <concino/print/detail/regions/arrangement.hpp>
#include <concino/print/detail/regions/segment_cuts.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <set>

namespace {

namespace cn = concino;
using cn::detail::numbered_segment;
using cn::detail::stepped_segments;

/// Whether p is at most half a unit away from the inner part of a b.
bool is_near(const cn::vec3& a, const cn::vec3& b, const cn::vec3& p) {
  const cn::vec3 step = b - a, x = p - a;
  const double along = dot(x, step), across = step.x * x.y - step.y * x.x;
  return along > 0 && along < dot(step, step) && across * across <= 0.25 * dot(step, step);
}

/// By all pairs: whether two segments cross, or a point of one is near to the other.
bool any_cut(const std::vector<cn::snapped_point>& points, const std::vector<numbered_segment>& segments) {
  const auto at = [&](std::uint32_t p) { return cn::detail::as_vec3(points[p]); };
  for (const auto& s : segments)
    for (const auto& t : segments) {
      if (&s == &t) continue;
      const cn::vec3 a = at(s[0]), b = at(s[1]), c = at(t[0]), d = at(t[1]);
      if (is_near(a, b, c) || is_near(a, b, d)) return true;
      if (cn::orient2d(a, b, c) * cn::orient2d(a, b, d) < 0 && cn::orient2d(c, d, a) * cn::orient2d(c, d, b) < 0)
        return true;
    }
  return false;
}

/// Arranges segments, and holds the result against its definition.
cn::detail::planar_arrangement arranged(const stepped_segments& s) {
  auto a = cn::detail::arrange("test", s);
  std::vector<numbered_segment> edges;
  for (const auto& e : a.edges) edges.push_back({e.low, e.high});
  REQUIRE_FALSE(any_cut(a.points, edges));
  for (std::size_t i = 0; i < s.segments.size(); ++i) {
    const auto chain = a.chain(i);
    const auto from = cn::detail::as_vec3(s.points[s.segments[i].from]),
               to = cn::detail::as_vec3(s.points[s.segments[i].to]);
    REQUIRE(a.points[chain.front()] == s.points[s.segments[i].from]);
    REQUIRE(a.points[chain.back()] == s.points[s.segments[i].to]);
    for (const std::uint32_t p : chain) {  // a segment moves by about half a unit
      const cn::vec3 x = cn::detail::as_vec3(a.points[p]) - from, step = to - from;
      if (dot(step, step) > 0) CHECK(std::abs(step.x * x.y - step.y * x.x) <= 2.5 * norm(step));
    }
  }
  return a;
}

stepped_segments segments_of(const std::vector<std::array<cn::snapped_point, 2>>& all) {
  stepped_segments s;
  for (const auto& [p, q] : all) {
    const auto n = static_cast<std::uint32_t>(s.points.size());
    s.points.insert(s.points.end(), {p, q});
    s.segments.push_back({n, n + 1, {1, 0}});
  }
  return s;
}

/// A star of n spikes, turned by an angle.
std::vector<cn::snapped_point> star(std::size_t n, double angle, double radius) {
  std::vector<cn::snapped_point> path;
  for (std::size_t i = 0; i < 2 * n; ++i) {
    const double r = i % 2 == 0 ? radius : radius / 2,
                 t = angle + std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    path.push_back({std::llround(r * std::cos(t)), std::llround(r * std::sin(t))});
  }
  return path;
}

}  // namespace

TEST_CASE("arrange: two segments that cross, touch, overlap, or share an end") {
  CHECK(arranged(segments_of({{{{0, 0}, {10, 10}}}, {{{0, 10}, {10, 0}}}})).edges.size() == 4);
  CHECK(arranged(segments_of({{{{0, 0}, {10, 0}}}, {{{5, 0}, {5, 10}}}})).edges.size() == 3);
  CHECK(arranged(segments_of({{{{0, 0}, {10, 0}}}, {{{4, 0}, {20, 0}}}})).edges.size() == 3);
  CHECK(arranged(segments_of({{{{0, 0}, {0, 10}}}, {{{0, 4}, {0, 6}}}})).edges.size() == 3);
  CHECK(arranged(segments_of({{{{0, 0}, {10, 0}}}, {{{10, 0}, {10, 5}}}})).edges.size() == 2);
  const auto same = arranged(segments_of({{{{0, 0}, {10, 3}}}, {{{10, 3}, {0, 0}}}}));
  REQUIRE(same.edges.size() == 1);
  CHECK(same.edges[0].step[0] == 0);
  const auto near = arranged(segments_of({{{{0, 0}, {1000, 1}}}, {{{100, 0}, {100, -50}}}}));
  CHECK(near.edges.size() == 3);  // a tenth of a unit apart
}

TEST_CASE("arrange: random segments on coarse and fine lattices") {
  std::mt19937_64 random(20);
  for (int round = 0; round < 300; ++round) {
    const std::int64_t size = std::int64_t{1} << (2 + round % 40);
    std::uniform_int_distribution<std::int64_t> x(-size, size);
    std::vector<std::array<cn::snapped_point, 2>> all;
    for (int i = 0; i < 2 + round % 23; ++i) all.push_back({{{x(random), x(random)}, {x(random), x(random)}}});
    CAPTURE(round);
    const auto s = segments_of(all);
    std::vector<cn::snapped_point> points = s.points;
    std::set<cn::snapped_point> different(points.begin(), points.end());
    if (different.size() == points.size()) {
      std::vector<numbered_segment> segments;
      for (const auto& e : s.segments) segments.push_back({e.from, e.to});
      const bool is_cut = any_cut(points, segments);
      CHECK(cn::detail::find_cuts(points, segments).empty() == !is_cut);
    }
    arranged(s);
  }
}

TEST_CASE("arrange: many lines through one point, a grid, vertical and horizontal ones") {
  std::vector<std::array<cn::snapped_point, 2>> fan, grid;
  for (std::int64_t i = -20; i <= 20; ++i) {
    fan.push_back({{{-1000, 37 * i}, {1000, -37 * i}}});
    grid.push_back({{{10 * i, -500}, {10 * i, 500}}});
    grid.push_back({{{-500, 10 * i}, {500, 10 * i}}});
  }
  CHECK(arranged(segments_of(fan)).edges.size() == 82);
  CHECK(arranged(segments_of(grid)).edges.size() == 2 * 41 * 42);
}

TEST_CASE("arrange: the area between paths stays, up to rounding") {
  // The steps along every horizontal line add up to 0, so that each point has one number.
  std::mt19937_64 random(4);
  std::uniform_int_distribution<std::int64_t> x(-10000, 10000);
  for (int round = 0; round < 20; ++round) {
    stepped_segments s;
    std::vector<cn::snapped_point> path;
    for (int i = 0; i < 30; ++i) path.push_back({x(random), x(random)});
    s.add_path(path, {1, 0});
    const auto a = arranged(s);
    double before = 0, after = 0;
    for (const auto& e : s.segments) {
      const auto p = s.points[e.from], q = s.points[e.to];
      before += static_cast<double>(p[0] * q[1] - p[1] * q[0]);
    }
    for (const auto& e : a.edges) {
      const auto p = a.points[e.low], q = a.points[e.high];
      after += static_cast<double>(e.step[0] * (p[0] * q[1] - p[1] * q[0]));
    }
    CHECK(std::abs(after - before) < 30 * 2 * 40000 * 2);
  }
}

TEST_CASE("meet: simple paths, and such that touch, cross, or double back") {
  const auto meet = [](const std::vector<std::vector<cn::snapped_point>>& all) {
    cn::lattice_paths paths;
    for (const auto& path : all) paths.push_back(path);
    return cn::detail::meet(paths);
  };
  CHECK_FALSE(meet({}));
  CHECK_FALSE(meet({{{0, 0}, {10, 0}, {0, 10}}}));
  CHECK_FALSE(meet({{{0, 0}, {10, 0}, {0, 10}}, {{2, 2}, {4, 2}, {2, 4}}}));
  CHECK_FALSE(meet({{{0, 0}, {5, 0}, {10, 0}, {0, 10}}}));  // a straight corner
  CHECK(meet({{{0, 0}, {10, 0}, {5, 0}, {0, 10}}}));        // doubled back
  CHECK(meet({{{0, 0}, {10, 10}, {10, 0}, {0, 10}}}));      // an eight
  CHECK(meet({{{0, 0}, {10, 0}, {0, 10}}, {{5, 0}, {5, -5}, {8, -5}}}));
  CHECK(meet({{{0, 0}, {10, 0}, {0, 10}}, {{0, 0}, {-5, 0}, {0, -5}}}));
  CHECK(meet({{{0, 0}, {10, 0}}}));
  CHECK_FALSE(meet({star(5000, 0, 1e12)}));
}

TEST_CASE("arrange: two stars of long spikes") {
  stepped_segments s;
  s.add_path(star(50, 0, 1e10), {1, 0});
  s.add_path(star(50, 0.01, 1e10), {0, 1});
  arranged(s);
}
