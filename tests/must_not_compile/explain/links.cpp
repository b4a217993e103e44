// The links of a half-edge mesh with everything but LACKING: explain_halfedge_links must say so. Compiled by the list in CMakeLists.txt.
#include <concino/concepts/halfedge_kernel.hpp>

struct mesh {};
#define no_halfedge 1
#define no_next 2
#define no_opposite 3
#define no_target 4
#define no_is_border 5
#define no_poly_of 6
#define no_edge_of 7
#define no_is_isolated 8
#define no_halfedge_of_vert 9
#define no_halfedge_of_edge 10
#define no_halfedge_of_poly 11
#define no_num_edges 12
#define no_has_opposite 13
#define HAS(what) (LACKING != no_##what)

struct links {
  using vert = concino::vert_id;
  using edge = concino::edge_id;
  using poly = concino::poly_id;
#if HAS(halfedge)
  using halfedge = int;
#endif
#if HAS(next)
  static int next(const mesh&, int);
#endif
#if HAS(opposite)
  static int opposite(const mesh&, int);
#endif
#if HAS(target)
  static vert target(const mesh&, int);
#endif
#if !HAS(has_opposite)
  static constexpr bool has_border_halfedges = false;
#endif
#if HAS(is_border)
  static bool is_border(const mesh&, int);
#endif
#if HAS(poly_of)
  static poly poly_of(const mesh&, int);
#endif
#if HAS(edge_of)
  static edge edge_of(const mesh&, int);
#endif
#if HAS(is_isolated)
  static bool is_isolated(const mesh&, vert);
#endif
#if HAS(halfedge_of_vert)
  static int halfedge_of(const mesh&, vert);
#endif
#if HAS(halfedge_of_edge)
  static int halfedge_of(const mesh&, edge);
#endif
#if HAS(halfedge_of_poly)
  static int halfedge_of(const mesh&, poly);
#endif
  static unsigned num_verts(const mesh&);
#if HAS(num_edges)
  static unsigned num_edges(const mesh&);
#endif
  static unsigned num_polys(const mesh&);
};

int main() { concino::explain_halfedge_links<links, mesh>(); }
