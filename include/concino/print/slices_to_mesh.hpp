// slices_to_mesh: a surface mesh of the layers of slices, each at its height.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/io/slice_layer.hpp>
#include <concino/mesh/arrays.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/property.hpp>
#include <concino/mesh/trimesh.hpp>
#include <concino/print/layer_options.hpp>
#include <concino/print/polygon_clipper.hpp>
#include <concino/print/slice_report.hpp>

#include <concepts>
#include <cstdint>
#include <utility>
#include <vector>

namespace concino {

/// A mesh of the layers of slices. Its properties of polys "layer" and "kind" are int: the number of the layer, and a
/// slice_kind.
template<class To>
struct layer_mesh {
  To mesh;
  slice_report report;
};

namespace requirement {

template<class To> concept is_layer_mesh = std::same_as<To, polygonmesh> || std::same_as<To, trimesh>;

}  // namespace requirement

namespace detail {

struct layer_polygons {
  surface_arrays arrays;
  std::vector<int> layers, kinds;  // by polygon
  slice_report report;
};

layer_polygons polygons_of_layers(const slices& s, const polygon_clipper& back_end, const layer_options& options,
                                  bool triangles);

}  // namespace detail

/// The material of slices as flat polygons, layer after layer, counter-clockwise seen from above.
/// Needs:  finite points; contours and lines of any layers, which may touch, overlap and run in any direction. A back
///         end such as concino::clipper.
/// Result: a polygonmesh, or as slices_to_mesh<trimesh> triangles. The part of a layer is what layer_regions gives;
///         open lines are thickened and become support where there is no part, and so do hatches where there is
///         neither. Polygons of one layer share verts and edges, those of different layers do not. A region without
///         holes is one polygon; one with holes is cut into simple polygons. Coordinates are snapped to a unit with
///         2^40 units or more in the size of the slices. The report names each contour that was left out, turned,
///         closed or crosses itself, by layer and number.
/// Cost:   O(n log n) for n points and crossings of a layer, more where many long segments lie close to one another;
///         and that of the back end.
/// Errors: invalid_argument that names layer and contour of a point that is not finite, or a group of hatches with an
///         odd number of points, or an option out of its range; if there would be too many elements. unsupported if the
///         back end cannot hold the coordinates. cancelled.
/// Source: paper section 2.2, 3D printing, and figure 8.
template<class To = polygonmesh>
  requires requirement::is_layer_mesh<To>
layer_mesh<To> slices_to_mesh(const slices& s, const polygon_clipper& back_end, const layer_options& options = {}) {
  const core::profiled_options profiled(options, "slices_to_mesh");
  detail::layer_polygons all = detail::polygons_of_layers(s, back_end, *profiled, std::same_as<To, trimesh>);
  layer_mesh<To> result{To(std::move(all.arrays)), std::move(all.report)};
  const auto layer = poly_property<int>(result.mesh, "layer"), kind = poly_property<int>(result.mesh, "kind");
  for (std::size_t i = 0; i < all.layers.size(); ++i) {
    layer[poly_id{i}] = all.layers[i];
    kind[poly_id{i}] = all.kinds[i];
  }
  return result;
}

// What to write instead of calls that cannot compile.
template<class To = polygonmesh> void slices_to_mesh(const slices&) = delete;                        // pass a back end: slices_to_mesh(s, clipper), with #include <concino/adapters/clipper.hpp> (Debian: libpolyclipping-dev)
template<class To = polygonmesh> void slices_to_mesh(const slices&, const layer_options&) = delete;  // pass a back end: slices_to_mesh(s, clipper, {...}), with #include <concino/adapters/clipper.hpp> (Debian: libpolyclipping-dev)

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/print/detail/slices/slices_to_mesh.ipp>
#endif
