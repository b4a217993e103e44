#include <concino/fields/detail/problems/laplace_system.hpp>

#include <concino/fields/harmonic_map.hpp>

#include <support/user_mesh.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

using namespace concino;

namespace {

/// A mesh whose range of verts is in descending order.
struct downwards : user_mesh::surface {};

}  // namespace

template<>
struct concino::mesh_traits<downwards> : concino::mesh_traits<user_mesh::surface> {
  static std::vector<vert> verts(const user_mesh::surface& m) {
    auto r = user_mesh::all<vert>(m.points.size());
    std::reverse(r.begin(), r.end());
    return r;
  }
};

/// Conductors along edges, also those of no poly. Masses are those of the mesh.
struct conductors {
  template<class M>
  auto edge_weights(const M& m) const { return make_edge_map<double>(m, 1.0); }
};

TEST_CASE("laplace_system: does not depend on the order of the verts") {
  user_mesh::surface m = user_mesh::surface_example();
  m.points[0] = {0.1, 0.05, 0};
  m.points[5] = {-1.2, -0.9, 0.1};
  const downwards turned{m};
  const user_mesh::vertex a{2}, b{6};
  for (const int n : {1, 2}) {
    const auto u = harmonic_map(m, {{a, 0.0}, {b, 1.0}}, {.exponent = n});
    const auto w = harmonic_map(turned, {{a, 0.0}, {b, 1.0}}, {.exponent = n});
    for (const auto v : verts(m)) CHECK(w[v] == doctest::Approx(u[v]).epsilon(1e-11));
  }
}

TEST_CASE("harmonic_map: higher exponents need a mass at every vert of a poly") {
  auto m = user_mesh::surface_example();  // vert 7 has no edges
  const user_mesh::vertex a{0}, b{5}, c{7};
  CHECK(harmonic_map(m, {{a, 0.0}, {b, 1.0}}, {.exponent = 2})[c] == 0);
  m.es.push_back({0, 7});
  CHECK(harmonic_map(m, {{a, 0.0}, {b, 1.0}}, {.exponent = 2})[c] == 0);
  CHECK(harmonic_map(m, {{a, 3.0}}, conductors())[c] == doctest::Approx(3));
  CHECK_THROWS_WITH_AS(harmonic_map(m, {{a, 0.0}, {b, 1.0}}, conductors(), {.exponent = 2}),
                       "harmonic_map: vert 7 has edges but no polys with a measure, so no mass; use uniform", invalid_mesh);
}

TEST_CASE("lumped masses: are 1 with uniform, else those of the mesh") {
  const user_mesh::surface m = user_mesh::surface_example();
  CHECK(detail::lumped_masses(m, uniform, "masses") == std::vector<double>(8, 1.0));
  const auto mass = vert_masses(m);
  CHECK(detail::lumped_masses(m, virtual_elements, "masses") == std::vector<double>(mass.values().begin(), mass.values().end()));
}
