// Two meshes as a user might write them, for tests of code against the concepts: own descriptors, own namespace, adjacency by searching all elements,
// ranges returned by value. They are slow, small and independent of the library's own tables.
#pragma once

#include <concino/concepts/mesh.hpp>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace user_mesh {

template<char Letter>
struct handle {
  int i = -1;
  friend bool operator==(handle, handle) = default;
};
using vertex = handle<'v'>;
using segment = handle<'e'>;
using facet = handle<'f'>;
using cell = handle<'p'>;

template<class H>
std::vector<H> all(std::size_t n) {
  std::vector<H> r;
  for (std::size_t i = 0; i < n; ++i) r.push_back(H{static_cast<int>(i)});
  return r;
}
template<class T>
bool holds(const std::vector<T>& r, const T& x) { return std::find(r.begin(), r.end(), x) != r.end(); }
template<class T>
void add_once(std::vector<T>& r, const T& x) { if (!holds(r, x)) r.push_back(x); }

using polygon = std::vector<int>;
using segments = std::vector<std::pair<int, int>>;

inline void add_polygon_edges(segments& es, const polygon& p) {
  for (std::size_t i = 0; i < p.size(); ++i) {
    const int a = p[i], b = p[(i + 1) % p.size()];
    add_once(es, {std::min(a, b), std::max(a, b)});
  }
}
inline bool has_segment(const polygon& p, const std::pair<int, int>& e) {
  for (std::size_t i = 0; i < p.size(); ++i)
    if (std::minmax(p[i], p[(i + 1) % p.size()]) == std::pair<const int&, const int&>(e)) return true;
  return false;
}

struct surface {
  std::vector<std::array<double, 3>> points;
  std::vector<polygon> polygons;
  segments es;

  surface() = default;
  surface(std::vector<std::array<double, 3>> x, std::vector<polygon> p) : points(std::move(x)), polygons(std::move(p)) {
    for (const auto& q : polygons) add_polygon_edges(es, q);
  }
};

/// cells: pairs of face and whether it runs counter-clockwise seen from outside.
struct volume {
  std::vector<std::array<double, 3>> points;
  std::vector<polygon> facets;
  std::vector<std::vector<std::pair<int, bool>>> cells;
  segments es;

  volume() = default;
  volume(std::vector<std::array<double, 3>> x, std::vector<polygon> f, std::vector<std::vector<std::pair<int, bool>>> c)
      : points(std::move(x)), facets(std::move(f)), cells(std::move(c)) {
    for (const auto& q : facets) add_polygon_edges(es, q);
  }
};

/// A fan of three triangles and a quad around v0, with a boundary, and an isolated vert v7.
inline surface surface_example() {
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {0, -1, 0}, {5, 5, 5}},
          {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5, 6}}};
}

/// A cube and a pyramid that share a square, and an isolated vert v9.
inline volume volume_example() {
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}, {0.5, 0.5, 2}, {9, 9, 9}},
          {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}, {4, 5, 8}, {5, 6, 8}, {6, 7, 8}, {7, 4, 8}},
          {{{0, true}, {1, true}, {2, true}, {3, true}, {4, true}, {5, true}}, {{1, false}, {6, true}, {7, true}, {8, true}, {9, true}}}};
}

}  // namespace user_mesh

namespace concino {

template<>
struct mesh_traits<user_mesh::surface> {
  using M = user_mesh::surface;
  using vert = user_mesh::vertex;
  using edge = user_mesh::segment;
  using poly = user_mesh::cell;
  static constexpr int dimension = 2;
  static constexpr bool edges_in_order = false;

  static auto verts(const M& m) { return user_mesh::all<vert>(m.points.size()); }
  static auto edges(const M& m) { return user_mesh::all<edge>(m.es.size()); }
  static auto polys(const M& m) { return user_mesh::all<poly>(m.polygons.size()); }
  static std::size_t num_verts(const M& m) { return m.points.size(); }
  static std::size_t num_edges(const M& m) { return m.es.size(); }
  static std::size_t num_polys(const M& m) { return m.polygons.size(); }
  static std::size_t vert_index_bound(const M& m) { return m.points.size(); }
  static std::size_t edge_index_bound(const M& m) { return m.es.size(); }
  static std::size_t poly_index_bound(const M& m) { return m.polygons.size(); }
  template<char L> static std::size_t index_of(const M&, user_mesh::handle<L> x) { return static_cast<std::size_t>(x.i); }

  static const user_mesh::polygon& at(const M& m, poly p) { return m.polygons[static_cast<std::size_t>(p.i)]; }
  static std::pair<int, int> at(const M& m, edge e) { return m.es[static_cast<std::size_t>(e.i)]; }

  static std::array<vert, 2> adj_e2v(const M& m, edge e) { return {vert{at(m, e).first}, vert{at(m, e).second}}; }
  static auto adj_v2e(const M& m, vert v) {
    std::vector<edge> r;
    for (edge e : edges(m)) if (at(m, e).first == v.i || at(m, e).second == v.i) r.push_back(e);
    return r;
  }
  static auto adj_v2v(const M& m, vert v) {
    std::vector<vert> r;
    for (edge e : adj_v2e(m, v)) r.push_back(vert{at(m, e).first + at(m, e).second - v.i});
    return r;
  }
  static auto adj_p2v(const M& m, poly p) {
    std::vector<vert> r;
    for (int i : at(m, p)) r.push_back(vert{i});
    return r;
  }
  static auto adj_e2p(const M& m, edge e) {
    std::vector<poly> r;
    for (poly p : polys(m)) if (user_mesh::has_segment(at(m, p), at(m, e))) r.push_back(p);
    return r;
  }
  static auto adj_v2p(const M& m, vert v) {
    std::vector<poly> r;
    for (poly p : polys(m)) if (user_mesh::holds(at(m, p), v.i)) r.push_back(p);
    return r;
  }
  static auto adj_p2e(const M& m, poly p) {
    std::vector<edge> r;
    for (edge e : edges(m)) if (user_mesh::has_segment(at(m, p), at(m, e))) r.push_back(e);
    return r;
  }
  static auto adj_p2p(const M& m, poly p) {
    std::vector<poly> r;
    for (edge e : adj_p2e(m, p))
      for (poly q : adj_e2p(m, e)) if (!(q == p)) user_mesh::add_once(r, q);
    return r;
  }
  static const std::array<double, 3>& point(const M& m, vert v) { return m.points[static_cast<std::size_t>(v.i)]; }
};

template<>
struct mesh_traits<user_mesh::volume> {
  using M = user_mesh::volume;
  using vert = user_mesh::vertex;
  using edge = user_mesh::segment;
  using face = user_mesh::facet;
  using poly = user_mesh::cell;
  static constexpr int dimension = 3;
  static constexpr bool edges_in_order = false;

  static auto verts(const M& m) { return user_mesh::all<vert>(m.points.size()); }
  static auto edges(const M& m) { return user_mesh::all<edge>(m.es.size()); }
  static auto faces(const M& m) { return user_mesh::all<face>(m.facets.size()); }
  static auto polys(const M& m) { return user_mesh::all<poly>(m.cells.size()); }
  static std::size_t num_verts(const M& m) { return m.points.size(); }
  static std::size_t num_edges(const M& m) { return m.es.size(); }
  static std::size_t num_faces(const M& m) { return m.facets.size(); }
  static std::size_t num_polys(const M& m) { return m.cells.size(); }
  static std::size_t vert_index_bound(const M& m) { return m.points.size(); }
  static std::size_t edge_index_bound(const M& m) { return m.es.size(); }
  static std::size_t face_index_bound(const M& m) { return m.facets.size(); }
  static std::size_t poly_index_bound(const M& m) { return m.cells.size(); }
  template<char L> static std::size_t index_of(const M&, user_mesh::handle<L> x) { return static_cast<std::size_t>(x.i); }

  static const user_mesh::polygon& at(const M& m, face f) { return m.facets[static_cast<std::size_t>(f.i)]; }
  static std::pair<int, int> at(const M& m, edge e) { return m.es[static_cast<std::size_t>(e.i)]; }
  static const auto& at(const M& m, poly p) { return m.cells[static_cast<std::size_t>(p.i)]; }

  static std::array<vert, 2> adj_e2v(const M& m, edge e) { return {vert{at(m, e).first}, vert{at(m, e).second}}; }
  static auto adj_v2e(const M& m, vert v) {
    std::vector<edge> r;
    for (edge e : edges(m)) if (at(m, e).first == v.i || at(m, e).second == v.i) r.push_back(e);
    return r;
  }
  static auto adj_v2v(const M& m, vert v) {
    std::vector<vert> r;
    for (edge e : adj_v2e(m, v)) r.push_back(vert{at(m, e).first + at(m, e).second - v.i});
    return r;
  }
  static auto adj_f2v(const M& m, face f) {
    std::vector<vert> r;
    for (int i : at(m, f)) r.push_back(vert{i});
    return r;
  }
  static auto adj_f2e(const M& m, face f) {
    std::vector<edge> r;
    for (edge e : edges(m)) if (user_mesh::has_segment(at(m, f), at(m, e))) r.push_back(e);
    return r;
  }
  static auto adj_p2f(const M& m, poly p) {
    std::vector<face> r;
    for (auto [i, outward] : at(m, p)) r.push_back(face{i});
    return r;
  }
  static auto adj_f2p(const M& m, face f) {
    std::vector<poly> r;
    for (poly p : polys(m)) if (user_mesh::holds(adj_p2f(m, p), f)) r.push_back(p);
    return r;
  }
  static auto adj_v2f(const M& m, vert v) {
    std::vector<face> r;
    for (face f : faces(m)) if (user_mesh::holds(at(m, f), v.i)) r.push_back(f);
    return r;
  }
  static auto adj_e2f(const M& m, edge e) {
    std::vector<face> r;
    for (face f : faces(m)) if (user_mesh::has_segment(at(m, f), at(m, e))) r.push_back(f);
    return r;
  }
  static auto adj_p2v(const M& m, poly p) {
    std::vector<vert> r;
    for (face f : adj_p2f(m, p)) for (vert v : adj_f2v(m, f)) user_mesh::add_once(r, v);
    return r;
  }
  static auto adj_p2e(const M& m, poly p) {
    std::vector<edge> r;
    for (face f : adj_p2f(m, p)) for (edge e : adj_f2e(m, f)) user_mesh::add_once(r, e);
    return r;
  }
  static auto adj_v2p(const M& m, vert v) {
    std::vector<poly> r;
    for (poly p : polys(m)) if (user_mesh::holds(adj_p2v(m, p), v)) r.push_back(p);
    return r;
  }
  static auto adj_e2p(const M& m, edge e) {
    std::vector<poly> r;
    for (poly p : polys(m))
      for (face f : adj_p2f(m, p)) if (user_mesh::has_segment(at(m, f), at(m, e))) user_mesh::add_once(r, p);
    return r;
  }
  static auto adj_p2p(const M& m, poly p) {
    std::vector<poly> r;
    for (face f : adj_p2f(m, p)) for (poly q : adj_f2p(m, f)) if (!(q == p)) user_mesh::add_once(r, q);
    return r;
  }
  static bool face_is_outward(const M& m, poly p, face f) {
    for (auto [i, outward] : at(m, p)) if (i == f.i) return outward;
    return false;
  }
  static const std::array<double, 3>& point(const M& m, vert v) { return m.points[static_cast<std::size_t>(v.i)]; }
};

}  // namespace concino
