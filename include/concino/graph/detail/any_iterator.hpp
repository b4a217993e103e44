// any_iterator: pairs of iterators of one type, as Boost requires, over ranges with much weaker guarantees.
#pragma once

#include <concino/concepts/halfedge_kernel.hpp>
#include <concino/concepts/ranges.hpp>

#include <cstddef>
#include <iterator>
#include <memory>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>

namespace concino::detail {

/// Whether iterators of the range R that a verb returns remain valid after R is destroyed.
template<class R>
inline constexpr bool is_borrowed_range =
    std::is_lvalue_reference_v<R> || std::ranges::enable_borrowed_range<std::remove_cvref_t<R>>;
template<class T> inline constexpr bool is_borrowed_range<id_span<T>> = true;
template<class Id> inline constexpr bool is_borrowed_range<id_range<Id>> = true;
template<class M, class K, ring_kind Ring> inline constexpr bool is_borrowed_range<halfedge_ring<M, K, Ring>> = true;
template<class M, class K> inline constexpr bool is_borrowed_range<halfedge_neighbours<M, K>> = true;

template<class R> using begin_of = decltype(std::declval<const std::remove_reference_t<R>&>().begin());
template<class R> using end_of = decltype(std::declval<const std::remove_reference_t<R>&>().end());

template<class R>
concept has_plain_iterators = is_borrowed_range<R> && std::same_as<begin_of<R>, end_of<R>> && std::regular<begin_of<R>>;

/// A position in a range of type R. The weakest range is enough: one that can be neither copied nor moved, whose
/// iterators must not outlive it and can be compared only with an end of another type. Such a range is stored once and
/// shared by all copies of the iterator.
template<class R>
class any_iterator {
  struct range {
    R elements;
    template<class F> explicit range(const F& make) : elements(make()) {}
  };
  std::shared_ptr<const range> range_;  // null: at the end
  std::optional<begin_of<R>> it_;
  std::size_t taken_ = 0;

  void detect_end() {
    if (!(*it_ != range_->elements.end())) range_.reset();
  }

 public:
  any_iterator() = default;
  template<class F>
  static std::pair<any_iterator, any_iterator> begin_and_end(const F& make) {
    std::pair<any_iterator, any_iterator> r;
    r.first.range_ = std::make_shared<const range>(make);
    r.first.it_.emplace(r.first.range_->elements.begin());
    r.first.detect_end();
    return r;
  }
  decltype(auto) operator*() const { return **it_; }
  void next() {
    ++*it_;
    ++taken_;
    detect_end();
  }
  friend bool operator==(const any_iterator& a, const any_iterator& b) {
    return a.range_ && b.range_ ? a.taken_ == b.taken_ : a.range_ == b.range_;
  }
};

/// The same for ranges whose iterators are sufficient themselves.
template<has_plain_iterators R>
class any_iterator<R> {
  begin_of<R> it_{};

 public:
  any_iterator() = default;
  template<class F>
  static std::pair<any_iterator, any_iterator> begin_and_end(const F& make) {
    const R& r = make();
    std::pair<any_iterator, any_iterator> both;
    both.first.it_ = r.begin();
    both.second.it_ = r.end();
    return both;
  }
  decltype(auto) operator*() const { return *it_; }
  void next() { ++it_; }
  friend bool operator==(const any_iterator& a, const any_iterator& b) { return a.it_ == b.it_; }
};

/// The common base class of all iterators for Boost. They return values and are multi-pass.
template<class Self, class Value>
struct forward_iterator {
  using iterator_category = std::forward_iterator_tag;
  using value_type = Value;
  using reference = Value;
  using pointer = const Value*;
  using difference_type = std::ptrdiff_t;

  Self& operator++() {
    static_cast<Self*>(this)->next();
    return *static_cast<Self*>(this);
  }
  Self operator++(int) {
    Self old = *static_cast<Self*>(this);
    static_cast<Self*>(this)->next();
    return old;
  }
};

}  // namespace concino::detail
