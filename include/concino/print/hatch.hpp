// hatch: parallel segments that fill a layer.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/io/slice_layer.hpp>

namespace concino {

/// Parallel segments across the material of a layer, as paths of a laser or a nozzle: layer.hatches = hatch(layer, 0.1,
/// 45).
/// Needs:  finite points; a distance above 0 between lines, and their angle to the x axis in degrees,
///         counter-clockwise.
/// Result: at most one group of hatches: segments line after line, and along each line in turn in both directions.
///         Filled is what the contours of the layer enclose by the rule of layer_regions. Lines lie halfway between
///         multiples of the distance from the origin, so that those of all layers lie above each other. The sum of
///         lengths times distance is the area, up to the parts of lines at the boundary.
/// Cost:   O(n + k log k) for n points and k ends of segments.
/// Errors: invalid_argument if the distance or the angle is out of its range, if more than 10^8 lines would be needed,
///         or that names a contour with a point that is not finite.
slice_lines hatch(const slice_layer& layer, double distance, double angle_deg);

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/print/detail/slices/hatch.ipp>
#endif
