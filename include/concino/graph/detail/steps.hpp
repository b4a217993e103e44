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
inline constexpr bool iterators_outlive = std::is_lvalue_reference_v<R> || std::ranges::enable_borrowed_range<std::remove_cvref_t<R>>;
template<class T> inline constexpr bool iterators_outlive<id_span<T>> = true;
template<class Id> inline constexpr bool iterators_outlive<id_range<Id>> = true;
template<class M, class K, around Ring> inline constexpr bool iterators_outlive<halfedge_ring<M, K, Ring>> = true;
template<class M, class K> inline constexpr bool iterators_outlive<halfedge_neighbours<M, K>> = true;

template<class R> using begin_of = decltype(std::declval<const std::remove_reference_t<R>&>().begin());
template<class R> using end_of = decltype(std::declval<const std::remove_reference_t<R>&>().end());

template<class R>
concept is_iterated_as_it_is = iterators_outlive<R> && std::same_as<begin_of<R>, end_of<R>> && std::regular<begin_of<R>>;

/// Where a walk along a range of type R is. The weakest range will do: one that can be neither copied nor moved, whose iterators live no
/// longer than it and compare with nothing but an end of another type. Such a range is kept, shared by all copies of the iterator.
template<class R>
class steps {
  struct range {
    R elements;
    template<class F> explicit range(const F& make) : elements(make()) {}
  };
  std::shared_ptr<const range> range_;  // null: at the end
  std::optional<begin_of<R>> it_;
  std::size_t taken_ = 0;

  void settle() {
    if (!(*it_ != range_->elements.end())) range_.reset();
  }

 public:
  steps() = default;
  template<class F>
  static std::pair<steps, steps> both(const F& make) {
    std::pair<steps, steps> r;
    r.first.range_ = std::make_shared<const range>(make);
    r.first.it_.emplace(r.first.range_->elements.begin());
    r.first.settle();
    return r;
  }
  decltype(auto) operator*() const { return **it_; }
  void next() {
    ++*it_;
    ++taken_;
    settle();
  }
  friend bool operator==(const steps& a, const steps& b) { return a.range_ && b.range_ ? a.taken_ == b.taken_ : a.range_ == b.range_; }
};

/// The same for ranges whose iterators need no help.
template<is_iterated_as_it_is R>
class steps<R> {
  begin_of<R> it_{};

 public:
  steps() = default;
  template<class F>
  static std::pair<steps, steps> both(const F& make) {
    const R& r = make();
    std::pair<steps, steps> both;
    both.first.it_ = r.begin();
    both.second.it_ = r.end();
    return both;
  }
  decltype(auto) operator*() const { return *it_; }
  void next() { ++it_; }
  friend bool operator==(const steps& a, const steps& b) { return a.it_ == b.it_; }
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
