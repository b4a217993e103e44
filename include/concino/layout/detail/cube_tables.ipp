// Bodies of cube_tables.hpp: cube_tables: the quads or hexes of a mesh as squares or cubes with axes, and who meets
// whom at their ridges, the verts of a surface or the edges of a volume.
#pragma once

#include <concino/layout/detail/cube_tables.hpp>

namespace concino::detail {

CONCINO_INLINE poly_incidence::poly_incidence(const std::vector<std::uint32_t>& lists, std::size_t num_elements)
    : first_(num_elements + 1), entries_(lists.size()) {
  for (const std::uint32_t x : lists) ++first_[x];
  std::uint32_t sum = 0;
  for (std::uint32_t& n : first_) sum += n, n = sum;  // the ends, which become starts below
  for (std::size_t i = lists.size(); i-- > 0;) entries_[--first_[lists[i]]] = static_cast<std::uint32_t>(i);
}

CONCINO_INLINE void cube_tables::prepare() {
  at_facets = poly_incidence(poly_facets, num_facets);
  at_ridges = poly_incidence(poly_ridges(), num_ridges());
}

CONCINO_INLINE std::uint32_t cube_tables::cell(std::size_t p, unsigned axes, unsigned place) const {
  const unsigned all = num_corners() - 1;
  if (axes == 0) return poly_verts[p * num_corners() + place];
  if (axes == all) return static_cast<std::uint32_t>(p);
  const unsigned other = all ^ axes;
  if ((axes & (axes - 1)) == 0) {  // an edge
    const unsigned axis = axes >> 1, low = axes - 1, number = (place & low) | (place >> 1 & ~low);
    return poly_edges[p * num_poly_edges() + (axis << (dimension - 1)) + number];
  }
  return facet(p, 2 * (other >> 1) + ((place & other) != 0));
}

CONCINO_INLINE std::pair<unsigned, unsigned> cube_tables::facets_at(unsigned k) const {
  if (dimension == 2) return {k & 1, 2 + (k >> 1)};
  const unsigned axis = k >> 2, a = axis == 0 ? 1 : 0, b = axis == 2 ? 1 : 2;
  return {2 * a + (k & 1), 2 * b + (k >> 1 & 1)};
}

CONCINO_INLINE unsigned cube_tables::place_of_facet(std::size_t p, std::uint32_t f) const {
  unsigned place = 0;
  while (facet(p, place) != f) ++place;
  return place;
}

CONCINO_INLINE unsigned cube_tables::place_of_ridge(std::size_t p, std::uint32_t r) const {
  const std::uint32_t* const ridges = poly_ridges().data() + p * num_poly_ridges();
  unsigned place = 0;
  while (ridges[place] != r) ++place;
  return place;
}

CONCINO_INLINE std::uint32_t cube_tables::other_poly(std::size_t p, std::uint32_t f) const {
  if (at_facets.count(f) != 2) return none;
  const std::uint32_t a = at_facets.entry(f, 0) / num_poly_facets(), b = at_facets.entry(f, 1) / num_poly_facets();
  return a == p ? b : a;
}

CONCINO_INLINE std::uint32_t cube_tables::next_facet(std::size_t p, std::uint32_t f, std::uint32_t r) const {
  const auto [a, b] = facets_at(place_of_ridge(p, r));
  return facet(p, a) == f ? facet(p, b) : facet(p, a);
}

CONCINO_INLINE unsigned cube_tables::ridges_of(std::uint32_t f, std::uint32_t (&entries)[4]) const {
  const std::uint32_t p = at_facets.entry(f, 0) / num_poly_facets(), place = at_facets.entry(f, 0) % num_poly_facets();
  unsigned count = 0;
  for (unsigned k = 0; k < num_poly_ridges(); ++k) {
    const auto [a, b] = facets_at(k);
    if (a == place || b == place) entries[count++] = p * num_poly_ridges() + k;
  }
  return count;
}

CONCINO_INLINE std::uint32_t cube_tables::opposite_at(std::uint32_t f, std::uint32_t r) const {
  const std::size_t p = at_facets.entry(f, 0) / num_poly_facets();
  const std::uint32_t beside = next_facet(p, f, r);
  return next_facet(other_poly(p, beside), beside, r);
}

/// Adds the polys that a walk about r meets which leaves p by f. Returns whether it comes back to p.
CONCINO_INLINE bool ridge_fans::walk(const cube_tables& t, std::uint32_t p, std::uint32_t f, std::uint32_t r) {
  for (std::uint32_t at = p;;) {
    const std::size_t num_polys = t.at_facets.count(f);
    if (num_polys > 2) shapes[r].is_manifold = false;
    if (num_polys == 1) shapes[r].on_boundary = true;
    at = t.other_poly(at, f);
    if (at == t.none) return false;
    if (at == p) return true;
    fan_.push_back(at * t.num_poly_ridges() + t.place_of_ridge(at, r));
    f = t.next_facet(at, f, r);
  }
}

CONCINO_INLINE void ridge_fans::find_fan(const cube_tables& t, std::uint32_t entry) {
  const std::uint32_t r = t.poly_ridges()[entry], p = entry / t.num_poly_ridges();
  const auto [a, b] = t.facets_at(entry % t.num_poly_ridges());
  fan_.assign(1, entry);
  const bool is_closed = walk(t, p, t.facet(p, a), r);
  if (!is_closed) walk(t, p, t.facet(p, b), r);
  const bool is_regular = fan_.size() == (is_closed ? 4 : 2);
  for (const std::uint32_t x : fan_) {
    is_crossing[x] = is_closed && is_regular;
    is_irregular[x] = !is_regular;
  }
  if (shapes[r].valence > 0) shapes[r].is_manifold = false;  // there was a fan before
  shapes[r].valence += static_cast<std::uint32_t>(fan_.size());
}

CONCINO_INLINE ridge_fans::ridge_fans(const cube_tables& t)
    : shapes(t.num_ridges()), is_crossing(t.poly_ridges().size(), 2), is_irregular(t.poly_ridges().size()) {
  for (std::uint32_t r = 0; r < t.num_ridges(); ++r)
    for (std::size_t n = 0; n < t.at_ridges.count(r); ++n)
      if (const std::uint32_t entry = t.at_ridges.entry(r, n); is_crossing[entry] == 2) find_fan(t, entry);
}

}  // namespace concino::detail
