// Problems by every solver: the same field, whichever triangle the solver reads.
#include <concino/fields/harmonic_map.hpp>

#include <concino/mesh/trimesh.hpp>
#include <concino/solve.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "support/meshes.hpp"

using namespace concino;

TEST_CASE("harmonic_map: the same by every solver, used again for another problem") {
  const trimesh m(testing::triangle_grid(12));
  const vert_id a{0}, b{100};
  const auto expected = harmonic_map(m, {{a, 0.0}, {b, 1.0}});
  const auto check = [&](auto&& solver) {
    for (int again = 0; again < 2; ++again) {
      const auto u = harmonic_map(m, {{a, 0.0}, {b, 1.0}}, {}, solver);
      double worst = 0;
      for (const auto v : verts(m)) worst = std::max(worst, std::abs(u[v] - expected[v]));
      CHECK(worst < 1e-9);
    }
  };
  check(llt{});
  check(lu{});
  check(qr{});
  check(conjugate_gradients{});
  check(bicgstab{});
  check(auto_solver{});
  check(auto_solver{{.most_factor_entries = 0}});
}
