// Computes a harmonic map on a mesh of the user's own: half-edges in arrays, which a function in another file reads. The adapter says how they are linked.
#include <concino/concepts/halfedge_kernel.hpp>
#include <concino/fields/harmonic_map.hpp>

#include <array>
#include <cstdio>
#include <vector>

namespace cn = concino;

/// Half-edge h ends at vert target[h].
struct own_mesh {
  static constexpr unsigned none = ~0u;
  std::vector<std::array<double, 3>> points;
  std::vector<unsigned> next, opposite, target, poly_of, edge_of;  // one per half-edge; poly_of is none at a boundary
  std::vector<unsigned> of_vert, of_edge, of_poly;                 // a half-edge of each element; of_vert is none at an isolated vert
};
own_mesh read_own_mesh(const char* path);

struct own_links {
  using vert = cn::vert_id;
  using edge = cn::edge_id;
  using poly = cn::poly_id;
  using halfedge = unsigned;
  static halfedge next(const own_mesh& m, halfedge h) { return m.next[h]; }
  static halfedge opposite(const own_mesh& m, halfedge h) { return m.opposite[h]; }
  static vert target(const own_mesh& m, halfedge h) { return vert{m.target[h]}; }
  static bool is_border(const own_mesh& m, halfedge h) { return m.poly_of[h] == own_mesh::none; }
  static poly poly_of(const own_mesh& m, halfedge h) { return poly{m.poly_of[h]}; }
  static edge edge_of(const own_mesh& m, halfedge h) { return edge{m.edge_of[h]}; }
  static bool is_isolated(const own_mesh& m, vert v) { return m.of_vert[v.raw()] == own_mesh::none; }
  static halfedge halfedge_of(const own_mesh& m, vert v) { return m.of_vert[v.raw()]; }
  static halfedge halfedge_of(const own_mesh& m, edge e) { return m.of_edge[e.raw()]; }
  static halfedge halfedge_of(const own_mesh& m, poly p) { return m.of_poly[p.raw()]; }
  static std::size_t num_verts(const own_mesh& m) { return m.points.size(); }
  static std::size_t num_edges(const own_mesh& m) { return m.of_edge.size(); }
  static std::size_t num_polys(const own_mesh& m) { return m.of_poly.size(); }
  static const std::array<double, 3>& point(const own_mesh& m, vert v) { return m.points[v.raw()]; }
};
template<> struct concino::mesh_traits<own_mesh> : concino::halfedge_kernel<own_mesh, own_links> {};

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const own_mesh m = read_own_mesh(argv[1]);
  const auto u = cn::harmonic_map(m, {{cn::vert_id{0}, 0.0}, {cn::vert_id{1}, 1.0}});
  for (const cn::vert_id v : cn::verts(m)) std::printf("%g\n", u[v]);
}
