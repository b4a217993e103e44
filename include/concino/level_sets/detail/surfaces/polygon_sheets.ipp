// Polygons made a manifold; see polygon_sheets.hpp.
#pragma once

#include <concino/core/hash_bytes.hpp>
#include <concino/level_sets/detail/surfaces/polygon_sheets.hpp>

#include <algorithm>
#include <utility>

namespace concino::detail {

/// Removes two edges that run in opposite directions between the same places. What lies across them is joined.
CONCINO_INLINE void polygon_sheets::remove_edge_pair(std::uint32_t a, std::uint32_t b) {
  const std::uint32_t at_a = neighbours_[a], at_b = neighbours_[b];
  if (at_a == b) return;
  if (at_a != none) neighbours_[at_a] = at_b;
  if (at_b != none) neighbours_[at_b] = at_a;
}

/// Adds a cycle of corners at different places, unless it has no size.
CONCINO_INLINE void polygon_sheets::add_loop(const std::uint32_t* first, const std::uint32_t* last,
                                             std::uint32_t cell) {
  const auto n = last - first;
  if (n == 2) remove_edge_pair(first[0], first[1]);
  if (n < 3) return;
  for (std::ptrdiff_t i = 0; i < n; ++i) next_[first[i]] = first[i + 1 < n ? i + 1 : 0];
  polygons_.insert(polygons_.end(), first, last);
  polygon_ends_.push_back(static_cast<std::uint32_t>(polygons_.size()));
  polygon_cells_.push_back(cell);
}

/// Joins equal corners that follow each other, cuts polygons that come twice to one place, and removes those that have
/// fewer than three corners left, or the corners of another one in opposite order. The neighbours of what is removed
/// become neighbours of each other.
CONCINO_INLINE void polygon_sheets::remove_polygons_without_size() {
  next_.assign(places_.size(), none);
  std::vector<std::uint32_t> open;                              // corners of the current polygon that are not in a
                                                                // cycle yet
  std::vector<std::uint32_t> position;                          // by place, in `open`
  for (const std::uint32_t x : places_)
    if (x >= position.size()) position.resize(x + std::size_t{1}, none);
  for (std::uint32_t i = 0; i < ends_.size(); ++i) {
    const std::uint32_t first = i == 0 ? 0 : ends_[i - 1], last = ends_[i];
    open.clear();
    for (std::uint32_t c = first; c < last; ++c) {
      if (places_[c] == places_[c + 1 < last ? c + 1 : first]) continue;  // the edge has no length
      const std::uint32_t start = position[places_[c]];
      if (start != none) {
        for (std::size_t k = start; k < open.size(); ++k) position[places_[open[k]]] = none;
        add_loop(open.data() + start, open.data() + open.size(), cells_[i]);
        open.resize(start);
      }
      position[places_[c]] = static_cast<std::uint32_t>(open.size());
      open.push_back(c);
    }
    for (const std::uint32_t c : open) position[places_[c]] = none;
    add_loop(open.data(), open.data() + open.size(), cells_[i]);
  }
  remove_opposite_polygons();
}

/// Removes pairs of polygons with the same corners in opposite order.
CONCINO_INLINE void polygon_sheets::remove_opposite_polygons() {
  const auto num_polygons = static_cast<std::uint32_t>(polygon_ends_.size());
  const auto begin = [&](std::uint32_t i) { return i == 0 ? 0 : polygon_ends_[i - 1]; };
  std::vector<std::uint64_t> order;  // polygons by a sum over their places, which does not depend on the first corner
                                     // and the direction
  for (std::uint32_t i = 0; i < num_polygons; ++i) {
    std::uint64_t sum = 0;
    for (std::uint32_t k = begin(i); k < polygon_ends_[i]; ++k) sum += core::scrambled(places_[polygons_[k]]);
    order.push_back(sum >> 32 << 32 | i);
  }
  std::sort(order.begin(), order.end());
  std::vector<unsigned char> is_removed(num_polygons, 0);
  const auto are_opposite = [&](std::uint32_t a, std::uint32_t b) {
    const std::uint32_t n = polygon_ends_[a] - begin(a);
    if (polygon_ends_[b] - begin(b) != n) return none;
    const std::uint32_t* const x = polygons_.data() + begin(a);
    const std::uint32_t* const y = polygons_.data() + begin(b);
    for (std::uint32_t s = 0; s < n; ++s) {
      if (places_[y[s]] != places_[x[0]]) continue;
      for (std::uint32_t k = 1; k < n; ++k)
        if (places_[x[k]] != places_[y[(s + n - k) % n]]) return none;
      return s;
    }
    return none;
  };
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto a = static_cast<std::uint32_t>(order[i]);
    for (std::size_t j = i + 1; !is_removed[a] && j < order.size() && order[j] >> 32 == order[i] >> 32; ++j) {
      const auto b = static_cast<std::uint32_t>(order[j]);
      const std::uint32_t shift = is_removed[b] ? none : are_opposite(a, b);
      if (shift == none) continue;
      const std::uint32_t n = polygon_ends_[a] - begin(a);
      is_removed[a] = is_removed[b] = 1;
      for (std::uint32_t k = 0; k < n; ++k)  // the edge from corner k of a, and the one that ends there in b
        remove_edge_pair(polygons_[begin(a) + k], polygons_[begin(b) + (shift + n - k - 1) % n]);
    }
  }
  std::vector<std::uint32_t> kept, kept_ends, kept_cells;
  for (std::uint32_t i = 0; i < num_polygons; ++i) {
    if (is_removed[i]) continue;
    kept.insert(kept.end(), polygons_.begin() + begin(i), polygons_.begin() + polygon_ends_[i]);
    kept_ends.push_back(static_cast<std::uint32_t>(kept.size()));
    kept_cells.push_back(polygon_cells_[i]);
  }
  polygons_.swap(kept), polygon_ends_.swap(kept_ends), polygon_cells_.swap(kept_cells);
}

CONCINO_INLINE void polygon_sheets::unite_fans() {
  fans_ = disjoint_sets(places_.size());
  for (const std::uint32_t c : polygons_) {
    const std::uint32_t other = neighbours_[c];
    if (other == none) continue;
    // at a face that both cells use in the same direction
    if (places_[c] != places_[next_[other]] || places_[next_[c]] != places_[other]) {
      neighbours_[c] = neighbours_[other] = none;
      continue;
    }
    fans_.unite(c, next_[other]);
    fans_.unite(next_[c], other);
  }
}

/// Exchanges the neighbours of two edges between the same two fans, which cuts both fans in two. Returns false if there
/// are no such edges.
CONCINO_INLINE bool polygon_sheets::separate_double_edges() {
  std::vector<std::uint64_t> order;
  for (const std::uint32_t c : polygons_) order.push_back(std::uint64_t{fans_.root(c)} << 32 | fans_.root(next_[c]));
  std::vector<std::uint64_t> sorted = order;
  std::sort(sorted.begin(), sorted.end());
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  if (sorted.size() == order.size()) return false;
  std::vector<std::uint32_t> first(sorted.size(), none);
  std::vector<unsigned char> is_cut(places_.size(), 0);  // fans that are no longer known
  bool any = false;
  for (std::size_t i = 0; i < order.size(); ++i) {
    std::uint32_t& a =
        first[static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), order[i]) - sorted.begin())];
    const std::uint32_t b = polygons_[i];
    if (a == none) {
      a = b;
      continue;
    }
    const std::uint32_t at_a = neighbours_[a], at_b = neighbours_[b];
    unsigned char &from = is_cut[fans_.root(b)], &to = is_cut[fans_.root(next_[b])];
    if (from || to || (at_a == none && at_b == none)) continue;
    from = to = 1;
    any = true;
    neighbours_[a] = at_b, neighbours_[b] = at_a;
    if (at_b != none) neighbours_[at_b] = a;
    if (at_a != none) neighbours_[at_a] = b;
  }
  return any;
}

/// Numbers the corners of polygons_ such that the surface is a manifold: corners have equal numbers if they are at one
/// place and in one fan of neighbours. No two numbers are joined by two edges.
CONCINO_INLINE level_surface_arrays polygon_sheets::number_fans() {
  unite_fans();
  while (separate_double_edges()) unite_fans();
  level_surface_arrays result;
  std::vector<std::uint32_t> number_of(places_.size(), none);
  for (const std::uint32_t c : polygons_) {
    std::uint32_t& number = number_of[fans_.root(c)];
    if (number == none) {
      number = static_cast<std::uint32_t>(result.places.size());
      result.places.push_back(numbers_.places[places_[c]]);
    }
    result.verts.push_back(number);
  }
  result.ends = std::move(polygon_ends_);
  result.cells = std::move(polygon_cells_);
  return result;
}

CONCINO_INLINE level_surface_arrays polygon_sheets::make() {
  remove_polygons_without_size();
  return number_fans();
}

}  // namespace concino::detail
