// Boost.Graph's algorithms run on OpenMesh's meshes, with OpenMesh's properties as property maps.
#include <support/allocations.hpp>
#include <support/openmesh.hpp>

#include <concino/concepts/views.hpp>
#include <concino/graph/boost.hpp>
#include <concino/mesh/trimesh.hpp>

#include <boost/graph/connected_components.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>

using namespace concino;
using namespace concino::testing::om;
using testing::allocated_by;

TEST_CASE("OpenMesh and Boost: properties store labels and distances") {
  only_one m;
  fill(m, two_grids<only_one>(3));
  m.delete_face(m.face_handle(0), true);
  OpenMesh::VPropHandleT<int> part;
  OpenMesh::VPropHandleT<double> far;
  m.add_property(part);
  m.add_property(far);
  CHECK(boost::connected_components(primal(m), boost_map(as_map(m, part))) == 3);
  CHECK(m.property(part, m.vertex_handle(1)) == 0);
  CHECK(m.property(part, m.vertex_handle(16)) == 1);
  boost::dijkstra_shortest_paths(primal(m), m.vertex_handle(1), boost::distance_map(boost_map(as_map(m, far))));
  CHECK(m.property(far, m.vertex_handle(2)) == doctest::Approx(1.0 / 3));
}

TEST_CASE("OpenMesh and Boost: visiting elements allocates nothing") {
  const surface_arrays s = testing::triangle_grid(12);
  const trimesh native(s);
  only_one m;
  fill(m, s);
  const auto verts_of = [](const auto& mesh) {
    auto labels = make_vert_map<int>(mesh);
    return allocated_by([&] { boost::connected_components(primal(mesh), boost_map(labels)); }).count;
  };
  const auto polys_of = [](const auto& mesh) {
    auto labels = make_poly_map<int>(mesh);
    return allocated_by([&] { boost::connected_components(dual(mesh), boost_map(labels)); }).count;
  };
  CHECK(verts_of(m) <= verts_of(native) + 60);
  CHECK(polys_of(m) <= polys_of(native) + 60);
}
