// Lists of the simplices of links.
#pragma once

#include <concino/core/small_array.hpp>

#include <algorithm>
#include <array>
#include <cstdint>

namespace concino::detail {

/// A simplex of N verts: their local numbers, sorted.
template<std::size_t N> using local_simplex = std::array<unsigned, N>;
template<std::size_t N> using simplex_list = core::small_array<local_simplex<N>, 32>;

/// Simplices with their weights, if these are not all 1.
template<std::size_t N>
struct weighted_simplices {
  simplex_list<N> simplices;
  core::small_array<unsigned, 32> weights;
};

/// Appends `corners` without the verts a and b.
template<std::size_t N>
void add_link_simplex(simplex_list<N>& all, const unsigned* corners, unsigned size, unsigned a, unsigned b) {
  local_simplex<N> s{};
  unsigned n = 0;
  for (unsigned i = 0; i < size && n < N; ++i) {  // there are N others
    if (corners[i] == a || corners[i] == b) continue;
    unsigned k = n++;
    for (; k > 0 && s[k - 1] > corners[i]; --k) s[k] = s[k - 1];
    s[k] = corners[i];
  }
  all.push_back(s);
}

/// The simplices of one vert less, apart from those that have exactly two simplices of `all`, which have the same
/// weight. Their weights are the sums of those of their simplices.
template<std::size_t N>
void find_odd_facets(const simplex_list<N>& all, const unsigned* weights, weighted_simplices<N - 1>& odd) {
  static_assert(N <= 3);
  struct entry {
    std::uint64_t key;
    unsigned weight;
    bool operator<(const entry& x) const { return key < x.key; }
  };
  core::small_array<entry, 96> entries;
  for (std::size_t k = 0; k < all.size(); ++k)
    for (unsigned left_out = 0; left_out < N; ++left_out) {
      std::uint64_t key = 0;
      for (unsigned i = 0; i < N; ++i)
        if (i != left_out) key = key << 32 | all[k][i];
      entries.push_back({key, weights ? weights[k] : 1});
    }
  std::sort(entries.begin(), entries.end());
  for (std::size_t i = 0, j = 0; i < entries.size(); i = j) {
    unsigned weight = 0;
    for (; j < entries.size() && entries[j].key == entries[i].key; ++j) weight += entries[j].weight;
    if (j - i == 2 && entries[i].weight == entries[i + 1].weight) continue;
    local_simplex<N - 1> s{};
    for (unsigned k = 0; k < N - 1; ++k) s[k] = static_cast<unsigned>(entries[i].key >> 32 * (N - 2 - k));
    odd.simplices.push_back(s);
    odd.weights.push_back(weight);
  }
}

}  // namespace concino::detail
