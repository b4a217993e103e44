// Loops that edit a mesh at one edge after another, in any order, spend most of their time waiting for memory. read_ahead requests it earlier.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/concepts/ranges.hpp>
#include <concino/edit/detail/direct_edits.hpp>

#include <type_traits>
#include <utility>

namespace concino {

namespace detail {

/// The edges of a range R, which is kept as R, a value or a reference. When an edge is reached, those some places further on are requested.
template<class M, class R>
class edges_read_ahead {
  using range = const std::remove_reference_t<R>;
  using base_iterator = decltype(std::declval<range&>().begin());
  using base_end = decltype(std::declval<range&>().end());
  static constexpr unsigned rounds = 3, distance = 4;  // by measurement; twice the distance takes as long

  const M* m_;
  R edges_;

 public:
  class iterator {
    const M* m_;
    base_iterator at_, ahead_[rounds];  // ahead_[k]: up to where edges were requested in round k
    base_end end_;

    void request(unsigned round) {
      if (!(ahead_[round] != end_)) return;
      traits<M>::prefetch_edit(*m_, *ahead_[round], round);
      ++ahead_[round];
    }

   public:
    constexpr iterator(const M& m, base_iterator begin, base_end end) : m_(&m), at_(begin), ahead_{begin, begin, begin}, end_(end) {
      if constexpr (prefetches_edits<M>)
        for (unsigned i = 0; i < rounds * distance; ++i)
          for (unsigned round = 0; round < rounds; ++round)
            if (i >= round * distance) request(round);
    }
    constexpr decltype(auto) operator*() const { return *at_; }
    constexpr iterator& operator++() {
      ++at_;
      if constexpr (prefetches_edits<M>)
        for (unsigned round = 0; round < rounds; ++round) request(round);
      return *this;
    }
    friend constexpr bool operator!=(const iterator& it, const base_end& end) { return it.at_ != end; }
  };

  constexpr edges_read_ahead(const M& m, R&& edges) : m_(&m), edges_(static_cast<R&&>(edges)) {}
  constexpr iterator begin() const { return iterator(*m_, list().begin(), list().end()); }
  constexpr base_end end() const { return list().end(); }

 private:
  constexpr range& list() const { return edges_; }
};

}  // namespace detail

/// The edges of a range, in its order, for a loop that edits m at each of them:
///   for (const auto e : read_ahead(m, list)) edge_flip(m, e);
/// While one edit is done, the memory that the next ones use is requested. In meshes that do not fit into the caches, random flips of a trimesh take half the time.
/// Needs:  AnyMesh M; a range of edges that the edits do not change, such as a vector. It may name edges that do not exist, now or when they are reached.
/// Result: a range. It refers to m, and to `list` if that is not temporary. It changes no result of an edit. With meshes whose traits cannot request memory
///         for edits, the loop is that over the list; of the meshes of this library trimesh can.
/// Cost:   O(1) an edge: about a hundred instructions, which do not wait for memory.      Errors: none.
template<AnyMesh M, class R>
  requires ElementRange<std::remove_reference_t<R>, edge_t<M>>
constexpr auto read_ahead(const M& m, R&& list) {
  return detail::edges_read_ahead<M, R>(m, static_cast<R&&>(list));
}
template<AnyMesh M, class R>
void read_ahead(const M&& m, R&& list) = delete;  // give the mesh a name: auto m = ...;

}  // namespace concino
