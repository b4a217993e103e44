// Incidence of polys and facets, as it is read: the facets of each poly, the polys of each facet, the neighbours.
#pragma once

#include <concino/mesh/detail/facets/adjacent_polys.hpp>
#include <concino/mesh/detail/facets/encoded_neighbour.hpp>
#include <concino/mesh/detail/facets/non_manifold_facets.hpp>
#include <concino/mesh/detail/rows/row_lookup.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>

namespace concino::detail {

/// N facets per poly, or any number (N = 0). The pair (p, k) is the incidence of poly p and its facet k.
template<class Facet, unsigned N>
class facet_incidence {
 protected:
  jagged_array<Facet, N> facets_;        // per poly
  jagged_array<encoded_neighbour, N> neighbours_;       // parallel to facets_
  core::flat_array<std::uint32_t> owner_;  // per facet: if N > 0, its first incidence, N * poly + k; if N = 0, the poly
                                           // of that; ~0 if none
  non_manifold_facets poly_lists_;
  row_lookup facet_lookup_;  // of facets in polys with many facets

  static constexpr std::size_t min_list_capacity = 4;  // of a new list of polys

 public:
  struct incidence {
    std::uint32_t poly, k;
  };

  facet_incidence() = default;
  facet_incidence(jagged_array<Facet, N> facets, jagged_array<encoded_neighbour, N> neighbours)
      : facets_(std::move(facets)), neighbours_(std::move(neighbours)) {}

  std::size_t num_polys() const { return facets_.size(); }
  std::size_t num_facets() const { return owner_.size(); }
  id_span<Facet> facets(poly_id p) const { return facets_[p.raw()]; }
  const encoded_neighbour* neighbours_of(poly_id p) const { return neighbours_.begin(p.raw()); }
  adjacent_polys polys(poly_id p) const {
    return {neighbours_.begin(p.raw()), neighbours_.end(p.raw()), &poly_lists_, p};
  }
  /// Whether f has two polys, and its owner is not adjacent to the other through an earlier facet. Needs: f has a poly.
  bool has_two_polys_once(Facet f) const {
    const incidence s = owner(f);
    return neighbours_.begin(s.poly)[s.k].is_first_occurrence();
  }
  const jagged_array<Facet, N>& facet_rows() const { return facets_; }
  bool is_owned(Facet f) const { return owner_[f.raw()] != ~0u; }

  /// The incidence that was linked to f first.
  incidence owner(Facet f) const {
    const std::uint32_t o = owner_[f.raw()];
    if constexpr (N > 0) {
      return {o / N, o % N};
    } else {
      return {o, local(o, f)};
    }
  }

  /// The k with facet k of p equal to f; the number of facets of p if there is none.
  std::uint32_t position_of(poly_id p, Facet f) const {
    const std::uint32_t n = facets_.length(p.raw());
    if (n > row_lookup::longest_scan) return facet_lookup_.find(p.raw(), facets_[p.raw()], f);
    const Facet* const at = facets_.begin(p.raw());
    std::uint32_t k = 0;
    while (k < n && at[k] != f) ++k;
    return k;
  }

  polys_of_facet polys_of(Facet f) const {
    if (!is_owned(f)) return {};
    const incidence s = owner(f);
    const encoded_neighbour x = neighbours_.begin(s.poly)[s.k];
    if (x.is_none()) return polys_of_facet{poly_id{s.poly}};
    if (x.is_non_manifold()) return {poly_lists_.begin(x.poly_list()), poly_lists_.end(x.poly_list())};
    return {poly_id{s.poly}, poly_id{x.poly()}};
  }

  encoded_neighbour neighbour(poly_id p, std::uint32_t k) const { return neighbours_.begin(p.raw())[k]; }
  /// The number of polys at facet k of p.
  std::uint32_t num_polys_at(poly_id p, std::uint32_t k) const {
    const encoded_neighbour x = neighbour(p, k);
    return x.is_none() ? 1 : x.is_non_manifold() ? poly_lists_.length(x.poly_list()) : 2;
  }

 protected:
  /// The k with facet k of p equal to f, which must exist.
  std::uint32_t local(std::uint32_t p, Facet f) const {
    const Facet* const at = facets_.begin(p);
    for (std::uint32_t k = 0; k < row_lookup::longest_scan; ++k)
      if (at[k] == f) return k;
    return facet_lookup_.find(p, facets_[p], f);
  }

  void set_owner(Facet f, std::uint32_t p, std::uint32_t k) { owner_[f.raw()] = N > 0 ? N * p + k : p; }
};

}  // namespace concino::detail
