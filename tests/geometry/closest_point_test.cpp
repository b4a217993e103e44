#include <concino/geometry/closest_point.hpp>

#include <support/poly_triangles.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

TEST_CASE("closest_point: is right for a segment") {
  const vec3 a{1, 0, 0}, b{3, 0, 0};
  CHECK(closest_point({0, 5, 0}, a, b) == a);
  CHECK(closest_point({9, 5, 1}, a, b) == b);
  CHECK(closest_point({2.5, 5, 1}, a, b) == vec3{2.5, 0, 0});
  CHECK(closest_point({2.5, 5, 1}, a, a) == a);
  const vec3 p{0.1, 0.2, 0.3}, q{0.7, 0.3, 0.9};
  CHECK(closest_point(p, p, q) == p);
  CHECK(closest_point(q, p, q) == q);
}

TEST_CASE("closest_point: is right inside a triangle, and beyond each edge and corner") {
  const vec3 a{0, 0, 0}, b{4, 0, 0}, c{0, 4, 0};
  CHECK(norm(closest_point({1, 1, 7}, a, b, c) - vec3{1, 1, 0}) < 1e-15);
  CHECK(closest_point({1, -1, 7}, a, b, c) == vec3{1, 0, 0});
  CHECK(closest_point({-2, 3, -7}, a, b, c) == vec3{0, 3, 0});
  CHECK(closest_point({5, 5, 1}, a, b, c) == vec3{2, 2, 0});
  CHECK(closest_point({-1, -1, 1}, a, b, c) == a);
  CHECK(closest_point({9, 1, 1}, a, b, c) == b);
  CHECK(closest_point({-1, 9, 1}, a, b, c) == c);
  const vec3 p{0.1, 0.2, 0.3}, q{0.7, 0.3, 0.9}, r{0.2, 0.8, 0.4};
  for (const vec3& x : {p, q, r}) CHECK(closest_point(x, p, q, r) == x);
}

TEST_CASE("closest_point: is right for random triangles, also obtuse and thin ones") {
  point_stream at(1, -1, 1);
  for (int i = 0; i < 3000; ++i) {
    const vec3 a = at(), b = at(), x = at();
    const vec3 c = i % 3 == 0 ? a + 0.4 * (b - a) + std::pow(0.1, i % 9) * at() : at();
    const vec3 y = closest_point(x, a, b, c);
    const double aspect = dot(b - a, b - a) / norm(cross(b - a, c - a));
    CHECK(std::abs(norm(x - y) - distance_to({a, b, c}, x)) < 1e-14 * (1 + aspect));
    CHECK(distance_to({a, b, c}, y) < 1e-15 * (1 + aspect));
  }
}

TEST_CASE("closest_point: treats a triangle without area as a segment or point") {
  const vec3 a{0, 0, 0}, b{1, 1, 1}, c{3, 3, 3};
  CHECK(closest_point({2, 2, 2}, a, b, c) == vec3{2, 2, 2});
  CHECK(closest_point({2, 2, 2}, c, a, b) == vec3{2, 2, 2});
  CHECK(closest_point({9, 9, 9}, b, c, a) == c);
  CHECK(closest_point({9, 8, 9}, b, b, b) == b);
}
