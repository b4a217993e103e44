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

namespace detail {

using simplices = std::multiset<std::set<unsigned>>;
constexpr unsigned extra_vert = ~0u;

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

/// The simplices s for which s and t together are a simplex of `all`, s and t being disjoint.
inline std::set<std::set<unsigned>> link(const std::set<std::set<unsigned>>& all, const std::set<unsigned>& t) {
  std::set<std::set<unsigned>> l;
  for (const auto& s : all) {
    if (!std::includes(s.begin(), s.end(), t.begin(), t.end())) continue;
    std::set<unsigned> rest;
    std::set_difference(s.begin(), s.end(), t.begin(), t.end(), std::inserter(rest, rest.end()));
    if (!rest.empty()) l.insert(rest);
  }
  return l;
}

}  // namespace detail

/// Whether collapsing edge ab of the complex of these polys keeps its topology, by the definitions of Dey et al. 1999, in time proportional to the mesh.
inline bool obeys_link_condition(detail::simplices polys, unsigned a, unsigned b) {
  detail::simplices at_edge;
  for (const auto& p : polys)
    if (p.count(a) && p.count(b)) at_edge.insert(p);
  for (const auto& p : at_edge)
    if (at_edge.count(p) > 1) return false;
  std::map<std::set<unsigned>, unsigned> weight;  // of the simplices after the first round: the number of polys; in the first round they may be repeated
  while (!polys.empty() && polys.begin()->size() > 1) {
    std::map<std::set<unsigned>, std::multiset<unsigned>> weights;
    for (const auto& p : polys)
      for (const unsigned v : p) {
        std::set<unsigned> facet = p;
        facet.erase(v);
        weights[facet].insert(weight.count(p) ? weight[p] : 1);
      }
    detail::simplices odd, with_cone = polys;
    weight.clear();
    for (const auto& [facet, w] : weights)
      if (w.size() != 2 || *w.begin() != *w.rbegin()) {
        odd.insert(facet);
        for (const unsigned x : w) weight[facet] += x;
        std::set<unsigned> cone = facet;
        cone.insert(detail::extra_vert);
        with_cone.insert(cone);
      }
    const auto all = detail::closure(with_cone);
    const auto link_a = detail::link(all, {a}), link_b = detail::link(all, {b}), link_ab = detail::link(all, {a, b});
    for (const auto& s : link_a)
      if (link_b.count(s) && !link_ab.count(s)) return false;
    polys = odd;
  }
  return true;
}

}  // namespace concino::testing
