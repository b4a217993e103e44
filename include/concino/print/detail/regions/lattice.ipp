// Defines lattice.hpp.
#pragma once

#include <concino/core/error.hpp>
#include <concino/print/detail/regions/lattice.hpp>

#include <algorithm>

namespace concino::detail {

CONCINO_INLINE lattice::lattice(const char* caller, const planar_box& box, double reach, int bits) {
  if (box.is_empty()) return;
  const double size = std::max(box.max[0] - box.min[0], box.max[1] - box.min[1]) + 2 * reach;
  double largest = 0;
  for (const std::size_t k : {0u, 1u}) largest = std::max({largest, std::abs(box.min[k]), std::abs(box.max[k])});
  if (!(largest + reach < 1e150) || (size > 0 && size < 1e-150))
    core::throw_joined<unsupported>({caller, ": the size of the contours is not between 1e-150 and 1e150"});
  const int digits = largest > 0 ? std::ilogb(largest) - 51 : -1000;
  unit_ = std::ldexp(1.0, std::max(size > 0 ? std::ilogb(size) - bits : digits, digits));
  for (const std::size_t k : {0u, 1u}) origin_[k] = std::nearbyint((box.min[k] / 2 + box.max[k] / 2) / unit_);
}

CONCINO_INLINE void check_finite_points(const char* caller, const planar_regions& regions, const char* which) {
  for (std::size_t i = 0; i < regions.points.size(); ++i)
    if (!std::isfinite(regions.points[i][0]) || !std::isfinite(regions.points[i][1]))
      core::throw_joined<invalid_argument>({caller, ": point ", i, " of the ", which, " is not finite"});
}

CONCINO_INLINE lattice_paths snap(const planar_regions& regions, const lattice& to) {
  lattice_paths paths;
  paths.points.reserve(regions.points.size());
  for (const slice_point& p : regions.points) paths.points.push_back(to(p));
  paths.ends = regions.contour_ends;
  return paths;
}

CONCINO_INLINE planar_regions regions_from(const lattice_regions& regions, const lattice& from) {
  planar_regions result;
  result.unit = regions.region_ends.empty() ? 0 : from.unit();
  result.points.reserve(regions.paths.points.size());
  for (const snapped_point& p : regions.paths.points) result.points.push_back(from(p));
  result.contour_ends = regions.paths.ends;
  result.region_ends = regions.region_ends;
  return result;
}

}  // namespace concino::detail
