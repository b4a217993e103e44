#include <concino/deform/affine_map.hpp>

#include <concino/core/error.hpp>
#include <concino/deform/detail/skin/best_rotation.hpp>

#include <support/motions.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

using namespace concino;
using namespace concino::testing;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("affine_map: rotation, translation and their products") {
  const affine_map r = rotation({0, 0, 0}, {1, 2, 3}, 0.7), t = translation({1, 2, 3});
  const vec3 p{0.3, -2, 5};
  CHECK(distance(r(p), rotated(p)) < 1e-15 * 10);
  CHECK(t(p) == p + vec3{1, 2, 3});
  CHECK(distance((t * r)(p), rotated(p) + vec3{1, 2, 3}) < 1e-14);
  CHECK(distance((r * t)(p), rotated(p + vec3{1, 2, 3})) < 1e-14);
  const affine_map about = rotation({1, 1, 0}, {0, 0, 2}, std::numbers::pi / 2);
  CHECK(distance(about({2, 1, 7}), {1, 2, 7}) < 1e-15 * 10);
  CHECK(affine_map()(p) == p);
  CHECK(is_rigid(r * t));
  CHECK_FALSE(is_rigid({{2, 0, 0}, {0, 1, 0}, {0, 0, 1}, {}}));
  CHECK_FALSE(is_rigid({{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {}}));
  CHECK_FALSE(is_rigid({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {not_a_number, 0, 0}}));
  CHECK_FALSE(is_rigid({{not_a_number, 0, 0}, {0, 1, 0}, {0, 0, 1}, {}}));
  CHECK_THROWS_AS((void)rotation({0, 0, 0}, {0, 0, 0}, 1), invalid_argument);
  CHECK_THROWS_AS((void)rotation({0, 0, 0}, {0, 0, 1}, not_a_number), invalid_argument);
  CHECK_THROWS_AS((void)translation({0, 0, not_a_number}), invalid_argument);
}

TEST_CASE("best_rigid_motion: finds rigid motions, of flat and straight points too") {
  std::mt19937 random(1);
  std::normal_distribution<double> in;
  for (int round = 0; round < 300; ++round) {
    const vec3 axis{in(random), in(random), in(random)};
    const affine_map f = translation({in(random), in(random), in(random)}) * rotation({in(random), 0, 0}, axis, round % 3 == 0 ? std::numbers::pi : in(random));
    std::vector<vec3> from, to;
    for (int i = 0; i < 12; ++i) from.push_back({in(random), in(random), round % 2 ? 0 : in(random)});
    for (const vec3& x : from) to.push_back(f(x));
    const affine_map g = best_rigid_motion(from, to);
    for (const vec3& x : from) CHECK(distance(g(x), f(x)) < 1e-12);
    CHECK(is_rigid(g, 1e-13));
  }
  // Points on a line: the smallest rotation. One point: a translation.
  const affine_map g = best_rigid_motion({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{5, 0, 0}, {5, 1, 0}, {5, 2, 0}});
  CHECK(distance(g({1, 0, 1}), {5, 1, 1}) < 1e-12);
  CHECK(best_rigid_motion({{1, 2, 3}}, {{2, 2, 3}}) == translation({1, 0, 0}));
  CHECK(best_rigid_motion({}, {}) == affine_map());
  CHECK(is_rigid(best_rigid_motion({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 0, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}}), 1e-12));  // a reflection
  CHECK_THROWS_AS((void)best_rigid_motion({{1, 2, 3}}, {}), invalid_argument);
  CHECK_THROWS_AS((void)best_rigid_motion({{1, 2, 3}}, {{not_a_number, 0, 0}}), invalid_argument);
}

TEST_CASE("best_rotation: is the best of many near it") {
  std::mt19937 random(2);
  std::normal_distribution<double> in;
  for (int round = 0; round < 300; ++round) {
    detail::moment_matrix m;
    for (int i = 0; i < (round % 5) + 1; ++i) m.add(1, {in(random), in(random), round % 7 ? in(random) : 0}, {in(random), in(random), in(random)});
    const auto r = detail::best_rotation(m);
    const affine_map f{r[0], r[1], r[2], {}};
    CHECK(is_rigid(f, 1e-12));
    const auto value = [&](const affine_map& g) { return dot(g.x, m.of[0]) + dot(g.y, m.of[1]) + dot(g.z, m.of[2]); };
    const double best = value(f);
    for (int k = 0; k < 20; ++k) CHECK(value(rotation({0, 0, 0}, {in(random), in(random), in(random)}, 0.01 * (k + 1)) * f) <= best + 1e-10);
  }
  CHECK(detail::best_rotation({})[0] == vec3{1, 0, 0});
}
