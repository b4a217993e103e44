// Topology of lists of corners; see list_topology.hpp.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/edit/detail/polys/list_topology.hpp>

#include <algorithm>
#include <tuple>

namespace concino::detail {

CONCINO_INLINE std::vector<list_edge> sorted_edges(std::span<const std::span<const unsigned>> lists) {
  std::vector<list_edge> all;
  for (unsigned i = 0; i < lists.size(); ++i)
    for_each_edge_of(lists[i], [&](unsigned a, unsigned b) {
      all.push_back({std::min(a, b), std::max(a, b), i, a < b});
    });
  std::sort(all.begin(), all.end(), [](const list_edge& x, const list_edge& y) {
    return std::tie(x.low, x.high, x.list) < std::tie(y.low, y.high, y.list);
  });
  return all;
}

/// Calls f(first, last) for each group of equal edges.
template<class F>
void for_each_equal(const std::vector<list_edge>& all, const F& f) {
  for (std::size_t i = 0, j = 0; i < all.size(); i = j) {
    while (j < all.size() && all[j].is_same(all[i])) ++j;
    f(i, j);
  }
}

CONCINO_INLINE list_fault merge_lists(std::span<const std::span<const unsigned>> lists, merged_cycle& result) {
  result = {};
  const std::vector<list_edge> all = sorted_edges(lists);
  std::vector<std::pair<unsigned, unsigned>> leaving;  // edges of the boundary, from and to
  list_fault fault = list_fault::none;
  std::ptrdiff_t num_edges = 0;
  for_each_equal(all, [&](std::size_t i, std::size_t j) {
    ++num_edges;
    const auto& [low, high, list, ascends] = all[i];
    if (j - i > 2) fault = list_fault::third_list;
    else if (j - i == 1) leaving.push_back(ascends ? std::pair{low, high} : std::pair{high, low});
    else if (all[i + 1].ascends == ascends) fault = list_fault::winding;
    else result.removed.emplace_back(low, high);
  });
  if (fault != list_fault::none) return fault;
  std::sort(leaving.begin(), leaving.end());
  std::vector<unsigned> verts;
  for (const auto& list : lists) verts.insert(verts.end(), list.begin(), list.end());
  verts = sorted_list(verts);
  const auto chi = static_cast<std::ptrdiff_t>(verts.size()) - num_edges + static_cast<std::ptrdiff_t>(lists.size());
  const auto is_twice = [](const auto& x, const auto& y) { return x.first == y.first; };
  if (leaving.empty() || chi != 1 ||
      std::adjacent_find(leaving.begin(), leaving.end(), is_twice) != leaving.end())
    return list_fault::not_a_disk;
  // begin at the first corner of the first list that stays, so that what is cut and merged again begins as before
  const auto next_of = [&](unsigned v) {
    return std::lower_bound(leaving.begin(), leaving.end(), std::pair{v, 0u});
  };
  unsigned at = leaving.front().first;
  for (const unsigned v : lists.front())
    if (const auto next = next_of(v); next != leaving.end() && next->first == v) {
      at = v;
      break;
    }
  const unsigned first = at;
  do {
    result.boundary.push_back(at);
    const auto next = next_of(at);
    if (next == leaving.end() || next->first != at) return list_fault::not_a_disk;
    at = next->second;
  } while (at != first && result.boundary.size() <= leaving.size());
  if (result.boundary.size() != leaving.size()) return list_fault::not_a_disk;
  const std::vector<unsigned> outside = sorted_list(result.boundary);
  std::set_difference(verts.begin(), verts.end(), outside.begin(), outside.end(), std::back_inserter(result.inside));
  return list_fault::none;
}

CONCINO_INLINE unsigned find_parts(std::span<const std::span<const unsigned>> lists,
                                   std::span<const std::pair<unsigned, unsigned>> barriers,
                                   std::vector<unsigned>& part) {
  constexpr unsigned none = ~0u;
  const std::vector<list_edge> all = sorted_edges(lists);
  std::vector<std::pair<unsigned, unsigned>> joined;  // both ways
  for_each_equal(all, [&](std::size_t i, std::size_t j) {
    if (std::binary_search(barriers.begin(), barriers.end(), std::pair{all[i].low, all[i].high})) return;
    for (std::size_t k = i + 1; k < j; ++k)
      joined.emplace_back(all[k - 1].list, all[k].list), joined.emplace_back(all[k].list, all[k - 1].list);
  });
  std::sort(joined.begin(), joined.end());
  part.assign(lists.size(), none);
  std::vector<unsigned> queue;
  unsigned count = 0;
  for (unsigned i = 0; i < lists.size(); ++i) {
    if (part[i] != none) continue;
    part[i] = count;
    queue.assign(1, i);
    while (!queue.empty()) {
      const unsigned x = queue.back();
      queue.pop_back();
      for (auto y = std::lower_bound(joined.begin(), joined.end(), std::pair{x, 0u});
           y != joined.end() && y->first == x; ++y)
        if (part[y->second] == none) part[y->second] = count, queue.push_back(y->second);
    }
    ++count;
  }
  return count;
}

CONCINO_INLINE list_fault check_sphere(std::span<const std::span<const unsigned>> lists) {
  const std::vector<list_edge> all = sorted_edges(lists);
  list_fault fault = list_fault::none;
  std::ptrdiff_t chi = static_cast<std::ptrdiff_t>(lists.size());
  for_each_equal(all, [&](std::size_t i, std::size_t j) {
    --chi;
    if (j - i != 2) fault = list_fault::not_a_disk;
    else if (all[i].ascends == all[i + 1].ascends && fault == list_fault::none) fault = list_fault::winding;
  });
  if (fault != list_fault::none) return fault;
  std::vector<unsigned> verts, part;
  for (const auto& list : lists) verts.insert(verts.end(), list.begin(), list.end());
  chi += static_cast<std::ptrdiff_t>(sorted_list(verts).size());
  return chi == 2 && find_parts(lists, {}, part) == 1 ? list_fault::none : list_fault::not_a_disk;
}

}  // namespace concino::detail
