// Prefetching of memory that will be read soon. Searches jump through memory, but know a little earlier what they will need. Early
// requests hide most of the latency.
#pragma once

#include <concino/concepts/mesh_traits.hpp>
#include <concino/concepts/ranges.hpp>

#include <concepts>

namespace concino::core {

inline void prefetch(const void* p) { __builtin_prefetch(p); }

/// The address of the entries of a row of neighbours, for ranges that are stored in memory: iterating over these twice costs very little.
template<class T>
const void* row_address(const id_span<T>& r) { return r.begin(); }
template<class R>
  requires requires(const R& r) { { r.row() } -> std::same_as<const void*>; }
const void* row_address(const R& r) { return r.row(); }

/// Requests what the verts and polys of an edge or of a face of a volume, or the lists of a poly of a volume, will be read from, if the mesh can do so.
template<class M, class X>
void prefetch(const M& m, const X& x) {
  if constexpr (requires { traits<M>::prefetch(m, x); }) traits<M>::prefetch(m, x);
}

template<class R> concept is_contiguous = requires(const R& r) { row_address(r); };

/// Requests the first entries of a row, if it is stored in memory.
template<class R>
void prefetch_row(const R& r) {
  if constexpr (is_contiguous<R>) prefetch(row_address(r));
}

/// Requests all entries of some short rows, of those that are stored in memory.
template<class... R>
void prefetch_rows(const R&... rows) {
  const auto prefetch_end = [](const auto& r) {
    if constexpr (requires { { r.end() } -> std::convertible_to<const void*>; }) prefetch(r.end());
  };
  (..., (prefetch_row(rows), prefetch_end(rows)));
}

}  // namespace concino::core
