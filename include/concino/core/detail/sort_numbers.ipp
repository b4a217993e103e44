// Sorting of numbers; see sort_numbers.hpp.
#pragma once

#include <concino/core/sort_numbers.hpp>

#include <algorithm>

namespace concino::core {

CONCINO_INLINE void sort_numbers(int* first, int* last) { std::sort(first, last); }

CONCINO_INLINE void sort_numbers(std::uint64_t* first, std::uint64_t* last) { std::sort(first, last); }

}  // namespace concino::core
