// Finds the polygons of a part that overhang, for one direction, and measures their supports.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/print/detail/supports/build_frame.hpp>
#include <concino/print/detail/supports/part_surface.hpp>
#include <concino/print/detail/supports/supports.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace concino::detail {

struct overhang_limits {
  double max_angle_deg;
  std::optional<double> plate;  // in units of the mesh
  double plate_tolerance;
};

/// Lengths are those of the part_surface.
struct overhang_figures {
  std::vector<std::uint32_t> polygons;
  double area = 0, plate_area = 0, plate = 0, height = 0;
};

/// Throws if a limit is out of its range.
void check_limits(const overhang_limits& limits, const char* caller);

overhang_figures find_overhangs(const part_surface& part, const vec3& up, const overhang_limits& limits,
                                const char* caller);

/// The supports below the polygons that were found.
supports_size supports_below(const part_surface& part, const vec3& up, const overhang_figures& found);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/print/detail/supports/overhang_search.ipp>
#endif
