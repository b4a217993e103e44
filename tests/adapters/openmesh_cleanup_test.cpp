// OpenMesh: remove_unreferenced and garbage_collect.
#include <concino/edit/remove_unreferenced.hpp>

#include <support/openmesh.hpp>

#include <doctest/doctest.h>

namespace cn = concino;
namespace om = concino::testing::om;

TEST_CASE_TEMPLATE("OpenMesh: remove_unreferenced", M, om::tri_float, om::tri_status, om::poly_double) {
  M m;
  om::fill(m, om::two_grids<M>(2));
  const std::size_t n = cn::num_verts(m), edges = cn::num_edges(m);
  CHECK(cn::remove_unreferenced(m) == cn::removed_counts{1});
  CHECK(cn::num_verts(m) == n - 1);
  CHECK(cn::num_edges(m) == edges);
  om::check_laws_hold(m);
  const std::vector<OpenMesh::FaceHandle> all(cn::polys(m).begin(), cn::polys(m).end());
  for (const auto p : all) cn::remove_poly(m, p);
  CHECK(cn::remove_unreferenced(m) == cn::removed_counts{n - 1});
  CHECK(cn::num_verts(m) == 0);
  om::check_laws_hold(m);
}
