// Bodies of vert_parts.hpp: the two parts into which marked facets divide the polys at one of their verts.
#pragma once

#include <concino/layout/detail/vert_parts.hpp>

#include <algorithm>

namespace concino::detail {

CONCINO_INLINE void vert_parts::find_facets() {
  const unsigned n = m_.t.num_corners();
  for (std::uint32_t i = 0; i < num_polys(); ++i)
    for (unsigned axis = 0; axis < m_.t.dimension; ++axis)
      facets_.emplace_back(m_.t.facet(corner(i) / n, 2 * axis + (corner(i) % n >> axis & 1)), i);
  std::sort(facets_.begin(), facets_.end());
}

CONCINO_INLINE void vert_parts::unite_through_facets() {
  for (std::size_t i = 0, next; i < facets_.size(); i = next) {
    const std::uint32_t f = facets_[i].first;
    for (next = i + 1; next < facets_.size() && facets_[next].first == f; ++next)
      if (!m_.is_marked[f]) nodes_.unite(facets_[i].second, facets_[next].second);
    if (next > i + 1) continue;
    const auto outside = static_cast<std::uint32_t>(nodes_.add());
    beyond_.emplace_back(f, outside);
    if (!m_.is_marked[f]) nodes_.unite(facets_[i].second, outside);
  }
}

/// Beyond two facets at the boundary that meet at a ridge is one outside, unless the marked facets go out there.
CONCINO_INLINE void vert_parts::unite_outside() {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> at_ridges;
  for (const auto& [f, outside] : beyond_) {
    std::uint32_t entries[4];
    const unsigned count = m_.t.ridges_of(f, entries);
    for (unsigned k = 0; k < count; ++k) {
      const std::uint32_t p = entries[k] / m_.t.num_poly_ridges(), r = m_.t.poly_ridges()[entries[k]];
      bool is_at_vert = m_.t.dimension == 2 && r == v_;
      if (m_.t.dimension == 3) {
        const unsigned place = entries[k] % 12, axis = place >> 2, rest = place & 3, low = (1u << axis) - 1;
        const unsigned first = (rest & low) | ((rest & ~low) << 1);
        is_at_vert = m_.t.cell(p, 0, first) == v_ || m_.t.cell(p, 0, first | 1u << axis) == v_;
      }
      if (is_at_vert) at_ridges.emplace_back(r, outside);
    }
  }
  std::sort(at_ridges.begin(), at_ridges.end());
  for (std::size_t i = 0, next; i < at_ridges.size(); i = next) {
    for (next = i + 1; next < at_ridges.size() && at_ridges[next].first == at_ridges[i].first; ++next) {}
    if (next == i + 2 && m_.num_marked_at[at_ridges[i].first] != 1)
      nodes_.unite(at_ridges[i].second, at_ridges[i + 1].second);
  }
}

CONCINO_INLINE vert_parts::vert_parts(const marked_patch& m, std::uint32_t v)
    : m_(m), v_(v), nodes_(m.at_verts.count(v)) {
  find_facets();
  unite_through_facets();
  unite_outside();
  std::uint32_t num_parts = 0;
  for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
    root_.push_back(static_cast<std::uint32_t>(nodes_.root(i)));
    num_parts += root_[i] == i;
    if (i < num_polys()) has_polys[part(i)] = true;
  }
  are_two = num_parts == 2;
  const auto beyond = [&](std::uint32_t f) {  // they are in the order of the facets
    const auto at = std::lower_bound(beyond_.begin(), beyond_.end(), std::pair{f, 0u});
    return at != beyond_.end() && at->first == f ? at->second : ~0u;
  };
  for (std::size_t i = 0; i < facets_.size(); ++i) {
    const auto [f, p] = facets_[i];
    const std::uint32_t outside = beyond(f);
    if (outside != ~0u && !m_.is_marked[f]) has_boundary[part(p)] = true;
    if (!m_.is_marked[f]) continue;
    const bool has_next = i + 1 < facets_.size() && facets_[i + 1].first == f;
    const bool is_second = i > 0 && facets_[i - 1].first == f;
    const std::uint32_t other = outside != ~0u ? outside : facets_[has_next ? i + 1 : i - is_second].second;
    are_two = are_two && root_[p] != root_[other];
  }
}

/// Twice the way to the mean of the centres of cells at the vert: in a grid, that of one edge inwards.
CONCINO_INLINE vec3 vert_parts::inward(const std::vector<std::uint32_t>& polys, bool at_boundary) const {
  const unsigned last = m_.t.num_corners() - 1;
  vec3 sum;
  double count = 0;
  const auto add = [&](std::uint32_t p, unsigned axes, unsigned place) {
    vec3 centre;
    for (unsigned k = 0; k <= last; ++k)
      if ((k & ~axes) == (place & ~axes)) centre += m_.points[m_.t.cell(p, 0, k)];
    sum += centre / static_cast<double>(m_.t.dimension == 2 ? (axes == 3 ? 4 : 2) : (axes == 7 ? 8 : 4));
    ++count;
  };
  for (const std::uint32_t c : polys) {
    const std::uint32_t p = c / (last + 1), place = c % (last + 1);
    if (!at_boundary) add(p, last, place);
    for (unsigned axis = 0; at_boundary && axis < m_.t.dimension; ++axis) {
      const std::uint32_t f = m_.t.facet(p, 2 * axis + (place >> axis & 1));
      if (m_.boundary.facets[f] && !m_.is_marked[f]) add(p, last ^ 1u << axis, place);
    }
  }
  return count > 0 ? 2 * (sum / count - m_.points[v_]) : vec3{};
}

CONCINO_INLINE vec3 vert_parts::into(unsigned wanted) const {
  const unsigned n = m_.t.num_corners();
  std::vector<std::uint32_t> polys;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ways;  // edges that no marked facet has, once for each poly, and
                                                              // their ends
  for (std::uint32_t i = 0; i < num_polys(); ++i) {
    if (part(i) != wanted) continue;
    polys.push_back(corner(i));
    const std::uint32_t p = corner(i) / n, place = corner(i) % n;
    for (unsigned axis = 1; axis < n; axis *= 2) {
      const std::uint32_t e = m_.t.cell(p, axis, place & ~axis);
      if (m_.has_mark(e)) continue;
      ways.emplace_back(e, m_.t.cell(p, 0, place ^ axis));
    }
  }
  std::sort(ways.begin(), ways.end());
  int best = -1;
  vec3 sum;
  double count = 0;
  for (std::size_t i = 0, next; i < ways.size(); i = next) {
    for (next = i + 1; next < ways.size() && ways[next].first == ways[i].first; ++next) {}
    int rank = 0;  // along edges of the boundary's shape, if there are some; else along it
    if (has_boundary[wanted] && m_.boundary.edges[ways[i].first]) rank = m_.t.dimension == 3 && next != i + 2 ? 2 : 1;
    if (rank < best) continue;
    if (rank > best) best = rank, sum = {}, count = 0;
    sum += m_.points[ways[i].second], ++count;
  }
  if (count == 0 || (best <= 0 && has_boundary[wanted])) return inward(polys, has_boundary[wanted]);
  return sum / count - m_.points[v_];
}

}  // namespace concino::detail
