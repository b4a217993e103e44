// Marks of the incidences of a poly whose neighbour is already behind another of its facets; see facet_marks.hpp.
#pragma once

#include <concino/mesh/detail/facets/facet_marks.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

template<class Facet, unsigned N>
void facet_marks<Facet, N>::update_marks(std::uint32_t p, std::vector<std::uint64_t> scratch) {
  encoded_neighbour* const s = neighbours_.begin(p);
  const std::uint32_t n = facets_.length(p);
  if (n <= max_scanned_facets) {
    mark_by_scanning(p);
  } else {
    for (std::uint32_t k = 0; k < n; ++k)
      if (!s[k].is_none() && !s[k].is_non_manifold()) scratch.push_back(std::uint64_t{s[k].poly()} << 32 | k);
    mark_repeats_in(scratch, s);
  }
  mark_in_poly_lists(p);
  for (const Facet f : facets_[p]) {
    const polys_of_facet all = polys_of(f);
    if (all.size() == 3) {  // the others were neighbours through f before
      mark_facets_to(all[0].raw(), all[1].raw());
      mark_facets_to(all[1].raw(), all[0].raw());
    }
    for (const poly_id q : all)
      if (q.raw() != p) mark_repeats_of(p, q.raw());
  }
}

template<class Facet, unsigned N>
template<class Scratch>
void facet_marks<Facet, N>::refresh_marks(poly_id p, Scratch& scratch) {
  encoded_neighbour* const s = neighbours_.begin(p.raw());
  const std::uint32_t n = facets_.length(p.raw());
  if (N > 0 && !is_marked(p.raw()) && !may_repeat(p.raw())) return;
  bool has_list = false;
  for (std::uint32_t k = 0; k < n; ++k) {
    if (s[k].is_none()) continue;
    if (s[k].is_non_manifold()) has_list = true;
    else s[k].raw &= ~encoded_neighbour::special;
  }
  if (n <= max_scanned_facets) {
    mark_by_scanning(p.raw());
  } else {
    scratch.clear();
    for (std::uint32_t k = 0; k < n; ++k)
      if (!s[k].is_none() && !s[k].is_non_manifold()) scratch.push_back(std::uint64_t{s[k].poly()} << 32 | k);
    mark_repeats_in(scratch, s);
  }
  if (has_list) mark_in_poly_lists(p.raw());
}

template<class Facet, unsigned N>
void facet_marks<Facet, N>::mark_repeats(std::uint32_t p, std::vector<std::uint32_t>& visited) {
  encoded_neighbour* const s = neighbours_.begin(p);
  const std::uint32_t n = facets_.length(p);
  if (n <= max_scanned_facets) {
    mark_by_scanning(p);
    return mark_in_poly_lists(p);
  }
  if (visited.size() < num_polys()) visited.assign(num_polys(), ~0u);
  std::size_t different = 0;
  bool has_poly_list = false;
  for (std::uint32_t k = 0; k < n; ++k) {
    has_poly_list = has_poly_list || s[k].is_non_manifold();
    if (s[k].is_none() || s[k].is_non_manifold()) continue;
    const std::uint32_t q = s[k].poly();
    if (visited[q] == p) s[k].raw |= encoded_neighbour::special;
    else ++different;
    visited[q] = p;
  }
  if (!has_poly_list || different == 0) return;
  // met[q] becomes more than p where q is at a non-manifold facet. The shorter list is searched: the polys of that
  // facet or the facets of p.
  for (std::uint32_t j = 0; j < n; ++j) {
    if (!s[j].is_non_manifold()) continue;
    const id_span<poly_id> poly_list = poly_lists_[s[j].poly_list()];
    if (poly_list.size() <= 16 * different) {
      for (const poly_id q : poly_list)
        if (visited[q.raw()] == p) visited[q.raw()] = p | encoded_neighbour::special;
    } else {
      for (std::uint32_t k = 0; k < n; ++k)
        if (s[k].is_first_occurrence() && poly_lists_.holds(s[j].poly_list(), poly_id{s[k].poly()}))
          s[k].raw |= encoded_neighbour::special;
    }
  }
  for (std::uint32_t k = 0; k < n; ++k)
    if (s[k].is_first_occurrence() && visited[s[k].poly()] == (p | encoded_neighbour::special))
      s[k].raw |= encoded_neighbour::special;
}

template<class Facet, unsigned N>
template<class Scratch>
void facet_marks<Facet, N>::mark_repeats_in(Scratch& sorted, encoded_neighbour* s) {
  std::sort(sorted.data(), sorted.data() + sorted.size());
  for (std::size_t i = 1; i < sorted.size(); ++i)
    if (sorted[i] >> 32 == sorted[i - 1] >> 32)
      s[static_cast<std::uint32_t>(sorted[i])].raw |= encoded_neighbour::special;
}

template<class Facet, unsigned N>
void facet_marks<Facet, N>::mark_by_scanning(std::uint32_t p) {
  encoded_neighbour* const s = neighbours_.begin(p);
  for (std::uint32_t k = 1; k < facets_.length(p); ++k)
    if (!s[k].is_none() && !s[k].is_non_manifold())
      for (std::uint32_t j = 0; j < k; ++j)
        if (!s[j].is_none() && !s[j].is_non_manifold() && s[j].poly() == s[k].poly()) {
          s[k].raw |= encoded_neighbour::special;
          break;
        }
}

template<class Facet, unsigned N>
void facet_marks<Facet, N>::mark_in_poly_lists(std::uint32_t p) {
  encoded_neighbour* const s = neighbours_.begin(p);
  const std::uint32_t n = facets_.length(p);
  for (std::uint32_t j = 0; j < n; ++j)
    if (s[j].is_non_manifold())
      for (std::uint32_t k = 0; k < n; ++k)
        if (s[k].is_first_occurrence() && poly_lists_.holds(s[j].poly_list(), poly_id{s[k].poly()}))
          s[k].raw |= encoded_neighbour::special;
}

template<class Facet, unsigned N>
void facet_marks<Facet, N>::mark_repeats_of(std::uint32_t p, std::uint32_t q) {
  encoded_neighbour* const s = neighbours_.begin(q);
  const std::uint32_t n = facets_.length(q);
  bool visited = false;
  for (std::uint32_t k = 0; k < n; ++k)
    visited = visited || (s[k].is_non_manifold() && *(poly_lists_.end(s[k].poly_list()) - 1) == poly_id{p});
  for (std::uint32_t k = 0; k < n; ++k) {
    if (s[k].is_none() || s[k].is_non_manifold() || s[k].poly() != p) continue;
    if (visited) s[k].raw |= encoded_neighbour::special;
    visited = true;
  }
}

template<class Facet, unsigned N>
void facet_marks<Facet, N>::mark_facets_to(std::uint32_t p, std::uint32_t q) {
  encoded_neighbour* const s = neighbours_.begin(q);
  for (std::uint32_t k = 0; k < facets_.length(q); ++k)
    if (s[k].is_first_occurrence() && s[k].poly() == p) s[k].raw |= encoded_neighbour::special;
}

template<class Facet, unsigned N>
void facet_marks<Facet, N>::mark_if_in_poly_list(std::uint32_t p, std::uint32_t k) {
  encoded_neighbour* const s = neighbours_.begin(p);
  for (std::uint32_t j = 0; j < facets_.length(p); ++j)
    if (s[j].is_non_manifold() && poly_lists_.holds(s[j].poly_list(), poly_id{s[k].poly()})) {
      s[k].raw |= encoded_neighbour::special;
      return;
    }
}

}  // namespace concino::detail
