// The sweep over the edges of a polygon agrees with a test of all pairs in exact integers.
#include <concino/validate/detail/self_intersection_finder.hpp>

#include <doctest/doctest.h>

#include <random>

using concino::detail::plane_point;

namespace {

struct whole { long x, y; };

long turn(whole a, whole b, whole c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }
bool within(whole a, whole b, whole c) {  // whether c is on the segment ab
  return turn(a, b, c) == 0 && std::min(a.x, b.x) <= c.x && c.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= c.y && c.y <= std::max(a.y, b.y);
}
bool meet(whole a, whole b, whole c, whole d) {
  const auto sign = [](long t) { return (t > 0) - (t < 0); };
  return within(a, b, c) || within(a, b, d) || within(c, d, a) || within(c, d, b) ||
         (sign(turn(a, b, c)) * sign(turn(a, b, d)) < 0 && sign(turn(c, d, a)) * sign(turn(c, d, b)) < 0);
}
/// Whether edges intersect; consecutive ones may share their common end only.
bool touches(const std::vector<whole>& p) {
  const std::size_t n = p.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) {
      const whole a = p[i], b = p[(i + 1) % n], c = p[j], d = p[(j + 1) % n];
      if (j == i + 1 || (i == 0 && j == n - 1)) {
        const whole far1 = j == i + 1 ? a : b, mid = j == i + 1 ? b : a, far2 = j == i + 1 ? d : c;
        if (within(mid, far1, far2) || within(mid, far2, far1)) return true;
      } else if (meet(a, b, c, d)) {
        return true;
      }
    }
  return false;
}

}  // namespace

TEST_CASE("self_intersection_finder: agrees with a test of all pairs on random polygons") {
  std::mt19937 random(3);
  concino::detail::self_intersection_finder touch, impatient(0);
  std::size_t simple = 0;
  for (int round = 0; round < 4000; ++round) {
    // Corners sorted by angle around the centre, which is simple; then a few of them are moved anywhere.
    const std::size_t n = 4 + random() % 30;
    const long size = round % 2 ? 200 : 12;
    std::vector<whole> p;
    for (std::size_t i = 0; i < n; ++i) {
      const double angle = 6.283185307 * static_cast<double>(i) / static_cast<double>(n), r = static_cast<double>(size) * (0.4 + 0.6 * static_cast<double>(random() % 100) / 100);
      p.push_back({std::lround(r * std::cos(angle)), std::lround(r * std::sin(angle))});
    }
    const auto anywhere = [&] { return static_cast<long>(random() % static_cast<unsigned>(2 * size)) - size; };
    for (unsigned k = static_cast<unsigned>(random() % 3); k-- > 0;) {
      const std::size_t corner = random() % n;
      p[corner].x = anywhere();
      p[corner].y = anywhere();
    }
    bool repeated = false;
    for (std::size_t i = 0; i < n; ++i) repeated = repeated || (p[i].x == p[(i + 1) % n].x && p[i].y == p[(i + 1) % n].y);
    if (repeated) continue;  // edges without length are skipped
    std::vector<plane_point> q;
    for (const whole& x : p) q.push_back({static_cast<double>(x.x), static_cast<double>(x.y)});
    const auto found = touch(q);
    const bool expected = touches(p);
    const auto in_order = impatient(q);
    CHECK(found.has_value() == expected);
    CHECK(in_order.has_value() == expected);
    for (const auto& pair : {found, in_order}) {
      if (!pair) continue;
      const auto [i, j] = *pair;
      CHECK(i < j);
      CHECK(j < n);
      CHECK(meet(p[i], p[(i + 1) % n], p[j], p[(j + 1) % n]));
    }
    simple += !expected;
  }
  CHECK(simple > 500);
  CHECK(simple < 3500);
}

TEST_CASE("self_intersection_finder: edges without length are ignored") {
  concino::detail::self_intersection_finder touch;
  const std::vector<plane_point> square = {{0, 0}, {0, 0}, {1, 0}, {1, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}};
  CHECK_FALSE(touch(square));
  CHECK_FALSE(touch(std::vector<plane_point>(5, plane_point{1, 1})));
  CHECK_FALSE(touch({}));
}

TEST_CASE("self_intersection_finder: is fast for many corners") {
  concino::detail::self_intersection_finder touch;
  std::vector<plane_point> circle;
  for (int i = 0; i < 100000; ++i) circle.push_back({std::cos(6.283185307 * i / 100000), std::sin(6.283185307 * i / 100000)});
  CHECK_FALSE(touch(circle));
  circle[70000] = {0, 0};
  CHECK_FALSE(touch(circle));
  circle[70000] = {1.5, 0.3};
  CHECK(touch(circle));
}

TEST_CASE("self_intersection_finder: is fast for long edges close to one another") {
  // A comb with slanted teeth: the boxes of any two of its long edges overlap.
  const auto comb = [](int teeth, double bend) {
    std::vector<plane_point> corners;
    const auto add = [&](double along, double across) { corners.push_back({along - across, along + across}); };
    for (int i = 0; i < teeth; ++i) {
      const double at = static_cast<double>(i) / teeth, step = 0.25 / teeth;
      add(0.1, at);
      add(1, at + step + (i == teeth / 2 ? bend : 0));
      add(1, at + 2 * step + (i == teeth / 2 ? bend : 0));
      add(0.1, at + 3 * step);
    }
    add(0, 1);
    add(0, 0);
    return corners;
  };
  concino::detail::self_intersection_finder touch;
  for (const int teeth : {4, 100, 20000}) {
    CHECK_FALSE(touch(comb(teeth, 0)));
    CHECK_FALSE(touch(comb(teeth, 0.2 / teeth)));
    CHECK(touch(comb(teeth, 1.0 / teeth)));
    CHECK(touch(comb(teeth, -0.9 / teeth)));
  }
}
