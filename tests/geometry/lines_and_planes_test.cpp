#include <concino/geometry/lines_and_planes.hpp>

#include <doctest/doctest.h>

using namespace concino;

TEST_CASE("plane: signed distances do not depend on the length of the normal") {
  const plane p = plane_through({1, 2, 3}, {0, 0, 4});
  CHECK(p.offset == 12);
  CHECK(signed_distance(p, {7, -5, 5}) == 2);
  CHECK(signed_distance(p, {0, 0, 0}) == -3);
  CHECK(signed_distance(p, {1, 2, 3}) == 0);
  CHECK(signed_distance(plane{}, {1, 1, -2}) == -2);
  const plane diagonal = plane_through({0, 0, 0}, {1, 1, 0});
  CHECK(signed_distance(diagonal, {1, 1, 9}) == doctest::Approx(std::sqrt(2.0)).epsilon(1e-15));
}

TEST_CASE("ray and segment: return the point at a parameter") {
  CHECK(point_at(ray{{1, 0, 0}, {0, 2, 0}}, 3) == vec3{1, 6, 0});
  const segment s{{0.1, 0.2, 0.3}, {1.7, 3, 5}};
  CHECK(point_at(s, 0) == s.from);
  CHECK(point_at(s, 1) == s.to);
  CHECK(norm(point_at(s, 0.5) - vec3{0.9, 1.6, 2.65}) < 1e-15);
}

TEST_CASE("segment: the closest parameter is on the segment") {
  const segment s{{1, 1, 0}, {5, 1, 0}};
  CHECK(closest_parameter(s, {2, 9, 9}) == 0.25);
  CHECK(closest_parameter(s, {-3, 0, 0}) == 0);
  CHECK(closest_parameter(s, {8, 0, 0}) == 1);
  CHECK(closest_parameter(s, {5, 1, 0}) == 1);
  CHECK(closest_parameter(segment{{1, 1, 1}, {1, 1, 1}}, {2, 2, 2}) == 0);
}
