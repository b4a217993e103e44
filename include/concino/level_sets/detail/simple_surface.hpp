// Whether a surface is a manifold on which no two polys cover each other.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/concepts/facets.hpp>
#include <concino/concepts/mesh.hpp>

#include <cstddef>

namespace concino::detail {

/// Whether the polys at a vert follow each other across its edges, each of which has at most two polys.
template<SurfaceMesh S>
bool has_one_fan(const S& s, const vert_t<S>& v) {
  std::size_t polys_at_v = 0, met = 1;
  for ([[maybe_unused]] const poly_t<S> p : adj_v2p(s, v)) ++polys_at_v;
  if (polys_at_v == 0) return false;
  edge_t<S> start{};
  bool any = false;
  for (const edge_t<S> e : adj_v2e(s, v)) {
    const bool is_open = num_elements(adj_e2p(s, e)) == 1;
    if (!any || is_open) start = e;
    any = true;
    if (is_open) break;
  }
  edge_t<S> at = start;
  poly_t<S> p = *adj_e2p(s, start).begin();
  for (;; ++met) {
    edge_t<S> next = at;
    for (const edge_t<S> e : adj_p2e(s, p)) {
      if (e == at) continue;
      const auto ends = end_verts(s, e);
      if (ends.first == v || ends.second == v) next = e;
    }
    at = next;
    bool crossed = false;
    for (const poly_t<S> q : other_polys(s, p, at)) {
      p = q;
      crossed = true;
      break;
    }
    if (!crossed || at == start) return met == polys_at_v;
    if (met == polys_at_v) return false;
  }
}

/// Whether each edge has at most two polys and each vert one fan, and no poly has the same neighbour across all of its edges.
template<SurfaceMesh S>
bool is_simple_surface(const S& s) {
  for (const edge_t<S> e : edges(s))
    if (num_elements(adj_e2p(s, e)) > 2) return false;
  for (const poly_t<S> p : polys(s)) {
    std::size_t others = 0;
    for ([[maybe_unused]] const poly_t<S> q : adj_p2p(s, p)) ++others;
    if (others != 1) continue;
    bool is_closed = true;
    for (const edge_t<S> e : adj_p2e(s, p)) is_closed = is_closed && !is_boundary(s, e);
    if (is_closed) return false;
  }
  for (const vert_t<S> v : verts(s))
    if (!has_one_fan(s, v)) return false;
  return true;
}

}  // namespace concino::detail
