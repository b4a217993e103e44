#include <concino/render/box_tree_tracer.hpp>
#include <concino/render/render.hpp>
#include <concino/render/shapes.hpp>

#include <doctest/doctest.h>
#include <support/brute_force.hpp>
#include <support/kinds.hpp>
#include <support/threads.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>
#include <vector>

using namespace concino;
using testing::brute_force;

namespace {

constexpr float nan_coordinate = std::numeric_limits<float>::quiet_NaN();

triangle_soup random_soup(std::size_t n, float size = 2) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> unit(-1, 1);
  triangle_soup soup;
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::array<float, 3> middle{unit(random), unit(random), unit(random)};
    for (int k = 0; k < 3; ++k)
      soup.points.push_back({middle[0] + size * unit(random), middle[1] + size * unit(random), middle[2] + size * unit(random)});
    soup.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return soup;
}

/// A ball of 1,280 triangles about the origin.
triangle_soup ball(float radius) {
  const vec3 origin;
  const drawable d = make_balls({origin}, {.radius = 1});
  triangle_soup soup;
  for (const vec3& p : d.points) soup.points.push_back({radius * static_cast<float>(p.x), radius * static_cast<float>(p.y), radius * static_cast<float>(p.z)});
  for (const auto& t : d.triangles) soup.triangles.push_back({d.corners[t[0]], d.corners[t[1]], d.corners[t[2]]});
  return soup;
}

}  // namespace

TEST_CASE("box_tree_tracer: hits equal those of brute force") {
  for (const std::size_t n : {1u, 3u, 5u, 60u, 300u}) {
    const triangle_soup soup = random_soup(n, n == 300 ? 0.3f : 2.0f);
    const auto fast = box_tree_tracer{}.build(soup);
    const auto slow = brute_force{}.build(soup);
    std::mt19937 random(6);
    std::uniform_real_distribution<double> unit(-1, 1);
    int hits = 0, differ = 0;
    for (int i = 0; i < 500; ++i) {
      const vec3 origin{2 * unit(random), 2 * unit(random), 2 * unit(random)}, toward{unit(random), unit(random), unit(random)};
      vec3 d = toward - origin;
      if (i % 5 == 0) d[static_cast<std::size_t>(i / 5 % 3)] = 0;
      if (i % 7 == 0) d = {0, i % 2 ? 1.0 : -1.0, 0};
      const double near = i % 4 ? 0 : 0.3, far = i % 3 ? 1e30 : 1.0;
      const ray_hit a = fast.intersect(origin, d, near, far), b = slow.intersect(origin, d, near, far);
      CHECK(fast.occluded(origin, d, near, far) == static_cast<bool>(a));
      differ += a.triangle != b.triangle;  // single precision: a ray at an edge may hit either of its triangles
      if (!a || a.triangle != b.triangle) continue;
      ++hits;
      CHECK(a.t == doctest::Approx(b.t).epsilon(1e-3));
      CHECK(std::abs(a.u - b.u) < 1e-3);
      CHECK(std::abs(a.v - b.v) < 1e-3);
    }
    CHECK(hits > 5);
    CHECK(differ <= 2);
  }
}

TEST_CASE("box_tree_tracer: no ray leaves a closed surface through its edges and corners") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (const float radius : {1.0f, 1e-6f, 1e6f}) {
    const triangle_soup soup = ball(radius);
    const auto caster = box_tree_tracer{}.build(soup);
    std::size_t lost = 0;
    const auto leave = [&](const vec3& from, const vec3& through) {
      const vec3 d = through - from;
      const ray_hit hit = caster.intersect(from, d, 0, 1e30);
      lost += !hit || std::abs(hit.t - 1) > 1e-3;
    };
    for (const auto& t : soup.triangles) {
      const vec3 from = vec3{unit(random), unit(random), unit(random)} * (0.5 * static_cast<double>(radius));
      const vec3 a = to_vec3(soup.points[t[0]]), b = to_vec3(soup.points[t[1]]), c = to_vec3(soup.points[t[2]]);
      const double s = 0.5 + unit(random) / 2;
      leave(from, a);
      leave({}, b);
      leave(from, b * s + c * (1 - s));
      leave({}, a * 0.5 + c * 0.5);
    }
    CHECK(lost == 0);
  }
}

TEST_CASE("box_tree_tracer: a ray is occluded where it hits something, also from corners and close to them") {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (const float radius : {1.0f, 1e-20f, 1e14f}) {
    triangle_soup soup = ball(radius);
    for (const float inner : {0.5f, 0.05f}) {
      const triangle_soup more = ball(inner * radius);
      const auto first = static_cast<std::uint32_t>(soup.points.size());
      soup.points.insert(soup.points.end(), more.points.begin(), more.points.end());
      for (std::size_t i = 0; i < more.triangles.size(); i += 3)
        soup.triangles.push_back({first + more.triangles[i][0], first + more.triangles[i][1], first + more.triangles[i][2]});
    }
    const auto caster = box_tree_tracer{}.build(soup);
    std::size_t differ = 0, hits = 0, all = 0;
    for (std::size_t i = 0; i < 60; ++i) {
      const vec3 corner = to_vec3(soup.points[(i * 97) % soup.points.size()]);
      const vec3 origin = i % 3 == 0 ? corner : corner * (i % 3 == 1 ? 0.99997 : 1.00003);
      const double near = i % 5 == 0 ? 0.1 : i % 7 == 0 ? -2 : 0, far = i % 2 ? 1e30 : 1.5;
      for (int k = 0; k < 137; ++k) {
        vec3 d = vec3{unit(random), unit(random), unit(random)} * static_cast<double>(radius);
        if (all++ % 9 == 0) d[all % 3] = 0;
        if (all % 11 == 0) d = to_vec3(soup.points[all % soup.points.size()]) - origin;  // through a corner
        const bool hit = static_cast<bool>(caster.intersect(origin, d, near, far));
        differ += hit != caster.occluded(origin, d, near, far);
        hits += hit;
      }
    }
    CHECK(differ == 0);
    CHECK(hits > all / 5);
    CHECK(hits < all * 9 / 10);
  }
}

TEST_CASE("box_tree_tracer: of triangles in the same place it hits the first, in any order") {
  triangle_soup soup{{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}, {-1, -1, 5}, {1, -1, 5}, {0, 1, 5}}, {}};
  for (std::uint32_t i = 0; i < 40; ++i) {
    if (i % 2) soup.triangles.push_back({3, 4, 5});
    else soup.triangles.push_back({i % 4 ? 0u : 1u, i % 4 ? 1u : 2u, i % 4 ? 2u : 0u});
  }
  const auto caster = box_tree_tracer{}.build(soup);
  CHECK(caster.intersect({0, 0, -4}, {0, 0, 1}, 0, 1e30).triangle == 0);
  CHECK(caster.intersect({0.1, 0, 9}, {0, 0, -1}, 0, 1e30).triangle == 1);
  const triangle_soup square{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 2, 3}, {0, 1, 2}}};
  CHECK(box_tree_tracer{}.build(square).intersect({0.25, 0.25, 1}, {0, 0, -1}, 0, 1e30).triangle == 0);  // on the diagonal
}

TEST_CASE("box_tree_tracer: every number of threads gives the same hits") {
  const triangle_soup soup = random_soup(9000, 0.05f);
  const auto hits = [&](int threads) {
    const testing::with_num_threads now(threads);
    const auto caster = box_tree_tracer{}.build(soup);
    std::vector<std::pair<std::uint32_t, double>> all;
    for (int i = 0; i < 500; ++i) {
      const double a = 0.1 * i;
      const ray_hit hit = caster.intersect({2 * std::cos(a), 2 * std::sin(a), 0.7 * std::sin(7 * a)}, {-std::cos(a), -std::sin(a), 0.1}, 0, 1e30);
      all.emplace_back(hit.triangle, hit.t);
    }
    return all;
  };
  const auto serial = hits(1);
  CHECK(std::count_if(serial.begin(), serial.end(), [](const auto& h) { return h.first != ray_hit::none; }) > 100);
  CHECK(hits(2) == serial);
  CHECK(hits(7) == serial);
}

TEST_CASE("box_tree_tracer: triangles without area or finite points are not hit; a wrong index throws") {
  const auto empty = box_tree_tracer{}.build({});
  CHECK(!empty.intersect({0, 0, 5}, {0, 0, -1}, 0, 1e30));
  CHECK(!empty.occluded({0, 0, 5}, {0, 0, -1}, 0, 1e30));
  CHECK(!box_tree_tracer{}.build(random_soup(3)).occluded({0, 0, 5}, {0, 0, 0}, 0, 1e30));
  const triangle_soup soup{{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}, {nan_coordinate, 0, 2}, {0, 0, 1}, {0, 0, 3}}, {{0, 1, 3}, {4, 4, 4}, {4, 5, 4}, {0, 1, 2}}};
  box_tree_caster a(soup);
  const box_tree_caster b = std::move(a);
  const ray_hit hit = b.intersect({0, 0, 5}, {0, 0, -1}, 0, 1e30);
  REQUIRE(hit.triangle == 3);
  CHECK(hit.t == 5);
  CHECK(hit.u == 0.25);
  CHECK(hit.v == 0.5);
  CHECK(!b.intersect({0, 0, 5}, {0, 0, -1}, 0, 4.9));
  CHECK(!b.occluded({0, 0, 5}, {0, 0, -1}, 5.1, 9));
  CHECK(!box_tree_tracer{}.build({{{nan_coordinate, 0, 0}}, {{0, 0, 0}}}).occluded({0, 0, 5}, {0, 0, -1}, 0, 1e30));
  CHECK_THROWS_AS(box_tree_tracer{}.build({{{0, 0, 0}, {1, 0, 0}}, {{0, 1, 2}}}), invalid_argument);
}

TEST_CASE("box_tree_tracer: pictures are those of brute force") {
  scene s;
  s.add(make_drawable(testing::grid<hexmesh>(2)));
  const render_options o{.width = 40, .height = 30, .samples = 2, .occlusion_rays = 8};
  const image fast = render(s, o), slow = render(s, o, brute_force{});
  int differ = 0;
  for (std::size_t y = 0; y < 30; ++y)
    for (std::size_t x = 0; x < 40; ++x) differ += std::abs(fast(x, y).g - slow(x, y).g) > 0.02f;
  CHECK(differ < 12);
  CHECK(render(s, o, box_tree_tracer{}) == fast);
}
