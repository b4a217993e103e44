// A surface, or with -DVOLUME a volume, that has everything but LACKING: LACKS_adj_v2v and so on, or LACKS_nothing. Compiled with the
// macros LACKING and, where polys have that many verts, ARITY.
#pragma once

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

#define LACKS_adapted 1
#define LACKS_dimension 2
#define LACKS_vert 3
#define LACKS_verts 4
#define LACKS_num_verts 5
#define LACKS_vert_index_bound 6
#define LACKS_vert_index_of 7
#define LACKS_adj_v2v 8
#define LACKS_poly 9
#define LACKS_polys 10
#define LACKS_num_polys 11
#define LACKS_poly_index_bound 12
#define LACKS_poly_index_of 13
#define LACKS_adj_p2p 14
#define LACKS_edge 15
#define LACKS_distinct 16
#define LACKS_edges 17
#define LACKS_num_edges 18
#define LACKS_edge_index_bound 19
#define LACKS_edge_index_of 20
#define LACKS_adj_e2v 21
#define LACKS_adj_e2p 22
#define LACKS_adj_v2e 23
#define LACKS_adj_v2p 24
#define LACKS_adj_p2v 25
#define LACKS_adj_p2e 26
#define LACKS_face 27
#define LACKS_distinct_faces 28
#define LACKS_faces 29
#define LACKS_num_faces 30
#define LACKS_face_index_bound 31
#define LACKS_face_index_of 32
#define LACKS_adj_f2v 33
#define LACKS_adj_f2e 34
#define LACKS_adj_f2p 35
#define LACKS_adj_v2f 36
#define LACKS_adj_e2f 37
#define LACKS_adj_p2f 38
#define LACKS_face_is_outward 39
#define LACKS_point 40
#define LACKS_set_point 41
#define LACKS_arity 42
#define LACKS_nothing 43

#define HAS(what) (LACKING != LACKS_##what)

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
#if HAS(set_point)
  template<class X> static void set_point(stranger::mesh&, v, const X&);
#endif
#if HAS(arity) && defined ARITY
  static constexpr int arity = ARITY;
#endif
};
#endif

// Arguments of calls.
namespace stranger {
inline constexpr mesh m;
inline constexpr v a;
inline constexpr p q;
inline constexpr auto length = [](v, v) { return 1.0; };
inline constexpr auto keep = [](p) { return true; };
}  // namespace stranger
