// Pairs of iterators of one type, as Boost wants them, over ranges of elements that promise much less.
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

/// Whether iterators of what a verb returns as an R are good after R is gone.
template<class R>
inline constexpr bool is_borrowed_range = std::is_lvalue_reference_v<R> || std::ranges::enable_borrowed_range<std::remove_cvref_t<R>>;
template<class T> inline constexpr bool is_borrowed_range<id_span<T>> = true;
template<class Id> inline constexpr bool is_borrowed_range<id_range<Id>> = true;
template<class M, class K, ring_kind Ring> inline constexpr bool is_borrowed_range<halfedge_ring<M, K, Ring>> = true;
template<class M, class K> inline constexpr bool is_borrowed_range<halfedge_neighbours<M, K>> = true;

template<class R> using begin_of = decltype(std::declval<const std::remove_reference_t<R>&>().begin());
template<class R> using end_of = decltype(std::declval<const std::remove_reference_t<R>&>().end());

template<class R>
concept has_plain_iterators = is_borrowed_range<R> && std::same_as<begin_of<R>, end_of<R>> && std::regular<begin_of<R>>;

/// Where a walk along a range of type R is. The weakest range will do: one that can be neither copied nor moved, whose iterators live no
/// longer than it and compare with nothing but an end of another type. Such a range is kept, shared by all copies of the iterator.
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
  friend bool operator==(const any_iterator& a, const any_iterator& b) { return a.range_ && b.range_ ? a.taken_ == b.taken_ : a.range_ == b.range_; }
};

/// The same for ranges whose iterators need no help.
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

/// What all iterators given to Boost have alike. They yield values, and may be walked again.
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
