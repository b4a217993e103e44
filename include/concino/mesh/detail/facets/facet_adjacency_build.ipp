// Construction of the incidence of polys and facets; see facet_adjacency.hpp.
#pragma once

#include <concino/mesh/detail/facets/facet_adjacency.hpp>

namespace concino::detail {

template<class Facet, unsigned N>
inline void facet_adjacency<Facet, N>::link(std::uint32_t p, std::uint32_t k, Facet f) {
  facets_.begin(p)[k] = f;
  std::uint32_t& o = owner_[f.raw()];
  if (o == ~0u) {
    o = N > 0 ? N * p + k : p;
    neighbours_.begin(p)[k] = {};
    return;
  }
  const incidence first = owner(f);
  const encoded_neighbour before = neighbours_.begin(first.poly)[first.k];
  join(first, p, k);
  if (!before.is_none() && !before.is_non_manifold())
    neighbours_.begin(before.poly())[local(before.poly(), f)] = neighbours_.begin(p)[k];
}

template<class Facet, unsigned N>
void facet_adjacency<Facet, N>::finish() {
  owner_.shrink_to_fit();
  if constexpr (N == 0) {
    facet_lookup_ = row_lookup(facets_);
    set_poly_lists();
    poly_lists_.index_poly_lists(neighbours_, few_facets);
  }
  std::vector<std::uint32_t> visited;
  for (std::uint32_t p = 0; p < num_polys(); ++p)
    if (may_repeat(p)) mark_repeats(p, visited);
}

template<class Facet, unsigned N>
void facet_adjacency<Facet, N>::set_poly_lists() {
  if (poly_lists_.size() == 0) return;
  std::vector<std::uint32_t> poly_list(num_facets(), encoded_neighbour::none);
  const auto for_each_incidence = [&](auto&& visit) {
    for (std::uint32_t p = 0; p < num_polys(); ++p)
      for (std::uint32_t k = 0; k < facets_.length(p); ++k) visit(facets_.begin(p)[k], neighbours_.begin(p)[k]);
  };
  for_each_incidence([&](Facet f, const encoded_neighbour& x) {
    if (x.is_non_manifold()) poly_list[f.raw()] = x.raw;
  });
  for_each_incidence([&](Facet f, encoded_neighbour& x) {
    if (poly_list[f.raw()] != encoded_neighbour::none) x.raw = poly_list[f.raw()];
  });
}

template<class Facet, unsigned N>
void facet_adjacency<Facet, N>::add_to_poly_list(incidence s, encoded_neighbour& first, std::uint32_t p,
                                                 std::uint32_t k) {
  if (first.is_non_manifold()) {
    poly_lists_.push(first.poly_list(), poly_id{p});
  } else {
    const std::uint32_t q = first.poly();  // smaller than the owner, if an edit has replaced it
    const poly_id three[] = {poly_id{std::min(s.poly, q)}, poly_id{std::max(s.poly, q)}, poly_id{p}};
    const std::uint32_t raw = encoded_neighbour::special | encoded_neighbour::non_manifold_bit |
                              static_cast<std::uint32_t>(poly_lists_.size());
    poly_lists_.add_row(three, three + 3, min_list_capacity);
    first.raw = raw;
  }
  neighbours_.begin(p)[k].raw = first.raw;
}

}  // namespace concino::detail
