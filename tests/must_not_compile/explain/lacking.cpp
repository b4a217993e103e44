// A surface, or with -DVOLUME a volume, that has everything but LACKING: EXPLAIN<mesh>() must say so. Compiled with -DLACKING=1 ... by
// the list in CMakeLists.txt; with LACKING=0 nothing is missing and it compiles.
#include <concino/concepts/mesh.hpp>

namespace stranger {
struct v { friend bool operator==(v, v) = default; };
struct e { friend bool operator==(e, e) = default; };
struct f { friend bool operator==(f, f) = default; };
struct p { friend bool operator==(p, p) = default; };
template<class T> struct all {
  const T* begin() const;
  const T* end() const;
};
struct mesh {};
}  // namespace stranger

#define no_adapted 1
#define no_dimension 2
#define no_vert 3
#define no_verts 4
#define no_num_verts 5
#define no_vert_index_bound 6
#define no_vert_index_of 7
#define no_adj_v2v 8
#define no_poly 9
#define no_polys 10
#define no_num_polys 11
#define no_poly_index_bound 12
#define no_poly_index_of 13
#define no_adj_p2p 14
#define no_edge 15
#define no_distinct 16
#define no_edges 17
#define no_num_edges 18
#define no_edge_index_bound 19
#define no_edge_index_of 20
#define no_adj_e2v 21
#define no_adj_e2p 22
#define no_adj_v2e 23
#define no_adj_v2p 24
#define no_adj_p2v 25
#define no_adj_p2e 26
#define no_face 27
#define no_distinct_faces 28
#define no_faces 29
#define no_num_faces 30
#define no_face_index_bound 31
#define no_face_index_of 32
#define no_adj_f2v 33
#define no_adj_f2e 34
#define no_adj_f2p 35
#define no_adj_v2f 36
#define no_adj_e2f 37
#define no_adj_p2f 38
#define no_face_is_outward 39
#define no_point 40

#define HAS(what) (LACKING != no_##what)

#if HAS(adapted)
template<>
struct concino::mesh_traits<stranger::mesh> {
  using m = const stranger::mesh&;
  template<class T> using all = stranger::all<T>;
  using size = unsigned;
  using v = stranger::v;
  using e = stranger::e;
  using f = stranger::f;
  using p = stranger::p;
#if HAS(dimension)
#ifdef VOLUME
  static constexpr int dimension = 3;
#else
  static constexpr int dimension = 2;
#endif
#endif
#if HAS(vert)
  using vert = v;
#endif
#if HAS(verts)
  static all<v> verts(m);
#endif
#if HAS(num_verts)
  static size num_verts(m);
#endif
#if HAS(vert_index_bound)
  static size vert_index_bound(m);
#endif
#if HAS(vert_index_of)
  static size index_of(m, v);
#endif
#if HAS(adj_v2v)
  static all<v> adj_v2v(m, v);
#endif
#if HAS(poly)
  using poly = p;
#endif
#if HAS(polys)
  static all<p> polys(m);
#endif
#if HAS(num_polys)
  static size num_polys(m);
#endif
#if HAS(poly_index_bound)
  static size poly_index_bound(m);
#endif
#if HAS(poly_index_of)
  static size index_of(m, p);
#endif
#if HAS(adj_p2p)
  static all<p> adj_p2p(m, p);
#endif
#if !HAS(distinct)
  using edge = v;
#elif HAS(edge)
  using edge = e;
#endif
#if HAS(edges)
  static all<e> edges(m);
#endif
#if HAS(num_edges)
  static size num_edges(m);
#endif
#if HAS(edge_index_bound)
  static size edge_index_bound(m);
#endif
#if HAS(edge_index_of)
  static size index_of(m, e);
#endif
#if HAS(adj_e2v)
  static all<v> adj_e2v(m, e);
#endif
#if HAS(adj_e2p)
  static all<p> adj_e2p(m, e);
#endif
#if HAS(adj_v2e)
  static all<e> adj_v2e(m, v);
#endif
#if HAS(adj_v2p)
  static all<p> adj_v2p(m, v);
#endif
#if HAS(adj_p2v)
  static all<v> adj_p2v(m, p);
#endif
#if HAS(adj_p2e)
  static all<e> adj_p2e(m, p);
#endif
#if !HAS(distinct_faces)
  using face = p;
#elif HAS(face)
  using face = f;
#endif
#if HAS(faces)
  static all<f> faces(m);
#endif
#if HAS(num_faces)
  static size num_faces(m);
#endif
#if HAS(face_index_bound)
  static size face_index_bound(m);
#endif
#if HAS(face_index_of)
  static size index_of(m, f);
#endif
#if HAS(adj_f2v)
  static all<v> adj_f2v(m, f);
#endif
#if HAS(adj_f2e)
  static all<e> adj_f2e(m, f);
#endif
#if HAS(adj_f2p)
  static all<p> adj_f2p(m, f);
#endif
#if HAS(adj_v2f)
  static all<f> adj_v2f(m, v);
#endif
#if HAS(adj_e2f)
  static all<f> adj_e2f(m, e);
#endif
#if HAS(adj_p2f)
  static all<f> adj_p2f(m, p);
#endif
#if HAS(face_is_outward)
  static bool face_is_outward(m, p, f);
#endif
#if HAS(point)
  static const double* point(m, v);
#endif
};
#endif

int main() { concino::EXPLAIN<const stranger::mesh&>(); }
