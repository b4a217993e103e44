// rewire on OpenMesh meshes: it does what the laws say, or refuses what half-edges cannot represent, and changes nothing then.
#include <support/foreign_operators.hpp>
#include <support/foreign_paths.hpp>
#include <support/kinds.hpp>
#include <support/openmesh.hpp>

using namespace concino;
using namespace concino::testing::om;
namespace ct = concino::testing;

static_assert(EditableSurfaceMesh<only_one> && EditableSurfaceMesh<tri_own> && EditableSurfaceMesh<poly_eigen> && !EditableSurfaceMesh<tri_planar>);
static_assert(!EditableSurfaceMesh<OpenMesh::PolyConnectivity> && !EditableVolumeMesh<only_one>);

TEST_CASE_TEMPLATE("OpenMesh: random cavities", M, CONCINO_FIRST_OF(tri_double, poly_status)) {
  std::mt19937 random(11);
  unsigned done = 0, refused = 0;
  for (unsigned round = 0; round < 4; ++round) {
    M m;
    fill(m, two_grids<M>(3));
    for (unsigned i = 0; i < 40; ++i) {
      (ct::rewires_by_the_laws(m, ct::random_foreign_cavity(m, random)) ? done : refused) += 1;
      check_rings(m);
    }
    ct::foreign_laws_hold(m);
  }
  CHECK(done > 40);
  CHECK(refused > 40);
}

TEST_CASE_TEMPLATE("OpenMesh: transactions leave no trace, and can be undone and done again", M, CONCINO_FIRST_OF(tri_double, tri_status, only_one)) {
  std::mt19937 random(13);
  for (unsigned round = 0; round < 5; ++round) {
    M m;
    fill(m, two_grids<M>(2));
    ct::transactions_leave_no_trace(m, random, [](const M& x) { check_rings(x); });
  }
}

TEST_CASE_TEMPLATE("OpenMesh: properties follow their elements", M, CONCINO_FIRST_OF(tri_double, tri_status)) {
  std::mt19937 random(14);
  M m;
  fill(m, two_grids<M>(3));
  OpenMesh::VPropHandleT<int> v;
  OpenMesh::EPropHandleT<int> e;
  OpenMesh::FPropHandleT<int> f;
  m.add_property(v), m.add_property(e), m.add_property(f);
  ct::values_follow(m, random, as_map(m, v), as_map(m, e), as_map(m, f));
}

TEST_CASE("OpenMesh: a copy of a mesh is not part of its transaction, and has no edits to undo") {
  std::mt19937 random(15);
  tri_status m;
  fill(m, testing::triangle_grid(2));
  transaction t(m);
  ct::edit_some_times(m, random, 5);
  tri_status copy = m;
  remove_poly(copy, *polys(copy).begin());
  const auto changed = ct::foreign_state(copy);
  t.roll_back();
  CHECK(ct::foreign_state(copy) == changed);
}

TEST_CASE("OpenMesh: edges that had no status attribute and no faces stay deleted when the attribute is requested") {
  poly_double m;
  fill(m, testing::quad_grid(2));
  m.request_face_status();
  m.delete_face(m.face_handle(0), false);
  const std::size_t edge_count = num_edges(m);
  remove_poly(m, m.face_handle(3));  // requests it
  CHECK(num_edges(m) == edge_count - 2);
  ct::foreign_laws_hold(m);
}

TEST_CASE("OpenMesh: what cannot be linked is refused with the reason") {
  tri_double m;
  fill(m, testing::triangle_grid(4));
  const auto before = ct::foreign_state(m);
  for (const auto p : polys(m))
    CHECK_THROWS_WITH_AS(flip_winding(m, p), doctest::Contains("cannot be linked: in OpenMesh at most two polys share an edge, in opposite directions"), unsupported);
  CHECK(ct::foreign_state(m) == before);
  CHECK(merge_verts(m, m.vertex_handle(0), {m.vertex_handle(24)}));  // two corners of the boundary now touch
  ct::foreign_laws_hold(m);
  tri_double grid;
  fill(grid, testing::triangle_grid(6));
  const auto inner = grid.vertex_handle(24), corner = grid.vertex_handle(0);
  const auto refused = merge_verts(grid, inner, {corner});
  CHECK(refused.reason == refusal::unsupported);
  CHECK(refused.why == "in OpenMesh a closed fan of polys is the only one at its vert");
  CHECK(can_merge_verts(grid, inner, {corner}).reason == refusal::unsupported);
  flip_winding(grid);
  ct::foreign_laws_hold(grid);
  CHECK(num_polys(grid) == 72);
}

TEST_CASE_TEMPLATE("OpenMesh: a path becomes edges", M, CONCINO_FIRST_OF(tri_double, poly_status)) {
  M m;
  fill(m, ct::triangle_grid(4));
  ct::embeds_a_path(m);
}

TEST_CASE_TEMPLATE("OpenMesh: a level set of a property or of a map becomes edges", M, CONCINO_FIRST_OF(tri_double, poly_status)) {
  M m;
  fill(m, ct::triangle_grid(4));
  OpenMesh::VPropHandleT<double> handle;
  m.add_property(handle);
  ct::embeds_a_level_set(m, as_map(m, handle));
  M n;
  fill(n, ct::triangle_grid(4));
  ct::embeds_a_level_set(n, make_vert_map<double>(n));
  CHECK(ct::foreign_state(m) == ct::foreign_state(n));
}
