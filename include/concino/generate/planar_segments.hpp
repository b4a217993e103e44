// The points and segments of a planar_graph in the plane, checked, for those who write a triangulation.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/generate/planar_graph.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace concino::core {

/// Segments in the plane of x and y. All used points have different places, and the points of a segment are in the
/// order of x, then y.
struct planar_segments {
  static constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);

  std::string_view caller;                             // of messages
  std::vector<vec3> points;                            // by the number in the graph: z = 0; coordinates that are used
                                                       // are at most 1
  std::vector<std::uint32_t> used;                     // the points of segments and the isolated ones, ascending
  std::vector<std::uint32_t> same_as;                  // by the number of a point: the used one at its place; none if
                                                       // it is not needed
  std::vector<std::array<std::uint32_t, 2>> segments;  // of used points; all different
  std::vector<std::uint8_t> is_outline;                // by segment: on one side of it is the inside, on the other one
                                                       // the outside
  std::vector<std::uint32_t> first_input;              // by segment: the first one of the graph that it is
  std::vector<std::uint32_t> segment_of;               // by segment of the graph
  std::vector<vec3> holes;
  std::array<vec3, 2> axes;                            // points are (dot(p, axes[0]), dot(p, axes[1]), 0) times
                                                       // 2^exponent
  int exponent = 0;

  bool is_before(std::uint32_t a, std::uint32_t b) const { return is_before(points[a], points[b]); }
  static bool is_before(const vec3& a, const vec3& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }
};

/// Checks a graph and projects it.
/// Needs:  caller: the function that messages name; merge: whether points at one place are one.
/// Result: see planar_segments.                                Cost: O(n log n).
/// Errors: invalid_argument that names the line, point or hole point, as triangulate lists them, but for intersections.
planar_segments planar_segments_of(std::string_view caller, const planar_graph& g, std::span<const vec3> holes,
                                   const vec3& seen_from, bool merge);

/// What a sweep finds. Above a segment is to the left of it, from its first point to its second one.
struct swept_segments {
  static constexpr std::uint32_t none = planar_segments::none;

  std::vector<std::uint8_t> inside_above;             // by segment
  std::vector<std::uint8_t> unbounded_below;          // by segment: whether it is known that the region below is the
                                                      // unbounded one
  std::vector<std::array<std::uint32_t, 2>> bridges;  // pairs of points, the first one first; with them each bounded
                                                      // region has one boundary cycle
  std::vector<std::uint32_t> below_hole;              // by hole point: the segment below it; none if there is none
};

/// A sweep over segments: intersections, what is inside of outlines, and bridges between parts that do not touch.
/// Needs:  the result of planar_segments_of.                   Cost: O(n log n).
/// Result: see swept_segments.
/// Errors: invalid_argument that names two segments that cross or overlap, or a point or hole point on a segment.
/// Source: Shamos and Hoey 1976 for intersections; bridges are diagonals at split vertices of Garey, Johnson, Preparata
///         and Tarjan 1978.
swept_segments sweep(const planar_segments& g);

/// Diagonals that divide regions into monotone ones: each line x = constant meets the boundary of such a region twice.
/// Needs:  the result of planar_segments_of, without intersections; by segment, whether the region above it is to be
///         divided.
/// Result: pairs of points, the first one first, which include bridges.   Cost: O(n log n).
/// Errors: none.
/// Source: Garey, Johnson, Preparata and Tarjan 1978.
std::vector<std::array<std::uint32_t, 2>> monotone_diagonals(const planar_segments& g,
                                                             const std::vector<std::uint8_t>& above);

/// The edge between each pair of verts.
/// Needs:  pairs of verts of m, or of invalid ones.                Cost: O(n log n) for n edges and pairs, whatever the
///         degrees of verts.
/// Result: an invalid edge where there is none.
/// Errors: none.
std::vector<edge_id> edges_between(const trimesh& m, std::span<const std::array<vert_id, 2>> pairs);

}  // namespace concino::core

#ifndef CONCINO_COMPILED
#include <concino/generate/detail/outlines/planar_segments.ipp>
#include <concino/generate/detail/outlines/segment_sweep.ipp>
#endif
