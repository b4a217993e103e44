// Finds where segments on a lattice must be cut, so that they meet at common ends only.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/vec3.hpp>
#include <concino/print/polygon_clipper.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace concino::detail {

inline vec3 as_vec3(const snapped_point& p) { return {static_cast<double>(p[0]), static_cast<double>(p[1]), 0}; }

/// A segment between two numbered points.
using numbered_segment = std::array<std::uint32_t, 2>;

/// A segment that must be cut at a point, or very near to it.
struct segment_cut {
  std::uint32_t segment, point;
};

/// Where segments cross, and where points of others are at most half a unit away from them.
/// Needs:  points that are all different, with coordinates of at most 2^46; segments that are all different.
/// Result: empty if, and only if, no segment must be cut. Otherwise most of the cuts; what is left shows in the next
///         call, with the segments cut. Crossings are rounded to the lattice and added to the points.
/// Cost:   O((n + k) log n) for k cuts; with `first_only`, which ends at the first cut, O(n log n).
/// Source: Bentley and Ottmann 1979, with the segments cut while the line sweeps over them.
std::vector<segment_cut> find_cuts(std::vector<snapped_point>& points, const std::vector<numbered_segment>& segments,
                                   bool first_only = false);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/print/detail/regions/segment_cuts.ipp>
#endif
