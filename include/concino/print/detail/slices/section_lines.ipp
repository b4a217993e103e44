// Defines section_lines.hpp.
#pragma once

#include <concino/core/error.hpp>
#include <concino/print/detail/slices/section_lines.hpp>
#include <concino/print/planar_regions.hpp>

#include <algorithm>
#include <cmath>

namespace concino::detail {

/// Adds the polys of a line.
inline void add_polys(section_polys& to, const std::vector<std::uint32_t>& polys) {
  const std::size_t begin = to.polys.size();
  for (const std::uint32_t p : polys)
    if (to.polys.size() == begin || to.polys.back() != p) to.polys.push_back(p);
  while (to.polys.size() > begin + 1 && to.polys.back() == to.polys[begin]) to.polys.pop_back();
  to.ends.push_back(to.polys.size());
}

/// Leaves out points that repeat the one before, and spikes.
inline section_line cleaned(const section_line& line) {
  section_line c;  // a stack
  const auto take_back = [&] {
    c.points.pop_back();
    c.polys.pop_back();
  };
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    if (!c.points.empty() && c.points.back() == line.points[i]) {
      c.polys.back() = line.polys[i];
    } else if (c.points.size() > 1 && c.points[c.points.size() - 2] == line.points[i]) {
      take_back();
      c.polys.back() = line.polys[i];
    } else {
      c.add(line.points[i], line.polys[i]);
    }
  }
  std::size_t begin = 0;
  while (c.points.size() > begin + 1) {
    if (c.points.back() == c.points[begin]) {
      take_back();  // the last segment has no length
    } else if (c.points.size() > begin + 2 && c.points[begin + 1] == c.points.back()) {
      ++begin;  // a spike at the first point
      take_back();
    } else if (c.points.size() > begin + 2 && c.points[c.points.size() - 2] == c.points[begin]) {
      take_back();  // a spike at the last point
      take_back();
    } else {
      break;
    }
  }
  c.points.erase(c.points.begin(), c.points.begin() + static_cast<std::ptrdiff_t>(begin));
  c.polys.erase(c.polys.begin(), c.polys.begin() + static_cast<std::ptrdiff_t>(begin));
  return c;
}

CONCINO_INLINE void section_layer::add_contour(section_line line, std::int32_t id) {
  line = cleaned(line);
  const double area = contour_area(line.points);
  if (line.points.size() < 3 || area == 0) return;
  (area > 0 ? layer.outer : layer.inner).push_back(line.points, id);
  add_polys(area > 0 ? outer : inner, line.polys);
}

CONCINO_INLINE void section_layer::add_open(const section_line& line, std::int32_t id) {
  layer.open.push_back(line.points, id);
  add_polys(open, line.polys);
}

CONCINO_INLINE std::vector<std::vector<std::uint32_t>> simple_cycles(const std::vector<section_edge>& edges) {
  std::vector<std::uint32_t> order(edges.size());
  std::uint32_t num_verts = 0;
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    order[i] = i;
    num_verts = std::max({num_verts, edges[i].from + 1, edges[i].to + 1});
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t i, std::uint32_t j) { return edges[i].from < edges[j].from; });
  // by vert: its edges that are not taken, in order
  std::vector<std::uint32_t> next(num_verts + 1, 0), end(num_verts + 1, 0);
  for (std::uint32_t k = static_cast<std::uint32_t>(order.size()); k-- > 0;) next[edges[order[k]].from] = k;
  for (std::uint32_t k = 0; k < order.size(); ++k) end[edges[order[k]].from] = k + 1;

  constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);
  std::vector<std::uint32_t> position(num_verts, none), path;  // by vert: where the path leaves it
  std::vector<std::vector<std::uint32_t>> cycles;
  for (std::uint32_t start = 0; start < num_verts; ++start)
    for (std::uint32_t v = start; next[v] < end[v];) {
      const std::uint32_t e = order[next[v]++];
      position[v] = static_cast<std::uint32_t>(path.size());
      path.push_back(e);
      v = edges[e].to;
      if (position[v] == none) continue;
      const auto first = path.begin() + static_cast<std::ptrdiff_t>(position[v]);
      for (auto x = first; x != path.end(); ++x) position[edges[*x].from] = none;
      cycles.emplace_back(first, path.end());
      path.erase(first, path.end());
    }
  return cycles;
}

CONCINO_INLINE slice_point section_point(double x, double y) {
  const auto clear = [](double c) { return std::abs(c) < 1e-290 ? 0.0 : c; };
  return {clear(x), clear(y)};
}

CONCINO_INLINE void check_heights(const std::vector<double>& heights) {
  for (std::size_t i = 0; i < heights.size(); ++i)
    if (!std::isfinite(heights[i])) core::throw_joined<invalid_argument>({"slice_mesh: height ", i, " is not finite"});
}

}  // namespace concino::detail
