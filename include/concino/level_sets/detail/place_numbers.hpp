// Numbers the places of a level set.
#pragma once

#include <concino/core/large_pages.hpp>
#include <concino/core/local_numbers.hpp>
#include <concino/level_sets/detail/level_place.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// Places that are equal have one number; numbers are given in the order in which places come.
class place_numbers {
  core::local_numbers numbers_, ends_;

  std::size_t key(const level_place& x) {
    if (x.kind == level_place::vert) return x.element;
    if (x.kind == level_place::edge) return std::size_t{1} << 33 | x.element;
    return std::size_t{2} << 33 | ends_.add(std::size_t{x.below} << 32 | x.above);  // a diagonal is known by its ends and its face
  }

 public:
  std::vector<level_place> places;

  /// Makes room for n places.
  void reserve(std::size_t n) {
    numbers_.reserve(n);
    core::reserve_pages(places, n);
  }

  std::uint32_t add(const level_place& x) {
    const unsigned number = numbers_.add(key(x));
    if (number == places.size()) places.push_back(x);
    return number;
  }
};

}  // namespace concino::detail
