// Meshes that have every verb but one: what a concept needs is what it cannot do without.
#pragma once

#include <concino/concepts/editable.hpp>

namespace stranger {

struct v { friend bool operator==(v, v) = default; };
struct e { friend bool operator==(e, e) = default; };
struct f { friend bool operator==(f, f) = default; };
struct p { friend bool operator==(p, p) = default; };
template<class T> struct all {
  const T* begin() const;
  const T* end() const;
};
template<int Lacks, int Dimension> struct mesh {};

inline constexpr const char* verbs[] = {
    "verts",   "num_verts", "vert_index_bound", "index_of(vert)", "adj_v2v", "polys",   "num_polys", "poly_index_bound", "index_of(poly)", "adj_p2p",
    "edges",   "num_edges", "edge_index_bound", "index_of(edge)", "adj_e2v", "adj_e2p", "adj_v2e",   "adj_v2p",          "adj_p2v",        "adj_p2e",
    "faces",   "num_faces", "face_index_bound", "index_of(face)", "adj_f2v", "adj_f2e", "adj_f2p",   "adj_v2f",          "adj_e2f",        "adj_p2f",
    "face_is_outward", "point", "set_point", "rewire"};
inline constexpr int num_verbs = sizeof(verbs) / sizeof(*verbs);

}  // namespace stranger

template<int L, int D>
struct concino::mesh_traits<stranger::mesh<L, D>> {
  using m = const stranger::mesh<L, D>&;
  template<class T> using all = stranger::all<T>;
  using vert = stranger::v;
  using edge = stranger::e;
  using face = stranger::f;
  using poly = stranger::p;
  static constexpr int dimension = D;

  static all<vert> verts(m) requires(L != 0);
  static unsigned num_verts(m) requires(L != 1);
  static unsigned vert_index_bound(m) requires(L != 2);
  static unsigned index_of(m, vert) requires(L != 3);
  static all<vert> adj_v2v(m, vert) requires(L != 4);
  static all<poly> polys(m) requires(L != 5);
  static unsigned num_polys(m) requires(L != 6);
  static unsigned poly_index_bound(m) requires(L != 7);
  static unsigned index_of(m, poly) requires(L != 8);
  static all<poly> adj_p2p(m, poly) requires(L != 9);
  static all<edge> edges(m) requires(L != 10);
  static unsigned num_edges(m) requires(L != 11);
  static unsigned edge_index_bound(m) requires(L != 12);
  static unsigned index_of(m, edge) requires(L != 13);
  static all<vert> adj_e2v(m, edge) requires(L != 14);
  static all<poly> adj_e2p(m, edge) requires(L != 15);
  static all<edge> adj_v2e(m, vert) requires(L != 16);
  static all<poly> adj_v2p(m, vert) requires(L != 17);
  static all<vert> adj_p2v(m, poly) requires(L != 18);
  static all<edge> adj_p2e(m, poly) requires(L != 19);
  static all<face> faces(m) requires(L != 20);
  static unsigned num_faces(m) requires(L != 21);
  static unsigned face_index_bound(m) requires(L != 22);
  static unsigned index_of(m, face) requires(L != 23);
  static all<vert> adj_f2v(m, face) requires(L != 24);
  static all<edge> adj_f2e(m, face) requires(L != 25);
  static all<poly> adj_f2p(m, face) requires(L != 26);
  static all<face> adj_v2f(m, vert) requires(L != 27);
  static all<face> adj_e2f(m, edge) requires(L != 28);
  static all<face> adj_p2f(m, poly) requires(L != 29);
  static bool face_is_outward(m, poly, face) requires(L != 30);
  static const double* point(m, vert) requires(L != 31);
  static void set_point(stranger::mesh<L, D>&, vert, const double*) requires(L != 32);
  template<class C, class R> static void rewire(stranger::mesh<L, D>&, const C&, const R&) requires(L != 33);
};
