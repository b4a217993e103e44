// The weakest descriptor, range, number and point that the concepts allow. Archetypes return them instead of the real
// ones.
#pragma once

#include <concino/concepts/mesh_traits.hpp>

namespace concino::archetypes {

struct access;

/// A descriptor that is std::regular and nothing else: no order, no hash, no null value, no access to an index, and no
/// construction from {} without the name of the type.
template<class Base, class Tag>
class opaque {
  Base base_{};

  friend struct access;
  constexpr explicit opaque(const Base& base, int) : base_(base) {}

 public:
  constexpr explicit opaque() {}
  friend constexpr bool operator==(const opaque& a, const opaque& b) { return a.base_ == b.base_; }
};

/// The only access to the content of an opaque descriptor, for archetypes and their traits.
struct access {
  template<class O, class Base> static constexpr O wrap(const Base& b) { return O(b, 0); }
  template<class Base, class Tag> static constexpr const Base& base(const opaque<Base, Tag>& o) { return o.base_; }
  // For arrays. An opaque descriptor has one member, which has the same address.
  template<class Base, class Tag> static const Base* base_array(const opaque<Base, Tag>* o) {
    static_assert(sizeof(Base) == sizeof(*o) && std::is_standard_layout_v<opaque<Base, Tag>>);
    return reinterpret_cast<const Base*>(o);
  }
  template<class Base, class Tag>
  static Base* base_array(opaque<Base, Tag>* o) {
    return const_cast<Base*>(base_array<Base>(static_cast<const opaque<Base, Tag>*>(o)));
  }
};

/// A number of elements or an index: converts to std::size_t.
class index_like {
  std::size_t n_;

 public:
  constexpr explicit index_like(std::size_t n) : n_(n) {}
  constexpr operator std::size_t() const { return n_; }
};

/// A boolean value: converts to bool.
class boolean_like {
  bool b_;

 public:
  constexpr explicit boolean_like(bool b) : b_(b) {}
  constexpr operator bool() const { return b_; }
};

/// A point: p[0], p[1], p[2], each of which converts to double. No arithmetic, no assignment.
class point_like {
  double x_[3];

 public:
  class coordinate {
    double x_;

   public:
    constexpr explicit coordinate(double x) : x_(x) {}
    constexpr operator double() const { return x_; }
  };

  constexpr point_like(double x, double y, double z) : x_{x, y, z} {}
  point_like(const point_like&) = default;
  point_like& operator=(const point_like&) = delete;
  constexpr coordinate operator[](int i) const { return coordinate(x_[i]); }
};

/// A range with iteration and nothing else. The range cannot be copied or moved, and its iterators must not outlive it.
/// Iterators can be copied, incremented by ++, dereferenced (to a value, not a reference) and compared by != with an
/// end of another type.
template<class R, class O>
class range {
  R base_;

 public:
  class sentinel;

  class iterator {
    using inner = decltype(std::declval<const std::remove_reference_t<R>&>().begin());
    inner it_;

    friend class range;
    constexpr explicit iterator(const inner& it) : it_(it) {}

   public:
    constexpr O operator*() const { return access::wrap<O>(*it_); }
    constexpr void operator++() { ++it_; }
    constexpr bool operator!=(const sentinel& b) const { return it_ != b.it_; }
  };

  class sentinel {
    using inner = decltype(std::declval<const std::remove_reference_t<R>&>().end());
    inner it_;

    friend class range;
    friend class iterator;
    constexpr explicit sentinel(const inner& it) : it_(it) {}
  };

  template<class F>
  constexpr range(const F& make, int) : base_(make()) {}
  range(const range&) = delete;
  range& operator=(const range&) = delete;

  constexpr iterator begin() const { return iterator(base_.begin()); }
  constexpr sentinel end() const { return sentinel(base_.end()); }
};

/// The range that `make()` returns, with every element converted to an O.
/// Needs:  make() returns a range of elements that O wraps.      Result: a range that cannot be copied or moved.
/// Cost:   that of make().                              Errors: those of make().
template<class O, class F>
constexpr auto rewrap(const F& make) { return range<decltype(make()), O>(make, 0); }

}  // namespace concino::archetypes
