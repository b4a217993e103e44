// Encoded neighbours of polys behind their facets, and the ranges that read them: the polys of a facet, the polys
// around a poly.
#pragma once

#include <concino/concepts/descriptors.hpp>
#include <concino/mesh/detail/rows/jagged_array.hpp>

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace concino::detail {

/// What is behind one facet of a poly, in 32 bits: nothing; a poly; a poly that is also behind an earlier facet of the
/// same poly; or the number of a poly list, if the facet is non-manifold.
struct encoded_neighbour {
  std::uint32_t raw = none;

  static constexpr std::uint32_t none = ~0u;
  static constexpr std::uint32_t special = 1u << 31;
  static constexpr std::uint32_t non_manifold_bit = 1u << 30;
  static constexpr std::uint32_t mask = non_manifold_bit - 1;

  bool is_none() const { return raw == none; }
  bool is_first_occurrence() const { return raw < special; }
  bool is_non_manifold() const { return raw != none && (raw & special) && (raw & non_manifold_bit); }
  std::uint32_t poly() const { return raw & mask; }
  std::uint32_t poly_list() const { return raw & mask; }
};

/// The polys of a facet: up to two polys, or a poly list.
class polys_of_facet {
  poly_id two_[2];
  const poly_id* first_ = nullptr;  // null: up to two polys
  std::uint32_t size_ = 0;

 public:
  using value_type = poly_id;
  /// Contains the values themselves, so that it can outlive the range.
  class iterator {
    poly_id now_, then_;
    const poly_id* poly_list_ = nullptr;
    std::uint32_t left_ = 0;

   public:
    using value_type = poly_id;
    using reference = poly_id;
    using difference_type = std::ptrdiff_t;
    iterator() = default;
    iterator(poly_id a, poly_id b, const poly_id* poly_list, std::uint32_t left)
        : now_(a), then_(b), poly_list_(poly_list), left_(left) {}
    poly_id operator*() const { return poly_list_ ? *poly_list_ : now_; }
    iterator& operator++() {
      if (poly_list_) ++poly_list_;
      else now_ = then_;
      --left_;
      return *this;
    }
    iterator operator++(int) { iterator old = *this; ++*this; return old; }
    friend bool operator==(const iterator& a, const iterator& b) { return a.left_ == b.left_; }
  };

  polys_of_facet() = default;
  explicit polys_of_facet(poly_id a) : two_{a, {}}, size_(1) {}
  polys_of_facet(poly_id a, poly_id b) : two_{a, b}, size_(2) {}
  polys_of_facet(const poly_id* first, const poly_id* last)
      : first_(first), size_(static_cast<std::uint32_t>(last - first)) {}

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  poly_id operator[](std::size_t i) const { return first_ ? first_[i] : two_[i]; }
  iterator begin() const { return {two_[0], two_[1], first_, size_}; }
  iterator end() const { return {{}, {}, nullptr, 0}; }
};

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
  void forget() noexcept {
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
    forget();
    return *this;
  }
  const base& rows() const { return *this; }

  template<class It>
  void add_row(It from, It to, std::size_t room = 0) {
    forget();
    base::add_row(from, to, room);
  }
  void push(std::size_t i, const poly_id& p) {
    forget();
    base::push(i, p);
  }
  /// Adds p to list i, which remains sorted.
  void insert(std::size_t i, const poly_id& p) {
    forget();
    base::insert_sorted(i, p);
  }
  void remove(std::size_t i, const poly_id& p) {
    forget();
    base::remove(i, p);
  }
  void clear_row(std::size_t i) {
    forget();
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
    std::vector<std::uint32_t> order(size()), same(size()), met(size(), ~0u);
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
        if (s->is_non_manifold() && met[same[s->poly_list()]] != p) {
          met[same[s->poly_list()]] = p;
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

/// The neighbours of a poly behind all its facets, each once: first those behind manifold facets, then those in its
/// poly lists, ascending.
class adjacent_polys {
  const encoded_neighbour* first_ = nullptr;
  const encoded_neighbour* last_ = nullptr;
  const non_manifold_facets* poly_lists_ = nullptr;
  poly_id self_;

  /// The poly with the smallest number, at least `from`, in the poly lists of `self`; none if there is none.
  // Poly lists are rare. This code stays out of the loop and works on values, so that an iterator fits in registers.
  static poly_id next_in_poly_lists(const encoded_neighbour* first, const encoded_neighbour* last,
                                    const non_manifold_facets& lists, poly_id self, std::uint32_t from) {
    poly_id next;
    const auto look = [&](std::uint32_t poly_list) {
      const id_span<poly_id> all = lists.members(poly_list);
      const poly_id* at = std::lower_bound(all.begin(), all.end(), poly_id{from});
      if (at != all.end() && *at == self) ++at;
      if (at != all.end() && *at < next) next = *at;
    };
    if (const id_span<std::uint32_t> listed = lists.poly_lists_of(self); !listed.empty()) {
      for (const std::uint32_t poly_list : listed) look(poly_list);
    } else {
      for (const encoded_neighbour* s = first; s != last; ++s)
        if (s->is_non_manifold()) look(s->poly_list());
    }
    return next;
  }

 public:
  using value_type = poly_id;
  class iterator {
    const encoded_neighbour* at_ = nullptr;
    const encoded_neighbour* last_ = nullptr;
    const encoded_neighbour* first_ = nullptr;
    const non_manifold_facets* poly_lists_ = nullptr;
    poly_id self_;
    poly_id now_;            // read once, when the iterator moves: the compiler cannot know that the caller's writes do
                             // not change it
    bool passed_poly_list_ = false;   // whether a poly list was passed

    void skip_invalid() {
      for (; at_ != last_; ++at_) {
        const encoded_neighbour x = *at_;
        now_ = poly_id{x.raw};
        if (x.is_first_occurrence()) return;
        if (x.is_non_manifold()) passed_poly_list_ = true;
      }
      now_ = {};
      if (passed_poly_list_) now_ = next_in_poly_lists(first_, last_, *poly_lists_, self_, 0);
    }

   public:
    using value_type = poly_id;
    using reference = poly_id;
    using difference_type = std::ptrdiff_t;
    iterator() = default;
    iterator(const encoded_neighbour* at, const encoded_neighbour* last, const non_manifold_facets* lists, poly_id self)
        : at_(at), last_(last), first_(at), poly_lists_(lists), self_(self) {
      skip_invalid();
    }
    poly_id operator*() const { return now_; }
    iterator& operator++() {
      if (at_ != last_) {
        ++at_;
        skip_invalid();
      } else {
        now_ = next_in_poly_lists(first_, last_, *poly_lists_, self_, now_.raw() + 1);
      }
      return *this;
    }
    iterator operator++(int) { iterator old = *this; ++*this; return old; }
    /// Each poly occurs once, and the end has none.
    friend bool operator==(const iterator& a, const iterator& b) { return a.now_ == b.now_; }
  };

  adjacent_polys() = default;
  adjacent_polys(const encoded_neighbour* first, const encoded_neighbour* last, const non_manifold_facets* lists,
                 poly_id self)
      : first_(first), last_(last), poly_lists_(lists), self_(self) {}
  /// Calls f(q) for all of them in the same order. Without an iterator, short loops are faster.
  template<class F>
  void for_each(F&& f) const {
    bool has_poly_list = false;
    for (const encoded_neighbour* s = first_; s != last_; ++s) {
      if (s->is_first_occurrence()) f(poly_id{s->raw});
      else if (s->is_non_manifold()) has_poly_list = true;
    }
    if (has_poly_list)
      for (poly_id q = next_in_poly_lists(first_, last_, *poly_lists_, self_, 0); !q.is_none();
           q = next_in_poly_lists(first_, last_, *poly_lists_, self_, q.raw() + 1))
        f(q);
  }
  iterator begin() const { return {first_, last_, poly_lists_, self_}; }
  iterator end() const { return {last_, last_, poly_lists_, self_}; }
};

}  // namespace concino::detail

// Their iterators contain all that they need.
template<>
inline constexpr bool std::ranges::enable_borrowed_range<concino::detail::polys_of_facet> = true;
template<>
inline constexpr bool std::ranges::enable_borrowed_range<concino::detail::adjacent_polys> = true;
