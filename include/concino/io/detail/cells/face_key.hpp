// A number that faces with the same verts have in common, in any order, and others almost never.
#pragma once

#include <concino/concepts/descriptors.hpp>

#include <cstddef>
#include <cstdint>

namespace concino::detail {

inline std::uint64_t face_key(const vert_id* v, std::size_t n) {
  std::uint64_t key = n;
  for (std::size_t i = 0; i < n; ++i) {
    std::uint64_t x = (std::uint64_t{v[i].raw()} + 1) * 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 31)) * 0xbf58476d1ce4e5b9u;
    key += x ^ (x >> 29);
  }
  return key;
}

}  // namespace concino::detail
