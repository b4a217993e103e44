// Defines region_offset.hpp.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/number_text.hpp>
#include <concino/print/detail/regions/lattice.hpp>
#include <concino/print/region_offset.hpp>
#include <concino/print/slice_report.hpp>

#include <algorithm>
#include <cmath>

namespace concino {

CONCINO_INLINE planar_regions region_offset(const planar_regions& regions, double distance,
                                            const polygon_clipper& back_end, const region_offset_options& options) {
  const char* const caller = "region_offset";
  detail::check_finite_points(caller, regions, "regions");
  if (!std::isfinite(distance)) core::throw_joined<invalid_argument>({caller, ": the distance is not finite"});
  if (!(options.chord_error >= 0))
    core::throw_joined<invalid_argument>(
        {caller, ": chord_error is ", core::number_text(options.chord_error), "; it must be 0 or more"});
  if (!(options.mitre_limit >= 1))
    core::throw_joined<invalid_argument>(
        {caller, ": mitre_limit is ", core::number_text(options.mitre_limit), "; it must be 1 or more"});
  detail::planar_box around;
  around.add(regions.points);
  const double limit = options.corners == offset_corners::mitred ? std::min(options.mitre_limit, 1e6) : 1.0;
  const detail::lattice to(caller, around, limit * std::max(distance, 0.0), 40);
  const double chord_error = options.chord_error > 0 ? options.chord_error : std::abs(distance) / 100;
  const lattice_offset how{distance / to.unit(), false, options.corners, chord_error / to.unit(), limit};
  if (distance == 0)
    return detail::regions_from(back_end.combine(region_operation::unite, detail::snap(regions, to), {}), to);
  return detail::regions_from(back_end.offset(detail::snap(regions, to), how), to);
}

CONCINO_INLINE planar_regions thicken(const slice_lines& lines, double radius, const polygon_clipper& back_end,
                                      const thicken_options& options) {
  const char* const caller = "thicken";
  if (!(radius > 0) || !std::isfinite(radius))
    core::throw_joined<invalid_argument>(
        {caller, ": radius is ", core::number_text(radius), "; it must be finite and above 0"});
  if (!(options.chord_error >= 0))
    core::throw_joined<invalid_argument>(
        {caller, ": chord_error is ", core::number_text(options.chord_error), "; it must be 0 or more"});
  detail::planar_box around;
  for (std::size_t i = 0; i < lines.size(); ++i)
    for (const slice_point& p : lines[i]) {
      if (!std::isfinite(p[0]) || !std::isfinite(p[1]))
        core::throw_joined<invalid_argument>({caller, ": ",
                                              detail::contour_name(detail::single_layer, slice_lines_kind::open, i),
                                              " has a point that is not finite"});
      around.add(p);
    }
  const detail::lattice to(caller, around, radius, 40);
  lattice_paths paths;
  paths.points.reserve(lines.points.size());
  for (const slice_point& p : lines.points) paths.points.push_back(to(p));
  paths.ends = lines.ends;
  const double chord_error = options.chord_error > 0 ? options.chord_error : radius / 100;
  return detail::regions_from(
      back_end.offset(paths, {radius / to.unit(), true, offset_corners::rounded, chord_error / to.unit(), 2}), to);
}

}  // namespace concino
