// Whether a surface is a manifold on which no two polys cover each other.
#pragma once

#include <concino/concepts/facets.hpp>
#include <concino/concepts/mesh.hpp>
#include <concino/core/parallel.hpp>
#include <concino/core/small_array.hpp>

#include <atomic>
#include <cstddef>
#include <cstdint>

namespace concino::detail {

/// Looks at the polys of one vert. They have to be oriented alike.
template<SurfaceMesh S>
class fan_checker {
  static constexpr std::size_t few = 8;
  struct corner {
    std::uint32_t previous, next;  // the neighbours of the vert in the poly
  };

  const S& s_;
  core::small_array<corner, few> corners_;

  /// Returns false if p does not have v once.
  bool add_corner(const poly_t<S>& p, std::uint32_t v) {
    const auto& ring = adj_p2v(s_, p);
    std::uint32_t first = ~0u, last = ~0u, before = ~0u, after = ~0u;
    std::size_t met = 0;
    for (const vert_t<S> x : ring) {
      const auto at = static_cast<std::uint32_t>(index_of(s_, x));
      if (first == ~0u) first = at;
      if (last == v && met > 0) after = at;
      if (at == v) before = last, ++met;
      last = at;
    }
    if (before == ~0u) before = last;
    if (after == ~0u) after = first;
    corners_.push_back({before, after});
    return met == 1;
  }

  /// Whether a few corners form one closed cycle, which is the usual case; without branches, since they differ from vert to vert.
  bool is_short_cycle() const {
    const std::size_t n = corners_.size();
    if (n < 3 || n > few) return false;
    std::size_t behind[few], met = 0;
    for (std::size_t i = 0; i < n; ++i) {
      behind[i] = i;
      for (std::size_t k = 0; k < n; ++k) {
        const bool follows = corners_[k].next == corners_[i].previous;
        met += follows;
        behind[i] = follows ? k : behind[i];
      }
    }
    std::size_t steps = 1, at = behind[0];
    for (; at != 0 && steps < n; at = behind[at]) ++steps;
    return met == n && steps == n && at == 0;
  }

  /// Whether all edges of p lead to one other poly.
  bool is_covered(const poly_t<S>& p) const {
    std::size_t others = 0;
    for ([[maybe_unused]] const poly_t<S> q : adj_p2p(s_, p)) ++others;
    if (others != 1) return false;
    for (const edge_t<S> e : adj_p2e(s_, p))
      if (is_boundary(s_, e)) return false;
    return true;
  }

 public:
  explicit fan_checker(const S& s) : s_(s) {}

  /// Whether the polys at v follow each other around it, one behind each of their edges, and none covers another.
  bool has_one_fan(const vert_t<S>& v) {
    corners_.clear();
    for (const poly_t<S> p : adj_v2p(s_, v))
      if (!add_corner(p, static_cast<std::uint32_t>(index_of(s_, v)))) return false;
    if (is_short_cycle()) return true;
    const std::size_t n = corners_.size();
    if (n == 0) return false;
    std::size_t start = 0;
    for (std::size_t i = 0; i < n; ++i) {
      bool is_last = true;  // no poly is behind its edge to the next vert
      for (std::size_t k = 0; k < n; ++k) {
        if (k < i && (corners_[k].previous == corners_[i].previous || corners_[k].next == corners_[i].next)) return false;
        is_last = is_last && corners_[k].previous != corners_[i].next;
      }
      if (is_last) start = i;
    }
    std::size_t met = 1, at = start;
    for (bool found = true; found; met += found) {
      found = false;
      for (std::size_t k = 0; k < n && !found; ++k)
        if (corners_[k].next == corners_[at].previous && k != start) at = k, found = true;
    }
    if (met != n) return false;
    if (n == 2 && corners_[0].next == corners_[1].previous && corners_[0].previous == corners_[1].next)
      for (const poly_t<S> p : adj_v2p(s_, v))
        if (is_covered(p)) return false;
    return true;
  }
};

/// Whether each edge has at most two polys and each vert one fan, and no poly has the same neighbour across all of its edges.
/// Needs: the polys at each edge run along it in opposite directions; otherwise the answer may be false for a manifold.
template<SurfaceMesh S>
bool is_simple_surface(const S& s) {
  std::atomic<bool> is_simple = true;
  parallel_for_each(verts(s), [&s, &is_simple](const vert_t<S>& v) {
    if (!fan_checker<S>(s).has_one_fan(v)) is_simple.store(false, std::memory_order_relaxed);
  });
  return is_simple;
}

}  // namespace concino::detail
