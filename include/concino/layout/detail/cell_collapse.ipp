// Bodies of cell_collapse.hpp: collapses quads or hexes: cells between opposite cells vanish, and what they connect
// becomes one.
#pragma once

#include <concino/graph/disjoint_sets.hpp>
#include <concino/layout/detail/cell_collapse.hpp>
#include <concino/layout/detail/verts_of_parts.hpp>

#include <algorithm>
#include <bit>
#include <utility>

namespace concino::detail {

CONCINO_INLINE cell_collapse collapse_along(const cube_tables& t, const boundary_flags& boundary,
                                            const std::vector<unsigned char>& is_marked) {
  cell_collapse c(t);
  const unsigned all = t.num_corners() - 1;
  for (std::uint32_t p = 0; p < t.num_polys(); ++p) {
    unsigned marked = 0;
    for (unsigned axis = 1; axis <= all; axis *= 2)
      if (is_marked[t.cell(p, axis, 0)]) marked |= axis;
    for (unsigned axes = 1; axes <= all; ++axes) {
      const unsigned along = axes & marked, n = static_cast<unsigned>(std::popcount(axes));
      if (along == 0) continue;
      for (unsigned place = 0; place <= all; ++place) {
        if (place & axes) continue;
        const std::uint32_t x = t.cell(p, axes, place);
        const bool is_poly = axes == all, is_edge = !is_poly && n == 1;
        std::vector<unsigned char>& gone = is_poly ? c.gone_polys : is_edge ? c.gone_edges : c.gone_facets;
        if (gone[x]) continue;
        gone[x] = 1;
        const unsigned first = along & (~along + 1), k = static_cast<unsigned>(std::popcount(along));
        c.vanishing.push_back({t.cell(p, axes & ~along, place), t.cell(p, axes & ~along, place | first),
                               static_cast<std::uint8_t>(n - k), k % 2 == 1,
                               !is_poly && (is_edge ? boundary.edges : boundary.facets)[x]});
      }
    }
  }
  return c;
}

CONCINO_INLINE cell_collapse collapse_diagonal(const cube_tables& t, std::uint32_t p, unsigned a) {
  cell_collapse c(t);
  c.gone_polys[p] = 1;
  c.vanishing.push_back({t.cell(p, 0, a), t.cell(p, 0, a ^ 3), 0, true, false});
  for (const unsigned between : {a ^ 1, a ^ 2}) {  // the edges from this corner to both others become one
    const unsigned axis = a ^ between, other = axis ^ 3;
    c.vanishing.push_back({t.cell(p, axis, a & ~axis), t.cell(p, other, between & ~other), 1, true, false});
  }
  return c;
}

/// The classes of cells of one dimension that become one.
class merged_cells {
  disjoint_sets sets_;
  std::vector<int> chi_, boundary_chi_;  // Euler characteristics of what becomes one cell
  std::vector<unsigned char> is_merged_;

 public:
  merged_cells(std::size_t n, const std::vector<unsigned char>& on_boundary, const std::vector<unsigned char>* gone,
               const cell_collapse& c, unsigned dim)
      : sets_(n), chi_(n), boundary_chi_(n), is_merged_(n) {
    for (const vanishing_cell& x : c.vanishing)
      if (x.dim == dim) sets_.unite(x.a, x.b);
    for (std::uint32_t i = 0; i < n; ++i)
      if (!gone || !(*gone)[i]) ++chi_[root(i)], boundary_chi_[root(i)] += on_boundary[i];
    for (const vanishing_cell& x : c.vanishing) {
      if (x.dim != dim) continue;
      const int sign = x.is_odd ? -1 : 1;
      chi_[root(x.a)] += sign, boundary_chi_[root(x.a)] += x.on_boundary ? sign : 0;
      is_merged_[root(x.a)] = 1;
    }
  }
  std::uint32_t root(std::uint32_t i) { return static_cast<std::uint32_t>(sets_.root(i)); }
  bool is_merged(std::uint32_t i) { return is_merged_[root(i)] != 0; }
  bool are_contractible() {
    for (std::uint32_t i = 0; i < sets_.size(); ++i)
      if (is_merged_[i] && (chi_[i] != 1 || boundary_chi_[i] < 0 || boundary_chi_[i] > 1)) return false;
    return true;
  }
};

inline constexpr permission not_contractible{
    refusal::link_condition, "parts of the mesh would touch or vanish: what is collapsed has another topology"};
inline constexpr permission poly_with_vert_twice{refusal::degenerate, "a poly would have a vert twice"};
inline constexpr permission cells_on_same_verts{refusal::same_verts,
                                                "two edges, faces or polys would have the same verts"};

/// By vert, how special its place is, from 0 in the interior on.
inline std::vector<std::uint32_t> ranks_of_verts(const cube_tables& t, const boundary_flags& boundary) {
  std::vector<std::uint32_t> num_polys(t.num_verts);
  for (const std::uint32_t v : t.poly_verts) ++num_polys[v];
  const std::uint32_t regular = t.dimension == 2 ? 2 : 4;
  for (std::size_t v = 0; v < t.num_verts; ++v) {
    const std::uint32_t n = num_polys[v];
    num_polys[v] = boundary.verts[v] ? 1 + (n < regular ? regular - n : n - regular) : 0;
  }
  return num_polys;
}

/// Labels the verts by what they become.
inline std::vector<std::uint32_t> label_merged(const cube_tables& t, const boundary_flags& boundary,
                                               const std::vector<vec3>& points, merged_cells& verts, cell_edit& e) {
  const std::vector<std::uint32_t> rank = ranks_of_verts(t, boundary);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> merged;  // root and vert
  std::vector<std::uint32_t> label(t.num_verts), kept;
  for (std::uint32_t v = 0; v < t.num_verts; ++v) {
    label[v] = v;
    if (verts.is_merged(v)) merged.emplace_back(verts.root(v), v);
  }
  std::sort(merged.begin(), merged.end());
  for (std::size_t first = 0, last; first < merged.size(); first = last) {
    std::uint32_t best = 0;
    for (last = first; last < merged.size() && merged[last].first == merged[first].first; ++last)
      best = std::max(best, rank[merged[last].second]);
    kept.clear();
    vec3 sum;
    for (std::size_t i = first; i < last; ++i)
      if (const std::uint32_t v = merged[i].second; rank[v] == best) kept.push_back(v), sum += points[v];
    const std::uint32_t becomes =
        kept.size() == 1 ? kept[0] : e.add_vert(t, sum / static_cast<double>(kept.size()), kept);
    for (std::size_t i = first; i < last; ++i) {
      label[merged[i].second] = becomes;
      if (merged[i].second != becomes) e.removed.push_back(merged[i].second);
    }
  }
  return label;
}

/// Whether the cells that remain have different verts, and none a vert twice.
inline permission check_verts(const cube_tables& t, const cell_edit& e, const cell_collapse& c, merged_cells& edges,
                              merged_cells& facets) {
  verts_of_parts all[3];
  const unsigned last = t.num_corners() - 1;
  for (std::uint32_t p = 0; p < t.num_polys(); ++p) {
    if (c.gone_polys[p]) continue;
    for (unsigned axes = 1; axes <= last; ++axes)
      for (unsigned place = 0; place <= last; ++place) {
        if (place & axes) continue;
        std::uint32_t verts[8];
        std::size_t n = 0;
        for (unsigned k = 0; k <= last; ++k)
          if ((k & ~axes) == place) verts[n++] = e.labels[p * t.num_corners() + k];
        const std::uint32_t x = t.cell(p, axes, place);
        const bool is_poly = axes == last, is_edge = !is_poly && n == 2;
        const std::uint32_t number = is_poly ? x : is_edge ? edges.root(x) : facets.root(x);
        if (!all[is_poly ? 2 : is_edge ? 0 : 1].add(verts, n, number)) return poly_with_vert_twice;
      }
  }
  for (verts_of_parts& x : all)
    if (x.has_two_on_same_verts()) return cells_on_same_verts;
  return {};
}

CONCINO_INLINE cell_edit collapsed(const cube_tables& t, const boundary_flags& boundary,
                                   const std::vector<vec3>& points, const cell_collapse& c) {
  cell_edit e(t);
  merged_cells verts(t.num_verts, boundary.verts, nullptr, c, 0);
  merged_cells edges(t.num_edges, boundary.edges, &c.gone_edges, c, 1);
  merged_cells faces(t.num_facets, boundary.facets, &c.gone_facets, c, 2);
  merged_cells& facets = t.dimension == 2 ? edges : faces;
  e.is_gone = c.gone_polys;
  const bool is_contractible =
      verts.are_contractible() && edges.are_contractible() && (t.dimension == 2 || faces.are_contractible());
  const std::vector<std::uint32_t> label = label_merged(t, boundary, points, verts, e);
  for (std::uint32_t& v : e.labels) v = label[v];
  e.allowed = is_contractible ? check_verts(t, e, c, edges, facets) : not_contractible;
  std::vector<unsigned char> is_listed(t.num_facets);
  for (std::uint32_t i = 0; i < t.poly_facets.size(); ++i) {
    const std::uint32_t f = t.poly_facets[i];
    if (c.gone_polys[i / t.num_poly_facets()] || !facets.is_merged(f) || is_listed[facets.root(f)]) continue;
    is_listed[facets.root(f)] = 1;
    e.facets.push_back(i);
  }
  return e;
}

}  // namespace concino::detail
