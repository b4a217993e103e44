// Measures decimation by OpenMesh's Decimater with quadrics beside that of the library. Both refuse collapses that turn a normal by 90 degrees or more.
#include "../support/decimate.hpp"

#include <concino/adapters/openmesh.hpp>

#include <OpenMesh/Core/Mesh/Traits.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>

namespace {

struct traits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using mesh = OpenMesh::TriMesh_ArrayKernelT<traits>;

mesh from(const bench::surface_arrays& a) {
  mesh m;
  m.request_vertex_status(), m.request_edge_status(), m.request_face_status(), m.request_face_normals();
  for (const auto& x : a.points) m.add_vertex({x.x, x.y, x.z});
  const auto vert = [&](std::size_t i) { return OpenMesh::VertexHandle(static_cast<int>(a.verts[i].raw())); };
  for (std::size_t i = 0; i < a.verts.size(); i += 3) m.add_face(vert(i), vert(i + 1), vert(i + 2));
  m.update_face_normals();
  return m;
}

struct openmesh {
  static std::size_t decimate(mesh& m, std::size_t target) {
    OpenMesh::Decimater::DecimaterT<mesh> decimater(m);
    OpenMesh::Decimater::ModQuadricT<mesh>::Handle quadric;
    OpenMesh::Decimater::ModNormalFlippingT<mesh>::Handle normals;
    decimater.add(quadric);
    decimater.add(normals);
    decimater.module(quadric).unset_max_err();
    decimater.initialize();
    return decimater.decimate_to_faces(0, target);
  }
  static concino::trimesh to_concino(const mesh& m) { return concino::convert<concino::trimesh>(m); }
};

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    const auto a = p.data.bunny16();
    bench::compare_decimation<openmesh>(p, "openmesh", "bunny16", a, from(a));
  });
}
