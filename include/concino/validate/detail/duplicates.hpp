// Finds elements with the same verts, in any order and direction.
#pragma once

#include <concino/core/hash_bytes.hpp>
#include <concino/core/index_table.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

#include <concino/concepts/mesh.hpp>

namespace concino::detail {

/// Calls found(x, y) for each x of the range `all` whose verts, ring(x), form the same set as those of an earlier
/// element y.
/// Cost: expected linear in the verts of all rings: sets are compared only if 32-bit hashes agree.
template<class X, class M, class R, class Ring, class Found>
void find_duplicates(const M& m, const R& all, std::size_t count, const Ring& ring, const Found& found) {
  core::index_table by_hash;
  std::vector<X> different;
  different.reserve(count);
  std::vector<std::uint64_t> visited(vert_index_bound(m));  // by vert: 2 c and 2 c + 1 mark the verts of the sets of
                                                        // comparison c
  std::uint64_t comparison = 0;
  const auto same_verts = [&](const X& x, const X& y) {
    const std::uint64_t in_x = 2 * ++comparison, in_both = in_x + 1;
    std::size_t left = 0;
    for (const vert_t<M> v : ring(x)) {
      std::uint64_t& at = visited[index_of(m, v)];
      left += at != in_x;
      at = in_x;
    }
    for (const vert_t<M> v : ring(y)) {
      std::uint64_t& at = visited[index_of(m, v)];
      if (at != in_x && at != in_both) return false;
      left -= at == in_x;
      at = in_both;
    }
    return left == 0;
  };

  for (const X x : all) {
    std::uint64_t hash = 0, n = 0;
    for (const vert_t<M> v : ring(x)) {
      hash += core::scrambled(index_of(m, v));
      ++n;
    }
    const std::uint32_t key = core::index_table::hash(core::scrambled(hash ^ n));
    const std::uint32_t earlier = by_hash.find(key, [&](std::uint32_t i) { return same_verts(x, different[i]); });
    if (earlier != core::index_table::none) {
      found(x, different[earlier]);
    } else {
      by_hash.add(key, static_cast<std::uint32_t>(different.size()));
      different.push_back(x);
    }
  }
}

}  // namespace concino::detail
