// For tests of edits of triangles and tets: meshes, figures that edits keep or change in a known way, and the link condition by its definition.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/concepts/facets.hpp>
#include <concino/mesh.hpp>
#include <concino/validate/validate.hpp>

#include <support/kinds.hpp>
#include <support/rebuilt.hpp>
#include <support/soups.hpp>
#include <support/whole_mesh.hpp>

#include <doctest/doctest.h>

#include <map>
#include <set>
#include <vector>

namespace concino::testing {

/// The edge between two verts, which must exist.
template<class M>
edge_id edge_between_verts(const M& m, unsigned a, unsigned b) {
  for (const auto e : edges(m))
    if (raw_set(adj_e2v(m, e)) == std::set<unsigned>{a, b}) return e;
  FAIL_CHECK("no edge between verts " << a << " and " << b);
  return {};
}

/// Numbers of elements: verts with polys, edges, faces, polys.
template<class M>
std::vector<std::ptrdiff_t> element_counts(const M& m) {
  std::ptrdiff_t used = 0;
  for (const auto v : verts(m)) used += num_elements(adj_v2p(m, v)) > 0;
  std::vector<std::ptrdiff_t> n{used, static_cast<std::ptrdiff_t>(num_edges(m))};
  if constexpr (VolumeMesh<M>) n.push_back(static_cast<std::ptrdiff_t>(num_faces(m)));
  n.push_back(static_cast<std::ptrdiff_t>(num_polys(m)));
  return n;
}

template<class M>
std::ptrdiff_t euler_characteristic(const M& m) {
  std::ptrdiff_t chi = 0, sign = 1;
  for (const std::ptrdiff_t n : element_counts(m)) chi += sign * n, sign = -sign;
  return chi;
}

/// What no edit of this library changes: manifold, orientable, closed, components, boundary loops, Euler characteristic.
template<class M>
std::vector<std::ptrdiff_t> topology(const M& m) {
  const mesh_facts f = validate(m).facts;
  return {f.manifold, f.orientable, f.closed, static_cast<std::ptrdiff_t>(f.components), static_cast<std::ptrdiff_t>(f.boundary_loops), f.euler_characteristic};
}

/// The polys as sets of verts.
template<class M>
std::multiset<std::set<unsigned>> polys_as_sets(const M& m) {
  std::multiset<std::set<unsigned>> all;
  for (const auto p : polys(m)) all.insert(raw_set(adj_p2v(m, p)));
  return all;
}

namespace complexes {

using simplices = std::multiset<std::set<unsigned>>;

inline std::set<std::set<unsigned>> closure(const simplices& all) {
  std::set<std::set<unsigned>> c;
  for (const auto& s : all) {
    const std::vector<unsigned> v(s.begin(), s.end());
    for (unsigned chosen = 1; chosen < 1u << v.size(); ++chosen) {
      std::set<unsigned> face;
      for (unsigned i = 0; i < v.size(); ++i)
        if (chosen >> i & 1) face.insert(v[i]);
      c.insert(face);
    }
  }
  return c;
}

/// The simplices of `polys` without the verts of t, of those that have them.
inline simplices link_of(const simplices& polys, const std::set<unsigned>& t) {
  simplices l;
  for (const auto& p : polys) {
    if (!std::includes(p.begin(), p.end(), t.begin(), t.end())) continue;
    std::set<unsigned> rest;
    std::set_difference(p.begin(), p.end(), t.begin(), t.end(), std::inserter(rest, rest.end()));
    l.insert(rest);
  }
  return l;
}

inline std::ptrdiff_t euler_characteristic(const simplices& all) {
  std::ptrdiff_t chi = 0;
  for (const auto& s : closure(all)) chi += s.size() % 2 ? 1 : -1;
  return chi;
}

inline bool is_connected(const simplices& all) {
  std::set<unsigned> reached = *all.begin();
  for (bool grows = true; grows;) {
    grows = false;
    for (const auto& s : all) {
      const bool meets = std::any_of(s.begin(), s.end(), [&](unsigned v) { return reached.count(v) > 0; });
      if (!meets || std::includes(reached.begin(), reached.end(), s.begin(), s.end())) continue;
      reached.insert(s.begin(), s.end());
      grows = true;
    }
  }
  return closure(all).size() > 0 && std::all_of(all.begin(), all.end(), [&](const auto& s) { return reached.count(*s.begin()) > 0; });
}

/// A graph without its verts of degree 2: the ends of its arcs. A circle is an arc with a vert that it keeps.
inline std::vector<std::pair<unsigned, unsigned>> arcs_of(const simplices& graph) {
  std::vector<std::pair<unsigned, unsigned>> arcs;
  std::set<unsigned> verts;
  for (const auto& e : graph) arcs.emplace_back(*e.begin(), *e.rbegin()), verts.insert(e.begin(), e.end());
  for (const unsigned v : verts) {
    std::vector<std::size_t> at;
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      if (arcs[i].first == v) at.push_back(i);
      if (arcs[i].second == v) at.push_back(i);
    }
    if (at.size() != 2 || at[0] == at[1]) continue;
    const auto other = [&](std::size_t i) { return arcs[i].first == v ? arcs[i].second : arcs[i].first; };
    arcs[at[0]] = {other(at[0]), other(at[1])};
    arcs.erase(arcs.begin() + static_cast<std::ptrdiff_t>(at[1]));
  }
  return arcs;
}

/// The order of a simplex whose link is a graph: 0 for a circle, 1 for arcs between the same two verts, else 2.
inline int order_by_graph(const simplices& graph) {
  const auto arcs = arcs_of(graph);
  if (arcs.size() == 1 && arcs[0].first == arcs[0].second) return 0;
  for (const auto& x : arcs)
    if (x.first == x.second || std::minmax(x.first, x.second) != std::minmax(arcs[0].first, arcs[0].second)) return 2;
  return 1;
}

/// The order of simplex s, -1 if the complex does not have it.
inline int order_of(const simplices& polys, const std::set<unsigned>& s) {
  const simplices l = link_of(polys, s);
  if (l.empty()) return -1;
  if (l.begin()->empty()) return 0;
  if (l.begin()->size() == 1) return l.size() == 2 ? 0 : 1;
  if (l.begin()->size() == 2) return order_by_graph(l);
  simplices odd;
  std::set<unsigned> verts, singular;
  for (const auto& t : l) verts.insert(t.begin(), t.end());
  for (const unsigned v : verts)
    if (order_by_graph(link_of(l, {v})) == 2) singular.insert(v);
  for (const auto& e : closure(l))
    if (e.size() == 2 && link_of(l, e).size() != 2) odd.insert(e);
  const std::ptrdiff_t chi = euler_characteristic(l);
  if (!is_connected(l)) return 3;
  if (singular.empty() && odd.empty()) return chi == 2 ? 0 : 3;
  if (singular.empty()) return is_connected(odd) && chi == static_cast<std::ptrdiff_t>(link_of(l, *odd.begin()).size()) ? 1 : 3;
  if (singular.size() != 2) return 3;
  const simplices g = link_of(l, {*singular.begin()}), h = link_of(l, {*singular.rbegin()});
  const auto degrees = [](const simplices& graph) {
    std::map<unsigned, unsigned> at;
    for (const auto& e : graph)
      for (const unsigned v : e) ++at[v];
    std::multiset<unsigned> all;
    for (const auto& [v, n] : at)
      if (n != 2) all.insert(n);
    return all;
  };
  return degrees(g) == degrees(h) && euler_characteristic(g) == euler_characteristic(h) && chi == 2 - euler_characteristic(g) ? 2 : 3;
}

}  // namespace complexes

/// Whether collapsing edge ab of the complex of these polys keeps its topology: by the definitions of Dey et al. 1999, for every simplex s of the links of a and b
/// the order of abs is not smaller than those of as and bs both.
inline bool obeys_link_condition(const complexes::simplices& all_polys, unsigned a, unsigned b) {
  complexes::simplices polys;  // those with a or b, since only links of simplices with one of them are looked at
  for (const auto& p : all_polys)
    if (p.count(a) || p.count(b)) polys.insert(p);
  const complexes::simplices at_edge = complexes::link_of(polys, {a, b});
  for (const auto& p : at_edge)
    if (at_edge.count(p) > 1) return false;
  auto all = complexes::closure(complexes::link_of(polys, {a}));
  all.insert(std::set<unsigned>());
  for (auto s : all) {
    if (s.count(b)) continue;
    s.insert(a);
    const int of_a = complexes::order_of(polys, s);
    s.erase(a), s.insert(b);
    const int of_b = complexes::order_of(polys, s);
    s.insert(a);
    if (std::min(of_a, of_b) > complexes::order_of(polys, s)) return false;
  }
  return true;
}

/// The links of verts of triangles that are neither manifold nor at a curve in which sheets meet, up to homeomorphism: for each arc, the numbers of arcs
/// at its ends. No collapse changes them.
template<class M>
std::multiset<std::multiset<std::pair<std::size_t, std::size_t>>> singular_links(const M& m) {
  std::multiset<std::multiset<std::pair<std::size_t, std::size_t>>> all;
  for (const auto v : verts(m)) {
    complexes::simplices sets;
    for (const auto p : adj_v2p(m, v)) sets.insert(raw_set(adj_p2v(m, p)));
    const auto graph = complexes::link_of(sets, {v.raw()});
    if (graph.empty() || complexes::order_by_graph(graph) < 2) continue;
    const auto arcs = complexes::arcs_of(graph);
    const auto degree = [&](unsigned x) {
      std::size_t n = 0;
      for (const auto& y : arcs) n += (y.first == x) + (y.second == x);
      return n;
    };
    std::multiset<std::pair<std::size_t, std::size_t>> of_vert;
    for (const auto& x : arcs) of_vert.insert(std::minmax({degree(x.first), degree(x.second)}));
    all.insert(of_vert);
  }
  return all;
}

}  // namespace concino::testing
