// Lines on a surface, joined of pieces.
#pragma once

#include <concino/core/block_allocator.hpp>
#include <concino/level_sets/detail/level_place.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace concino::detail {

/// Lines, one after another. Line i has the places from ends[i - 1] to ends[i].
struct level_lines {
  std::vector<level_place, core::block_allocator<level_place>> places;
  std::vector<std::size_t> ends;
  std::vector<unsigned char> closed;

  /// Without lines. The places are taken from the block.
  explicit level_lines(std::shared_ptr<core::memory_block> block = nullptr) : places(core::block_allocator<level_place>(std::move(block))) {}

  /// Whether the current line has no places yet.
  bool begins() const { return places.size() == begin_of_current(); }
  /// Adds a place to the current line unless it is there already; a line that returns at once to the place before loses both steps.
  void add_place(const level_place& x) {
    const std::size_t n = places.size() - begin_of_current();
    if (n > 0 && places.back() == x) return;
    if (n > 1 && places[places.size() - 2] == x) places.pop_back();
    else places.push_back(x);
  }

  /// Ends the current line. One that has become a point or, if closed, a segment and back, has no size and is removed.
  void end_line(bool is_closed) {
    const std::size_t begin = begin_of_current();
    std::size_t first = begin, last = places.size();
    if (is_closed) {
      if (last - first > 1 && places[first] == places[last - 1]) --last;
      while (last - first > 2 && places[first + 1] == places[last - 1]) ++first, --last;
    }
    if (last - first < (is_closed ? 3u : 2u)) {
      places.resize(begin);
      return;
    }
    places.resize(last);
    places.erase(places.begin() + static_cast<std::ptrdiff_t>(begin), places.begin() + static_cast<std::ptrdiff_t>(first));
    ends.push_back(places.size());
    closed.push_back(is_closed);
  }

 private:
  std::size_t begin_of_current() const { return ends.empty() ? 0 : ends.back(); }
};

/// Joins n pieces: in the order of the pieces, and in the direction of the first one of each line. link_of(x) says what follows at an end of a piece, or ~0 for
/// nothing; ends have the numbers 2 piece + (0 at the start of the piece, 1 at its end). Links are mutual.
/// append(lines, i, forward) adds the places of piece i to the current line. The places are taken from the block, if there is one.
template<class LinkOf, class Append>
level_lines join_pieces(std::size_t n, const LinkOf& link_of, const Append& append, std::shared_ptr<core::memory_block> block = nullptr) {
  constexpr std::uint32_t none = ~0u;
  level_lines lines(std::move(block));
  lines.places.reserve(n + n / 8);  // most lines have about as many places as pieces
  std::vector<unsigned char> is_joined(n, 0);
  for (std::uint32_t i = 0; i < n; ++i) {
    if (is_joined[i]) continue;
    std::uint32_t start = 2 * i;  // an end of a piece: the line starts there
    bool closed = false;
    for (std::uint32_t before = link_of(start); before != none; before = link_of(start)) {
      start = before ^ 1u;
      closed = before / 2 == i;
      if (closed) break;
    }
    if (closed) start = 2 * i;
    for (std::uint32_t at = start;;) {
      append(lines, at / 2, at % 2 == 0);
      is_joined[at / 2] = 1;
      const std::uint32_t after = link_of(at ^ 1u);
      if (after == none || after == start) break;
      at = after;
    }
    lines.end_line(closed);
  }
  return lines;
}

}  // namespace concino::detail
