// Solutions of equations do not depend on the order in which a mesh is stored.
#include <concino/fields/harmonic_map.hpp>
#include <concino/fields/heat_flow.hpp>
#include <concino/fields/hodge_decomposition.hpp>
#include <concino/fields/poisson.hpp>
#include <concino/fields/smooth.hpp>
#include <concino/solve/ldlt.hpp>

#include <support/permuted.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("solutions do not depend on storage", M, CONCINO_KINDS) {
  for_each_stored_mesh<M>([](const storage_check<M>& check) {
    using s = stored_mesh<M>;
    const vert_id a{0}, b{check.original().verts.size() / 2 + 2};
    const auto fixed = [&](const s& x) { return std::vector<std::pair<vert_id, double>>{{x[a], 0.0}, {x[b], 1.0}}; };
    check.at_verts("harmonic_map", [&](const s& x) { return harmonic_map(x.mesh, fixed(x), {}, ldlt()); });
    check.at_verts("harmonic_map of exponent 2", [&](const s& x) { return harmonic_map(x.mesh, fixed(x), {.exponent = 2}, ldlt()); });
    check.at_verts("poisson", [&](const s& x) { return poisson(x.mesh, x.vert_values(), {.values = fixed(x)}, ldlt()); });
    check.at_verts("heat_flow", [&](const s& x) { return heat_flow(x.mesh, x.vert_values(), 0.02, {}, ldlt()); });
    check.at_verts("smooth", [&](const s& x) { return smooth(x.mesh, x.vert_values(), 0.1, {}, ldlt()); });
    if constexpr (TriMesh<M> || TetMesh<M>) {
      const auto parts = [](const s& x) { return hodge_decomposition(x.mesh, x.poly_vectors(), {}, ldlt()); };
      check.at_polys("exact part", [&](const s& x) { return parts(x).exact; });
      check.at_polys("coexact part", [&](const s& x) { return parts(x).coexact; });
    }
  });
}
