// No mesh data is copied: iterating over an OpenMesh mesh allocates nothing, algorithms allocate as much as on a native mesh, and they run on a
// mesh that cannot be copied.
#include <support/allocations.hpp>
#include <support/kinds.hpp>
#include <support/openmesh.hpp>
#include <support/threads.hpp>

#include <concino/concepts/views.hpp>
#include <concino/edit.hpp>
#include <concino/fields.hpp>
#include <concino/graph.hpp>
#include <concino/io/save.hpp>
#include <concino/mesh/trimesh.hpp>
#include <concino/validate.hpp>

#include <support/closed_surfaces.hpp>

using namespace concino;
using namespace concino::testing::om;
using testing::allocated_by;
using testing::allocations;

namespace {

template<class M>
void walk_everything(const M& m) {
  std::size_t met = 0;
  const auto walk = [&](const auto& ring) {
    for (const auto x : ring) met += 1 + index_of(m, x);
  };
  for (const auto v : verts(m)) {
    walk(adj_v2v(m, v));
    walk(adj_v2e(m, v));
    walk(adj_v2p(m, v));
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
  met += num_verts(m) + num_edges(m) + num_polys(m);
  CHECK(met > 0);
}

/// The allocations of each algorithm. The first of them allocates nothing.
template<class M>
std::vector<allocations> allocated_on(const M& m) {
  auto v = *verts(m).begin();
  auto p = *polys(m).begin();
  auto last = v;
  for (const auto w : verts(m)) last = w;
  return {allocated_by([&] { walk_everything(m); }),
          allocated_by([&] { bfs(m, v); }),
          allocated_by([&] { bfs(m, p); }),
          allocated_by([&] { dijkstra(m, v); }),
          allocated_by([&] { dijkstra(m, p); }),
          allocated_by([&] { shortest_path(m, v, last); }),
          allocated_by([&] { connected_components(m); }),
          allocated_by([&] { spanning_tree(dual(m)); }),
          allocated_by([&] { grow_regions(m, {v, last}, [](auto, auto) { return true; }); }),
          allocated_by([&] { boundary_loops(m); }),
          allocated_by([&] { laplacian(m, cotangent); }),
          allocated_by([&] { mass_matrix(m); }),
          allocated_by([&] { harmonic_map(m, {{v, 0.0}, {last, 1.0}}, uniform); }),
          allocated_by([&] { total_measure(m); })};
}

}  // namespace

TEST_CASE_TEMPLATE("OpenMesh: iterating allocates nothing, and algorithms allocate as much as on a native mesh", M, CONCINO_FIRST_OF(only_one, tri_double)) {
  const surface_arrays arrays = testing::jittered(testing::triangle_grid(30), 0.005);
  trimesh native(arrays);
  M m;
  fill(m, arrays);
  const testing::with_num_threads alone(1);  // threads that help in a loop allocate, and start only if the loop takes long
  const auto compare = [&] {
    // With assertions, OpenMesh allocates a string each time a property is read. For points these would be too many, so they are read through a map.
    // For status attributes they are few, and are recognised by their size.
    const auto mesh = with_points(m, as_map(m, m.points_property_handle()));
    const allocations string = allocated_by([&] { return m.has_face_status() && m.status(m.face_handle(0)).deleted(); });
    const auto expected = allocated_on(native), found = allocated_on(mesh);
    CHECK(expected.front() == allocations{});
    for (std::size_t i = 0; i < expected.size(); ++i) {
      CAPTURE(i);
      CHECK(found[i].count <= expected[i].count + 20 * string.count);
      CHECK(found[i].bytes <= expected[i].bytes + 20 * string.bytes);
    }
  };
  compare();
  for (int i = 0; i < 1800; i += 7) {
    remove_poly(native, poly_id(i));
    remove_poly(m, OpenMesh::FaceHandle(i));
  }
  compare();
}

TEST_CASE("OpenMesh: algorithms run on a const mesh that can be neither copied nor moved") {
  only_one filled;
  fill(filled, two_grids<only_one>(3));
  const only_one& m = filled;
  static_assert(!std::copy_constructible<only_one> && !std::move_constructible<only_one>);
  const OpenMesh::VertexHandle a = m.vertex_handle(0), b = m.vertex_handle(15), c = m.vertex_handle(20);
  CHECK(bfs(m, a)[b] == 3);
  CHECK(std::isinf(dijkstra(m, a)[c]));
  CHECK(connected_components(m).count == 3);
  CHECK(shortest_path(m, a, b).front() == a);
  CHECK(harmonic_map(m, {{a, 1.0}, {c, 2.0}})[b] == doctest::Approx(1));
  CHECK(total_measure(m) == doctest::Approx(2));
  CHECK(boundary_loops(m).count == 2);
  CHECK(validate(m).facts.components == 2);
  CHECK(spanning_tree(m).arcs.size() == num_verts(m) - 3);
  CHECK(grow_regions(m, {a, c}, [](auto, auto) { return true; })[b] == 0);
  CHECK(laplacian(m).rows() == static_cast<int>(vert_index_bound(m)));
  CHECK(!save_text(m, file_format::obj).empty());

  only_one torus;
  fill(torus, testing::triangulated(testing::rolled_grid(4, 5)));
  CHECK(homology_generators(torus).size() == 2);
}
