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

/// Requests what the verts and polys of an edge, or of a face of a volume, will be read from, if the mesh can do so.
template<class M, class X>
void prefetch(const M& m, const X& x) {
  if constexpr (requires { traits<M>::prefetch(m, x); }) traits<M>::prefetch(m, x);
}

template<class R> concept is_contiguous = requires(const R& r) { row_address(r); };

}  // namespace concino::core
