// What lies across the sides of polys, and the ranges that walk it: the polys of a facet, the polys around a poly.
#pragma once

#include <concino/concepts/descriptors.hpp>
#include <concino/mesh/rows.hpp>

#include <cstdint>

namespace concino::detail {

/// What lies across one side of a poly, in 32 bits: nothing; a poly; a poly that an earlier side of the same poly already leads to; or a
/// crowd, the list of polys of a facet that has more than two.
struct across {
  std::uint32_t raw = none;

  static constexpr std::uint32_t none = ~0u;
  static constexpr std::uint32_t special = 1u << 31;
  static constexpr std::uint32_t crowd_bit = 1u << 30;
  static constexpr std::uint32_t mask = crowd_bit - 1;

  bool is_none() const { return raw == none; }
  bool is_first() const { return raw < special; }
  bool is_crowd() const { return raw != none && (raw & special) && (raw & crowd_bit); }
  std::uint32_t poly() const { return raw & mask; }
  std::uint32_t crowd() const { return raw & mask; }
};

/// Up to two polys, or a crowd.
class polys_of_facet {
  poly_id few_[2];
  const poly_id* first_ = nullptr;  // null: the few
  std::uint32_t size_ = 0;

 public:
  using value_type = poly_id;
  /// Carries the values themselves, so that it outlives the range.
  class iterator {
    poly_id now_, then_;
    const poly_id* crowd_ = nullptr;
    std::uint32_t left_ = 0;

   public:
    using value_type = poly_id;
    using reference = poly_id;
    using difference_type = std::ptrdiff_t;
    iterator() = default;
    iterator(poly_id a, poly_id b, const poly_id* crowd, std::uint32_t left) : now_(a), then_(b), crowd_(crowd), left_(left) {}
    poly_id operator*() const { return crowd_ ? *crowd_ : now_; }
    iterator& operator++() {
      if (crowd_) ++crowd_;
      else now_ = then_;
      --left_;
      return *this;
    }
    iterator operator++(int) { iterator old = *this; ++*this; return old; }
    friend bool operator==(const iterator& a, const iterator& b) { return a.left_ == b.left_; }
  };

  polys_of_facet() = default;
  explicit polys_of_facet(poly_id a) : few_{a, {}}, size_(1) {}
  polys_of_facet(poly_id a, poly_id b) : few_{a, b}, size_(2) {}
  polys_of_facet(const poly_id* first, const poly_id* last) : first_(first), size_(static_cast<std::uint32_t>(last - first)) {}

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  poly_id operator[](std::size_t i) const { return first_ ? first_[i] : few_[i]; }
  iterator begin() const { return {few_[0], few_[1], first_, size_}; }
  iterator end() const { return {{}, {}, nullptr, 0}; }
};

/// The polys across all sides of one poly, each once.
class polys_across {
  const across* first_ = nullptr;
  const across* last_ = nullptr;
  const rows<poly_id, 0>* crowds_ = nullptr;
  poly_id self_;

 public:
  using value_type = poly_id;
  class iterator {
    const across* at_ = nullptr;
    const across* last_ = nullptr;
    const across* first_ = nullptr;
    const rows<poly_id, 0>* crowds_ = nullptr;
    poly_id self_;
    poly_id now_;            // read once, when the iterator comes here: what the caller writes in between may look like the same memory
    std::uint32_t nth_ = 0;  // in a crowd: which of it, counted from 1

    /// Where to go on, and what is there.
    struct place {
      const across* at;
      poly_id now;
      std::uint32_t nth;
    };

    // Crowds are rare. Their code stays out of the loop, and works on values, so that an iterator lives in registers.
    [[gnu::noinline]] static bool met_before(const across* first, const across* at, const rows<poly_id, 0>& crowds, poly_id q) {
      for (const across* s = first; s != at; ++s) {
        if (s->is_none()) continue;
        if (!s->is_crowd()) {
          if (s->poly() == q.raw()) return true;
        } else {
          for (const poly_id r : crowds[s->crowd()])
            if (r == q) return true;
        }
      }
      return false;
    }
    [[gnu::noinline]] static place next_in_crowd(const across* at, std::uint32_t nth, const across* first, const across* last, const rows<poly_id, 0>& crowds,
                                                 poly_id self) {
      for (; at != last; ++at, nth = 0) {
        if (at->is_first()) return {at, poly_id{at->raw}, 0};
        if (!at->is_crowd()) continue;
        const id_span<poly_id> crowd = crowds[at->crowd()];
        for (; nth < crowd.size(); ++nth)
          if (crowd[nth] != self && !met_before(first, at, crowds, crowd[nth])) return {at, crowd[nth], nth + 1};
      }
      return {at, {}, 0};
    }
    void go_to(const place& p) {
      at_ = p.at;
      now_ = p.now;
      nth_ = p.nth;
    }
    void settle() {
      for (; at_ != last_; ++at_) {
        const across x = *at_;
        now_ = poly_id{x.raw};
        if (x.is_first()) [[likely]] return;
        if (x.is_crowd()) return go_to(next_in_crowd(at_, 0, first_, last_, *crowds_, self_));
      }
    }

    friend polys_across;

   public:
    using value_type = poly_id;
    using reference = poly_id;
    using difference_type = std::ptrdiff_t;
    iterator() = default;
    iterator(const across* at, const across* last, const rows<poly_id, 0>* crowds, poly_id self)
        : at_(at), last_(last), first_(at), crowds_(crowds), self_(self) {
      settle();
    }
    poly_id operator*() const { return now_; }
    iterator& operator++() {
      if (nth_ == 0) [[likely]] {
        ++at_;
        settle();
      } else {
        go_to(next_in_crowd(at_, nth_, first_, last_, *crowds_, self_));
      }
      return *this;
    }
    iterator operator++(int) { iterator old = *this; ++*this; return old; }
    friend bool operator==(const iterator& a, const iterator& b) { return a.at_ == b.at_ && a.nth_ == b.nth_; }
  };

  polys_across() = default;
  polys_across(const across* first, const across* last, const rows<poly_id, 0>* crowds, poly_id self)
      : first_(first), last_(last), crowds_(crowds), self_(self) {}
  const void* row() const { return first_; }
  /// Calls f(q) for all of them in the same order: without an iterator to carry, which short loops notice.
  template<class F>
  void for_each(F&& f) const {
    for (const across* s = first_; s != last_; ++s) {
      if (s->is_first()) [[likely]] {
        f(poly_id{s->raw});
      } else if (s->is_crowd()) {
        for (const poly_id q : (*crowds_)[s->crowd()])
          if (q != self_ && !iterator::met_before(first_, s, *crowds_, q)) f(q);
      }
    }
  }
  iterator begin() const { return {first_, last_, crowds_, self_}; }
  iterator end() const { return {last_, last_, crowds_, self_}; }
};

}  // namespace concino::detail
