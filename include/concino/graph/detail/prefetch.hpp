// Having the processor bring in what will be read soon. Searches jump through memory; what they will need next is known a little earlier,
// and asking for all of it at once hides most of the waiting.
#pragma once

#include <concino/concepts/ranges.hpp>

#include <concepts>

namespace concino::detail {

inline void prefetch(const void* p) { __builtin_prefetch(p); }

/// Where the entries of a row of neighbours lie, for the ranges that lie in memory: walking those twice costs next to nothing.
template<class T>
const void* row_address(const id_span<T>& r) { return r.begin(); }
template<class R>
  requires requires(const R& r) { { r.row() } -> std::same_as<const void*>; }
const void* row_address(const R& r) { return r.row(); }

template<class R> concept is_contiguous = requires(const R& r) { row_address(r); };

}  // namespace concino::detail
