// Bodies of blocks.hpp: positions in blocks, which are found row by row.
#pragma once

#include <concino/layout/detail/block_mesh.hpp>

#include <algorithm>
#include <cstdlib>
#include <limits>

namespace concino::detail {

/// Gives the polys of one block after another their positions, which may be negative at first.
class block_search {
  using position = std::array<std::int32_t, 3>;

  const cube_tables& t_;
  block_tables& b_;
  std::vector<position> at_;            // by poly and place of the corner
  std::vector<std::uint32_t> members_;  // the polys of the block so far

  /// The axis of the block along which axis a of p runs.
  unsigned axis_of(std::uint32_t p, unsigned a) const {
    const position &x = at_[p << t_.dimension], &y = at_[(p << t_.dimension) + (1u << a)];
    unsigned axis = 0;
    while (x[axis] == y[axis]) ++axis;
    return axis;
  }
  /// Whether the facet `place` of p is at its upper, or lower, end along an axis of the block.
  bool leads(std::uint32_t p, unsigned place, unsigned axis, bool upwards) const {
    const unsigned bit = 1u << (place / 2), at = place & 1 ? bit : 0;
    const position* const x = at_.data() + p * t_.num_corners();
    return upwards ? x[at][axis] > x[at ^ bit][axis] : x[at][axis] < x[at ^ bit][axis];
  }
  /// Calls use(place of a corner of q, the position that it has if q continues p at the facet `place` of p).
  template<class Use>
  void for_each_continued(std::uint32_t p, unsigned place, std::uint32_t q, const Use& use) const {
    const unsigned a = place / 2, bit = 1u << a, end = place & 1, n = t_.num_corners();
    const unsigned there = t_.place_of_facet(q, t_.facet(p, place)), bit_there = 1u << (there / 2);
    for (unsigned k = 0; k < n; ++k) {
      if ((k >> a & 1) != end) continue;
      const std::uint32_t v = t_.poly_verts[p * n + k];
      unsigned j = there & 1 ? bit_there : 0;
      while ((j >> (there / 2) & 1) != (there & 1) || t_.poly_verts[q * n + j] != v) ++j;
      position x = at_[p * n + k];
      use(j, x);
      for (unsigned i = 0; i < t_.dimension; ++i) x[i] += x[i] - at_[p * n + (k ^ bit)][i];
      use(j ^ bit_there, x);
    }
  }
  void add(std::uint32_t p, std::uint32_t block) {
    b_.block[p] = block;
    members_.push_back(p);
  }
  /// Adds what continues the members in one direction of an axis, or in any.
  void continue_along(unsigned axis, bool upwards, bool any = false) {
    const std::uint32_t block = b_.block[members_[0]];
    for (std::size_t i = 0; i < members_.size(); ++i)
      for (unsigned place = 0; place < t_.num_poly_facets(); ++place) {
        const std::uint32_t p = members_[i], f = t_.facet(p, place);
        if (b_.is_interface[f] || !(any || leads(p, place, axis, upwards))) continue;
        const std::uint32_t q = t_.other_poly(p, f);
        if (b_.block[q] != t_.none) continue;
        for_each_continued(p, place, q, [&](unsigned k, const position& x) { at_[q * t_.num_corners() + k] = x; });
        add(q, block);
      }
  }
  void end_block(layout_block& block) {
    position low, high;
    low.fill(std::numeric_limits<std::int32_t>::max()), high.fill(std::numeric_limits<std::int32_t>::min());
    const unsigned n = t_.num_corners(), d = t_.dimension;
    for (const std::uint32_t p : members_)
      for (unsigned k = 0; k < n; ++k)
        for (unsigned i = 0; i < d; ++i) {
          low[i] = std::min(low[i], at_[p * n + k][i]);
          high[i] = std::max(high[i], at_[p * n + k][i]);
        }
    for (const std::uint32_t p : members_) {
      for (unsigned place = 0; place < t_.num_poly_facets(); ++place) {
        if (b_.is_interface[t_.facet(p, place)]) continue;
        const std::uint32_t q = t_.other_poly(p, t_.facet(p, place));
        for_each_continued(p, place, q, [&](unsigned k, const position& x) {
          if (x != at_[q * n + k]) block.periodic[axis_of(p, place / 2)] = true;
        });
      }
      for (unsigned k = 0; k < n; ++k)
        for (unsigned i = 0; i < d; ++i)
          b_.positions[p * n + k][i] = static_cast<std::uint32_t>(at_[p * n + k][i] - low[i]);
    }
    for (unsigned i = 0; i < d; ++i) block.size[i] = static_cast<std::uint32_t>(high[i] - low[i]);
    for (const bool x : block.periodic) b_.is_periodic = b_.is_periodic || x;
  }

 public:
  block_search(const cube_tables& t, block_tables& b) : t_(t), b_(b), at_(t.poly_verts.size()) {
    b_.block.assign(t.num_polys(), t.none);
    b_.positions.assign(t.poly_verts.size(), {});
  }

  void find_all() {
    const unsigned n = t_.num_corners();
    for (std::uint32_t p = 0; p < t_.num_polys(); ++p) {
      if (b_.block[p] != t_.none) continue;
      members_.clear();
      for (unsigned k = 0; k < n; ++k)
        at_[p * n + k] = {static_cast<std::int32_t>(k & 1), static_cast<std::int32_t>(k >> 1 & 1),
                          static_cast<std::int32_t>(k >> 2)};
      add(p, static_cast<std::uint32_t>(b_.blocks.size()));
      for (unsigned axis = 0; axis < t_.dimension; ++axis)  // one direction first: round a periodic block, all rows
        continue_along(axis, true), continue_along(axis, false);  // then end at the same place
      continue_along(0, true, true);  // of a block that exchanges its axes on the way round, some are left
      end_block(b_.blocks.emplace_back());
    }
  }
};

CONCINO_INLINE block_tables find_blocks(const cube_tables& t) {
  block_tables b;
  b.is_interface = find_interfaces(t);
  block_search(t, b).find_all();
  find_block_mesh(t, b);
  return b;
}

}  // namespace concino::detail
