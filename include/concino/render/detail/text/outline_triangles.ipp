// Bodies of outline_triangles.hpp: triangles of plane outlines with holes.
#pragma once

#include <concino/geometry/orientation.hpp>
#include <concino/geometry/triangulate_polygon.hpp>
#include <concino/render/detail/text/outline_triangles.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace concino::detail {

using outline = std::vector<vec3>;

inline double signed_area(const outline& o) {
  double sum = 0;
  for (std::size_t i = 0, before = o.size() - 1; i < o.size(); before = i++)
    sum += (o[before].x - o[0].x) * (o[i].y - o[0].y) - (o[i].x - o[0].x) * (o[before].y - o[0].y);
  return sum / 2;
}

inline bool is_inside(const vec3& p, const outline& o) {
  bool inside = false;
  for (std::size_t i = 0, before = o.size() - 1; i < o.size(); before = i++) {
    const vec3 &a = o[before], &b = o[i];
    if ((a.y > p.y) != (b.y > p.y)) inside ^= (orient2d(a, b, p) > 0) == (b.y > a.y);
  }
  return inside;
}

inline bool same_place(const vec3& a, const vec3& b) { return a.x == b.x && a.y == b.y; }

/// Whether a segment meets an edge of the outline elsewhere than at its own ends.
inline bool meets_edge(const vec3& p, const vec3& q, const outline& o) {
  for (std::size_t i = 0, before = o.size() - 1; i < o.size(); before = i++) {
    const vec3 &a = o[before], &b = o[i];
    if (same_place(a, p) || same_place(a, q) || same_place(b, p) || same_place(b, q)) continue;
    if (std::max(a.x, b.x) < std::min(p.x, q.x) || std::max(p.x, q.x) < std::min(a.x, b.x)) continue;
    if (std::max(a.y, b.y) < std::min(p.y, q.y) || std::max(p.y, q.y) < std::min(a.y, b.y)) continue;
    if (orient2d(p, q, a) * orient2d(p, q, b) <= 0 && orient2d(a, b, p) * orient2d(a, b, q) <= 0) return true;
  }
  return false;
}

/// Whether the segment from corner i to p begins inside the outline.
inline bool begins_inside(const outline& o, std::size_t i, const vec3& p) {
  const vec3 &before = o[(i + o.size() - 1) % o.size()], &at = o[i], &after = o[(i + 1) % o.size()];
  if (orient2d(before, at, after) >= 0) return orient2d(at, p, before) > 0 && orient2d(p, at, after) > 0;
  return !(orient2d(at, p, after) >= 0 && orient2d(p, at, before) >= 0);
}

/// Joins a hole to its outline by an edge that is passed twice. Holes that extend farther to the right are joined
/// already: so the rightmost corner of this one sees a corner of the outline that is not left of it.
inline void join_hole(outline& o, const outline& hole) {
  const std::size_t from = static_cast<std::size_t>(
      std::max_element(hole.begin(), hole.end(), [](const vec3& a, const vec3& b) { return a.x < b.x; }) -
      hole.begin());
  const vec3 p = hole[from];
  std::vector<std::size_t> nearest;
  for (std::size_t i = 0; i < o.size(); ++i)
    if (o[i].x >= p.x) nearest.push_back(i);
  if (nearest.empty()) return;  // the hole is not inside
  std::stable_sort(nearest.begin(), nearest.end(),
                   [&](std::size_t i, std::size_t j) { return dot(o[i] - p, o[i] - p) < dot(o[j] - p, o[j] - p); });
  const auto seen = std::find_if(nearest.begin(), nearest.end(), [&](std::size_t i) {
    return begins_inside(o, i, p) && !meets_edge(p, o[i], o) && !meets_edge(p, o[i], hole);
  });
  const std::size_t to = seen == nearest.end() ? nearest.front() : *seen;
  outline bridge;
  for (std::size_t k = 0; k <= hole.size(); ++k) bridge.push_back(hole[(from + k) % hole.size()]);
  bridge.push_back(o[to]);
  o.insert(o.begin() + static_cast<std::ptrdiff_t>(to) + 1, bridge.begin(), bridge.end());
}

CONCINO_INLINE std::vector<std::array<vec3, 3>> outline_triangles(std::span<const std::vector<vec3>> outlines) {
  std::vector<double> areas;
  for (const outline& o : outlines) areas.push_back(o.size() < 3 ? 0 : signed_area(o));
  std::vector<std::vector<std::size_t>> holes(outlines.size());
  for (std::size_t h = 0; h < outlines.size(); ++h) {
    if (!(areas[h] < 0)) continue;
    std::size_t around = outlines.size();
    for (std::size_t o = 0; o < outlines.size(); ++o)
      if (areas[o] > 0 && (around == outlines.size() || areas[o] < areas[around]) &&
          is_inside(outlines[h][0], outlines[o]))
        around = o;
    if (around < outlines.size()) holes[around].push_back(h);
  }
  const auto right_end = [&](std::size_t h) {
    return std::max_element(outlines[h].begin(), outlines[h].end(),
                            [](const vec3& a, const vec3& b) { return a.x < b.x; })
        ->x;
  };
  std::vector<std::array<vec3, 3>> result;
  polygon_triangulator cut;
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    if (!(areas[i] > 0)) continue;
    outline o = outlines[i];
    std::stable_sort(holes[i].begin(), holes[i].end(),
                     [&](std::size_t g, std::size_t h) { return right_end(g) > right_end(h); });
    for (const std::size_t h : holes[i]) join_hole(o, outlines[h]);
    for (const auto& [a, b, c] : cut.from_above(o)) result.push_back({o[a], o[b], o[c]});
  }
  return result;
}

}  // namespace concino::detail
