// The regions of a layer of slices.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/io/slice_layer.hpp>
#include <concino/print/planar_regions.hpp>
#include <concino/print/polygon_clipper.hpp>
#include <concino/print/slice_report.hpp>

namespace concino {

struct layer_regions_options {
  slice_report* report = nullptr;  // unless null, cleared and then filled in; it names contours of layer 0
};

/// The regions within the contours of a layer: each outer contour adds 1 inside, each inner one -1, whatever their
/// directions, and what has a positive sum is filled. A contour that crosses itself counts as what it winds around.
/// Needs:  finite points; a back end such as concino::clipper.
/// Result: regions that do not overlap. Coordinates are snapped to a unit, a power of two with 2^40 units or more in
///         the size of the layer, or their last digit. Contours without area on this lattice are dropped. Open lines
///         and hatches are left out: thicken makes regions of them.
/// Cost:   that of the back end, and O(n log n) for n points; more where many long segments lie close to one another.
/// Errors: invalid_argument that names a contour with a point that is not finite. unsupported if the back end cannot
///         hold the coordinates.
planar_regions layer_regions(const slice_layer& layer, const polygon_clipper& back_end,
                             const layer_regions_options& options = {});

// What to write instead of calls that cannot compile.
planar_regions layer_regions(const slice_layer&) = delete;  // pass a back end: layer_regions(layer, clipper), with #include <concino/adapters/clipper.hpp> (Debian: libpolyclipping-dev)

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/print/detail/regions/layer_regions.ipp>
#endif
