// Harmonic maps run on archetypes of the concepts that they need.
#include <concino/fields/harmonic_map.hpp>

#include <concino/concepts/archetypes.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("harmonic_map, uniform: runs on the archetype of a primal graph", M, CONCINO_KINDS) {
  const M m = grid<M>(2);
  const auto g = only_primal_graph(m);
  const vert_id a{0}, b{static_cast<unsigned>(num_verts(m) - 1)};
  const auto u = harmonic_map(m, {{a, 0.0}, {b, 1.0}}, uniform);
  const auto stripped = harmonic_map(g, {{g.vert(a), 0.0}, {g.vert(b), 1.0}}, uniform);
  for (const auto v : verts(g)) CHECK(stripped[v] == doctest::Approx(u[g.base(v)]).epsilon(1e-12));
  const auto squared = harmonic_map(g, {{g.vert(a), 0.0}, {g.vert(b), 1.0}}, uniform, {.exponent = 2});
  const auto expected = harmonic_map(m, {{a, 0.0}, {b, 1.0}}, uniform, {.exponent = 2});
  for (const auto v : verts(g)) CHECK(squared[v] == doctest::Approx(expected[g.base(v)]).epsilon(1e-8));
}

TEST_CASE_TEMPLATE("harmonic_map: higher exponents need no points, and points without polys are not enough", M, CONCINO_KINDS) {
  const M m = grid<M>(2);
  const vert_id a{0}, b{static_cast<unsigned>(num_verts(m) - 1)};
  const auto expected = harmonic_map(m, {{a, 0.0}, {b, 1.0}}, uniform, {.exponent = 2});
  const auto same = [&](const auto& stripped) {
    const auto u = harmonic_map(stripped, {{stripped.vert(a), 0.0}, {stripped.vert(b), 1.0}}, uniform, {.exponent = 2});
    for (const auto v : verts(stripped)) CHECK(u[v] == doctest::Approx(expected[stripped.base(v)]).epsilon(1e-8));
  };
  same(only_mesh(m));
  same(only_embedded_graph(m));
}
