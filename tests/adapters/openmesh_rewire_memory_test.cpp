// Edits of OpenMesh meshes and their transactions change nothing if memory runs out.
#include <support/failing_allocations.hpp>
#include <support/foreign_operators.hpp>
#include <support/foreign_poly_edits.hpp>
#include <support/kinds.hpp>
#include <support/openmesh.hpp>

using namespace concino;
using namespace concino::testing::om;

TEST_CASE_TEMPLATE("OpenMesh: edits that run out of memory change nothing", M, CONCINO_FIRST_OF(tri_double, tri_status)) {
  M m;
  fill(m, testing::triangle_grid(2));
  testing::edits_are_all_or_nothing(m, 3, [](const auto& f) { return testing::for_each_failing_allocation(f, 8); });  // OpenMesh's assertions allocate memory
}

TEST_CASE("OpenMesh: edits of polygons and chords that run out of memory change nothing") {
  poly_double m;
  fill(m, testing::quad_grid(3));
  testing::poly_edits_are_all_or_nothing(m, [](const auto& f) { return testing::for_each_failing_allocation(f, 8); });
}

TEST_CASE("OpenMesh: a transaction for which there is no memory can be opened later") {
  tri_status start;
  fill(start, testing::triangle_grid(1));
  const auto result = testing::for_each_failing_allocation([&](const auto& attempt) {
    tri_status m = start;
    attempt([&] { transaction t(m); });
    {
      transaction t(m);
      edge_split(m, *edges(m).begin());
    }
    CHECK(testing::foreign_state(m) == testing::foreign_state(start));
  });
  CHECK(result.failed > 2);
}

TEST_CASE_TEMPLATE("OpenMesh: garbage_collect that runs out of memory changes nothing", M, CONCINO_FIRST_OF(tri_double, tri_status)) {
  M start;
  fill(start, two_grids<M>(2));
  OpenMesh::VPropHandleT<int> number;
  start.add_property(number);
  for (const auto v : verts(start)) start.property(number, v) = v.idx();
  for (const int p : {1, 3, 4}) remove_poly(start, start.face_handle(static_cast<unsigned>(p)));
  remove_vert(start, start.vertex_handle(0));
  const auto before = testing::foreign_state(start);
  const auto result = testing::for_each_failing_allocation([&](const auto& attempt) {
    M m = start;
    if (attempt([&] { garbage_collect(m); })) {
      CHECK(testing::foreign_state(m) == before);
      for (const auto v : verts(m)) CHECK(m.property(number, v) == v.idx());
      garbage_collect(m);
    }
    CHECK(vert_index_bound(m) == num_verts(m));
    CHECK(check_laws(m).empty());
  });
  CHECK(result.failed > 5);
  CHECK(result.leaks == 0);
}
