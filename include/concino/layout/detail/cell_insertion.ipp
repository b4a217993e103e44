// Bodies of cell_insertion.hpp: inserts a layer of quads or hexes between the two sides of some facets.
#pragma once

#include <concino/layout/detail/cell_insertion.hpp>
#include <concino/layout/detail/vert_parts.hpp>

namespace concino::detail {

inline constexpr permission no_facets{refusal::wrong_set, "there are no facets to insert polys at"};
inline constexpr permission facet_twice{refusal::wrong_set, "a facet is listed twice"};
inline constexpr permission open_facets{
    refusal::wrong_set, "the facets end inside the mesh, or more than two of them meet at a vert or edge"};
inline constexpr permission not_two_parts{refusal::link_condition,
                                          "the facets do not separate the polys at one of their verts into two parts"};

/// Corners of facet 2 a + s of a hex, as places, counter-clockwise seen from outside; of a quad's edge the first two.
inline constexpr unsigned char outward_corners[6][4] = {{2, 0, 4, 6}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                                        {3, 2, 6, 7}, {0, 2, 3, 1}, {4, 5, 7, 6}};

inline permission mark_facets(marked_patch& m, const std::vector<std::uint32_t>& facets) {
  if (facets.empty()) return no_facets;
  for (const std::uint32_t f : facets) {
    if (m.is_marked[f]) return facet_twice;
    m.is_marked[f] = 1;
    if (const std::size_t n = m.t.at_facets.count(f); n == 0 || n > 2) return facet_of_many;
    std::uint32_t entries[4];
    const unsigned count = m.t.ridges_of(f, entries);
    for (unsigned k = 0; k < count; ++k) ++m.num_marked_at[m.t.poly_ridges()[entries[k]]];
  }
  const std::vector<unsigned char>& on_boundary = m.t.dimension == 2 ? m.boundary.verts : m.boundary.edges;
  for (std::size_t r = 0; r < m.num_marked_at.size(); ++r)
    if (m.num_marked_at[r] > 2 || (m.num_marked_at[r] == 1 && !on_boundary[r])) return open_facets;
  return {};
}

/// Gives the parts at a vert of marked facets verts of their own. `outer` has their labels for the other part, by
/// corner.
inline bool split_vert(const marked_patch& m, std::uint32_t v, double thickness, cell_edit& e,
                       std::vector<std::uint32_t>& outer) {
  const vert_parts parts(m, v);
  if (!parts.are_two) return false;
  std::uint32_t label[2] = {v, v};
  bool stays = false;
  for (const unsigned k : {0u, 1u}) {
    const bool keeps = !parts.has_polys[k] || (!stays && parts.has_polys[1 - k] && thickness == 0);
    stays = stays || keeps;
    if (!keeps) label[k] = e.add_vert(m.t, m.points[v] + thickness * parts.into(k), {v});
  }
  if (!stays) e.removed.push_back(v);
  for (std::uint32_t i = 0; i < parts.num_polys(); ++i) {
    const std::uint32_t corner = m.at_verts.entry(v, i);
    e.labels[corner] = label[parts.part(i)];
    outer[corner] = label[1 - parts.part(i)];
  }
  return true;
}

CONCINO_INLINE cell_edit inserted(const cube_tables& t, const boundary_flags& boundary, const std::vector<vec3>& points,
                                  const std::vector<std::uint32_t>& facets, double thickness) {
  cell_edit e(t);
  marked_patch m{t,
                 boundary,
                 points,
                 std::vector<unsigned char>(t.num_facets),
                 std::vector<std::uint32_t>(t.num_ridges()),
                 poly_incidence(t.poly_verts, t.num_verts)};
  if (e.allowed = mark_facets(m, facets); !e.allowed) return e;
  const unsigned n = t.num_corners(), half = n / 2;
  std::vector<std::uint32_t> outer(t.poly_verts.size());
  std::vector<unsigned char> is_split(t.num_verts);
  for (const std::uint32_t f : facets) {
    const std::uint32_t entry = t.at_facets.entry(f, 0), p = entry / t.num_poly_facets();
    const unsigned char* const corners = outward_corners[entry % t.num_poly_facets()];
    for (unsigned k = 0; k < half; ++k) {
      const std::uint32_t v = t.cell(p, 0, corners[k]);
      if (is_split[v]) continue;
      is_split[v] = 1;
      if (!split_vert(m, v, thickness, e, outer)) return e.allowed = not_two_parts, e;
    }
  }
  for (const std::uint32_t f : facets) {
    const std::uint32_t entry = t.at_facets.entry(f, 0), p = entry / t.num_poly_facets();
    const unsigned char* const corners = outward_corners[entry % t.num_poly_facets()];
    std::uint32_t
        in_order[8];  // of adj_p2v: first those on the side of p; of a quad backwards, as p runs the other way
    for (unsigned k = 0; k < half; ++k) {
      const std::uint32_t at = p * n + corners[k];
      in_order[n == 8 ? k : 1 - k] = e.labels[at];
      in_order[n == 8 ? 4 + k : 2 + k] = outer[at];
    }
    const std::size_t first = e.added.size();
    e.added.resize(first + n);
    for (unsigned k = 0; k < n; ++k) e.added[first + corner_places[k]] = in_order[k];
    e.added_from.push_back(p);
  }
  return e;
}

}  // namespace concino::detail
