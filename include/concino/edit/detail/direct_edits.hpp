// Operators that a mesh does itself, faster than by rewire.
//
// mesh_traits<M> may have split_edge(m, e, x), which returns the new vert or none, flip_edge(m, e) and collapse_edge(m, e, x), which return a direct_edit. Here x
// is the point of the new vert, or of the first end of e, which remains. Each leaves the same mesh as the operator by rewire, or does nothing. Like rewire, they
// change nothing if memory runs out. Only native meshes have them: inherited ones do not know whether another `rewire` was written. split_edge and flip_edge are asked if there are no invariants, collapse_edge also if the invariants hold.
//
// prefetch_edit(m, e, round) may request memory that these edits of e use, if e is an edge of m; read_ahead calls it. It is called in three rounds for each edge,
// 0, 1 and 2, some edges apart: a round may read what the one before has requested.
#pragma once

#include <concino/core/vec3.hpp>
#include <concino/concepts/mesh_traits.hpp>
#include <concino/core/precompiled.hpp>
#include <concino/mesh/direct_edit.hpp>

#include <concepts>

namespace concino::detail {

template<class M> concept splits_edges = core::is_native<M> && requires(M& m, edge_t<M> e, const vec3& x) { { traits<M>::split_edge(m, e, x) } -> std::same_as<vert_t<M>>; };
template<class M> concept flips_edges = core::is_native<M> && requires(M& m, edge_t<M> e) { { traits<M>::flip_edge(m, e) } -> std::same_as<direct_edit>; };
template<class M> concept collapses_edges = core::is_native<M> && requires(M& m, edge_t<M> e, const vec3& x) { { traits<M>::collapse_edge(m, e, x) } -> std::same_as<direct_edit>; };
template<class M> concept prefetches_edits = requires(const M& m, edge_t<M> e, unsigned round) { traits<M>::prefetch_edit(m, e, round); };

/// The point (1 - t) a + t b of the edge between a and b; its ends to the bit for 0 and 1.
inline vec3 point_between(const vec3& a, const vec3& b, double t) {
  if (t == 0) return a;
  return t == 1 ? b : (1 - t) * a + t * b;
}

}  // namespace concino::detail
