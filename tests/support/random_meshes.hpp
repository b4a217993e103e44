// Small random meshes of every kind: random polys, polys attached to facets of others, and grids with holes. Some are open or disconnected, some
// have edges and faces with many polys, isolated verts, or gaps in the indices.
#pragma once

#include <concino/edit/elements.hpp>

#include <support/soups.hpp>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <random>
#include <vector>

namespace concino::testing {

/// The verts of a random facet of a poly, in order: two of a polygon, three of a tet, four of a hex.
template<class M>
std::vector<unsigned> some_side(std::mt19937& random, const std::vector<unsigned>& poly) {
  const auto pick = [&](std::initializer_list<std::size_t> at) {
    std::vector<unsigned> side;
    for (const std::size_t i : at) side.push_back(poly[i]);
    return side;
  };
  if constexpr (std::same_as<M, tetmesh>) {
    const std::array<std::array<std::size_t, 3>, 4> sides = {{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
    const auto& s = sides[random() % 4];
    return pick({s[0], s[1], s[2]});
  } else if constexpr (std::same_as<M, hexmesh>) {
    const std::array<std::array<std::size_t, 4>, 6> sides = {{{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
    const auto& s = sides[random() % 6];
    return pick({s[0], s[1], s[2], s[3]});
  } else {
    const std::size_t i = random() % poly.size();
    return pick({i, (i + 1) % poly.size()});
  }
}

/// Each poly except the first contains a facet of an earlier one; its other verts are random.
template<class M>
M random_pile(std::mt19937& random, unsigned vert_count, unsigned poly_count) {
  soup<M> s = random_soup<M>(random, vert_count, poly_count);
  if constexpr (!std::same_as<M, polyhedralmesh>) {  // the soup of polyhedra shares faces anyway
    for (std::size_t p = 1; p < s.verts.size(); ++p) {
      auto ring = some_side<M>(random, s.verts[random() % p]);
      for (const unsigned v : some_of(random, vert_count, vert_count))
        if (ring.size() < s.verts[p].size() && std::count(ring.begin(), ring.end(), v) == 0) ring.push_back(v);
      s.verts[p] = ring;
    }
  }
  return s.mesh();
}

/// A grid, or two disjoint grids and an isolated vert, without about one poly in four.
template<class M>
M random_holes(std::mt19937& random) {
  const unsigned n = dimension_v<M> == 2 ? 2 + static_cast<unsigned>(random() % 2) : 1 + static_cast<unsigned>(random() % 2);
  M m = n == 1 || random() % 3 == 0 ? two_grids<M>(1) : grid<M>(n);
  std::vector<poly_id> gone;
  for (const poly_id p : polys(m))
    if (random() % 4 == 0) gone.push_back(p);
  for (const poly_id p : gone) remove_poly(m, p);
  return m;
}

template<class M>
M random_mesh(std::mt19937& random) {
  const unsigned vert_count = 8 + static_cast<unsigned>(random() % 5), poly_count = 1 + static_cast<unsigned>(random() % 7);
  const auto make = [&] {
    switch (random() % 3) {
      case 0: return random_soup<M>(random, vert_count, poly_count).mesh();
      case 1: return random_pile<M>(random, vert_count, poly_count);
      default: return random_holes<M>(random);
    }
  };
  M m = make();
  if (random() % 4 == 0 && num_polys(m) > 0) remove_poly(m, *polys(m).begin());
  return m;
}

}  // namespace concino::testing
