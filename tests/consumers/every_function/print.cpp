#include "call.hpp"

#include <concino/print.hpp>

namespace {

/// A back end that finds nothing.
struct no_regions final : cn::polygon_clipper {
  cn::lattice_regions combine(cn::region_operation, const cn::lattice_paths&, const cn::lattice_paths&) const override { return {}; }
  cn::lattice_regions offset(const cn::lattice_paths&, const cn::lattice_offset&) const override { return {}; }
  const char* name() const override { return "no_regions"; }
};

void call_slices() {
  const no_regions back_end;
  cn::slices s;
  s.layers.resize(1);
  s.layers[0].outer.push_back(std::vector<cn::slice_point>{{0, 0}, {1, 0}, {0, 1}});
  const cn::planar_regions triangle = cn::layer_regions(s.layers[0], back_end);
  call("layer_regions", [&] { cn::layer_regions(s.layers[0], back_end); });
  call("region_union", [&] { cn::region_union(triangle, triangle, back_end); });
  call("region_difference", [&] { cn::region_difference(triangle, triangle, back_end); });
  call("region_intersection", [&] { cn::region_intersection(triangle, triangle, back_end); });
  call("region_offset", [&] { cn::region_offset(triangle, 1, back_end); });
  call("thicken", [&] { cn::thicken(s.layers[0].open, 1, back_end); });
  call("contour_area", [&] { cn::contour_area(triangle.contour(0)); });
  call("to_layer", [&] { cn::to_layer(triangle, 1); });
  call("hatch", [&] { cn::hatch(s.layers[0], 0.1, 45); });
  call("heights", [](auto& m) { cn::heights(m, 0.25); }, all);
  call("slice_mesh", [](auto& m) { cn::slice_mesh(m, {0.25}); }, volumes);
  call("slices_to_mesh", [&] { cn::slices_to_mesh(s, back_end), cn::slices_to_mesh<cn::trimesh>(s, back_end); });
  call("slices_to_volume", [&] { cn::slices_to_volume(s, back_end, {.last_height = 1}); });
}

}  // namespace

void call_print() { call_slices(); }
