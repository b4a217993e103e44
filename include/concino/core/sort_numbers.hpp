// Sorting of rare or short lists of numbers: std::sort takes long to compile, once for each type and each order.
#pragma once

#include <concino/core/compiled.hpp>

#include <cstdint>

namespace concino::core {

/// Sorts [first, last), ascending.
/// Cost:   as std::sort.      Errors: none.
void sort_numbers(int* first, int* last);
void sort_numbers(std::uint64_t* first, std::uint64_t* last);

}  // namespace concino::core

#ifndef CONCINO_COMPILED
#include <concino/core/detail/sort_numbers.ipp>
#endif
