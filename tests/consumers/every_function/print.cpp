#include "call.hpp"

#include <concino/print.hpp>

namespace {

/// A back end that returns the paths of `a`, or all paths, as regions without holes.
struct own_clipper final : cn::polygon_clipper {
  cn::lattice_regions combine(cn::region_operation, const cn::lattice_paths& a, const cn::lattice_paths&) const override { return regions(a); }
  cn::lattice_regions offset(const cn::lattice_paths& paths, const cn::lattice_offset&) const override { return regions(paths); }
  const char* name() const override { return "own_clipper"; }

  static cn::lattice_regions regions(const cn::lattice_paths& paths) {
    cn::lattice_regions result{paths, {}};
    for (std::size_t i = 0; i < paths.size(); ++i) result.region_ends.push_back(i + 1);
    return result;
  }
};

}  // namespace

void call_print() {
  const own_clipper back_end;
  cn::slice_layer layer;
  layer.outer.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  layer.outer.ends = {4};
  layer.outer.ids = {0};
  const cn::planar_regions square = cn::layer_regions(layer, back_end);
  call("layer_regions", [&] { cn::layer_regions(layer, back_end); });
  call("region_union", [&] { cn::region_union(square, square, back_end); });
  call("region_difference", [&] { cn::region_difference(square, square, back_end); });
  call("region_intersection", [&] { cn::region_intersection(square, square, back_end); });
  call("region_offset", [&] { cn::region_offset(square, 0.1, back_end); });
  call("thicken", [&] { cn::thicken(layer.outer, 0.1, back_end); });
  call("contour_area", [&] { cn::contour_area(square.contour(0)); });
  call("to_layer", [&] { cn::to_layer(square, 0); });
  call("hatch", [&] { cn::hatch(layer, 0.1, 45); });
  cn::slices both;
  both.layers = {layer, cn::to_layer(square, 1)};
  call("slices_to_mesh", [&] { cn::slices_to_mesh(both, back_end); });
  call("slices_to_volume", [&] { cn::slices_to_volume(both, back_end); });
  call("heights", [](auto& m) { cn::heights(m, 0.1); }, all);
  call("slice_mesh", [](auto& m) { cn::slice_mesh(m, {0.25, 0.5}, {.accept_open = true}); }, all);
  call("slice_mesh", [](auto& m) { cn::slice_mesh(m, {0.25, 0.5}, cn::make_poly_map<int>(m, 1)); }, volumes);
  call("thin_walls", [](auto& m) { cn::thin_walls(m, 0.1); }, all);
  call("narrow_gaps", [](auto& m) { cn::narrow_gaps(m, 0.1); }, all);
  call("height_map", [](auto& m) { cn::height_map(m, {.resolution = 8}); }, all);
  call("shadow_on_plate", [&](auto& m) { cn::shadow_on_plate(m, back_end); }, all);
  call("overhangs", [](auto& m) { cn::overhangs(m); }, all);
  call("best_build_direction", [](auto& m) { cn::best_build_direction(m); }, all);
}
