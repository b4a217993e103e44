// The range between two iterators of another library, which need not be C++20 forward iterators, as elements.
#pragma once

#include <cstddef>
#include <utility>

namespace concino::detail {

/// The element at iterator i is at(i).
template<class X, class Base, class At>
class mapped_range {
  Base first_{}, last_{};
  [[no_unique_address]] At at_{};

 public:
  using value_type = X;
  class iterator {
    Base base_{};
    [[no_unique_address]] At at_{};

   public:
    using value_type = X;
    using reference = X;
    using difference_type = std::ptrdiff_t;
    iterator() = default;
    iterator(Base base, At at) : base_(std::move(base)), at_(at) {}
    X operator*() const { return at_(base_); }
    iterator& operator++() { ++base_; return *this; }
    iterator operator++(int) { iterator old = *this; ++*this; return old; }
    friend bool operator==(const iterator& a, const iterator& b) { return a.base_ == b.base_; }
  };

  mapped_range() = default;
  mapped_range(Base first, Base last, At at = {}) : first_(std::move(first)), last_(std::move(last)), at_(at) {}
  iterator begin() const { return {first_, at_}; }
  iterator end() const { return {last_, at_}; }
};

}  // namespace concino::detail
