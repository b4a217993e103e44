// What operators share: checks of their input, and the cavity of splits.
#pragma once

#include <concino/edit/detail/cavity_builder.hpp>

#include <algorithm>
#include <array>
#include <vector>

namespace concino::detail {

/// Replaces each old poly of c by one for each of the `n` verts `split`, in which the new vert takes the place of that
/// vert.
template<class M>
void split_old_polys(cavity_builder<M>& c, const unsigned* split, unsigned n) {
  for (unsigned i = 0; i < n; ++i)
    for (unsigned k = 0; k < c.num_old(); ++k) c.add_new(k, split[i], cavity_builder<M>::added);
  c.split_at(split, n);
  c.keep(c.num_old());
}

inline constexpr permission polys_on_same_verts{refusal::same_verts, "two polys have, or would have, the same verts"};

/// Whether two old polys of c have the same verts. If they are split, edges that were different ones become one.
template<class M>
bool has_repeated_polys(const cavity_builder<M>& c) {
  constexpr unsigned few = 16, size = cavity_builder<M>::size;
  const unsigned n = c.num_old();
  if (n <= few) {
    for (unsigned k = 1; k < n; ++k)
      for (unsigned j = 0; j < k; ++j)
        if (std::all_of(c.corners(k), c.corners(k) + size, [&](unsigned v) { return c.has(j, v); })) return true;
    return false;
  }
  std::vector<std::array<unsigned, size>> all(n);
  for (unsigned k = 0; k < n; ++k) {
    std::copy_n(c.corners(k), size, all[k].begin());
    std::sort(all[k].begin(), all[k].end());
  }
  std::sort(all.begin(), all.end());
  return std::adjacent_find(all.begin(), all.end()) != all.end();
}

/// Errors: invalid_mesh if x is not an element of m.
template<class M, class X>
void check_element(const M& m, const X& x, const char* edit, const char* kind) {
  if (!contains(m, x))
    core::throw_joined<invalid_mesh>(
        {edit, ": ", kind, " ", index_of(m, x), " is not ", *kind == 'e' ? "an " : "a ", kind, " of the mesh"});
}

/// Errors: invalid_argument if x is not finite.
inline void check_point(const vec3& x, const char* edit) {
  if (!is_finite(x)) core::throw_joined<invalid_argument>({edit, ": the point is not finite"});
}

inline constexpr permission not_simplices{refusal::not_simplices, "a poly at the element is not a triangle or a tet"};

}  // namespace concino::detail
