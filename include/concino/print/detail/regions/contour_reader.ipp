// Defines contour_reader.hpp.
#pragma once

#include <concino/core/error.hpp>
#include <concino/print/detail/regions/arrangement.hpp>
#include <concino/print/detail/regions/contour_reader.hpp>
#include <concino/print/detail/regions/disjoint_regions.hpp>

#include <algorithm>
#include <cmath>

namespace concino::detail {

CONCINO_INLINE const slice_lines& lines_of(const slice_layer& layer, slice_lines_kind kind) {
  switch (kind) {
    case slice_lines_kind::outer: return layer.outer;
    case slice_lines_kind::inner: return layer.inner;
    case slice_lines_kind::open: return layer.open;
    default: return layer.hatches;
  }
}

CONCINO_INLINE void add_layer(const char* caller, const slice_layer& layer, std::size_t index, planar_box& to) {
  for (const auto kind :
       {slice_lines_kind::outer, slice_lines_kind::inner, slice_lines_kind::open, slice_lines_kind::hatches}) {
    const slice_lines& lines = lines_of(layer, kind);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      for (const slice_point& p : lines[i]) {
        if (!std::isfinite(p[0]) || !std::isfinite(p[1]))
          core::throw_joined<invalid_argument>(
              {caller, ": ", contour_name(index, kind, i), " has a point that is not finite"});
        to.add(p);
      }
      if (kind == slice_lines_kind::hatches && lines[i].size() % 2 != 0)
        core::throw_joined<invalid_argument>(
            {caller, ": ", contour_name(index, kind, i), " has ", lines[i].size(), " points; hatches have two each"});
    }
  }
}

/// Twice the area within a path.
inline double twice_area(std::span<const snapped_point> path) {
  double sum = 0;
  for (std::size_t i = 2; i < path.size(); ++i) {
    const double ax = static_cast<double>(path[i - 1][0] - path[0][0]),
                 ay = static_cast<double>(path[i - 1][1] - path[0][1]);
    const double bx = static_cast<double>(path[i][0] - path[0][0]), by = static_cast<double>(path[i][1] - path[0][1]);
    sum += ax * by - ay * bx;
  }
  return sum;
}

CONCINO_INLINE void contour_reader::add_contours(const slice_lines& lines, slice_lines_kind kind,
                                                 lattice_paths& paths) {
  const bool is_outer = kind == slice_lines_kind::outer;
  std::vector<snapped_point> path;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    path.clear();
    for (const slice_point& p : lines[i])
      if (const snapped_point x = to_(p); path.empty() || path.back() != x) path.push_back(x);
    if (const auto all = lines[i]; all.size() > 1 && all.front() == all.back()) note(kind, i, contour_change::closed);
    while (path.size() > 1 && path.back() == path.front()) path.pop_back();
    const double area = twice_area(path);
    lattice_paths one;
    one.push_back(path);
    const bool is_simple = path.size() > 2 && !meet(one);
    if (path.size() < 3 || (area == 0 && is_simple)) {
      note(kind, i, contour_change::dropped);
      continue;
    }
    if (!is_simple) {
      lattice_paths turned;  // `one` winds around parts with a positive number, this around those with a negative one
      std::reverse(path.begin(), path.end());
      turned.push_back(path);
      const lattice_regions left = back_end_.combine(region_operation::unite, one, {}),
                            right = back_end_.combine(region_operation::unite, turned, {});
      const lattice_regions both = back_end_.combine(region_operation::unite, left.paths, right.paths);
      note(kind, i, both.paths.size() > 0 ? contour_change::crossing : contour_change::dropped);
      for (std::size_t k = 0; k < both.paths.size(); ++k) {
        path.assign(both.paths[k].begin(), both.paths[k].end());
        if (!is_outer) std::reverse(path.begin(), path.end());
        paths.push_back(path);
      }
      continue;
    }
    if ((area > 0) != is_outer) {
      note(kind, i, contour_change::turned);
      std::reverse(path.begin(), path.end());
    }
    paths.push_back(path);
  }
}

CONCINO_INLINE lattice_regions contour_reader::regions(const slice_layer& layer) {
  lattice_paths paths;
  add_contours(layer.outer, slice_lines_kind::outer, paths);
  add_contours(layer.inner, slice_lines_kind::inner, paths);
  if (auto done = disjoint_regions(paths)) return std::move(*done);
  return back_end_.combine(region_operation::unite, paths, {});
}

CONCINO_INLINE lattice_regions contour_reader::thickened(const slice_lines& lines, slice_lines_kind kind, double radius,
                                                         double chord_error, const lattice_paths& without) {
  lattice_paths paths;
  std::vector<snapped_point> path;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto line = lines[i];
    if (radius == 0 || line.empty()) {
      note(kind, i, contour_change::dropped);
      continue;
    }
    const std::size_t step = kind == slice_lines_kind::hatches ? 2 : line.size();
    for (std::size_t begin = 0; begin < line.size(); begin += step) {
      path.clear();
      for (std::size_t k = begin; k < begin + step; ++k) path.push_back(to_(line[k]));
      paths.push_back(path);
    }
  }
  if (paths.size() == 0) return {};
  const lattice_offset how{radius / to_.unit(), true, offset_corners::rounded,
                           (chord_error > 0 ? chord_error : radius / 100) / to_.unit(), 2};
  lattice_regions all = back_end_.offset(paths, how);
  return without.size() == 0 ? all : back_end_.combine(region_operation::subtract, all.paths, without);
}

}  // namespace concino::detail
