// Orientation predicates are exact: they agree with integer arithmetic, also where rounding fails, and under all permutations.
#include <concino/geometry/orientation.hpp>

#include <doctest/doctest.h>

#include <array>
#include <random>

using namespace concino;

namespace {

__extension__ typedef __int128 wide;

int sign(wide x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

/// Points on a grid of 2^-30 near (1, 1, 1): their differences need about 31 bits, the triple products of these fit in 128.
struct grid_point {
  long long x, y, z;
  vec3 point() const {
    const double step = 0x1p-30;
    return {1 + step * static_cast<double>(x), 1 + step * static_cast<double>(y), 1 + step * static_cast<double>(z)};
  }
};

int exact2(const grid_point& a, const grid_point& b, const grid_point& c) {
  return sign(wide(a.x - c.x) * (b.y - c.y) - wide(a.y - c.y) * (b.x - c.x));
}
int exact3(const grid_point& a, const grid_point& b, const grid_point& c, const grid_point& d) {
  const wide ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z, vx = c.x - a.x, vy = c.y - a.y, vz = c.z - a.z, wx = d.x - a.x, wy = d.y - a.y, wz = d.z - a.z;
  return sign(ux * (vy * wz - vz * wy) + uy * (vz * wx - vx * wz) + uz * (vx * wy - vy * wx));
}

}  // namespace

TEST_CASE("orientation: is positive for the standard triangle and tet, negative if mirrored, 0 if flat") {
  const vec3 o{0, 0, 0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  CHECK(orient2d(o, x, y) == 1);
  CHECK(orient2d(o, y, x) == -1);
  CHECK(orient2d(o, x, {2, 0, 0}) == 0);
  CHECK(orient3d(o, x, y, z) == 1);
  CHECK(orient3d(o, y, x, z) == -1);
  CHECK(orient3d(o, x, y, {0.3, 0.4, 0}) == 0);
  CHECK(orient3d(o, o, o, o) == 0);
}

TEST_CASE("orientation: agrees with integer arithmetic near a line or plane") {
  std::mt19937_64 random(1);
  const auto some = [&](long long range) { return static_cast<long long>(random() % static_cast<unsigned long long>(2 * range + 1)) - range; };
  int flat = 0;
  for (int round = 0; round < 20000; ++round) {
    const long long range = round % 2 ? 1 << 30 : 1 << 10;
    const grid_point a{some(range), some(range), some(range)}, b{some(range), some(range), some(range)}, c{some(range), some(range), some(range)};
    grid_point d{some(range), some(range), some(range)};
    if (round % 3 == 0) {  // nearly coplanar: a combination of the others, moved by at most one unit
      const long long s = some(2), t = some(2), n = some(1);
      d = {a.x + s * (b.x - a.x) + t * (c.x - a.x), a.y + s * (b.y - a.y) + t * (c.y - a.y), a.z + s * (b.z - a.z) + t * (c.z - a.z) + n};
    }
    const int expected = exact3(a, b, c, d);
    flat += expected == 0;
    REQUIRE(orient3d(a.point(), b.point(), c.point(), d.point()) == expected);
    REQUIRE(orient2d(a.point(), b.point(), d.point()) == exact2(a, b, d));
  }
  CHECK(flat > 1000);
}

TEST_CASE("orientation: every exchange of two points changes the sign") {
  const std::array<vec3, 4> p = {vec3{0.1, 0.2, 0.3}, {0.1 + 0x1p-54, 0.7, 0.9}, {0.3, 0.2, 1e-17}, {0.2, 0.45, 0.6}};
  const int whole = orient3d(p[0], p[1], p[2], p[3]);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      auto q = p;
      std::swap(q[i], q[j]);
      CHECK(orient3d(q[0], q[1], q[2], q[3]) == -whole);
    }
}

TEST_CASE("orientation: is right for a point one unit off a line, where rounding fails") {
  // Kettner et al. 2008: evaluated in doubles only, these have all three signs at random
  int wrong = 0;
  for (int i = 0; i < 64; ++i)
    for (int j = 0; j < 64; ++j) {
      const vec3 a{0.5 + i * 0x1p-53, 0.5 + j * 0x1p-53, 0}, b{12, 12, 0}, c{24, 24, 0};
      const int expected = i < j ? 1 : i > j ? -1 : 0;  // points above the diagonal are to the left of it
      wrong += orient2d(b, c, a) != expected;
    }
  CHECK(wrong == 0);
}

TEST_CASE("orientation: is right for large and small coordinates") {
  for (const double s : {1e-90, 1e-30, 1.0, 1e30, 1e90}) {
    CHECK(orient3d({0, 0, 0}, {s, 0, 0}, {0, s, 0}, {s / 3, s / 3, s * 0x1p-60}) == 1);
    CHECK(orient3d({s, s, s}, {2 * s, s, s}, {s, 2 * s, s}, {3 * s, 3 * s, s}) == 0);
  }
}
