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

/// Requests what adj_e2v and adj_e2p of an edge will read, if the mesh can do so.
template<class M, class E>
void prefetch(const M& m, const E& e) {
  if constexpr (requires { traits<M>::prefetch(m, e); }) traits<M>::prefetch(m, e);
}

template<class R> concept is_contiguous = requires(const R& r) { row_address(r); };

}  // namespace concino::core
