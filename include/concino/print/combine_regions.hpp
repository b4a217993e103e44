// The union, difference and intersection of regions of the plane.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/print/planar_regions.hpp>
#include <concino/print/polygon_clipper.hpp>

namespace concino {

/// What is in a or b; in a but not in b; in both.
/// Needs:  regions with finite points, whose contours may touch or overlap; where they do, what winds around with a
///         positive sum is filled. A back end such as concino::clipper.
/// Result: regions that do not overlap. Coordinates are snapped to a unit, a power of two with 2^40 units or more in
///         the size of both, or their last digit. Areas are right to a few units times the lengths of contours.
/// Cost:   that of the back end.
/// Errors: invalid_argument that names a point that is not finite. unsupported if the back end cannot hold the
///         coordinates.
planar_regions region_union(const planar_regions& a, const planar_regions& b, const polygon_clipper& back_end);
planar_regions region_difference(const planar_regions& a, const planar_regions& b, const polygon_clipper& back_end);
planar_regions region_intersection(const planar_regions& a, const planar_regions& b, const polygon_clipper& back_end);

// What to write instead of calls that cannot compile.
planar_regions region_union(const planar_regions&, const planar_regions&) = delete;         // pass a back end as the last argument: clipper, with #include <concino/adapters/clipper.hpp> (Debian: libpolyclipping-dev)
planar_regions region_difference(const planar_regions&, const planar_regions&) = delete;    // pass a back end as the last argument: clipper, with #include <concino/adapters/clipper.hpp> (Debian: libpolyclipping-dev)
planar_regions region_intersection(const planar_regions&, const planar_regions&) = delete;  // pass a back end as the last argument: clipper, with #include <concino/adapters/clipper.hpp> (Debian: libpolyclipping-dev)

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/print/detail/regions/combine_regions.ipp>
#endif
