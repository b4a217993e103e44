#include <concino/fields/heat_geodesics.hpp>

#include <concino/geometry/centroid.hpp>

#include <support/geodesic_errors.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <utility>
#include <vector>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("heat_geodesics: do not depend on the position of the mesh, and scale with it", M, CONCINO_KINDS) {
  const auto arrays = jittered(grid_arrays<M>(3), 0.02, VolumeMesh<M>);
  const M m(arrays);
  const vert_id s{1};
  const auto d = heat_geodesics(m, s);
  const auto changed = [&](double factor, const vec3& by) {
    auto a = arrays;
    for (vec3& x : a.points) x = factor * x + by;
    const M other(std::move(a));
    const auto e = heat_geodesics(other, s);
    return std::vector<double>(e.values().begin(), e.values().end());
  };
  const auto large = changed(0x1p20, {}), small = changed(0x1p-20, {}), moved = changed(1e3, {5, -7, 3});
  for (const auto v : verts(m)) {
    const std::size_t i = index_of(m, v);
    CHECK(large[i] == 0x1p20 * d[v]);
    CHECK(small[i] == 0x1p-20 * d[v]);
    CHECK(moved[i] == doctest::Approx(1e3 * d[v]).epsilon(1e-9));
  }
}

TEST_CASE_TEMPLATE("heat_geodesics: scale exactly with powers of two", M, CONCINO_KINDS) {
  const auto arrays = jittered(grid_arrays<M>(2), 0.02, VolumeMesh<M>);
  const auto scaled = [&](int exponent) { return M(scaled_by_power_of_two(arrays, exponent)); };
  const M m = scaled(0);
  const vert_id s{1};
  const auto d = heat_geodesics(m, s), e = heat_geodesics(m, {{s, 0.25}}, {.clamp = false});
  for (const int exponent : {-1000, -266, -45, 45, 67, 266, 1000}) {
    CAPTURE(exponent);
    const M other = scaled(exponent);
    const auto heat = prepare_heat_geodesics(other);
    const auto f = heat.distance_from(s), g = heat_geodesics(other, {{s, std::ldexp(0.25, exponent)}}, {.clamp = false});
    for (const auto v : verts(m)) {
      CHECK(f[v] == std::ldexp(d[v], exponent));
      CHECK(g[v] == std::ldexp(e[v], exponent));
    }
    const vec3 x = centroid(m, poly_id{0});
    const vec3 y{std::ldexp(x.x, exponent), std::ldexp(x.y, exponent), std::ldexp(x.z, exponent)};
    const auto in = heat_geodesics(m, poly_id{0}, x), out = heat.distance_from(poly_id{0}, y);
    for (const auto v : verts(m)) CHECK(out[v] == std::ldexp(in[v], exponent));
  }
}
