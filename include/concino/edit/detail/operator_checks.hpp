// What operators share: checks of their input, and the cavity of splits.
#pragma once

#include <concino/edit/detail/cavity_builder.hpp>

namespace concino::detail {

/// Replaces each old poly of c by one for each of the `n` verts `split`, in which the new vert takes the place of that vert.
template<class M>
void split_old_polys(cavity_builder<M>& c, const unsigned* split, unsigned n) {
  for (unsigned i = 0; i < n; ++i)
    for (unsigned k = 0; k < c.num_old(); ++k) c.add_new(k, split[i], cavity_builder<M>::added);
  c.split_at(split, n);
  c.keep(c.num_old());
}

/// Errors: invalid_mesh if x is not an element of m.
template<class M, class X>
void check_element(const M& m, const X& x, const char* edit, const char* kind) {
  if (!contains(m, x)) core::throw_joined<invalid_mesh>({edit, ": ", kind, " ", index_of(m, x), " is not ", *kind == 'e' ? "an " : "a ", kind, " of the mesh"});
}

/// Errors: invalid_argument if x is not finite.
inline void check_point(const vec3& x, const char* edit) {
  if (!is_finite(x)) core::throw_joined<invalid_argument>({edit, ": the point is not finite"});
}

inline constexpr permission not_simplices{refusal::not_simplices, "a poly at the element is not a triangle or a tet"};

}  // namespace concino::detail
