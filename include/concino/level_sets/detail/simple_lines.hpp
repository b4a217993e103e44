// The level set of a function on a surface that cuts each poly once and meets no vert: the fast way, for most smooth functions.
#pragma once

#include <concino/concepts/oriented_edges.hpp>
#include <concino/core/block_allocator.hpp>
#include <concino/core/parallel.hpp>
#include <concino/level_sets/detail/level_lines.hpp>
#include <concino/level_sets/detail/level_states.hpp>
#include <concino/level_sets/detail/polygon_crossings.hpp>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace concino::detail {

/// One piece for each poly that the level set crosses. The lines are those of line_pieces. Places have as elements where their edges come first, as edge_of()
/// takes it, and no verts.
template<class M>
class simple_lines {
  static constexpr std::size_t chunk = 256, few = 32;
  static constexpr std::uint32_t none = ~0u, many = ~0u - 1;

  struct corner {
    vert_t<M> vert;
    edge_t<M> edge;
    unsigned char state;
  };

  template<class T> using array = std::vector<T, core::block_allocator<T>>;
  std::shared_ptr<core::memory_block> block_;
  // By end of a piece: 2 piece + (0 at its start, 1 at its end).
  array<edge_t<M>> edges_;       // that on which the end is
  array<std::uint32_t> firsts_;  // the end where this edge comes first
  array<std::uint32_t> links_;   // see join_pieces; `many`, until all are linked, where an edge of more than two polys comes first

  template<class T> array<T> array_of() const { return array<T>(core::block_allocator<T>(block_)); }

 public:
  /// All arrays are taken from the block, if there is one.
  explicit simple_lines(std::shared_ptr<core::memory_block> block = nullptr)
      : block_(std::move(block)), edges_(array_of<edge_t<M>>()), firsts_(array_of<std::uint32_t>()), links_(array_of<std::uint32_t>()) {}

  edge_t<M> edge_of(std::uint32_t end) const { return edges_[end]; }

  /// Finds the pieces of the polys that the level set crosses. Returns false if it meets a vert, crosses more than two edges of a poly, or crosses a poly that is
  /// not convex; nothing here is of use then.
  bool find(const M& m, const unsigned char* states, const std::vector<poly_t<M>>& polys) {
    edges_.resize(2 * polys.size());
    std::atomic<bool> is_simple = true;
    parallel_for(
        (polys.size() + chunk - 1) / chunk,
        [&](std::size_t i) {
          const std::size_t first = i * chunk, last = std::min(polys.size(), first + chunk);
          if (!find_pieces(m, states, {polys.data() + first, last - first}, edges_.data() + 2 * first)) is_simple.store(false, std::memory_order_relaxed);
        },
        1);
    if (!is_simple) return false;
    link(m);
    return true;
  }

  level_lines join() const {
    const auto append = [this](level_lines& lines, std::uint32_t i, bool forward) {
      const std::uint32_t start = 2 * i + (forward ? 0 : 1);
      if (lines.begins()) lines.add_place({level_place::edge, firsts_[start], 0, 0});  // else it is where the piece before ended
      lines.add_place({level_place::edge, firsts_[start ^ 1u], 0, 0});
    };
    return join_pieces(
        edges_.size() / 2, [this](std::uint32_t end) { return links_[end]; }, append, block_);
  }

 private:
  /// Reads a few polys before it looks at them, so that the processor waits for the memory of several at once.
  static bool find_pieces(const M& m, const unsigned char* states, std::span<const poly_t<M>> polys, edge_t<M>* to) {
    std::vector<corner> corners;
    std::vector<vec3> points;  // of one poly
    std::size_t ends[few];
    while (!polys.empty()) {
      const std::size_t n = std::min(polys.size(), few);
      corners.clear();
      for (std::size_t i = 0; i < n; ++i) {
        for (const auto& [e, from, next] : oriented_edges(m, polys[i])) corners.push_back({from, e, 0});
        ends[i] = corners.size();
      }
      for (corner& c : corners) c.state = states[index_of(m, c.vert)];
      for (std::size_t i = 0, first = 0; i < n; first = ends[i++], to += 2)
        if (!find_piece(m, {corners.data() + first, ends[i] - first}, points, to)) return false;
      polys = polys.subspan(n);
    }
    return true;
  }

  /// Larger values are to the left of a piece.
  static bool find_piece(const M& m, std::span<const corner> corners, std::vector<vec3>& points, edge_t<M>* to) {
    unsigned char before = corners.back().state, joint = before;
    unsigned crossings = 0;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const unsigned char state = corners[k].state;
      joint |= state;
      if (state != before) {
        to[state == below_level ? 0 : 1] = corners[k == 0 ? corners.size() - 1 : k - 1].edge;
        ++crossings;
      }
      before = state;
    }
    if ((joint & on_level) || crossings != 2) return false;
    if (corners.size() == 3) return true;
    points.clear();
    for (const corner& c : corners) points.push_back(to_vec3(point(m, c.vert)));
    return is_convex_polygon(points);
  }

  /// Links the two pieces at each edge of two polys. All polys at a crossed edge are crossed.
  void link(const M& m) {
    const std::size_t n = edges_.size(), size = std::bit_ceil(n + n / 2 + 1);  // of a hash table: most pieces add one edge, some add two
    array<std::uint32_t> slots(size, none, core::block_allocator<std::uint32_t>(block_));  // where edges come first
    firsts_.resize(n);
    links_.resize(n, none);
    bool has_many = false;
    for (std::uint32_t end = 0; end < n; ++end) {
      const edge_t<M> e = edges_[end];
      const std::uint64_t hash = std::uint64_t{index_of(m, e)} * 0x9e3779b97f4a7c15u;
      std::size_t at = static_cast<std::size_t>(hash >> 32) & (size - 1);
      while (slots[at] != none && edges_[slots[at]] != e) at = (at + 1) & (size - 1);
      if (slots[at] == none) slots[at] = end;
      else has_many |= join_at_edge(slots[at], end);
      firsts_[end] = slots[at];
    }
    if (!has_many) return;
    for (std::uint32_t& link : links_)
      if (link == many) link = none;
  }
  /// Links two ends on one edge, `first` being the first one there. Returns whether the edge has more than two polys.
  bool join_at_edge(std::uint32_t first, std::uint32_t end) {
    std::uint32_t& link = links_[first];
    if (link == none) {
      link = end, links_[end] = first;
      return false;
    }
    if (link != many) links_[link] = none;
    link = many;
    return true;
  }
};

}  // namespace concino::detail
