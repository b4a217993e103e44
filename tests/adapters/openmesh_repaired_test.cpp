// OpenMesh: repaired() to a native mesh, of meshes with deleted elements too.
#include <concino/edit/elements.hpp>
#include <concino/repair.hpp>
#include <concino/validate/validate.hpp>

#include <support/kinds.hpp>
#include <support/openmesh.hpp>

#include <doctest/doctest.h>

namespace cn = concino;
namespace om = concino::testing::om;

TEST_CASE_TEMPLATE("OpenMesh: repaired", M, CONCINO_FIRST_OF(om::tri_status, om::poly_double)) {
  M m;
  om::fill(m, om::two_grids<M>(3));
  const std::size_t n = cn::num_polys(m);
  cn::remove_poly(m, OpenMesh::FaceHandle(1));
  const auto [mesh, fix] = cn::repaired(m, {.merge_within = 0.0, .fill_holes = 4});
  static_assert(std::is_same_v<std::remove_cvref_t<decltype(mesh)>, cn::repaired_mesh_of<M>>);
  CHECK(fix.count(cn::repair_kind::removed_verts) == 1);
  CHECK(cn::validate(mesh).count(cn::defect_kind::isolated_vert) == 0);
  CHECK(cn::num_polys(mesh) >= n - 1);
  // verts and polys have the indices of those of which they were made
  for (const auto v : cn::verts(mesh)) {
    const auto from = fix.from.verts.only(v.raw());
    REQUIRE(from != cn::element_origins::none);
    CHECK(cn::point(mesh, v) == cn::to_vec3(cn::point(m, OpenMesh::VertexHandle(static_cast<int>(from)))));
  }
  for (const auto p : cn::polys(mesh)) {
    const auto from = fix.from.polys.only(p.raw());
    CHECK(from != 1);
    if (from == cn::element_origins::none) continue;
    CHECK(cn::contains(m, OpenMesh::FaceHandle(static_cast<int>(from))));
  }
  const std::size_t polys = cn::num_polys(m);
  CHECK_THROWS_AS(cn::repaired(m, {.merge_within = -1.0}), cn::invalid_argument);
  CHECK(cn::num_polys(m) == polys);
}
