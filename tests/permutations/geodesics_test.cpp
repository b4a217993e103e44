// Geodesic distances do not depend on the order in which a mesh is stored.
#include <concino/fields/heat_geodesics.hpp>
#include <concino/solve/ldlt.hpp>

#include <support/permuted.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("heat geodesics do not depend on storage", M, CONCINO_KINDS) {
  for_each_stored_mesh<M>([](const storage_check<M>& check) {
    using s = stored_mesh<M>;
    const vert_id a{0}, b{check.original().verts.size() / 2 + 2};
    check.at_verts("heat_geodesics", [&](const s& x) { return heat_geodesics(x.mesh, x[a], {.clamp = true}, ldlt()); });
    check.at_verts("heat_geodesics of two", [&](const s& x) { return heat_geodesics(x.mesh, {{x[a], 0.1}, {x[b], 0.0}}, {.clamp = true}, ldlt()); });
    check.at_verts("heat_geodesics without bounds", [&](const s& x) { return heat_geodesics(x.mesh, x[b], {}, ldlt()); });
    const poly_id p{1};
    check.at_verts("heat_geodesics from a poly", [&](const s& x) {
      return heat_geodesics(x.mesh, x[p], centroid(x.mesh, x[p]), {}, ldlt());
    });
  });
}
