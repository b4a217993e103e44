// ElementRange: what algorithms require of a range of elements. Also the small ranges that meshes return.
#pragma once

#include <compare>
#include <concepts>
#include <cstddef>
#include <type_traits>

namespace concino {

/// A multi-pass range of Ts (values or references, so that `auto x : r` makes a T).
/// Nothing else is required: no size, no index; begin and end may differ in type, and iterators may be invalid when the
/// range is destroyed.
template<class R, class T>
concept ElementRange = requires(const R& r, decltype(r.begin()) it) {
  requires std::copyable<decltype(r.begin())> && std::same_as<std::remove_cvref_t<decltype(*it)>, T>;
  { it != r.end() } -> std::convertible_to<bool>;
  ++it;
};

/// The number of elements in a range that a verb returns.
/// Needs:  begin() and end().
/// Result: the number of elements.      Cost: O(1) if the elements are in an array, else a pass over the range.
/// Errors: none.
inline constexpr struct num_elements_verb {
  template<class R>
    requires requires(const R& range, decltype(range.begin()) it) { it != range.end(); ++it; }
  constexpr std::size_t operator()(const R& range) const {
    if constexpr (requires {
                    requires std::is_pointer_v<decltype(range.begin())>;
                    requires std::same_as<decltype(range.begin()), decltype(range.end())>;
                  }) {
      return static_cast<std::size_t>(range.end() - range.begin());
    } else {
      std::size_t n = 0;
      const auto end = range.end();
      for (auto it = range.begin(); it != end; ++it) ++n;
      return n;
    }
  }
} num_elements{};

/// A range of consecutive elements in memory that the mesh owns.
template<class T>
class id_span {
  const T* first_ = nullptr;
  const T* last_ = nullptr;

 public:
  using value_type = T;
  using iterator = const T*;

  constexpr id_span() = default;
  constexpr id_span(const T* first, const T* last) : first_(first), last_(last) {}

  constexpr const T* begin() const { return first_; }
  constexpr const T* end() const { return last_; }
  constexpr std::size_t size() const { return static_cast<std::size_t>(last_ - first_); }
  constexpr bool empty() const { return first_ == last_; }
  constexpr T operator[](std::size_t i) const { return first_[i]; }
};

namespace detail {

/// An iterator over elements with indices below `bound` that skips those for which skips(i) holds.
template<class Id, class Skips>
class skipping_iterator {
  unsigned i_ = 0, bound_ = 0;
  Skips skips_{};

  constexpr void skip() { while (i_ != bound_ && skips_(i_)) ++i_; }

 public:
  using value_type = Id;
  using reference = Id;
  using difference_type = std::ptrdiff_t;

  constexpr skipping_iterator() = default;
  constexpr skipping_iterator(unsigned i, unsigned bound, const Skips& skips) : i_(i), bound_(bound), skips_(skips) {
    skip();
  }
  constexpr Id operator*() const {
    if constexpr (requires(unsigned i) { Id{i}; }) return Id{i_};
    else return Id(static_cast<int>(i_));
  }
  constexpr skipping_iterator& operator++() { ++i_; skip(); return *this; }
  constexpr skipping_iterator operator++(int) { skipping_iterator old = *this; ++*this; return old; }
  friend constexpr bool operator==(const skipping_iterator& a, const skipping_iterator& b) { return a.i_ == b.i_; }
};

/// An iterator of a small range R, which it contains: element i is r[i].
template<class R>
class index_iterator {
  R range_{};
  std::size_t i_ = 0;

 public:
  using value_type = typename R::value_type;
  using reference = value_type;
  using difference_type = std::ptrdiff_t;

  constexpr index_iterator() = default;
  constexpr index_iterator(const R& range, std::size_t i) : range_(range), i_(i) {}
  constexpr value_type operator*() const { return range_[i_]; }
  constexpr index_iterator& operator++() { ++i_; return *this; }
  constexpr index_iterator operator++(int) { index_iterator old = *this; ++i_; return old; }
  friend constexpr bool operator==(const index_iterator& a, const index_iterator& b) { return a.i_ == b.i_; }
};

/// Elements with indices below `bound` without those for which skips(i) holds.
template<class Id, class Skips>
struct skipping_range {
  unsigned bound = 0;
  Skips skips{};

  constexpr skipping_iterator<Id, Skips> begin() const { return {0, bound, skips}; }
  constexpr skipping_iterator<Id, Skips> end() const { return {bound, bound, skips}; }
};

}  // namespace detail

/// Elements 0 .. bound-1, without those that `dead` marks (null: none are marked).
template<class Id>
class id_range {
  unsigned first_ = 0;
  unsigned bound_ = 0;
  const unsigned char* dead_ = nullptr;

  struct is_dead {
    const unsigned char* dead = nullptr;
    constexpr bool operator()(unsigned i) const { return dead && dead[i]; }
  };

 public:
  using iterator = detail::skipping_iterator<Id, is_dead>;
  using value_type = Id;

  constexpr id_range() = default;
  constexpr explicit id_range(std::size_t bound, const unsigned char* dead = nullptr)
      : bound_(static_cast<unsigned>(bound)), dead_(dead) {}

  constexpr iterator begin() const { return {first_, bound_, {dead_}}; }
  constexpr iterator end() const { return {bound_, bound_, {}}; }

  /// The elements of this range with index `first` or more and less than `last`, for parallel loops.
  constexpr id_range part(std::size_t first, std::size_t last) const {
    id_range r(last, dead_);
    r.first_ = static_cast<unsigned>(first);
    return r;
  }
  constexpr std::size_t index_bound() const { return bound_; }
};

/// Elements 0 .. bound-1 for which a function returns true: the result of ids_where. Iterators must not outlive the
/// range.
template<class Id, class Alive>
class filtered_id_range {
  unsigned bound_;
  Alive alive_;

  struct is_not_alive {
    const filtered_id_range* range = nullptr;
    constexpr bool operator()(unsigned i) const { return !range->alive_(i); }
  };

 public:
  using iterator = detail::skipping_iterator<Id, is_not_alive>;
  using value_type = Id;

  constexpr filtered_id_range(std::size_t bound, const Alive& alive)
      : bound_(static_cast<unsigned>(bound)), alive_(alive) {}
  constexpr iterator begin() const { return {0, bound_, {this}}; }
  constexpr iterator end() const { return {bound_, bound_, {this}}; }
};

/// The elements of a mesh whose indices have gaps:
/// ids_where<vert_id>(bound, [&m](unsigned i) { return !m.is_deleted(i); }).
/// Needs:  Id(i) makes an element from an unsigned; alive(i) for all i below bound, with the same result each time.
/// Result: an ElementRange of Id. It stores a copy of `alive`, so what that refers to must outlive the range.
/// Cost:   a pass over the range calls alive(i) once for every i.
/// Errors: none.
template<class Id, class Alive>
constexpr auto ids_where(std::size_t bound, const Alive& alive) { return filtered_id_range<Id, Alive>(bound, alive); }

}  // namespace concino
