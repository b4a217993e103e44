// Reads cells that lie far apart in memory, which is requested before.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/prefetch.hpp>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <type_traits>

namespace concino::detail {

/// Requests what is behind the lists of some cells: the ends of their edges, the verts of their faces, and the points of their verts. Each loop requests one
/// thing of all cells, so that the processor waits for the memory that says where it is of several cells at once.
template<class M>
void request_elements(const M& m, std::span<const poly_t<M>> polys) {
  if constexpr (core::is_contiguous<decltype(adj_f2v(m, face_t<M>{}))>)
    for (const poly_t<M>& p : polys)
      for (const face_t<M> f : adj_p2f(m, p)) core::prefetch_row(adj_f2v(m, f));
  if constexpr (core::is_contiguous<decltype(adj_e2v(m, edge_t<M>{}))>)
    for (const poly_t<M>& p : polys)
      for (const edge_t<M> e : adj_p2e(m, p)) core::prefetch_row(adj_e2v(m, e));
  if constexpr (std::is_lvalue_reference_v<decltype(point(m, vert_t<M>{}))>)
    for (const poly_t<M>& p : polys)
      for (const vert_t<M> v : adj_p2v(m, p)) core::prefetch(std::addressof(point(m, v)));
}

/// Requests the lists of some cells, of tets those of their edges and verts.
template<class M>
void request_lists(const M& m, std::span<const poly_t<M>> polys) {
  for (const poly_t<M>& p : polys)
    if constexpr (arity_v<M> == 4) core::prefetch_rows(adj_p2e(m, p), adj_p2v(m, p));  // all that is read of tets
    else core::prefetch(m, p);
}

/// Calls read(p) for each poly until it returns false. Some cells before, the lists of p are requested, and then what is behind them; of tets, this is not read.
template<class M, class Read>
void read_requested(const M& m, std::span<const poly_t<M>> polys, const Read& read) {
  constexpr std::size_t few = 8;
  const auto some = [&](std::size_t first) {
    const std::size_t begin = std::min(first, polys.size()), end = std::min(first + few, polys.size());
    return polys.subspan(begin, end - begin);
  };
  request_lists<M>(m, some(0)), request_lists<M>(m, some(few));
  if constexpr (arity_v<M> != 4) request_elements<M>(m, some(0));  // of tets they are not read
  for (std::size_t first = 0; first < polys.size(); first += few) {
    request_lists<M>(m, some(first + 2 * few));
    if constexpr (arity_v<M> != 4) request_elements<M>(m, some(first + few));  // the same
    for (const poly_t<M>& p : some(first))
      if (!read(p)) return;
  }
}

}  // namespace concino::detail
