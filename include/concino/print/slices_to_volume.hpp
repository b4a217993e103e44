// slices_to_volume: tets of the material of slices, layer upon layer.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/profiler.hpp>
#include <concino/core/progress.hpp>
#include <concino/io/slice_layer.hpp>
#include <concino/mesh/tetmesh.hpp>
#include <concino/print/layer_options.hpp>
#include <concino/print/polygon_clipper.hpp>
#include <concino/print/slice_report.hpp>

#include <vector>

namespace concino {

struct slices_to_volume_options {
  double last_height = 0;            // the height of the last layer, in units of length; 0: that of the one before it
  double thicken = 0;                // the radius of open lines, in units of length, 0 or more; 0: they are left out,
                                     // which the report says
  double thicken_hatches = 0;        // the same for hatches. Only what is neither part nor support becomes material of
                                     // hatches
  double chord_error = 0;            // the largest distance between the round ends of lines and their chords, in units
                                     // of length; 0: 1/100 of the radius
  concino::progress progress = {};   // called with the fraction of the layers
  concino::profiler* profiler = nullptr;  // measures the call and its steps
};

/// Tets of slices. Their properties of polys "layer" and "kind" are int: the number of the layer, and a slice_kind.
struct layer_volume {
  tetmesh mesh;
  slice_report report;
  double unit = 0;                // points of contours are multiples of it, in units of length
  std::vector<poly_id> inverted;  // tets without positive volume, at places that are hardly wider than a unit
};

/// The volume of slices: each layer fills the space from its height to that of the next one.
/// Needs:  layers by ascending height, whose contours and lines are as for slices_to_mesh; a back end such as
///         concino::clipper.
/// Result: tets that share verts, edges and faces, within a layer and with the layers below and above it. Each layer is
///         cut into triangles, and each triangle gives a column, whose bottom and top are cut by the triangles of the
///         layers that it touches; to_tets cuts the columns. Points of contours are snapped to a unit, a power of two,
///         with 2^20 units or more in the size of the slices, 0.2 micrometres for a part of 200 mm. Points where layers
///         cross are snapped to 2^-18 of it, so that the volume is the sum of snapped areas times heights to 1e-9.
///         Where lines of neighbouring layers nearly meet in a point, tets may be so small that validate calls them
///         flat. The report names contours as that of slices_to_mesh.
/// Cost:   O(n log n) for n points, and crossings of triangles of neighbouring layers; and that of the back end.
/// Errors: invalid_argument as slices_to_mesh, and if heights do not ascend, which names a layer, or there is but one
///         layer and no last_height, or it is not finite and above 0. unsupported if the back end cannot hold the
///         coordinates. cancelled.
/// Source: Livesu, Cabiddu, Attene 2019, "slice2mesh: a meshing tool for the simulation of additive manufacturing
///         processes".
layer_volume slices_to_volume(const slices& s, const polygon_clipper& back_end,
                              const slices_to_volume_options& options = {});

// What to write instead of calls that cannot compile.
layer_volume slices_to_volume(const slices&) = delete;                                   // pass a back end: slices_to_volume(s, clipper), with #include <concino/adapters/clipper.hpp> (Debian: libpolyclipping-dev)
layer_volume slices_to_volume(const slices&, const slices_to_volume_options&) = delete;  // pass a back end: slices_to_volume(s, clipper, {...}), with #include <concino/adapters/clipper.hpp> (Debian: libpolyclipping-dev)

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/print/detail/slices/slices_to_volume.ipp>
#endif
