// OpenMesh: chords and blocks of meshes of quads, as of native ones, and edits of chords.
#include <concino/adapters/openmesh.hpp>

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>

#include <support/foreign_layouts.hpp>

#include <doctest/doctest.h>

namespace {

struct with_status : OpenMesh::DefaultTraitsDouble {
  VertexAttributes(OpenMesh::Attributes::Status);
  HalfedgeAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::PrevHalfedge);
  EdgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status);
};

}  // namespace

TEST_CASE("OpenMesh: chords, singularities, separatrices and blocks") {
  concino::testing::check_foreign_layouts<OpenMesh::PolyMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>>();
}

TEST_CASE("OpenMesh: chords are collapsed and inserted, at random too") {
  concino::testing::check_foreign_layer_edits<OpenMesh::PolyMesh_ArrayKernelT<with_status>>();
}
