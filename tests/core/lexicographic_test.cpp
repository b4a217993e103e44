#include <concino/core/lexicographic.hpp>

#include <doctest/doctest.h>

using namespace concino;

TEST_CASE("is_lexicographically_less: compares x, then y, then z") {
  const vec3 sorted[] = {{-1, 5, 5}, {0, -2, 9}, {0, -2, 10}, {0, 3, -4}, {2, 0, 0}};
  for (const vec3& a : sorted)
    for (const vec3& b : sorted) CHECK(core::is_lexicographically_less(a, b) == (&a < &b));
  CHECK_FALSE(core::is_lexicographically_less({0, 0, 0}, {-0.0, 0, 0}));
}
