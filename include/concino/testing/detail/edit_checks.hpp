// Edits a mesh into the states that conformance() checks, and checks KIT4 and KIT6.
#pragma once

#include <concino/core/message.hpp>
#include <concino/edit/elements.hpp>
#include <concino/testing/detail/adjacencies.hpp>
#include <concino/validate/broken_law.hpp>

#include <string>
#include <vector>

namespace concino::testing::detail {

/// KIT4: set_point moves its vert and no other.
template<MutablePoints M>
void check_point_edits(M& m, concino::detail::law_log& log) {
  // numbers that floats represent exactly
  const auto new_point = [](std::size_t i) {
    return vec3{static_cast<double>(i * 7 % 97) / 4, static_cast<double>(i * 3 % 89) / 4,
                static_cast<double>(i % 83) / 4};
  };
  for (const vert_t<M> v : verts(m)) traits<M>::set_point(m, v, new_point(index_of(m, v)));
  for (const vert_t<M> v : verts(m)) {
    const std::size_t i = index_of(m, v);
    if (to_vec3(point(m, v)) != new_point(i))
      log.add("KIT4", concino::core::joined({"point(", name('v', i), ") is not the point that set_point has set"}),
              name('v', i));
  }
}

/// Removes every third poly. KIT6: the removed polys are gone, the others still exist.
template<class M>
void remove_polys(M& m, concino::detail::law_log& log) {
  std::vector<poly_t<M>> all, removed, remaining;
  for (const poly_t<M> p : polys(m)) all.push_back(p);
  for (std::size_t i = 0; i < all.size(); ++i) (i % 3 == 0 ? removed : remaining).push_back(all[i]);
  for (const poly_t<M>& p : removed) traits<M>::remove_poly(m, p);
  if (num_polys(m) != remaining.size())
    log.add("KIT6",
            concino::core::joined(
                {removed.size(), " of ", all.size(), " polys were removed, but num_polys is ", num_polys(m)}),
            "");
  for (const poly_t<M>& p : remaining)
    if (!contains(m, p))
      log.add("KIT6",
              concino::core::joined({name('p', index_of(m, p)), " no longer exists after other polys were removed"}),
              name('p', index_of(m, p)));
  for (const poly_t<M>& p : removed)
    if (contains(m, p)) log.add("KIT6", "a removed poly still exists", name('p', index_of(m, p)));
}

/// Adds a poly with new verts. KIT6: the poly exists and has these verts.
template<class M>
void add_one(M& m, concino::detail::law_log& log) {
  constexpr int n = arity_v<M> ? arity_v<M> : 3;
  static constexpr double corner[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                          {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  std::vector<vert_t<M>> corners;
  for (int i = 0; i < n; ++i) {
    const double* const x = corner[n == 4 && dimension_v<M> == 3 && i == 3 ? 4 : i];
    corners.push_back(traits<M>::add_vert(m, vec3{50 + x[0], x[1], x[2]}));
  }
  const poly_t<M> p = traits<M>::add_poly(m, std::span<const vert_t<M>>(corners));
  if (!contains(m, p)) log.add("KIT6", "add_poly returned a poly that is not in the mesh", name('p', index_of(m, p)));
  for (const vert_t<M>& v : corners) {
    bool found = false;
    for (const vert_t<M> w : adj_p2v(m, p)) found = found || w == v;
    if (!found)
      log.add("KIT6", concino::core::joined({"the poly that add_poly returned lacks ", name('v', index_of(m, v))}),
              name('p', index_of(m, p)));
  }
}

}  // namespace concino::testing::detail
