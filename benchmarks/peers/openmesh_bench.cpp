// Measures reading surfaces into OpenMesh's polygon mesh with double coordinates.
#include "../support/peer.hpp"

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/DefaultTriMesh.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/Traits.hh>

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    struct traits : OpenMesh::DefaultTraits {
      using Point = OpenMesh::Vec3d;
      using Normal = OpenMesh::Vec3d;
    };
    using mesh = OpenMesh::PolyMesh_ArrayKernelT<traits>;
    bench::compare_reading(
        p, "openmesh",
        [](const std::string& path) {
          mesh m;
          if (!OpenMesh::IO::read_mesh(m, path)) throw std::runtime_error("OpenMesh cannot read " + path);
          return m;
        },
        [](const mesh& m) { return m.n_faces(); });
  });
}
