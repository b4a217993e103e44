#include <concino/adapters/openmesh.hpp>

#include <support/foreign_decimation.hpp>
#include <support/kinds.hpp>
#include <support/openmesh.hpp>

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

namespace ct = concino::testing;

namespace {

struct decimate_traits : OpenMesh::DefaultTraitsDouble {
  VertexAttributes(OpenMesh::Attributes::Status);
  EdgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status);
};

}  // namespace

TEST_CASE_TEMPLATE("OpenMesh: decimation does what it does on a trimesh", M, CONCINO_FIRST_OF(OpenMesh::TriMesh_ArrayKernelT<decimate_traits>, OpenMesh::PolyMesh_ArrayKernelT<decimate_traits>)) {
  ct::decimates_as_trimesh_does<M>();
}
