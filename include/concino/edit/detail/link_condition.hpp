// The link condition: whether collapsing an edge of triangles or tets keeps the topology, boundaries and non-manifold parts.
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
  for (unsigned i = 0; i < size; ++i) {
    if (corners[i] == a || corners[i] == b) continue;
    unsigned k = n++;
    for (; k > 0 && s[k - 1] > corners[i]; --k) s[k] = s[k - 1];
    s[k] = corners[i];
  }
  all.push_back(s);
}

/// The simplices of one vert less, apart from those that have exactly two simplices of `all`, which have the same weight. Their weights are the sums of those
/// of their simplices.
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

/// The faces of at least two verts, all of them marked. Shorter ones are filled up with the last vert.
template<std::size_t N, std::size_t K>
void add_marked_faces(const simplex_list<K>& all, const core::small_array<unsigned char, 64>& mark, unsigned char wanted, simplex_list<N>& faces) {
  for (const local_simplex<K>& s : all)
    for (unsigned chosen = 1; chosen < 1u << K; ++chosen) {
      local_simplex<N> f{};
      unsigned n = 0;
      bool is_marked = true;
      for (unsigned i = 0; i < K; ++i)
        if (chosen >> i & 1) is_marked = is_marked && mark[s[i]] == wanted, f[n++] = s[i];
      if (!is_marked || n < 2) continue;
      for (; n < N; ++n) f[n] = f[n - 1];
      faces.push_back(f);
    }
}

/// Whether each simplex that is in the closure of `a` and in that of `b` is in the closure of `ab`. Local numbers are below num_verts.
template<std::size_t N>
bool common_faces_are_in(const simplex_list<N>& a, const simplex_list<N>& b, const simplex_list<N - 1>& ab, unsigned num_verts) {
  constexpr unsigned char in_all = 7;
  core::small_array<unsigned char, 64> mark(num_verts, 0);
  const auto set = [&](const auto& all, unsigned char bit) {
    for (const auto& s : all)
      for (const unsigned v : s) mark[v] = static_cast<unsigned char>(mark[v] | bit);
  };
  set(a, 1), set(b, 2), set(ab, 4);
  for (const unsigned char x : mark)
    if (x == 3) return false;
  if constexpr (N > 1) {
    simplex_list<N> of_a, of_b, of_ab;
    add_marked_faces(a, mark, in_all, of_a);
    if (of_a.empty()) return true;
    add_marked_faces(b, mark, in_all, of_b);
    if (of_b.empty()) return true;
    if constexpr (N > 2) add_marked_faces(ab, mark, in_all, of_ab);
    std::sort(of_b.begin(), of_b.end());
    std::sort(of_ab.begin(), of_ab.end());
    for (const local_simplex<N>& s : of_a)
      if (std::binary_search(of_b.begin(), of_b.end(), s) && !std::binary_search(of_ab.begin(), of_ab.end(), s)) return false;
  }
  return true;
}

/// The link condition for the links of the verts a and b and of the edge ab in a complex of simplices of N + 1 verts. Its odd facets are joined to an extra
/// vert, and must obey the link condition themselves. `weights`, of the simplices of a, of b and of ab, are null if all are 1.
/// Source: Dey, Edelsbrunner, Guha and Nekhayev 1999, "Topology preserving edge contraction".
template<std::size_t N>
bool links_meet_in_link_of_edge(const simplex_list<N>& a, const simplex_list<N>& b, const simplex_list<N - 1>& ab, const std::array<const unsigned*, 3>& weights, unsigned num_verts) {
  if (!common_faces_are_in<N>(a, b, ab, num_verts)) return false;
  weighted_simplices<N - 1> odd_a, odd_b;
  find_odd_facets<N>(a, weights[0], odd_a);
  if (odd_a.simplices.empty()) return true;
  find_odd_facets<N>(b, weights[1], odd_b);
  if (odd_b.simplices.empty()) return true;
  if constexpr (N == 1) {
    return false;
  } else {
    weighted_simplices<N - 2> odd_ab;
    find_odd_facets<N - 1>(ab, weights[2], odd_ab);
    return !odd_ab.simplices.empty() &&
           links_meet_in_link_of_edge<N - 1>(odd_a.simplices, odd_b.simplices, odd_ab.simplices, {odd_a.weights.data(), odd_b.weights.data(), odd_ab.weights.data()}, num_verts);
  }
}

/// Whether the edge of simplices of N + 1 verts with these links can be collapsed: at least one simplex is at it, none twice, and the link condition holds.
template<std::size_t N>
bool can_collapse(const simplex_list<N>& a, const simplex_list<N>& b, simplex_list<N - 1>& ab, unsigned num_verts) {
  std::sort(ab.begin(), ab.end());
  return !ab.empty() && std::adjacent_find(ab.begin(), ab.end()) == ab.end() && links_meet_in_link_of_edge<N>(a, b, ab, {}, num_verts);
}

}  // namespace concino::detail
