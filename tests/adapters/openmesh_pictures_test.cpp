// A picture of an OpenMesh mesh: it is added to a scene by the same call as a native mesh, and not copied.
#include <concino/adapters/openmesh.hpp>
#include <concino/mesh/element_map.hpp>
#include <concino/mesh/trimesh.hpp>
#include <concino/render/scene.hpp>

#include <support/allocations.hpp>
#include <support/openmesh.hpp>
#include <support/threads.hpp>

#include <doctest/doctest.h>

using namespace concino;
using testing::allocated_by;

TEST_CASE("OpenMesh: a picture takes as much memory as that of a native mesh") {
  const surface_arrays arrays = testing::triangle_grid(40);
  const trimesh native(arrays);
  testing::om::tri_double m;
  testing::om::fill(m, arrays);
  const testing::with_num_threads alone(1);  // threads that help in a loop allocate
  const auto u = make_vert_map<double>(native, 1.0);
  const auto v = make_vert_map<double>(m, 1.0);
  const auto own = allocated_by([&] { scene().add(native, {.field = u, .edges = true}); });
  const auto foreign = allocated_by([&] { scene().add(m, {.field = v, .edges = true}); });
  // In debug mode OpenMesh itself allocates a string at each look at a property, here at the points.
  const auto at_points = allocated_by([&] {
    for (const auto x : verts(m)) CHECK(point(m, x)[2] == 0);
  });
  CHECK(foreign.bytes <= own.bytes + at_points.bytes);
}
