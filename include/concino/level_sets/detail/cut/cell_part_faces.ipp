// Makes one face of equal ones, and lists the faces of each part; see cell_parts.hpp.
#pragma once

#include <concino/core/hash_bytes.hpp>
#include <concino/level_sets/detail/cut/cell_parts.hpp>
#include <concino/level_sets/detail/cut/level_states.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace concino::detail {

/// Makes one face of those with the same places, which parts without an inside leave behind.
CONCINO_INLINE void cell_parts::merge_equal_faces() {
  std::vector<std::uint64_t> order;
  order.reserve(faces.size());
  for (std::uint32_t i = 0; i < faces.size(); ++i) {
    std::uint64_t sum = 0;
    for (std::uint32_t k = faces[i].first; k < faces[i].last; ++k) sum += core::scrambled(face_places[k]);
    order.push_back(sum >> 32 << 32 | i);
  }
  std::sort(order.begin(), order.end());
  std::vector<std::uint32_t> merged(faces.size());
  std::vector<unsigned char> is_turned(faces.size(), 0);
  for (std::uint32_t i = 0; i < faces.size(); ++i) merged[i] = i;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto a = static_cast<std::uint32_t>(order[i]);
    for (std::size_t j = i + 1; merged[a] == a && j < order.size() && order[j] >> 32 == order[i] >> 32; ++j) {
      const auto b = static_cast<std::uint32_t>(order[j]);
      const int direction = merged[b] == b ? compare_places(faces[a], faces[b]) : 0;
      if (direction == 0) continue;
      merged[b] = a;
      is_turned[b] = direction < 0;
      faces[a].is_cut = faces[a].is_cut != faces[b].is_cut;
    }
  }
  for (use& u : uses_) {
    if (is_turned[u.face]) u.outward = !u.outward;
    u.face = merged[u.face];
  }
}

/// 1 if two faces have the same places in the same order, -1 if the order is opposite, else 0.
CONCINO_INLINE int cell_parts::compare_places(const face& a, const face& b) const {
  const std::uint32_t n = a.last - a.first;
  if (b.last - b.first != n) return 0;
  const std::uint32_t* const x = face_places.data() + a.first;
  const std::uint32_t* const y = face_places.data() + b.first;
  const auto start = static_cast<std::uint32_t>(std::find(y, y + n, x[0]) - y);
  if (start == n) return 0;
  bool same = true, opposite = true;
  for (std::uint32_t k = 1; k < n; ++k) {
    same = same && x[k] == y[(start + k) % n];
    opposite = opposite && x[k] == y[(start + n - k) % n];
  }
  return same ? 1 : opposite ? -1 : 0;
}

/// Lists the faces of each part. A face that a part uses twice, from both sides, is not one of its faces; a part
/// without faces has no inside.
CONCINO_INLINE void cell_parts::list_parts() {
  const std::uint32_t num_roots = cuts_.num_cell_verts();
  std::vector<std::uint32_t> ends(num_roots + std::size_t{1}, 0);  // by part: where its uses begin in `sorted`, then
                                                                   // where they end
  for (const use& u : uses_) ++ends[u.part + std::size_t{1}];
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  std::vector<use> sorted(uses_.size()), of_part;
  for (const use& u : uses_) sorted[ends[u.part]++] = u;
  part_faces.reserve(uses_.size()), outward.reserve(uses_.size());
  std::vector<std::uint32_t> cell_of_vert(cuts_.num_cell_verts(), none);
  for (std::uint32_t k = 0; k < v_.num_corners(); ++k)
    cell_of_vert[cuts_.number_in_cells(k)] = cuts_.cell_of(cuts_.facet_of(k));
  for (std::uint32_t root = 0, i = 0; root < num_roots; ++root) {
    of_part.clear();
    for (; i < ends[root]; ++i) {
      const use& u = sorted[i];
      const auto twice = std::find_if(of_part.begin(), of_part.end(),
                                      [&](const use& x) { return x.face == u.face && x.outward != u.outward; });
      if (twice == of_part.end()) of_part.push_back(u);
      else of_part.erase(twice);
    }
    const std::size_t first = parts.size();
    for (std::size_t first_use = 0; first_use < of_part.size();) {
      part p{cell_of_vert[root], static_cast<std::uint32_t>(part_faces.size()), 0, is_above_[root] != 0, true};
      for (const std::size_t end = end_of_piece(of_part, first_use); first_use < end; ++first_use) {
        part_faces.push_back(of_part[first_use].face);
        outward.push_back(of_part[first_use].outward);
        p.is_whole = p.is_whole && faces[of_part[first_use].face].is_whole;
      }
      p.last = static_cast<std::uint32_t>(part_faces.size());
      parts.push_back(p);
    }
    if (parts.size() > first + 1)  // one whose faces are all whole is not the whole cell
      for (std::size_t k = first; k < parts.size(); ++k) parts[k].is_whole = false;
  }
}

}  // namespace concino::detail
