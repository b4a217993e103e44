// The arrangement of segments on a lattice: cut where they meet, so that they meet at common ends only.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/print/polygon_clipper.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace concino::detail {

/// Directed segments through numbered points, each with the steps of two integer functions: by how much they are larger
/// on the left side than on the right one.
struct stepped_segments {
  struct segment {
    std::uint32_t from, to;
    std::array<std::int64_t, 2> step;
  };
  std::vector<snapped_point> points;
  std::vector<segment> segments;

  /// Adds a closed path.
  void add_path(std::span<const snapped_point> path, const std::array<std::int64_t, 2>& step) {
    const auto first = static_cast<std::uint32_t>(points.size()), n = static_cast<std::uint32_t>(path.size());
    points.insert(points.end(), path.begin(), path.end());
    for (std::uint32_t i = 0; i < n; ++i) segments.push_back({first + i, first + (i + 1) % n, step});
  }
  void add_paths(const lattice_paths& paths, const std::array<std::int64_t, 2>& step) {
    for (std::size_t i = 0; i < paths.size(); ++i) add_path(paths[i], step);
  }
};

/// Edges that meet at common ends only, and into which edges each segment was cut.
struct planar_arrangement {
  struct edge {
    std::uint32_t low, high;  // points, low < high
    std::array<std::int64_t, 2> step;  // from the right side to the left one, seen from low to high
  };
  std::vector<snapped_point> points;      // those of edges are all different
  std::vector<std::uint32_t> point_of;    // by point of the input
  std::vector<edge> edges;                // sorted by points, all different
  std::vector<std::size_t> chain_ends;    // segment i passes the points before chain_points[chain_ends[i]]
  std::vector<std::uint32_t> chain_points;

  std::span<const std::uint32_t> chain(std::size_t segment) const {
    const std::size_t begin = segment == 0 ? 0 : chain_ends[segment - 1];
    return {chain_points.data() + begin, chain_ends[segment] - begin};
  }
};

/// Cuts segments at their crossings, rounded to the lattice, and at points of others that are at most half a unit away.
/// Needs:  coordinates of at most 2^46.
/// Result: no two edges cross, and no point lies on an edge; segments move by about half a unit.      Cost: O((n + k)
///         log n) a round for k crossings; few rounds.
/// Errors: unsupported if a hundred rounds were not enough.
/// Source: iterated snap rounding, Halperin and Packer 2002.
planar_arrangement arrange(const char* caller, const stepped_segments& s);

/// Whether closed paths meet themselves or each other, other than at common ends of neighbours, or come within half a
/// unit of it.
bool meet(const lattice_paths& paths);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/print/detail/regions/arrangement.ipp>
#endif
