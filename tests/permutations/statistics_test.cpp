// Statistics of fields and values at other elements do not depend on the order in which a mesh is stored.
#include <concino/fields/persistence.hpp>
#include <concino/fields/resample.hpp>
#include <concino/fields/statistics.hpp>
#include <concino/fields/to_polys.hpp>
#include <concino/level_sets/to_verts.hpp>

#include <support/permuted.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("statistics and values elsewhere do not depend on storage", M, CONCINO_KINDS) {
  for_each_stored_mesh<M>([](const storage_check<M>& check) {
    using s = stored_mesh<M>;
    check.number("statistics", [](const s& x) {
      const auto a = statistics(x.mesh, x.vert_values());
      const auto b = statistics(x.mesh, x.poly_values());
      return std::vector<double>{a.min, a.max, a.mean, a.deviation, a.integral, b.min, b.max, b.mean, b.deviation, b.integral};
    });
    check.number("persistence", [](const s& x) {
      const auto pairs = persistence(x.mesh, x.vert_values());
      std::vector<double> r;
      for (const auto& p : pairs.maxima) r.push_back(p.persistence);
      std::sort(r.begin(), r.end());
      const std::size_t n = r.size();
      for (const auto& p : pairs.minima) r.push_back(p.persistence);
      std::sort(r.begin() + static_cast<std::ptrdiff_t>(n), r.end());
      return r;
    });
    check.at_polys("to_polys", [](const s& x) { return to_polys(x.mesh, x.vert_values()); });
    check.at_verts("to_verts", [](const s& x) { return to_verts(x.mesh, x.poly_values()); });
    check.number("resample", [](const s& x) {
      auto other = make_grid<std::conditional_t<SurfaceMesh<M>, trimesh, tetmesh>>({.cells = {3, 3, 3}});
      jitter(other, 0.2, {.seed = 7, .keep_boundary = false, .in_plane = false});
      const auto at_verts = resample(x.mesh, x.vert_values(), other);
      const auto at_polys = resample(x.mesh, x.poly_values(), other);
      std::vector<double> r(at_verts.values().begin(), at_verts.values().end());
      r.insert(r.end(), at_polys.values().begin(), at_polys.values().end());
      return r;
    });
  });
}
