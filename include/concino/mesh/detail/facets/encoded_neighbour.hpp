// What is behind one facet of a poly, in 32 bits; and the polys of a facet.
#pragma once

#include <concino/concepts/descriptors.hpp>

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>

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

}  // namespace concino::detail

// Its iterators contain all that they need.
template<>
inline constexpr bool std::ranges::enable_borrowed_range<concino::detail::polys_of_facet> = true;
