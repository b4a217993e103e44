// The link condition: whether collapsing an edge of triangles or tets keeps the topology, boundaries and non-manifold
// parts.
#pragma once

#include <concino/edit/detail/link_orders.hpp>

namespace concino::detail {

/// The faces of at least two verts, all of them marked. Shorter ones are filled up with the last vert.
template<std::size_t N, std::size_t K>
void add_marked_faces(const simplex_list<K>& all, const core::small_array<unsigned char, 64>& mark,
                      unsigned char wanted, simplex_list<N>& faces) {
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

/// Whether each simplex that is in the closure of `a` and in that of `b` is in the closure of `ab`. Local numbers are
/// below num_verts.
template<std::size_t N>
bool common_faces_are_in(const simplex_list<N>& a, const simplex_list<N>& b, const simplex_list<N - 1>& ab,
                         unsigned num_verts) {
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
      if (std::binary_search(of_b.begin(), of_b.end(), s) && !std::binary_search(of_ab.begin(), of_ab.end(), s))
        return false;
  }
  return true;
}

/// Whether the edge ab of simplices of N + 1 verts can be collapsed, by the links of a, b and ab: at least one simplex
/// is at it, none twice, and for every simplex s of the links, the order of abs is not larger than those of as and bs
/// both. This is certain if one of the ends has order 0.
/// Source: Dey, Edelsbrunner, Guha and Nekhayev 1999, "Topology preserving edge contraction".
template<std::size_t N>
bool can_collapse(const simplex_list<N>& a, const simplex_list<N>& b, simplex_list<N - 1>& ab, unsigned num_verts) {
  std::sort(ab.begin(), ab.end());
  if (ab.empty() || std::adjacent_find(ab.begin(), ab.end()) != ab.end() ||
      !common_faces_are_in<N>(a, b, ab, num_verts))
    return false;
  return is_sphere<N>(a, num_verts) || is_sphere<N>(b, num_verts) || orders_allow_collapse(a, b, ab, num_verts);
}

}  // namespace concino::detail
