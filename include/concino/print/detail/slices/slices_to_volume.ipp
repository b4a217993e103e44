// Defines slices_to_volume.hpp.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/number_text.hpp>
#include <concino/generate/to_tets.hpp>
#include <concino/mesh/polyhedralmesh.hpp>
#include <concino/mesh/property.hpp>
#include <concino/print/detail/slices/layer_columns.hpp>
#include <concino/print/slices_to_volume.hpp>

#include <cmath>
#include <limits>
#include <utility>

namespace concino::detail {

/// The heights of all layers, and of the end of the last one.
inline std::vector<double> heights_of_layers(const slices& s, double last_height) {
  const char* const caller = "slices_to_volume";
  std::vector<double> z;
  for (std::size_t i = 0; i < s.layers.size(); ++i) {
    z.push_back(s.layers[i].z);
    if (i > 0 && !(z[i] > z[i - 1]))
      core::throw_joined<invalid_argument>(
          {caller, ": layer ", i, " is not above layer ", i - 1, "; sort the layers by height"});
  }
  if (!(last_height >= 0) || !std::isfinite(last_height))
    core::throw_joined<invalid_argument>(
        {caller, ": last_height is ", core::number_text(last_height), "; it must be finite and 0 or more"});
  if (last_height == 0 && z.size() == 1)
    core::throw_joined<invalid_argument>({caller, ": there is one layer; give its height as last_height"});
  if (!z.empty()) z.push_back(z.back() + (last_height > 0 ? last_height : z.back() - z[z.size() - 2]));
  return z;
}

}  // namespace concino::detail

namespace concino {

CONCINO_INLINE layer_volume slices_to_volume(const slices& s, const polygon_clipper& back_end,
                                             const slices_to_volume_options& input_options) {
  const char* const caller = "slices_to_volume";
  const core::profiled_options profiled(input_options, caller);
  const slices_to_volume_options& options = *profiled;
  const layer_options shared{
      .thicken = options.thicken, .thicken_hatches = options.thicken_hatches, .chord_error = options.chord_error};
  constexpr int finer = 20, crossings = 18;  // 2^finer units of the back end in each unit, and 2^crossings of points
                                             // where contours cross
  const detail::lattice units = detail::lattice_of(caller, s, shared, 20);
  const std::vector<double> z = detail::heights_of_layers(s, options.last_height);
  layer_volume result;
  const std::size_t n = s.layers.size();
  if (n == 0) return result;
  result.unit = units.unit();
  const detail::lattice fine = units.finer(finer), units_of_crossings = units.finer(crossings);
  const auto cells = [&](std::size_t i) {
    return detail::cells_of_layer(caller, s.layers[i], fine, shared, back_end, {finer, crossings}, i, result.report);
  };
  detail::column_builder columns(caller, units_of_crossings);
  detail::layer_cells layer = cells(0);
  columns.begin(layer, z[0]);
  for (std::size_t i = 0; i < n; ++i) {
    detail::report_progress(options.progress, static_cast<double>(i) / static_cast<double>(n), caller);
    detail::layer_cells next = i + 1 < n ? cells(i + 1) : detail::layer_cells();
    columns.add(layer, next, z[i + 1], static_cast<int>(i));
    layer = std::move(next);
    if (columns.arrays.face_verts.size() > std::numeric_limits<std::uint32_t>::max() / 8)
      core::throw_joined<invalid_argument>({caller, ": up to layer ", i, " there are too many cells for one mesh"});
  }
  polyhedralmesh polyhedra(std::move(columns.arrays));
  const auto of_layer = poly_property<int>(polyhedra, "layer"), kind = poly_property<int>(polyhedra, "kind");
  for (std::size_t i = 0; i < columns.layers.size(); ++i) {
    of_layer[poly_id{i}] = columns.layers[i];
    kind[poly_id{i}] = columns.kinds[i];
  }
  result.mesh = to_tets(polyhedra, {.inverted = &result.inverted});
  return result;
}

}  // namespace concino
