// The level set of a function on a surface that cuts each poly once and meets no vert: the fast way, for most smooth functions.
#pragma once

#include <concino/concepts/oriented_edges.hpp>
#include <concino/core/local_numbers.hpp>
#include <concino/core/parallel.hpp>
#include <concino/level_sets/detail/level_lines.hpp>
#include <concino/level_sets/detail/level_states.hpp>
#include <concino/level_sets/detail/polygon_crossings.hpp>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace concino::detail {

/// One piece for each poly that the level set crosses. The lines are those of line_pieces. Places have numbers of edges as elements, and no verts.
template<class M>
class simple_lines {
  static constexpr std::size_t chunk = 256, few = 32;
  static constexpr std::uint32_t none = ~0u, many = ~0u - 1;

  struct piece {
    edge_t<M> edges[2];                     // those where it starts and ends
    std::uint32_t numbers[2] = {};          // of the edges
    std::uint32_t link[2] = {none, none};  // see join_pieces
  };
  struct corner {
    vert_t<M> vert;
    edge_t<M> edge;
    unsigned char state;
  };

  std::vector<piece> pieces_;

 public:
  std::vector<edge_t<M>> edges;  // by number

  /// Finds the pieces of the polys that the level set crosses. Returns false if it meets a vert, crosses more than two edges of a poly, or crosses a poly that is
  /// not convex; nothing here is of use then.
  bool find(const M& m, const unsigned char* states, const std::vector<poly_t<M>>& polys) {
    pieces_.resize(polys.size());
    std::atomic<bool> is_simple = true;
    parallel_for(
        (polys.size() + chunk - 1) / chunk,
        [&](std::size_t i) {
          const std::size_t first = i * chunk, last = std::min(polys.size(), first + chunk);
          if (!find_pieces(m, states, {polys.data() + first, last - first}, pieces_.data() + first)) is_simple.store(false, std::memory_order_relaxed);
        },
        1);
    if (!is_simple) return false;
    link(m);
    return true;
  }

  level_lines join() const {
    return join_pieces(pieces_, [this](level_lines& lines, std::uint32_t i, bool forward) {
      for (const unsigned end : {0u, 1u}) lines.add_place({level_place::edge, pieces_[i].numbers[forward ? end : 1 - end], 0, 0});
    });
  }

 private:
  /// Reads a few polys before it looks at them, so that the processor waits for the memory of several at once.
  static bool find_pieces(const M& m, const unsigned char* states, std::span<const poly_t<M>> polys, piece* to) {
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
      for (std::size_t i = 0, first = 0; i < n; first = ends[i++])
        if (!find_piece(m, {corners.data() + first, ends[i] - first}, points, *to++)) return false;
      polys = polys.subspan(n);
    }
    return true;
  }

  /// Larger values are to the left of a piece.
  static bool find_piece(const M& m, std::span<const corner> corners, std::vector<vec3>& points, piece& x) {
    unsigned char before = corners.back().state, joint = before;
    unsigned crossings = 0;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const unsigned char state = corners[k].state;
      joint |= state;
      if (state != before) {
        x.edges[state == below_level ? 0 : 1] = corners[k == 0 ? corners.size() - 1 : k - 1].edge;
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

  /// Numbers the edges, and links the two pieces at each edge of two polys. All polys at a crossed edge are crossed.
  void link(const M& m) {
    core::local_numbers numbers;
    numbers.reserve(pieces_.size() + pieces_.size() / 16);  // about as many as pieces
    std::vector<std::uint32_t> uses;                        // by edge: where it came first, as in link; `many` if it has more than two
    uses.reserve(pieces_.size()), edges.reserve(pieces_.size());
    for (std::uint32_t i = 0; i < pieces_.size(); ++i)
      for (const unsigned end : {0u, 1u}) {
        const std::uint32_t use = 2 * i + end, number = pieces_[i].numbers[end] = numbers.add(index_of(m, pieces_[i].edges[end]));
        if (number == uses.size()) uses.push_back(use), edges.push_back(pieces_[i].edges[end]);
        else add_use(uses[number], use);
      }
  }
  void add_use(std::uint32_t& first, std::uint32_t use) {
    if (first == many) return;
    std::uint32_t& link = pieces_[first / 2].link[first % 2];
    if (link == none) {
      link = use;
      pieces_[use / 2].link[use % 2] = first;
    } else {
      pieces_[link / 2].link[link % 2] = none;
      link = none;
      first = many;
    }
  }
};

}  // namespace concino::detail
