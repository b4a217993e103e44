// Models: OpenMesh's triangle meshes with floats, its polygon meshes with doubles, and a derived class.
#pragma once

#include <concino/adapters/openmesh.hpp>

#include <agreement/run.hpp>

namespace concino::agreement {

struct in_doubles : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
};
struct derived_from_openmesh : OpenMesh::PolyMesh_ArrayKernelT<in_doubles> {};

template<class K, class M>
struct openmesh {
  using kind = K;
  static constexpr const char* column = "OpenMesh";
  static constexpr const char* name = polys_of_kind<K>;
  static constexpr bool any_surface = false, gaps = true;

  template<class F>
  static void with(const input<surface_arrays>& in, F&& f) {
    M m;
    m.request_vertex_status();
    m.request_edge_status();
    m.request_face_status();
    const K n(in.arrays);
    for (const auto v : verts(n)) {
      typename M::Point x;
      for (unsigned i = 0; i < 3; ++i) x[i] = static_cast<typename M::Point::value_type>(point(n, v)[i]);
      m.add_vertex(x);
    }
    for (const auto p : polys(n)) {
      std::vector<OpenMesh::VertexHandle> ring;
      for (const auto v : adj_p2v(n, p)) ring.emplace_back(static_cast<int>(v.raw()));
      m.add_face(ring);
    }
    for (const unsigned p : in.gone_polys) m.delete_face(OpenMesh::FaceHandle(static_cast<int>(p)), false);
    for (const unsigned v : in.gone_verts) m.delete_vertex(OpenMesh::VertexHandle(static_cast<int>(v)));
    f(std::as_const(m));
  }
};

using openmesh_meshes = models<openmesh<trimesh, OpenMesh::TriMesh_ArrayKernelT<>>, openmesh<polygonmesh, derived_from_openmesh>>;

}  // namespace concino::agreement
