// Limits of smooth subdivision: how the ring around a vert, after one step, gives the point and the tangent plane of
// the smooth surface.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/generate/detail/dual/read_sectors.hpp>
#include <concino/generate/detail/subdivide/smooth_rules.hpp>
#include <concino/generate/detail/subdivide/subdivision.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace concino::detail {

/// A vert after one step of subdivision, with the new verts around it, counter-clockwise: of its edges, and of its
/// polys, of which poly k is between edges k and k + 1. On the boundary there is one edge more than polys.
struct limit_ring {
  vec3 vert;
  std::span<const vec3> edges, polys;
  std::size_t num_polys = 0;
  bool is_closed = false;
};

enum class smooth_scheme { loop, catmull_clark };

/// Where a vert inside the surface goes.
vec3 inner_limit(smooth_scheme scheme, const limit_ring& r);
/// The normal at a vert, 0 if there is none.
vec3 limit_normal(smooth_scheme scheme, const limit_ring& r);

/// The limits at all verts. Loop's rules use no verts of polys; the ring has none then.
template<smooth_scheme scheme, class Result, class M, class Rule>
Result limit_of(const M& m, const Rule& rule) {
  auto edge_points = make_edge_map<vec3>(m);
  parallel_for_each(edges(m), [&](const edge_t<M>& e) { edge_points[e] = refined_point(m, rule, e); });
  std::vector<vec3> poly_points;  // by position, as the sectors name polys
  auto number = make_poly_map<std::uint32_t>(m);
  std::uint32_t n = 0;
  for (const poly_t<M> p : polys(m)) {
    number[p] = n++;
    if constexpr (scheme == smooth_scheme::catmull_clark) poly_points.push_back(refined_point(m, rule, p));
  }
  const sharp_edges<M, no_creases> sharp{m, no_creases()};
  auto is_sharp = std::vector<unsigned char>(edge_index_bound(m));
  for (const edge_t<M> e : edges(m)) is_sharp[index_of(m, e)] = sharp[e] ? 1 : 0;
  sector_fans fans(vert_index_bound(m));
  read_sectors(m, [&](const poly_t<M>& p) { return number[p]; }, fans);
  Result result{make_vert_map<vec3>(m), make_vert_map<vec3>(m)};
  std::vector<vec3> ring_edges, ring_polys;
  for (const vert_t<M> v : verts(m)) {
    const fan_kind kind = fans.arrange(index_of(m, v), [&](std::uint32_t e) { return is_sharp[e] != 0; });
    const std::span<const sector> fan = fans[index_of(m, v)];
    ring_edges.clear(), ring_polys.clear();
    vec3 sharp_ends;
    std::size_t num_sharp = 0;
    for (const edge_t<M> e : adj_v2e(m, v)) {
      ring_edges.push_back(edge_points[e]);
      if (is_sharp[index_of(m, e)]) sharp_ends += edge_points[e], ++num_sharp;
    }
    if constexpr (scheme == smooth_scheme::catmull_clark)
      for (const sector& s : fan) ring_polys.push_back(poly_points[s.poly]);
    limit_ring r{refined_point(m, rule, v), ring_edges, ring_polys, fan.size(), kind == fan_kind::closed};
    if (ring_edges.empty() || num_sharp > 2) {
      result.points[v] = r.vert;
      continue;
    }
    result.points[v] = num_sharp == 2 ? (4.0 * r.vert + sharp_ends) / 6 : inner_limit(scheme, r);
    if (kind == fan_kind::broken) continue;
    ring_edges.clear();  // now in cyclic order
    for (const sector& s : fan) ring_edges.push_back(edge_points.values()[s.in]);
    if (kind == fan_kind::open) ring_edges.push_back(edge_points.values()[fan.back().out]);
    r.edges = ring_edges;
    result.normals[v] = limit_normal(scheme, r);
  }
  return result;
}

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/generate/detail/subdivide/limit_masks.ipp>
#endif
