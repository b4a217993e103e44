#include <concino/generate/random_points.hpp>

#include <doctest/doctest.h>

#include <limits>

using namespace concino;

namespace {
box construct_from_arrays(vec3 low, vec3 high) {
  box b;
  b.min = low;
  b.max = high;
  return b;
}
}  // namespace

TEST_CASE("random_points: are uniform in the box and depend only on the seed") {
  const box b = construct_from_arrays({-1, 5, 100}, {1, 5, 1100});
  const auto points = random_points(4000, b, 7);
  CHECK(points == random_points(4000, b, 7));
  CHECK(!(points == random_points(4000, b, 8)));
  const auto fewer = random_points(10, b, 7);
  CHECK(std::equal(fewer.begin(), fewer.end(), points.begin()));
  vec3 sum, squares;
  for (const vec3& x : points) {
    CHECK((x.x >= -1 && x.x <= 1 && x.y == 5 && x.z >= 100 && x.z <= 1100));
    const vec3 u = {x.x, 0, (x.z - 600) / 500};
    sum += u;
    squares += vec3{u.x * u.x, u.x * u.z, u.z * u.z};
  }
  CHECK(norm(sum) / 4000 < 0.03);
  CHECK(norm(squares / 4000 - vec3{1.0 / 3, 0, 1.0 / 3}) < 0.03);
}

TEST_CASE("random_points: use the stream of SplitMix64") {
  detail::random_stream random(1234567);
  CHECK(random.next() == 6457827717110365317u);
  CHECK(random.next() == 3203168211198807973u);
  CHECK(random.next() == 9817491932198370423u);
}

TEST_CASE("random_points: throws if the box is empty or not finite") {
  CHECK(random_points(0, construct_from_arrays({0, 0, 0}, {0, 0, 0})).empty());
  CHECK_THROWS_AS(random_points(1, box()), invalid_argument);
  CHECK_THROWS_AS(random_points(1, construct_from_arrays({0, 0, 0}, {1, 1, std::numeric_limits<double>::infinity()})), invalid_argument);
  CHECK_THROWS_AS(random_points(1, construct_from_arrays({-1.7e308, 0, 0}, {1.7e308, 1, 1})), invalid_argument);
}
