// worst: finds the poly that is worst by any metric.
#include <concino/quality/worst.hpp>

#include <concino/concepts/archetypes.hpp>

#include <support/generators.hpp>
#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <cmath>

namespace cn = concino;
using cn::metric;

TEST_CASE_TEMPLATE("worst: no poly is worse", M, CONCINO_KINDS) {
  const M m(cn::testing::jittered(cn::testing::grid_arrays<M>(3), 0.1));
  for (const metric what : {metric::scaled_jacobian, metric::edge_ratio, metric::relative_size_squared}) {
    const auto w = cn::worst(m, what);
    const auto all = cn::quality(m, what);
    CHECK(all[w.poly] == w.value);
    for (const auto p : cn::polys(m)) CHECK_FALSE(cn::is_worse(what, all[p], w.value));
    const auto g = cn::only_embedded_mesh(m);
    CHECK(g.base(cn::worst(g, what).poly) == w.poly);
  }
}

TEST_CASE("worst: a poly with a point that is not finite, ties, no polys") {
  const cn::trimesh m({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {std::nan(""), 0, 0}}, {{0, 1, 2}, {1, 3, 2}, {0, 4, 1}});
  const auto w = cn::worst(m, metric::aspect);
  CHECK(w.poly == cn::poly_id{2});
  CHECK(std::isnan(w.value));
  const cn::trimesh tied({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {1, 3, 2}});
  CHECK(cn::worst(tied, metric::minimum_angle).poly == cn::poly_id{0});
  CHECK(cn::worst(tied, metric::minimum_angle).value == doctest::Approx(45));
  CHECK_THROWS_AS(cn::worst(cn::trimesh(), metric::area), cn::invalid_mesh);
  CHECK_THROWS_AS(cn::worst(tied, metric::volume), cn::unsupported);
}
