// Measures splits, flips and collapses of edges in OpenMesh's triangle mesh beside those of the library.
#include "../support/edits.hpp"

#include <OpenMesh/Core/Mesh/DefaultTriMesh.hh>
#include <OpenMesh/Core/Mesh/Traits.hh>

namespace {

struct traits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using mesh = OpenMesh::TriMesh_ArrayKernelT<traits>;

mesh from(const bench::surface_arrays& a) {
  mesh m;
  m.request_vertex_status(), m.request_edge_status(), m.request_face_status();
  for (const auto& x : a.points) m.add_vertex({x.x, x.y, x.z});
  const auto vert = [&](std::size_t i) { return OpenMesh::VertexHandle(static_cast<int>(a.verts[i].raw())); };
  for (std::size_t i = 0; i < a.verts.size(); i += 3) m.add_face(vert(i), vert(i + 1), vert(i + 2));
  return m;
}

struct edits {
  static std::size_t num_edges(const mesh& m) { return m.n_edges(); }
  static bool split(mesh& m, bench::u32 i) {
    const OpenMesh::EdgeHandle e(static_cast<int>(i));
    m.split(e, m.add_vertex(m.calc_edge_midpoint(e)));
    return true;
  }
  static bool flip(mesh& m, bench::u32 i) {
    const OpenMesh::EdgeHandle e(static_cast<int>(i));
    if (!m.is_flip_ok(e)) return false;
    m.flip(e);
    return true;
  }
  static bool collapse(mesh& m, bench::u32 i) {
    const OpenMesh::EdgeHandle e(static_cast<int>(i));
    if (m.status(e).deleted() || !m.is_collapse_ok(m.halfedge_handle(e, 0))) return false;
    const auto middle = m.calc_edge_midpoint(e);
    const auto v = m.to_vertex_handle(m.halfedge_handle(e, 0));
    m.collapse(m.halfedge_handle(e, 0));
    m.set_point(v, middle);
    return true;
  }
};

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    const auto a = p.data.bunny16();
    bench::compare_edits<edits>(p, "openmesh", a, from(a));
  });
}
