#include <concino/adapters/openmesh.hpp>

#include <support/foreign_remeshing.hpp>
#include <support/kinds.hpp>
#include <support/openmesh.hpp>

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

namespace ct = concino::testing;

namespace {

struct remesh_traits : OpenMesh::DefaultTraitsDouble {
  VertexAttributes(OpenMesh::Attributes::Status);
  EdgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status);
};

}  // namespace

TEST_CASE_TEMPLATE("OpenMesh: remeshing does what it does on a trimesh", M, CONCINO_FIRST_OF(OpenMesh::TriMesh_ArrayKernelT<remesh_traits>, OpenMesh::PolyMesh_ArrayKernelT<remesh_traits>)) {
  ct::remeshes_as_trimesh_does<M>();
}
