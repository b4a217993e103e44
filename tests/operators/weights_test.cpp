#include <concino/operators/weights.hpp>

#include <doctest/doctest.h>

using namespace concino;

TEST_CASE("weights of a triangle in space: one formula for surfaces and volumes, checked against gradients of the hat functions") {
  const std::array<vec3, 3> x = {vec3{0.1, 0.3, -1}, vec3{2, 0.5, 0.4}, vec3{0.7, 1.9, 0.2}};
  const detail::simplex_weights<2> w(x);
  const vec3 normal = cross(x[1] - x[0], x[2] - x[0]);
  vec3 gradient[3];  // of hat i: normal to the opposite edge in the plane, 1 / height
  for (std::size_t i = 0; i < 3; ++i) {
    const vec3 edge = x[(i + 2) % 3] - x[(i + 1) % 3];
    gradient[i] = cross(normal, edge) / dot(normal, normal);
    CHECK(dot(gradient[i], x[i] - x[(i + 1) % 3]) == doctest::Approx(1));
  }
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) CHECK(w(i, j) == doctest::Approx(-0.5 * norm(normal) * dot(gradient[i], gradient[j])));
}

TEST_CASE("weights of a tet") {
  const std::array<vec3, 4> x = {vec3{0.1, 0.3, -1}, vec3{2, 0.5, 0.4}, vec3{0.7, 1.9, 0.2}, vec3{0.3, 0.2, 2}};
  const detail::simplex_weights<3> w(x);
  const double volume = std::abs(dot(cross(x[1] - x[0], x[2] - x[0]), x[3] - x[0])) / 6;
  vec3 gradient[4];
  for (std::size_t i = 0; i < 4; ++i) {
    const vec3 a = x[(i + 1) % 4], normal = cross(x[(i + 2) % 4] - a, x[(i + 3) % 4] - a);
    gradient[i] = normal / dot(normal, x[i] - a);
  }
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) CHECK(w(i, j) == doctest::Approx(-volume * dot(gradient[i], gradient[j])));
}
