// No mesh data is copied: iterating over a CGAL mesh allocates nothing, and algorithms allocate as much as on a native mesh.
#include <concino/adapters/cgal_polyhedron.hpp>
#include <concino/adapters/cgal_surface_mesh.hpp>
#include <concino/fields.hpp>
#include <concino/graph.hpp>
#include <concino/mesh/trimesh.hpp>
#include <concino/render/scene.hpp>

#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <doctest/doctest.h>
#include <support/allocations.hpp>
#include <support/cgal.hpp>
#include <support/threads.hpp>

using namespace concino;
using testing::allocated_by;
using testing::allocations;

namespace {

using kernel = CGAL::Simple_cartesian<double>;
using surface_mesh = CGAL::Surface_mesh<kernel::Point_3>;
using with_id = CGAL::Polyhedron_3<kernel, CGAL::Polyhedron_items_with_id_3>;

/// Calls the verbs for every element, index, adjacency and point.
template<class M>
void walk_everything(const M& m) {
  std::size_t met = 0;
  const auto walk = [&](const auto& ring) {
    for (const auto x : ring) met += 1 + index_of(m, x);
  };
  double sum = 0;
  for (const auto v : verts(m)) {
    walk(adj_v2v(m, v));
    walk(adj_v2e(m, v));
    walk(adj_v2p(m, v));
    sum += to_vec3(point(m, v)).x;
  }
  for (const auto e : edges(m)) {
    walk(adj_e2v(m, e));
    walk(adj_e2p(m, e));
  }
  for (const auto p : polys(m)) {
    walk(adj_p2v(m, p));
    walk(adj_p2e(m, p));
    walk(adj_p2p(m, p));
  }
  CHECK(met > 0);
  CHECK(sum > 0);
}

/// The allocations of each algorithm.
template<class M>
std::vector<allocations> allocated_on(const M& m) {
  const auto v = *verts(m).begin();
  const auto p = *polys(m).begin();
  auto last = v;
  for (const auto w : verts(m)) last = w;
  std::vector<allocations> r(9);
  r[0] = allocated_by([&] { bfs(m, v); });
  r[1] = allocated_by([&] { bfs(m, p); });
  r[2] = allocated_by([&] { dijkstra(m, v); });
  r[3] = allocated_by([&] { dijkstra(m, p); });
  r[4] = allocated_by([&] { connected_components(m); });
  r[5] = allocated_by([&] { laplacian(m, uniform); });
  r[6] = allocated_by([&] { harmonic_map(m, {{v, 0.0}, {last, 1.0}}, uniform); });
  r[7] = allocated_by([&] { scene().add(m, {.edges = true}); });
  r[8] = allocated_by([&] { walk_everything(m); });
  return r;
}

}  // namespace

TEST_CASE("CGAL: the counter of this test counts allocations") {
  CHECK(allocated_by([] { std::vector<int> a(100); CHECK(a.size() == 100); }).bytes >= 400);
}

TEST_CASE("CGAL: iterating allocates nothing, and algorithms allocate as much as on a native mesh") {
  const surface_arrays arrays = testing::jittered(testing::triangle_grid(40), 0.005);
  const trimesh native(arrays);
  const surface_mesh m = testing::cgal_surface<kernel::Point_3>(arrays);
  with_id p;
  CGAL::copy_face_graph(m, p);
  CGAL::set_halfedgeds_items_id(p);
  const testing::with_num_threads alone(1);  // threads that help in a loop allocate, and start only if the loop takes long
  const auto expected = allocated_on(native), on_surface_mesh = allocated_on(m), on_polyhedron = allocated_on(p);
  CHECK(expected.back() == allocations{});
  for (std::size_t i = 0; i < expected.size(); ++i) {
    CAPTURE(i);
    CHECK(on_surface_mesh[i].bytes <= expected[i].bytes);
    CHECK(on_polyhedron[i].bytes <= 2 * expected[i].bytes);  // the handles in its queues are pointers, which are larger
  }
  CHECK(on_polyhedron.back() == allocations{});
}

TEST_CASE("CGAL: iterating over a mesh with garbage allocates nothing, and indexed(m) only its tables") {
  surface_mesh m = testing::cgal_surface<kernel::Point_3>(testing::triangle_grid(20));
  with_id p;
  CGAL::copy_face_graph(m, p);
  for (int i = 0; i < 100; ++i) CGAL::Euler::remove_face(m.halfedge(*polys(m).begin()), m);
  CHECK(allocated_by([&] { walk_everything(m); }) == allocations{});
  const std::size_t elements = num_verts(p) + num_edges(p) + num_polys(p);
  const auto tables = allocated_by([&] { indexed(p); });
  CHECK(tables.bytes <= 73 * elements);
  CHECK(tables.count <= 5);
  const auto i = indexed(p);
  CHECK(allocated_by([&] { walk_everything(i); }) == allocations{});
  CHECK(allocated_by([&] { const auto copy = i; CHECK(&copy.base() == &p); }) == allocations{});
}
