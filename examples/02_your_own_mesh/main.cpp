// Adapt a mesh type of your own in one screen: a torus of n x n quads that stores nothing but n. Its adapter says how half-edges are linked. This makes it
// a SurfaceMesh, and every algorithm of the library runs on it.
#include <concino/concepts/halfedge_kernel.hpp>
#include <concino/fields.hpp>
#include <concino/graph.hpp>
#include <concino/validate.hpp>

#include <fmt/core.h>

#include <array>
#include <cmath>

namespace cn = concino;

//! [links]
struct torus { unsigned n; };  // n >= 3

// Vert (i, j) is number n * j + i; quad p has vert p at its lower left. Half-edge {v, d} leaves vert v to the right, up, left or down (d = 0 .. 3).
struct torus_links {
  using vert = cn::vert_id;
  using edge = cn::edge_id;
  using poly = cn::poly_id;
  struct halfedge { unsigned v, d; bool operator==(const halfedge&) const = default; };

  static unsigned step(torus m, unsigned v, unsigned d) {
    const std::array<unsigned, 4> i{1, 0, m.n - 1, 0}, j{0, 1, 0, m.n - 1};
    return (v / m.n + j[d]) % m.n * m.n + (v % m.n + i[d]) % m.n;
  }
  static vert target(torus m, halfedge h) { return vert{step(m, h.v, h.d)}; }
  static halfedge next(torus m, halfedge h) { return {step(m, h.v, h.d), (h.d + 1) % 4}; }
  static halfedge opposite(torus m, halfedge h) { return {step(m, h.v, h.d), (h.d + 2) % 4}; }
  static bool is_border(torus, halfedge) { return false; }
  static poly poly_of(torus m, halfedge h) { return poly{h.d == 0 ? h.v : h.d == 1 ? step(m, h.v, 2) : h.d == 2 ? step(m, step(m, h.v, 2), 3) : step(m, h.v, 3)}; }
  static edge edge_of(torus m, halfedge h) { return edge{h.d < 2 ? 2 * h.v + h.d : 2 * step(m, h.v, h.d) + h.d - 2}; }
  static bool is_isolated(torus, vert) { return false; }
  static halfedge halfedge_of(torus, vert v) { return {v.raw(), 0}; }
  static halfedge halfedge_of(torus, edge e) { return {e.raw() / 2, e.raw() % 2}; }
  static halfedge halfedge_of(torus, poly p) { return {p.raw(), 0}; }
  static std::size_t num_verts(torus m) { return m.n * m.n; }
  static std::size_t num_edges(torus m) { return 2 * m.n * m.n; }
  static std::size_t num_polys(torus m) { return m.n * m.n; }

  static std::array<double, 3> point(torus m, vert v) {  // the position of a vert
    const double turn = 2 * 3.14159265358979 / m.n, a = turn * (v.raw() % m.n), b = turn * (v.raw() / m.n);
    return {(3 + std::cos(b)) * std::cos(a), (3 + std::cos(b)) * std::sin(a), std::sin(b)};
  }
};
template<> struct concino::mesh_traits<torus> : concino::halfedge_kernel<torus, torus_links> { static constexpr int arity = 4; };
static_assert(cn::QuadMesh<torus> && cn::Embedded<torus>);
//! [links]

int main() {
  const torus m{12};
  const auto broken = cn::check_laws(m);  // what the compiler cannot check: are the half-edges linked consistently?
  for (const auto& b : broken) fmt::print("{}: {}\n", b.law, b.what);
  fmt::print("{} verts, {} edges, {} polys, {} broken laws\n", cn::num_verts(m), cn::num_edges(m), cn::num_polys(m), broken.size());

  const cn::vert_id a{0}, b{6 * 12 + 6};  // a is outermost; b is innermost, on the opposite side
  fmt::print("hops from a to b: {}, from poly to poly: {}\n", cn::bfs(m, a)[b], cn::bfs(m, cn::poly_id{0})[cn::poly_id{78}]);
  fmt::print("length of the shortest path: {:.4f}\n", cn::dijkstra(m, a)[b]);
  fmt::print("harmonic function, 0 at a and 1 at b: {:.4f} at the outermost vert opposite a\n", cn::harmonic_map(m, {{a, 0.0}, {b, 1.0}})[cn::vert_id{6}]);
}
