#include <concino/adapters/embree.hpp>
#include <concino/render/ambient_occlusion.hpp>
#include <concino/render/render.hpp>
#include <concino/render/render.hpp>

#include <doctest/doctest.h>
#include <support/brute_force.hpp>
#include <support/kinds.hpp>
#include <support/threads.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

using namespace concino;
using testing::brute_force;

namespace {

triangle_soup random_soup(std::size_t n) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> unit(-1, 1);
  triangle_soup soup;
  for (std::size_t i = 0; i < 3 * n; ++i) soup.points.push_back({unit(random), unit(random), unit(random)});
  for (std::uint32_t i = 0; i < n; ++i) soup.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  return soup;
}

}  // namespace

TEST_CASE("embree: hits equal those of brute force") {
  const triangle_soup soup = random_soup(60);
  const auto fast = embree{}.build(soup);
  const auto slow = brute_force{}.build(soup);
  std::mt19937 random(6);
  std::uniform_real_distribution<double> unit(-1, 1);
  int hits = 0, differ = 0;
  for (int i = 0; i < 2000; ++i) {
    const vec3 origin{2 * unit(random), 2 * unit(random), 2 * unit(random)}, toward{unit(random), unit(random), unit(random)};
    vec3 d = toward - origin;
    d /= norm(d);
    const double far = i % 3 ? 1e30 : 1.0;
    const ray_hit a = fast.intersect(origin, d, 0, far), b = slow.intersect(origin, d, 0, far);
    CHECK(fast.occluded(origin, d, 0, far) == static_cast<bool>(a));
    differ += a.triangle != b.triangle;  // single precision: a ray at an edge may hit either of its triangles
    if (!a || a.triangle != b.triangle) continue;
    ++hits;
    CHECK(a.t == doctest::Approx(b.t).epsilon(1e-3));
    CHECK(a.u == doctest::Approx(b.u).epsilon(1e-2));
    CHECK(a.v == doctest::Approx(b.v).epsilon(1e-2));
  }
  CHECK(hits > 1000);
  CHECK(differ <= 4);
}

TEST_CASE("embree: an empty scene has no hits, and ray casters can be moved") {
  const auto empty = embree{}.build({});
  CHECK(!empty.intersect({0, 0, 5}, {0, 0, -1}, 0, 1e30));
  CHECK(!empty.occluded({0, 0, 5}, {0, 0, -1}, 0, 1e30));
  embree_caster a({{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}, {{0, 1, 2}}});
  const embree_caster b = std::move(a);
  const ray_hit hit = b.intersect({0, 0, 5}, {0, 0, -1}, 0, 1e30);
  REQUIRE(hit);
  CHECK(hit.t == doctest::Approx(5));
  CHECK(hit.u == doctest::Approx(0.25));
  CHECK(hit.v == doctest::Approx(0.5));
}

TEST_CASE("embree: every number of threads gives the same hits") {
  triangle_soup soup = random_soup(20000);
  for (std::size_t i = 0; i < soup.points.size(); i += 3)  // smaller triangles, each twice
    for (std::size_t k = 1; k < 3; ++k)
      for (std::size_t axis = 0; axis < 3; ++axis)
        soup.points[i + k][axis] = soup.points[i][axis] + 0.02f * (soup.points[i + k][axis] - soup.points[i][axis]);
  const auto once = soup.triangles;
  soup.triangles.insert(soup.triangles.end(), once.begin(), once.end());
  const auto hits = [&](int threads) {
    const testing::with_num_threads now(threads);
    const auto caster = embree{}.build(soup);
    std::vector<std::uint32_t> all;
    for (int i = 0; i < 500; ++i) {
      const double a = 0.1 * i;
      all.push_back(caster.intersect({2 * std::cos(a), 2 * std::sin(a), 0.7 * std::sin(7 * a)}, {-std::cos(a), -std::sin(a), 0.1}, 0, 1e30).triangle);
    }
    return all;
  };
  const auto serial = hits(1);
  CHECK(std::count(serial.begin(), serial.end(), ray_hit::none) < 400);
  CHECK(hits(2) == serial);
  CHECK(hits(7) == serial);
  const ray_hit hit = embree{.parallel_build = true}.build(soup).intersect({2, 0, 0}, {-1, 0, 0.1}, 0, 1e30);
  CHECK(hit.triangle % once.size() == serial[0] % once.size());
}

TEST_CASE("embree: ray casters can be created and destroyed repeatedly") {
  for (int i = 0; i < 20; ++i) CHECK(embree{}.build(random_soup(2)).occluded({0, 0, 9}, {0, 0, 1}, 0, 1) == false);
}

TEST_CASE_TEMPLATE("embree: pictures look like those by brute force", M, CONCINO_KINDS) {
  scene s;
  s.add(make_drawable(testing::grid<M>(2)));
  const render_options o{.width = 40, .height = 30, .samples = 2, .occlusion_rays = 8};
  const image fast = render(s, o, embree{}), slow = render(s, o, brute_force{});
  int differ = 0;
  for (std::size_t y = 0; y < 30; ++y)
    for (std::size_t x = 0; x < 40; ++x) differ += std::abs(fast(x, y).g - slow(x, y).g) > 0.02f;
  CHECK(differ < 12);
  CHECK(render(s, o, embree{}) == fast);
}

TEST_CASE("ambient occlusion by Embree: a plane is not occluded") {
  const quadmesh m = testing::grid<quadmesh>(4);
  const auto ao = ambient_occlusion(m, {}, embree{});
  for (const auto p : polys(m)) CHECK(ao[p] == 1);
}
