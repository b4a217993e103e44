// Defines slices_to_mesh.hpp.
#pragma once

#include <concino/core/error.hpp>
#include <concino/print/detail/regions/layer_cells.hpp>
#include <concino/print/slices_to_mesh.hpp>

#include <limits>

namespace concino::detail {

/// Adds the polygons of one layer after another.
class layer_mesh_builder {
  layer_polygons& to_;
  const lattice& lattice_;
  std::vector<std::uint32_t> number_;  // by point of the layer: its vert

  void add_polygon(const std::uint32_t* begin, const std::uint32_t* end, const layer_cells& layer, double z) {
    for (const std::uint32_t* p = begin; p != end; ++p) {
      if (number_[*p] == cell_triangles::none) {
        number_[*p] = static_cast<std::uint32_t>(to_.arrays.points.size());
        const slice_point x = lattice_(layer.points[*p]);
        to_.arrays.points.push_back({x[0], x[1], z});
      }
      to_.arrays.verts.push_back(vert_id{number_[*p]});
    }
    if (to_.arrays.arity == 0) to_.arrays.offsets.push_back(static_cast<std::uint32_t>(to_.arrays.verts.size()));
  }

 public:
  layer_mesh_builder(layer_polygons& to, const lattice& l) : to_(to), lattice_(l) {}

  void add(const layer_cells& layer, double z, int index) {
    number_.assign(layer.points.size(), cell_triangles::none);
    if (to_.arrays.arity == 3) {
      for (const auto& t : layer.cells.triangles) add_polygon(t.data(), t.data() + 3, layer, z);
      to_.kinds.insert(to_.kinds.end(), layer.kinds.begin(), layer.kinds.end());
    } else {
      const merged_polygons merged = merge_triangles(layer);
      const std::uint32_t* const points = merged.points.data();
      for (std::size_t i = 0; i < merged.ends.size(); ++i)
        add_polygon(points + (i == 0 ? 0 : merged.ends[i - 1]), points + merged.ends[i], layer, z);
      to_.kinds.insert(to_.kinds.end(), merged.kinds.begin(), merged.kinds.end());
    }
    to_.layers.resize(to_.kinds.size(), index);
  }
};

CONCINO_INLINE layer_polygons polygons_of_layers(const slices& s, const polygon_clipper& back_end,
                                                 const layer_options& options, bool triangles) {
  const char* const caller = "slices_to_mesh";
  const lattice to = lattice_of(caller, s, options, 40);
  layer_polygons result;
  if (triangles) result.arrays.arity = 3;
  else result.arrays.offsets.push_back(0);
  layer_mesh_builder builder(result, to);
  for (std::size_t i = 0; i < s.layers.size(); ++i) {
    report_progress(options.progress, static_cast<double>(i) / static_cast<double>(s.layers.size()), caller);
    builder.add(cells_of_layer(caller, s.layers[i], to, options, back_end, {}, i, result.report), s.layers[i].z,
                static_cast<int>(i));
    if (result.arrays.verts.size() > std::numeric_limits<std::uint32_t>::max() / 2)
      core::throw_joined<invalid_argument>({caller, ": up to layer ", i, " there are too many polygons for one mesh"});
  }
  return result;
}

}  // namespace concino::detail
