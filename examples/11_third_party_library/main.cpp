// Adapt the mesh of a library that you cannot change: `hedge`, the header beside this file, is a half-edge library that does not know concino.
// One struct says how its half-edges are linked. Every algorithm then runs on its meshes, and its users still pass hedge::Vertex.
#include "hedge/mesh.h"

#include <concino/concepts/halfedge_kernel.hpp>
#include <concino/fields.hpp>
#include <concino/geometry.hpp>
#include <concino/graph.hpp>
#include <concino/validate.hpp>

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace cn = concino;

// The whole adapter.
struct hedge_links {
  using vert = hedge::Vertex;
  using edge = hedge::Edge;
  using poly = hedge::Face;
  using halfedge = hedge::Halfedge;
  using mesh = hedge::Mesh;

  static halfedge next(const mesh& m, halfedge h) { return m.next(h); }
  static halfedge opposite(const mesh& m, halfedge h) { return m.twin(h); }
  static vert target(const mesh& m, halfedge h) { return m.tip(h); }
  static bool is_border(const mesh& m, halfedge h) { return m.face(h) == hedge::Face{}; }
  static poly poly_of(const mesh& m, halfedge h) { return m.face(h); }
  static edge edge_of(const mesh& m, halfedge h) { return m.edge(h); }
  static bool is_isolated(const mesh& m, vert v) { return m.out(v) == hedge::Halfedge{}; }
  static halfedge halfedge_of(const mesh& m, vert v) { return m.out(v); }
  static halfedge halfedge_of(const mesh&, edge e) { return {2 * e.idx}; }
  static halfedge halfedge_of(const mesh& m, poly p) { return m.start(p); }

  static std::size_t num_verts(const mesh& m) { return m.vertex_count(); }
  static std::size_t num_edges(const mesh& m) { return m.edge_count(); }
  static std::size_t num_polys(const mesh& m) { return m.face_count(); }
  static auto verts(const mesh& m) { return cn::id_range<vert>(m.vertex_count()); }  // indices have no gaps, and a descriptor is made from its index
  static auto edges(const mesh& m) { return cn::id_range<edge>(m.edge_count()); }
  static auto polys(const mesh& m) { return cn::id_range<poly>(m.face_count()); }
  static std::size_t vert_index_bound(const mesh& m) { return m.vertex_count(); }
  static std::size_t edge_index_bound(const mesh& m) { return m.edge_count(); }
  static std::size_t poly_index_bound(const mesh& m) { return m.face_count(); }
  static std::size_t index_of(const mesh&, vert v) { return v.idx; }
  static std::size_t index_of(const mesh&, edge e) { return e.idx; }
  static std::size_t index_of(const mesh&, poly p) { return p.idx; }

  static std::array<float, 3> point(const mesh& m, vert v) { return {m.position(v).x, m.position(v).y, m.position(v).z}; }
};
template<> struct concino::mesh_traits<hedge::Mesh> : concino::halfedge_kernel<hedge::Mesh, hedge_links> {};
static_assert(cn::SurfaceMesh<hedge::Mesh> && cn::Embedded<hedge::Mesh>);

/// A spiral ramp of two turns around a pole: `steps` quads per turn, 6 quads wide.
hedge::Mesh ramp(int steps) {
  std::vector<hedge::Position> positions;
  std::vector<std::vector<unsigned>> quads;
  for (int s = 0; s <= 2 * steps; ++s)
    for (int i = 0; i <= 6; ++i) {
      const float turn = 6.2831853f * float(s) / float(steps), r = 1 + 0.25f * float(i);
      positions.push_back({r * std::cos(turn), r * std::sin(turn), turn / 4});
      const auto here = unsigned(s * 7 + i);
      if (s < 2 * steps && i < 6) quads.push_back({here, here + 1, here + 8, here + 7});
    }
  return {positions, quads};
}

int main() {
  const hedge::Mesh m = ramp(24);
  const auto broken = cn::check_laws(m);  // are the links right? The first thing to test in an adapter
  for (const auto& b : broken) fmt::print("{}: {}\n", b.law, b.what);
  fmt::print("{} verts, {} edges, {} polys, {} broken laws\n", cn::num_verts(m), cn::num_edges(m), cn::num_polys(m), broken.size());
  const auto border = cn::boundary_loops(m);
  fmt::print("area {:.3f}, {} border of {} edges\n", cn::total_measure(m), border.count, border.loops[0].edges.size());

  // Two lines that are new for the users of hedge. Arguments and results are their own handles.
  const hedge::Vertex foot{3}, top{unsigned(m.vertex_count()) - 4};
  const auto distance = cn::dijkstra(m, foot);
  const auto u = cn::harmonic_map(m, {{foot, 0.0}, {top, 1.0}});

  fmt::print("from the foot to the top: {:.3f}\n", distance[top]);
  const std::vector<hedge::Vertex> path = cn::shortest_path(m, foot, top);
  fmt::print("the path has {} verts and keeps to the {} side\n", path.size(), path[path.size() / 2].idx % 7 == 0 ? "inner" : "outer");
  fmt::print("half way up, the harmonic function is {:.4f}\n", u[hedge::Vertex{24 * 7 + 3}]);
}
