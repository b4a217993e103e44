// Sorting of numbers; see sort_numbers.hpp.
#pragma once

#include <concino/core/large_pages.hpp>
#include <concino/core/sort_numbers.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <new>

namespace concino::core {

CONCINO_INLINE void sort_numbers(int* first, int* last) { std::sort(first, last); }

CONCINO_INLINE void sort_numbers(std::uint64_t* first, std::uint64_t* last) {
  constexpr std::size_t few = 2048, num_bytes = 8;
  const auto n = static_cast<std::size_t>(last - first);
  const std::unique_ptr<std::uint64_t[]> memory(n < few ? nullptr : new (std::nothrow) std::uint64_t[n]);
  if (!memory) {
    std::sort(first, last);
    return;
  }
  prefer_large_pages(memory.get(), n * sizeof(std::uint64_t));
  request_pages(memory.get(), n * sizeof(std::uint64_t));
  std::array<std::array<std::size_t, 256>, num_bytes> count{};  // by byte: how many numbers have each value there, then where they begin
  for (const std::uint64_t* x = first; x != last; ++x)
    for (std::size_t b = 0; b < num_bytes; ++b) ++count[b][*x >> 8 * b & 255u];
  std::uint64_t *from = first, *to = memory.get();
  for (std::size_t b = 0; b < num_bytes; ++b) {
    std::array<std::size_t, 256>& begin = count[b];
    if (begin[*from >> 8 * b & 255u] == n) continue;  // the same value in all
    std::size_t sum = 0;
    for (std::size_t& x : begin) {
      const std::size_t size = x;
      x = sum;
      sum += size;
    }
    for (const std::uint64_t* x = from; x != from + n; ++x) to[begin[*x >> 8 * b & 255u]++] = *x;
    std::swap(from, to);
  }
  if (from != first) std::copy(from, from + n, first);
}

}  // namespace concino::core
