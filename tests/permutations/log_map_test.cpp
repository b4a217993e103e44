// Exact geodesics and what depends on tangent planes of surfaces do not depend on the order in which a mesh is stored. The frames of tangent vectors follow
// the first edge of a vert, so only lengths and angles between vectors are compared.
#include <concino/fields/exact_geodesics.hpp>
#include <concino/fields/log_map.hpp>
#include <concino/fields/parallel_transport.hpp>

#include <support/permuted.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("exact geodesics, the log map and parallel transport do not depend on storage", M, CONCINO_SURFACE_KINDS) {
  for_each_stored_mesh<M>([](const storage_check<M>& check) {
    using s = stored_mesh<M>;
    const vert_id a{8}, b{check.original().verts.size() / 2 + 2};
    if constexpr (TriMesh<M>) check.at_verts("exact_geodesics", [&](const s& x) { return exact_geodesics(x.mesh, {x[a], x[b]}); });
    const auto log = [&](const s& x) { return log_map(x.mesh, x[a]); };
    check.at_verts("distances of log_map", [&](const s& x) { return log(x).distance; });
    check.number("angles of log_map", [&](const s& x) {
      const auto r = log(x);
      std::vector<double> cosines;
      for (const vert_id v : x.verts) cosines.push_back(dot(r.direction[v], r.direction[x[b]]));
      return cosines;
    });
    check.number("lengths of parallel_transport", [&](const s& x) {
      const auto r = parallel_transport(x.mesh, {{x[a], tangent_vector{1, 0}}, {x[b], tangent_vector{2, 0}}});
      std::vector<double> lengths;
      for (const vert_id v : x.verts) lengths.push_back(norm(r[v]));
      return lengths;
    });
  });
}
