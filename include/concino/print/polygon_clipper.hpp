// The interface to a library that unites, cuts and offsets polygons, such as concino::clipper of
// <concino/adapters/clipper.hpp>.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace concino {

/// A point of a lattice: two numbers of units, of at most 2^53.
using snapped_point = std::array<std::int64_t, 2>;

/// Paths on a lattice, closed unless said otherwise. Path i has the points before ends[i].
struct lattice_paths {
  std::vector<snapped_point> points;
  std::vector<std::size_t> ends;

  std::size_t size() const { return ends.size(); }
  std::span<const snapped_point> operator[](std::size_t i) const {
    const std::size_t begin = i == 0 ? 0 : ends[i - 1];
    return {points.data() + begin, ends[i] - begin};
  }
  void push_back(std::span<const snapped_point> path) {
    points.insert(points.end(), path.begin(), path.end());
    ends.push_back(points.size());
  }
};

/// Regions on a lattice, as in planar_regions: region r has the paths before region_ends[r], its outer contour first.
struct lattice_regions {
  lattice_paths paths;
  std::vector<std::size_t> region_ends;
};

enum class region_operation : std::uint8_t { unite, subtract, intersect };

/// How convex corners are offset.
enum class offset_corners : std::uint8_t {
  rounded,  // by an arc
  mitred    // by prolonged edges, up to a limit
};

/// How paths are offset, in units of the lattice.
struct lattice_offset {
  double distance = 0;        // positive: outward
  bool open = false;          // whether the paths are lines, which get round ends
  offset_corners corners = offset_corners::rounded;
  double chord_error = 0.25;  // the largest distance between an arc and its chords
  double mitre_limit = 2;     // the largest distance of a mitred corner, in multiples of `distance`
};

/// A back end. Paths are filled where the sum of their winding numbers is positive.
struct polygon_clipper {
  /// What is in a or b, in a only, or in both.
  /// Errors: unsupported if the back end cannot hold or do it.
  virtual lattice_regions combine(region_operation what, const lattice_paths& a, const lattice_paths& b) const = 0;
  /// What is nearer to closed paths, or to lines, than the distance.
  /// Errors: as combine.
  virtual lattice_regions offset(const lattice_paths& paths, const lattice_offset& how) const = 0;
  virtual const char* name() const = 0;

 protected:
  constexpr polygon_clipper() = default;
  ~polygon_clipper() = default;
};

}  // namespace concino
