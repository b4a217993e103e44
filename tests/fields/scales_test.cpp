// Fields do not depend on the scale of the mesh, to the last bit.
#include <concino/fields/harmonic_map.hpp>
#include <concino/fields/heat_flow.hpp>
#include <concino/fields/poisson.hpp>
#include <concino/fields/smooth.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <utility>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("harmonic_map, poisson, heat_flow, smooth: do not depend on the scale of the mesh", M, CONCINO_KINDS) {
  const auto arrays = jittered(grid_arrays<M>(2), 0.02, VolumeMesh<M>);
  const auto scaled = [&](int exponent) { return M(scaled_by_power_of_two(arrays, exponent)); };
  const M m = scaled(0);
  const vert_id a{0}, b{5};
  auto f = make_vert_map<double>(m);
  for (const auto v : verts(m)) f[v] = std::sin(2 * point(m, v).x) + point(m, v).y;
  const auto same = [](const auto& u, const auto& w) {
    for (const auto v : verts(u.mesh()))
      if (!(u[v] == w[v])) return false;
    return true;
  };
  const auto u = harmonic_map(m, {{a, 0.0}, {b, 1.0}}), u2 = harmonic_map(m, {{a, 0.0}, {b, 1.0}}, {.exponent = 2});
  const auto p = poisson(m, f, {.values = {{a, 0.5}}});
  const auto h = heat_flow(m, f, 0.01), s = smooth(m, f, 0.01);
  for (const int exponent : {-400, -266, -45, 45, 266, 400}) {
    CAPTURE(exponent);
    const M other = scaled(exponent);
    CHECK(same(harmonic_map(other, {{a, 0.0}, {b, 1.0}}), u));
    CHECK(same(prepare_harmonic_map(other, {a, b}, {.exponent = 2}).with_values({{a, 0.0}, {b, 1.0}}), u2));
    auto load = f;
    for (const auto v : verts(m)) load[v] = std::ldexp(f[v], -2 * exponent);
    CHECK(same(poisson(other, load, {.values = {{a, 0.5}}}), p));
    CHECK(same(prepare_poisson(other, {a}).solve(load, {.values = {{a, 0.5}}}), p));
    CHECK(same(heat_flow(other, f, std::ldexp(0.01, 2 * exponent)), h));
    CHECK(same(prepare_smooth(other, std::ldexp(0.01, 2 * exponent)).apply(f), s));
  }
  for (const int exponent : {-1000, 1000}) {
    const M other = scaled(exponent);
    CHECK(same(harmonic_map(other, {{a, 0.0}, {b, 1.0}}), u));
  }
}
