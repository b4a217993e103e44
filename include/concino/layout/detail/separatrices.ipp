// Bodies of blocks.hpp: interfaces and separatrices.
#pragma once

#include <concino/layout/detail/blocks.hpp>

namespace concino::detail {

/// Calls f for each facet with two polys in the fans at r that are not regular, twice.
template<class F>
void for_each_start_at(const cube_tables& t, const ridge_fans& fans, std::uint32_t r, const F& f) {
  for (std::size_t n = 0; n < t.at_ridges.count(r); ++n) {
    const std::uint32_t entry = t.at_ridges.entry(r, n), p = entry / t.num_poly_ridges();
    if (!fans.is_irregular[entry]) continue;
    const auto [a, b] = t.facets_at(entry % t.num_poly_ridges());
    for (const std::uint32_t x : {t.facet(p, a), t.facet(p, b)})
      if (t.at_facets.count(x) == 2) f(x);
  }
}

/// Visits the facets that continue those in `stack` through crossings, each that visit(facet) says is new.
template<class Visit>
void continue_facets(const cube_tables& t, const ridge_fans& fans, std::vector<std::uint32_t>& stack,
                     const Visit& visit) {
  std::uint32_t entries[4];
  while (!stack.empty()) {
    const std::uint32_t f = stack.back();
    stack.pop_back();
    const unsigned n = t.ridges_of(f, entries);
    for (unsigned k = 0; k < n; ++k)
      if (fans.is_crossing[entries[k]])
        if (const std::uint32_t g = t.opposite_at(f, t.poly_ridges()[entries[k]]); visit(g)) stack.push_back(g);
  }
}

CONCINO_INLINE std::vector<unsigned char> find_interfaces(const cube_tables& t) {
  const ridge_fans fans(t);
  std::vector<unsigned char> is_interface(t.num_facets);
  std::vector<std::uint32_t> stack;
  const auto mark = [&](std::uint32_t f) {
    if (is_interface[f]) return false;
    is_interface[f] = 1;
    return true;
  };
  for (std::uint32_t r = 0; r < t.num_ridges(); ++r)
    for_each_start_at(t, fans, r, [&](std::uint32_t f) {
      if (mark(f)) stack.push_back(f);
    });
  continue_facets(t, fans, stack, mark);
  for (std::uint32_t f = 0; f < t.num_facets; ++f)
    if (const std::size_t n = t.at_facets.count(f); n == 1 || n > 2) is_interface[f] = 1;
  return is_interface;
}

/// The walk from r along f. It ends at an irregular vert or at the boundary.
inline separatrix_facets walk_from(const cube_tables& t, const ridge_fans& fans, std::uint32_t r, std::uint32_t f,
                                   std::vector<unsigned char>& is_known) {
  separatrix_facets walk{{}, {r}};
  for (;;) {
    std::uint32_t ends[4];
    t.ridges_of(f, ends);
    is_known[f] = 1;
    const std::uint32_t end = t.poly_ridges()[ends[0]] == r ? ends[1] : ends[0];
    r = t.poly_ridges()[end];
    walk.facets.push_back(f), walk.ridges.push_back(r);
    if (!fans.is_crossing[end]) return walk;
    f = t.opposite_at(f, r);
  }
}

CONCINO_INLINE std::vector<separatrix_facets> find_separatrices(const cube_tables& t) {
  const ridge_fans fans(t);
  std::vector<separatrix_facets> all;
  std::vector<unsigned char> is_known(t.num_facets);
  std::vector<std::uint32_t> stack;
  for (std::uint32_t r = 0; r < t.num_ridges(); ++r) {
    for_each_start_at(t, fans, r, [&](std::uint32_t f) {
      if (is_known[f]) return;
      if (t.dimension == 2) return all.push_back(walk_from(t, fans, r, f, is_known));
      separatrix_facets group{{f}, {}};
      is_known[f] = 1;
      stack.push_back(f);
      continue_facets(t, fans, stack, [&](std::uint32_t g) {
        if (is_known[g]) return false;
        is_known[g] = 1;
        group.facets.push_back(g);
        return true;
      });
      all.push_back(std::move(group));
    });
  }
  return all;
}

}  // namespace concino::detail
