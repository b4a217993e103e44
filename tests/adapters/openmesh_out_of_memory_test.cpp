// If there is no memory for the status attributes of an OpenMesh mesh, removing an element changes nothing, and works later.
#include <concino/adapters/openmesh.hpp>
#include <concino/edit.hpp>
#include <concino/validate/check_laws.hpp>

#include <support/failing_allocations.hpp>

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>

#include <doctest/doctest.h>

namespace cn = concino;
using mesh = OpenMesh::PolyMesh_ArrayKernelT<>;
using vert = mesh::VertexHandle;
using poly = mesh::FaceHandle;

namespace {

/// Four triangles around v0.
mesh fan() {
  mesh m;
  const double x[5][2] = {{0, 0}, {1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  for (const auto& p : x) cn::add_vert(m, {p[0], p[1], 0});
  for (int i = 0; i < 4; ++i) cn::add_poly(m, {vert{0}, vert{i + 1}, vert{(i + 1) % 4 + 1}});
  return m;
}

}  // namespace

TEST_CASE("OpenMesh: status attributes are requested again after std::bad_alloc") {
  std::size_t refused = 0;
  const auto result = cn::testing::for_each_failing_allocation([&](const auto& attempt) {
    mesh m = fan();
    const bool failed = attempt([&] { cn::remove_poly(m, poly{1}); });
    if (failed) {
      ++refused;
      CHECK(cn::num_polys(m) == 4);
      cn::remove_poly(m, poly{1});
    }
    CHECK(cn::num_polys(m) == 3);
    CHECK(cn::check_laws(m).empty());
  });
  CHECK(refused > 0);
  CHECK(result.failed > 0);
}

TEST_CASE("OpenMesh: removing a vert allocates before it changes the mesh") {
  const auto result = cn::testing::for_each_failing_allocation([&](const auto& attempt) {
    mesh m = fan();
    const std::vector<poly> all(m.faces_begin(), m.faces_end());
    if (attempt([&] { cn::traits<mesh>::reserve_removal(m, all); })) CHECK(cn::num_polys(m) == 4);
    cn::remove_vert(m, vert{0});
    CHECK(cn::num_polys(m) == 0);
    CHECK(cn::num_verts(m) == 4);
    CHECK(cn::check_laws(m).empty());
  });
  CHECK(result.failed > 2);
  CHECK(result.leaks == 0);
}
