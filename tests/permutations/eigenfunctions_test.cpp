// Eigenfunctions do not depend on the order in which a mesh is stored, but for signs, and for the basis where a value is multiple. So values are compared,
// and projections onto the span of all functions below a gap between values.
#include <concino/fields/eigenfunctions.hpp>

#include <support/permuted.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

namespace {

/// How many functions are below the largest gap between the values after the first two.
inline std::size_t num_below_gap(const std::vector<double>& values) {
  std::size_t best = 2;
  for (std::size_t k = 2; k < values.size(); ++k)
    if (values[k] - values[k - 1] > values[best] - values[best - 1]) best = k;
  return best;
}

}  // namespace

TEST_CASE_TEMPLATE("eigenfunctions do not depend on storage", M, CONCINO_KINDS) {
  for_each_stored_mesh<M>([](const storage_check<M>& check) {
    using s = stored_mesh<M>;
    constexpr std::size_t count = 6;
    const auto of = [](const s& x) { return eigenfunctions(x.mesh, count, lobpcg, {.tolerance = 1e-12, .accept_missed_tolerance = true}); };
    const std::size_t below = num_below_gap(of(check.original()).values);
    check.number("values", [&](const s& x) { return of(x).values; });
    check.at_verts("projection onto eigenfunctions", [&](const s& x) {
      const auto f = of(x);
      const auto u = x.vert_values();
      const auto mass = vert_masses(x.mesh);
      auto r = make_vert_map<double>(x.mesh, 0.0);
      for (std::size_t i = 0; i < below; ++i) {
        double product = 0;
        for (const vert_id v : x.verts) product += mass[v] * f.functions[i][v] * u[v];
        for (const vert_id v : x.verts) r[v] += product * f.functions[i][v];
      }
      return r;
    });
  });
}
