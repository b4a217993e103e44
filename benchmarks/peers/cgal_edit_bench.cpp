// Measures splits, flips and collapses of edges in CGAL::Surface_mesh beside those of the library.
#include "../support/edits.hpp"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

namespace {

using mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

mesh from(const bench::surface_arrays& a) {
  mesh m;
  for (const auto& x : a.points) m.add_vertex({x.x, x.y, x.z});
  const auto vert = [&](std::size_t i) { return mesh::Vertex_index(a.verts[i].raw()); };
  for (std::size_t i = 0; i < a.verts.size(); i += 3) m.add_face(vert(i), vert(i + 1), vert(i + 2));
  return m;
}

auto middle(const mesh& m, mesh::Edge_index e) { return CGAL::midpoint(m.point(m.vertex(e, 0)), m.point(m.vertex(e, 1))); }

struct edits {
  static std::size_t num_edges(const mesh& m) { return m.number_of_edges(); }
  static bool split(mesh& m, bench::u32 i) {
    const mesh::Edge_index e(i);
    const auto x = middle(m, e);
    const auto h = CGAL::Euler::split_edge(m.halfedge(e), m);  // points to the new vert
    m.point(m.target(h)) = x;
    const auto next = m.next(h), other = m.opposite(next);
    if (!m.is_border(h)) CGAL::Euler::split_face(h, m.next(next), m);
    if (!m.is_border(other)) CGAL::Euler::split_face(other, m.next(m.next(other)), m);
    return true;
  }
  static bool flip(mesh& m, bench::u32 i) {
    const mesh::Edge_index e(i);
    if (m.is_border(e)) return false;
    const auto h = m.halfedge(e);
    if (CGAL::halfedge(m.target(m.next(h)), m.target(m.next(m.opposite(h))), m).second) return false;
    CGAL::Euler::flip_edge(h, m);
    return true;
  }
  static bool collapse(mesh& m, bench::u32 i) {
    const mesh::Edge_index e(i);
    if (m.is_removed(e) || !CGAL::Euler::does_satisfy_link_condition(e, m)) return false;
    const auto x = middle(m, e);
    m.point(CGAL::Euler::collapse_edge(e, m)) = x;
    return true;
  }
};

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    const auto a = p.data.bunny16();
    bench::compare_edits<edits>(p, "cgal", a, from(a));
  });
}
