#include <concino/fields/detail/laplace_system.hpp>

#include <concino/fields/harmonic_map.hpp>

#include <support/tiny.hpp>

#include <doctest/doctest.h>

using namespace concino;

TEST_CASE("harmonic_map: higher exponents need a mass at every vert with edges") {
  auto m = tiny::surface_example();  // of which vert 7 has no edges
  const tiny::vertex a{0}, b{5}, c{7};
  CHECK(harmonic_map(m, {{a, 0.0}, {b, 1.0}}, {.exponent = 2})[c] == 0);
  m.es.push_back({0, 7});
  CHECK_THROWS_WITH_AS(harmonic_map(m, {{a, 0.0}, {b, 1.0}}, {.exponent = 2}),
                       "harmonic_map: vert 7 has edges but no polys with a measure, so no mass; use uniform weights", invalid_mesh);
}
