// The offset of regions of the plane, and regions around lines.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/io/slice_layer.hpp>
#include <concino/print/planar_regions.hpp>
#include <concino/print/polygon_clipper.hpp>

namespace concino {

struct region_offset_options {
  offset_corners corners = offset_corners::rounded;  // how convex corners are offset
  double chord_error = 0;  // the largest distance between an arc and its chords, in units of length; 0: 1/100 of the
                           // distance. At least one unit of the result
  double mitre_limit = 2;  // the largest distance of a mitred corner, in multiples of the distance, 1 or more; sharper
                           // corners are cut off
};

/// What is nearer to regions than a distance, or if that is negative, what is in them and farther from their boundary.
/// Needs:  regions with finite points, as other functions make them; a finite distance; a back end such as
///         concino::clipper.
/// Result: regions that do not overlap, as of region_union. Arcs are polygons inside of the exact ones, which differ
///         from them by chord_error at most.
/// Cost:   that of the back end.
/// Errors: invalid_argument that names a point or an option that is not finite or out of its range. unsupported if the
///         back end cannot hold the coordinates.
planar_regions region_offset(const planar_regions& regions, double distance, const polygon_clipper& back_end,
                             const region_offset_options& options = {});

struct thicken_options {
  double chord_error = 0;  // the largest distance between an arc and its chords, in units of length; 0: 1/100 of the
                           // radius. At least one unit of the result
};

/// What is nearer to open lines than a radius: lines with round ends, such as supports.
/// Needs:  lines with finite points; a line of one point gives a disk. A finite radius above 0; a back end such as
///         concino::clipper.
/// Result: regions that do not overlap, as of region_offset. A straight line of length l gives the area 2 r l + pi r^2,
///         less up to chord_error times pi r.
/// Cost:   that of the back end.
/// Errors: invalid_argument that names a line with a point that is not finite, or if the radius or the chord error is
///         out of its range. unsupported if the back end cannot hold the coordinates.
planar_regions thicken(const slice_lines& lines, double radius, const polygon_clipper& back_end,
                       const thicken_options& options = {});

// What to write instead of calls that cannot compile.
planar_regions region_offset(const planar_regions&, double) = delete;  // pass a back end: region_offset(regions, 1, clipper), with #include <concino/adapters/clipper.hpp> (Debian: libpolyclipping-dev)
planar_regions thicken(const slice_lines&, double) = delete;           // pass a back end: thicken(lines, 1, clipper), with #include <concino/adapters/clipper.hpp> (Debian: libpolyclipping-dev)

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/print/detail/regions/region_offset.ipp>
#endif
