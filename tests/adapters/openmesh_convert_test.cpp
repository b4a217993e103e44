// OpenMesh's meshes convert from and to native meshes, and pass the conformance kit in every state.
#include <concino/adapters/doctest.hpp>
#include <concino/adapters/openmesh.hpp>

#include <support/foreign_conversions.hpp>
#include <support/kinds.hpp>

namespace cn = concino;

namespace {

struct in_doubles : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
};
using triangles = OpenMesh::TriMesh_ArrayKernelT<in_doubles>;
using polygons = OpenMesh::PolyMesh_ArrayKernelT<in_doubles>;

}  // namespace

TEST_CASE("OpenMesh: converting there and back is the identity, and non-manifold meshes throw") {
  cn::testing::conversions_of_half_edge_meshes<triangles, polygons>();
}

TEST_CASE_TEMPLATE("OpenMesh: meshes conform in every state", M, CONCINO_FIRST_OF(triangles, polygons)) {
  cn::check_conformance([] {
    cn::trimesh t = cn::testing::grid<cn::trimesh>(3);
    cn::add_vert(t, {7, 7, 7});
    return cn::convert<M>(t);
  });
}

TEST_CASE("OpenMesh: converting the corpus there and back is the identity") { cn::testing::corpus_there_and_back<polygons>(); }
