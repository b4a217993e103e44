// Measures OpenMesh's triangle mesh through its adapter, against loops over OpenMesh's half-edges.
#include "by_hand.hpp"

#include <concino/adapters/openmesh.hpp>

namespace {

struct traits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using mesh = OpenMesh::TriMesh_ArrayKernelT<traits>;

struct openmesh {
  const mesh& m;
  using vert = OpenMesh::VertexHandle;
  using poly = OpenMesh::FaceHandle;

  std::size_t num_verts() const { return m.n_vertices(); }
  std::size_t num_polys() const { return m.n_faces(); }
  std::size_t num_edges() const { return m.n_edges(); }
  vert vert_at(std::size_t i) const { return vert(static_cast<int>(i)); }
  poly poly_at(std::size_t i) const { return poly(static_cast<int>(i)); }
  template<class Handle>
  std::size_t index(Handle x) const { return static_cast<std::size_t>(x.idx()); }
  concino::vec3 at(vert v) const { return {m.point(v)[0], m.point(v)[1], m.point(v)[2]}; }

  template<class F>
  void leaving(vert v, F&& f) const {
    const auto first = m.halfedge_handle(v);
    if (!first.is_valid()) return;
    auto h = first;
    do {
      f(h);
      h = m.next_halfedge_handle(m.opposite_halfedge_handle(h));
    } while (h != first);
  }
  template<class F>
  void along(poly p, F&& f) const {
    const auto first = m.halfedge_handle(p);
    auto h = first;
    do {
      f(h);
      h = m.next_halfedge_handle(h);
    } while (h != first);
  }
  template<class F>
  void around(vert v, F&& f) const { leaving(v, [&](auto h) { f(m.to_vertex_handle(h)); }); }
  template<class F>
  void around(poly p, F&& f) const {
    along(p, [&](auto h) {
      const auto o = m.opposite_halfedge_handle(h);
      if (!m.is_boundary(o)) f(m.face_handle(o));
    });
  }
  template<class F>
  void corners(poly p, F&& f) const { along(p, [&](auto h) { f(m.from_vertex_handle(h)); }); }
  template<class F>
  void sides(poly p, F&& f) const { along(p, [&](auto h) { f(static_cast<std::size_t>(m.edge_handle(h).idx())); }); }
  template<class F>
  void edges_at(vert v, F&& f) const {
    leaving(v, [&](auto h) { f(static_cast<std::size_t>(m.edge_handle(h).idx()), m.to_vertex_handle(h)); });
  }
};

mesh from(const bench::surface_arrays& a) {
  mesh m;
  for (const auto& x : a.points) m.add_vertex({x.x, x.y, x.z});
  const auto corner = [&](std::size_t i) { return OpenMesh::VertexHandle(static_cast<int>(a.verts[i].raw())); };
  for (std::size_t i = 0; i < a.verts.size(); i += 3) m.add_face(corner(i), corner(i + 1), corner(i + 2));
  return m;
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    {
      const mesh m = from(p.data.tri1m());
      bench::by_hand::compare_all(p, "openmesh", openmesh{m}, m);
    }
    const mesh small = from(p.data.bunny());
    bench::by_hand::compare_harmonic(p, "openmesh", openmesh{small}, small);
  });
}
