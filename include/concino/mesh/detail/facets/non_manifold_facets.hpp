// The polys of non-manifold facets, as lists.
#pragma once

#include <concino/concepts/descriptors.hpp>
#include <concino/mesh/detail/facets/encoded_neighbour.hpp>
#include <concino/mesh/detail/rows/jagged_array.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

template<class Id> class compact_numbers;

/// The poly lists of non-manifold facets, each in ascending order. The numbers of the lists of a poly with many facets
/// are stored as well, until a list is edited.
class non_manifold_facets : private jagged_array<poly_id, 0> {
  using base = jagged_array<poly_id, 0>;
  std::vector<std::uint32_t> polys_, first_, poly_lists_;  // polys with many facets, ascending; where the list numbers
                                                           // of each begin; these numbers
  std::vector<poly_id> united_;                        // unions of all poly lists of one poly, numbered after the lists
                                                       // themselves
  std::vector<std::uint32_t> united_first_;

  /// Replaces the list numbers since `from` by one number, that of their union.
  void unite(std::size_t from) {
    std::vector<std::uint64_t> all;
    for (std::size_t i = from; i < poly_lists_.size(); ++i)
      for (const poly_id q : (*this)[poly_lists_[i]]) all.push_back(q.raw());
    std::sort(all.data(), all.data() + all.size());
    for (std::size_t i = 0; i < all.size(); ++i)
      if (i == 0 || all[i] != all[i - 1]) united_.push_back(poly_id{all[i]});
    poly_lists_.resize(from);
    poly_lists_.push_back(static_cast<std::uint32_t>(size() + united_first_.size() - 1));
    united_first_.push_back(static_cast<std::uint32_t>(united_.size()));
  }
  void invalidate() noexcept {
    polys_.clear();
    first_.clear();
    poly_lists_.clear();
    united_.clear();
    united_first_.clear();
  }

 public:
  using base::begin;
  using base::end;
  using base::length;
  using base::size;
  using base::operator[];

  using base::make_editable;
  using base::reserve_in_row;
  using base::reserve_rows;

  /// The lists as rows, which the caller may change.
  base& rows() {
    invalidate();
    return *this;
  }
  const base& rows() const { return *this; }

  template<class It>
  void add_row(It from, It to, std::size_t room = 0) {
    invalidate();
    base::add_row(from, to, room);
  }
  void push(std::size_t i, const poly_id& p) {
    invalidate();
    base::push(i, p);
  }
  /// Adds p to list i, which remains sorted.
  void insert(std::size_t i, const poly_id& p) {
    invalidate();
    base::insert_sorted(i, p);
  }
  void remove(std::size_t i, const poly_id& p) {
    invalidate();
    base::remove(i, p);
  }
  void clear_row(std::size_t i) {
    invalidate();
    base::clear_row(i);
  }
  bool holds(std::uint32_t poly_list, poly_id p) const {
    return std::binary_search(begin(poly_list), end(poly_list), p);
  }

  /// The polys of a list, or of a union of lists.
  id_span<poly_id> members(std::uint32_t poly_list) const {
    if (poly_list < size()) return (*this)[poly_list];
    const std::size_t i = poly_list - size();
    return {united_.data() + united_first_[i], united_.data() + united_first_[i + 1]};
  }

  /// Stores the list numbers of polys with more than `few` facets. Of several equal lists only one is stored. Lists
  /// that are small compared to the number of facets are united, so that the memory is proportional to the number of
  /// facets.
  template<class FacetLists>
  void index_poly_lists(const FacetLists& facets, std::uint32_t few) {
    if (size() == 0) return;
    std::vector<std::uint32_t> order(size()), same(size()), visited(size(), ~0u);
    for (std::uint32_t c = 0; c < size(); ++c) order[c] = c;
    const auto poly_list = [this](std::uint32_t c) { return (*this)[c]; };
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return std::lexicographical_compare(poly_list(a).begin(), poly_list(a).end(), poly_list(b).begin(),
                                          poly_list(b).end());
    });
    for (std::size_t i = 0; i < order.size(); ++i) {
      const std::uint32_t c = order[i], before = i > 0 ? order[i - 1] : c;
      const bool again = i > 0 && std::equal(poly_list(c).begin(), poly_list(c).end(), poly_list(before).begin(),
                                             poly_list(before).end());
      same[c] = again ? same[before] : c;
    }
    united_first_.push_back(0);
    for (std::uint32_t p = 0; p < facets.size(); ++p) {
      if (facets.length(p) <= few) continue;
      const std::size_t before = poly_lists_.size();
      std::size_t polys = 0;
      for (const encoded_neighbour* s = facets.begin(p); s != facets.end(p); ++s)
        if (s->is_non_manifold() && visited[same[s->poly_list()]] != p) {
          visited[same[s->poly_list()]] = p;
          poly_lists_.push_back(same[s->poly_list()]);
          polys += (*this)[s->poly_list()].size();
        }
      if (poly_lists_.size() == before) continue;
      if (poly_lists_.size() > before + 1 && polys <= 16 * std::size_t{facets.length(p)}) unite(before);
      polys_.push_back(p);
      first_.push_back(static_cast<std::uint32_t>(before));
    }
    first_.push_back(static_cast<std::uint32_t>(poly_lists_.size()));
  }
  /// These lists, with new numbers of polys.
  non_manifold_facets compacted(const std::vector<std::uint32_t>& lists, const compact_numbers<poly_id>& kept) const;

  /// The list numbers that were stored for p; none if p has few facets.
  id_span<std::uint32_t> poly_lists_of(poly_id p) const {
    const auto at = std::lower_bound(polys_.begin(), polys_.end(), p.raw());
    if (at == polys_.end() || *at != p.raw()) return {};
    const std::size_t i = static_cast<std::size_t>(at - polys_.begin());
    return {poly_lists_.data() + first_[i], poly_lists_.data() + first_[i + 1]};
  }
};

}  // namespace concino::detail
