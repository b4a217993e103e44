// Builds the incidence of polys and facets: the facets of each poly, the polys of each facet, and the neighbour of each
// poly at each of its facets. Facets are the edges of a surface and the faces of a volume. The dual graph is
// traversed in this table.
#pragma once

#include <concino/core/parallel.hpp>
#include <concino/mesh/detail/facets/facet_edits.hpp>
#include <concino/mesh/detail/rows/row_lookup.hpp>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// N facets per poly, or any number (N = 0). The pair (p, k) is the incidence of poly p and its facet k.
template<class Facet, unsigned N>
class facet_adjacency : public facet_edits<Facet, N> {
  using base = facet_edits<Facet, N>;
  using base::facets_, base::neighbours_, base::owner_, base::poly_lists_, base::facet_lookup_;
  using base::min_list_capacity, base::local, base::set_owner;

 public:
  using typename base::incidence;
  using base::is_owned, base::num_facets, base::num_polys, base::owner, base::polys_of;
  using base::few_facets, base::max_scanned_facets, base::mark_repeats, base::may_repeat;

  facet_adjacency() = default;
  /// Starts without facets and with uninitialised neighbours. Call link() once for each incidence.
  facet_adjacency(jagged_array<Facet, N> facets, jagged_array<encoded_neighbour, N> unwritten)
      : base(std::move(facets), std::move(unwritten)) {}
  /// The same with new numbers; removed facets and polys are left out.
  facet_adjacency compacted(const compact_numbers<Facet>& kept_facets, const compact_numbers<poly_id>& kept) const;
  /// Adds a facet without polys.
  void add_facet() { owner_.push_back(~0u); }
  /// Construction: adds the next facet, which is facet k of p and of no other poly so far.
  void add_facet(std::uint32_t p, std::uint32_t k, Facet f)
    requires(N > 0)
  {
    facets_.begin(p)[k] = f;
    neighbours_.begin(p)[k] = {};
    owner_.push_back(N * p + k);
  }
  void reserve_facets(std::size_t n) { owner_.reserve(n); }
  /// Construction: sets n facets without polys.
  void set_facets(std::size_t n) { owner_ = core::flat_array<std::uint32_t>(n, ~0u); }

  /// Construction: makes f facet k of p.
  void link(std::uint32_t p, std::uint32_t k, Facet f);
  /// The same if the owner of f is known: the search takes long if polys have many facets. finish() must follow.
  void link(std::uint32_t p, std::uint32_t k, Facet f, incidence first) {
    facets_.begin(p)[k] = f;
    join(first, p, k);
  }

  /// Construction: call it after the last link, so that a neighbour behind two facets is listed once.
  void finish();

  // Edits allocate their memory first, which changes nothing, and cannot fail afterwards.

  /// Edits: stages the n facets of a poly that will be added. They are copied, or the caller writes them; none for a
  /// facet that does not exist yet.
  Facet* stage_poly(std::uint32_t n, const Facet* facets = nullptr) {
    neighbours_.stage_row(nullptr, n);
    return facets_.stage_row(facets, n);
  }
  /// Edits: allocates memory for the links of the staged poly, which has `more` new facets. Returns scratch memory for
  /// update_marks().
  std::vector<std::uint64_t> reserve_links(const Facet* facets, std::uint32_t n, std::size_t more) {
    std::size_t num_poly_lists = 0;
    for (std::uint32_t k = 0; k < n; ++k) {
      if (facets[k].is_none() || !is_owned(facets[k])) continue;
      const incidence s = owner(facets[k]);
      const encoded_neighbour x = neighbours_.begin(s.poly)[s.k];
      if (x.is_non_manifold()) poly_lists_.reserve_in_row(x.poly_list(), 1);
      else if (!x.is_none()) ++num_poly_lists;
    }
    if (num_poly_lists > 0) poly_lists_.reserve_rows(num_poly_lists, num_poly_lists * min_list_capacity);
    owner_.reserve_back(more);
    std::vector<std::uint64_t> scratch;
    if (n > max_scanned_facets) scratch.reserve(n);
    return scratch;
  }
  /// Edits: adds the staged poly; add_facet() and link() of its facets must follow.
  void commit_poly(std::uint32_t n) {
    facets_.commit_row(n);
    neighbours_.commit_row(n);
    std::fill_n(neighbours_.begin(num_polys() - 1), n, encoded_neighbour{});
  }

 private:
  /// Gives the second poly of every non-manifold facet the list of its polys: before, it had one neighbour there.
  void set_poly_lists();

  void join(incidence s, std::uint32_t p, std::uint32_t k) {
    encoded_neighbour& first = neighbours_.begin(s.poly)[s.k];
    if (first.is_none()) {
      first.raw = p;
      neighbours_.begin(p)[k].raw = s.poly;
    } else {
      add_to_poly_list(s, first, p, k);
    }
  }

  /// The incidence of the second poly is not updated here.
  void add_to_poly_list(incidence s, encoded_neighbour& first, std::uint32_t p, std::uint32_t k);
};

}  // namespace concino::detail

#include <concino/mesh/detail/facets/facet_adjacency_build.ipp>
