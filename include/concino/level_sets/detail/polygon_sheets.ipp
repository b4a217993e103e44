// Polygons made a manifold; see polygon_sheets.hpp.
#pragma once

#include <concino/core/sort_numbers.hpp>
#include <concino/level_sets/detail/polygon_sheets.hpp>

#include <algorithm>

namespace concino::detail {

/// Removes two edges that run in opposite directions between the same places. What lies across them is joined.
CONCINO_INLINE void polygon_sheets::remove_edge_pair(std::uint32_t a, std::uint32_t b) {
  const std::uint32_t at_a = neighbours[a], at_b = neighbours[b];
  if (at_a == b) return;
  if (at_a != none) neighbours[at_a] = at_b;
  if (at_b != none) neighbours[at_b] = at_a;
}

/// Adds a cycle of corners at different places, unless it has no size.
CONCINO_INLINE void polygon_sheets::add_loop(const std::uint32_t* first, const std::uint32_t* last, std::uint32_t origin) {
  const auto n = last - first;
  if (n == 2) remove_edge_pair(first[0], first[1]);
  if (n < 3) return;
  for (std::ptrdiff_t i = 0; i < n; ++i) next_[first[i]] = first[i + 1 < n ? i + 1 : 0];
  polygons.insert(polygons.end(), first, last);
  polygon_ends.push_back(static_cast<std::uint32_t>(polygons.size()));
  polygon_origins.push_back(origin);
}

CONCINO_INLINE void polygon_sheets::remove_polygons_without_size() {
  next_.assign(places.size(), none);
  std::vector<std::uint32_t> open;                              // corners of the current polygon that are not in a cycle yet
  std::vector<std::uint32_t> position;                          // by place, in `open`
  for (const std::uint32_t x : places)
    if (x >= position.size()) position.resize(x + std::size_t{1}, none);
  for (std::uint32_t i = 0; i < ends.size(); ++i) {
    const std::uint32_t first = i == 0 ? 0 : ends[i - 1], last = ends[i];
    open.clear();
    for (std::uint32_t c = first; c < last; ++c) {
      if (places[c] == places[c + 1 < last ? c + 1 : first]) continue;  // the edge has no length
      const std::uint32_t start = position[places[c]];
      if (start != none) {
        for (std::size_t k = start; k < open.size(); ++k) position[places[open[k]]] = none;
        add_loop(open.data() + start, open.data() + open.size(), i);
        open.resize(start);
      }
      position[places[c]] = static_cast<std::uint32_t>(open.size());
      open.push_back(c);
    }
    for (const std::uint32_t c : open) position[places[c]] = none;
    add_loop(open.data(), open.data() + open.size(), i);
  }
  remove_opposite_polygons();
}

/// Removes pairs of polygons with the same corners in opposite order.
CONCINO_INLINE void polygon_sheets::remove_opposite_polygons() {
  const auto num_polygons = static_cast<std::uint32_t>(polygon_ends.size());
  const auto begin = [&](std::uint32_t i) { return i == 0 ? 0 : polygon_ends[i - 1]; };
  std::vector<std::uint64_t> order;  // polygons by a sum over their places, which does not depend on the first corner and the direction
  for (std::uint32_t i = 0; i < num_polygons; ++i) {
    std::uint64_t sum = 0;
    for (std::uint32_t k = begin(i); k < polygon_ends[i]; ++k) {
      const std::uint64_t x = (places[polygons[k]] + std::uint64_t{1}) * 0x9e3779b97f4a7c15u;
      sum += x ^ x >> 29;
    }
    order.push_back((sum * 0xbf58476d1ce4e5b9u >> 32) << 32 | i);
  }
  core::sort_numbers(order.data(), order.data() + order.size());
  std::vector<unsigned char> is_removed(num_polygons, 0);
  const auto are_opposite = [&](std::uint32_t a, std::uint32_t b) {
    const std::uint32_t n = polygon_ends[a] - begin(a);
    if (polygon_ends[b] - begin(b) != n) return none;
    const std::uint32_t* const x = polygons.data() + begin(a);
    const std::uint32_t* const y = polygons.data() + begin(b);
    for (std::uint32_t s = 0; s < n; ++s) {
      if (places[y[s]] != places[x[0]]) continue;
      for (std::uint32_t k = 1; k < n; ++k)
        if (places[x[k]] != places[y[(s + n - k) % n]]) return none;
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
      const std::uint32_t n = polygon_ends[a] - begin(a);
      is_removed[a] = is_removed[b] = 1;
      for (std::uint32_t k = 0; k < n; ++k)  // the edge from corner k of a, and the one that ends there in b
        remove_edge_pair(polygons[begin(a) + k], polygons[begin(b) + (shift + n - k - 1) % n]);
    }
  }
  std::vector<std::uint32_t> kept, kept_ends, kept_origins;
  for (std::uint32_t i = 0; i < num_polygons; ++i) {
    if (is_removed[i]) continue;
    kept.insert(kept.end(), polygons.begin() + begin(i), polygons.begin() + polygon_ends[i]);
    kept_ends.push_back(static_cast<std::uint32_t>(kept.size()));
    kept_origins.push_back(polygon_origins[i]);
  }
  polygons.swap(kept), polygon_ends.swap(kept_ends), polygon_origins.swap(kept_origins);
}

CONCINO_INLINE void polygon_sheets::unite_fans() {
  fans_ = disjoint_sets(places.size());
  for (const std::uint32_t c : polygons) {
    const std::uint32_t other = neighbours[c];
    if (other == none) continue;
    if (places[c] != places[next_[other]] || places[next_[c]] != places[other]) {  // at a face that both cells use in the same direction
      neighbours[c] = neighbours[other] = none;
      continue;
    }
    fans_.unite(c, next_[other]);
    fans_.unite(next_[c], other);
  }
}

/// Exchanges the neighbours of two edges between the same two fans, which cuts both fans in two. Returns false if there are no such edges.
CONCINO_INLINE bool polygon_sheets::separate_double_edges() {
  std::vector<std::uint64_t> order;
  for (const std::uint32_t c : polygons) order.push_back(std::uint64_t{fans_.root(c)} << 32 | fans_.root(next_[c]));
  std::vector<std::uint64_t> sorted = order;
  core::sort_numbers(sorted.data(), sorted.data() + sorted.size());
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  if (sorted.size() == order.size()) return false;
  std::vector<std::uint32_t> first(sorted.size(), none);
  std::vector<unsigned char> is_cut(places.size(), 0);  // fans that are no longer known
  bool any = false;
  for (std::size_t i = 0; i < order.size(); ++i) {
    std::uint32_t& a = first[static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), order[i]) - sorted.begin())];
    const std::uint32_t b = polygons[i];
    if (a == none) {
      a = b;
      continue;
    }
    const std::uint32_t at_a = neighbours[a], at_b = neighbours[b];
    unsigned char &from = is_cut[fans_.root(b)], &to = is_cut[fans_.root(next_[b])];
    if (from || to || (at_a == none && at_b == none)) continue;
    from = to = 1;
    any = true;
    neighbours[a] = at_b, neighbours[b] = at_a;
    if (at_b != none) neighbours[at_b] = a;
    if (at_a != none) neighbours[at_a] = b;
  }
  return any;
}

CONCINO_INLINE std::vector<std::uint32_t> polygon_sheets::number_fans() {
  unite_fans();
  while (separate_double_edges()) unite_fans();
  std::vector<std::uint32_t> number_of(places.size(), none), place_of;
  numbers.clear();
  for (const std::uint32_t c : polygons) {
    std::uint32_t& number = number_of[fans_.root(c)];
    if (number == none) {
      number = static_cast<std::uint32_t>(place_of.size());
      place_of.push_back(places[c]);
    }
    numbers.push_back(number);
  }
  return place_of;
}

}  // namespace concino::detail
