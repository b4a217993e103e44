// UV maps do not depend on the order in which a mesh is stored, nor on the first corner of a poly.
#include <concino/parametrize.hpp>

#include <support/permuted.hpp>
#include <support/uv_disks.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("UV maps do not depend on storage", M, CONCINO_SURFACE_KINDS) {
  using s = stored_mesh<M>;
  const M hill = grid_on<M>(5, on_hill), cone = grid_on<M>(4, on_cone), plane = grid<M>(3);
  for (const M* m : {&hill, &cone, &plane}) {
    const storage_check<M> check("a disk", *m);
    const auto in_space = [](const s& x, const auto& uv) {
      auto u = make_vert_map<vec3>(x.mesh);
      for (const auto v : verts(x.mesh)) u[v] = {uv[v][0], uv[v][1], 0};
      return u;
    };
    check.at_verts("tutte", [&](const s& x) { return in_space(x, tutte(x.mesh).uv); });
    check.at_verts("lscm", [&](const s& x) { return in_space(x, lscm(x.mesh)); });
    check.at_verts("spectral_conformal", [&](const s& x) { return in_space(x, spectral_conformal(x.mesh)); }, 100);
    check.at_verts("arap_map", [&](const s& x) { return in_space(x, arap_map(x.mesh, {.max_iterations = 5, .tolerance = 0}).uv); }, 10);
    check.at_verts("injective_map", [&](const s& x) { return in_space(x, injective_map(x.mesh, lscm(x.mesh), {.max_iterations = 2, .tolerance = 0}).uv); }, 100);
    check.at_polys("map_distortion: angles", [&](const s& x) { return map_distortion(x.mesh, tutte(x.mesh).uv).angle; }, 1e3);
    check.at_polys("map_distortion: areas", [&](const s& x) { return map_distortion(x.mesh, tutte(x.mesh).uv).area; });
    check.number("attached", [&](const s& x) { return static_cast<double>(tutte(x.mesh).attached.size()); });
  }
}
