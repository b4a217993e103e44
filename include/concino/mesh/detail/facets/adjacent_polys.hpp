// The neighbours of a poly behind all its facets, each once.
#pragma once

#include <concino/concepts/descriptors.hpp>
#include <concino/mesh/detail/facets/encoded_neighbour.hpp>
#include <concino/mesh/detail/facets/non_manifold_facets.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace concino::detail {

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

// Its iterators contain all that they need.
template<>
inline constexpr bool std::ranges::enable_borrowed_range<concino::detail::adjacent_polys> = true;
