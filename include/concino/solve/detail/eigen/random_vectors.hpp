// Random vectors, always the same, with which the search for eigenvectors starts.
#pragma once

#include <concino/solve/detail/eigen/vector_block.hpp>

#include <Eigen/SparseCore>

#include <cstdint>

namespace concino::detail {

/// Numbers in [-1, 1) that depend only on row, column and seed.
inline void fill_with_noise(const column_range& x, Eigen::Index rows, std::uint64_t seed) {
  for (Eigen::Index i = 0; i < rows; ++i)
    for (Eigen::Index j = 0; j < x.columns; ++j) {
      // splitmix64
      std::uint64_t z = (seed << 56) + (static_cast<std::uint64_t>(j) << 40) + static_cast<std::uint64_t>(i) + 1;
      z *= 0x9e3779b97f4a7c15u;
      z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
      z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
      x.row(i)[j] = static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-52 - 1;
    }
}

}  // namespace concino::detail
