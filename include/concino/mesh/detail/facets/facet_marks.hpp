// Marks of the incidences of a poly whose neighbour is already behind another of its facets.
#pragma once

#include <concino/mesh/detail/facets/facet_incidence.hpp>

#include <cstdint>
#include <vector>

namespace concino::detail {

/// Keeps the marks of the neighbours that a poly has behind several facets.
template<class Facet, unsigned N>
class facet_marks : public facet_incidence<Facet, N> {
  using base = facet_incidence<Facet, N>;

 protected:
  using base::facets_, base::neighbours_, base::owner_, base::poly_lists_, base::facet_lookup_;
  using base::min_list_capacity, base::local, base::set_owner;

  using base::base;

 public:
  using typename base::incidence;
  using base::is_owned, base::num_facets, base::num_polys, base::owner, base::polys_of;

  /// Edits: updates which incidences of p and of its neighbours repeat a neighbour. p is a new poly that was linked.
  void update_marks(std::uint32_t p, std::vector<std::uint64_t> scratch);

  /// Marks the incidences of p whose neighbour is already behind an earlier facet or a non-manifold facet of p, and no
  /// others. The scratch memory needs room for its facets, if these are more than `max_scanned_facets`.
  template<class Scratch>
  void refresh_marks(poly_id p, Scratch& scratch);
  static constexpr std::uint32_t few_facets = 8;           // of polys whose poly lists are not stored
  static constexpr std::uint32_t max_scanned_facets = 24;  // up to here comparing all pairs is fastest

  /// Whether an incidence of p is marked or non-manifold.
  bool is_marked(std::uint32_t p) const {
    bool is = false;
    for (const encoded_neighbour *s = neighbours_.begin(p), *last = s + facets_.length(p); s != last; ++s)
      is |= !s->is_none() && !s->is_first_occurrence();
    return is;
  }

  /// A fast test that is false for nearly all polys.
  bool may_repeat(std::uint32_t p) const {
    const std::uint32_t n = facets_.length(p);
    if (n > max_scanned_facets) return true;
    const encoded_neighbour* const s = neighbours_.begin(p);
    bool may = false;
    for (std::uint32_t k = 0; k < n; ++k) {
      may |= s[k].is_non_manifold();
      for (std::uint32_t j = 0; j < k; ++j) may |= s[k].raw == s[j].raw && !s[k].is_none();
    }
    return may;
  }

  /// Marks the incidences of p whose neighbour is already behind an earlier facet or a non-manifold facet of p.
  void mark_repeats(std::uint32_t p, std::vector<std::uint32_t>& visited);

 protected:
  /// Marks facet k of p, which has one neighbour, if that is also at a non-manifold facet of p.
  void mark_if_in_poly_list(std::uint32_t p, std::uint32_t k);

 private:
  /// Marks incidences of one poly, given as neighbour and position, that repeat a neighbour.
  template<class Scratch>
  static void mark_repeats_in(Scratch& sorted, encoded_neighbour* s);

  void mark_by_scanning(std::uint32_t p);

  /// Marks the incidences of p whose neighbour is also at a non-manifold facet of p.
  void mark_in_poly_lists(std::uint32_t p);

  // A repeated neighbour stays repeated as long as that poly lives, so marks are only added: at incidences with a new
  // poly, with one that is at a non-manifold facet now, or with one that was at a non-manifold facet before.

  /// Marks the incidences of q with neighbour p if p is also behind an earlier facet or a non-manifold facet of q. p is
  /// the last poly of each of its lists.
  void mark_repeats_of(std::uint32_t p, std::uint32_t q);
  /// Marks the incidences of q whose only neighbour is p.
  void mark_facets_to(std::uint32_t p, std::uint32_t q);
};

}  // namespace concino::detail

#include <concino/mesh/detail/facets/facet_marks.ipp>
