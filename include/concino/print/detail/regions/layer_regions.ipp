// Defines layer_regions.hpp.
#pragma once

#include <concino/print/detail/regions/contour_reader.hpp>
#include <concino/print/layer_regions.hpp>

namespace concino {

CONCINO_INLINE planar_regions layer_regions(const slice_layer& layer, const polygon_clipper& back_end,
                                            const layer_regions_options& options) {
  detail::planar_box around;
  detail::add_layer("layer_regions", layer, detail::single_layer, around);
  const detail::lattice to("layer_regions", around, 0, 40);
  std::vector<contour_note> notes;
  const lattice_regions regions = detail::contour_reader(to, back_end, detail::single_layer, notes).regions(layer);
  if (options.report) options.report->notes = std::move(notes);
  return detail::regions_from(regions, to);
}

}  // namespace concino
