// Where the level set of a function crosses a polygon: chords between points on its edges. The rule is the same for the
// polys of a surface and for the faces of a volume, and does not depend on the side from which a polygon is seen.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/vec3.hpp>
#include <concino/geometry/triangulate_polygon.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace concino::detail {

/// One piece of a level set in a polygon. Edge k joins the corners k and k + 1.
struct level_chord {
  std::uint32_t from;                     // an edge whose first corner is above and whose second one is below
  std::uint32_t to;                       // an edge whose first corner is below and whose second one is above
  std::uint32_t inner_begin, inner_end;  // the diagonals that it crosses between, in polygon_crossings::inner()
};

/// A crossed diagonal of a polygon, by its corners.
struct crossed_diagonal {
  std::uint32_t below, above;
};

/// Whether a polygon is convex if it is seen along its vector area; corners may be flat up to rounding. Polygons
/// without area count as convex.
bool is_convex_polygon(std::span<const vec3> corners);

/// Whether the corners of a polygon lie in a plane, up to rounding.
bool is_planar_polygon(std::span<const vec3> corners);

/// Finds the chords of one polygon after another and reuses its memory.
class polygon_crossings {
  static constexpr std::uint32_t none = ~0u;

  std::vector<level_chord> chords_;
  std::vector<crossed_diagonal> inner_;
  std::vector<std::uint32_t> crossed_, edges_, mates_;
  std::vector<vec3> rotated_;
  polygon_triangulator triangulate_;

 public:
  /// Finds the chords. Those of a convex polygon are straight. If signs change more than twice, the mean of the values
  /// is below or above too, and each run of corners of the other sign is cut off by a chord of its own. Any other
  /// polygon is crossed triangle by triangle of its triangulation.
  /// Needs:  above[k] is 1 if corner k has at least the value of the level set, else 0; values and points of all
  ///         corners; start: the corner from which the polygon is triangulated, so that the result does not depend on
  ///         the corner that comes first.
  /// Result: in chords(): every crossed edge is the end of one chord. Larger values are to the left of a chord if the
  ///         polygon is counter-clockwise.
  /// Cost:   O(corners); that of a triangulation if the polygon is not convex.      Errors: none.
  void find(std::span<const unsigned char> above, std::span<const double> values, std::span<const vec3> points,
            double level, std::uint32_t start);

  /// Valid until the next call of find().
  std::span<const level_chord> chords() const { return chords_; }
  std::span<const crossed_diagonal> inner() const { return inner_; }

 private:
  void cut_off_runs(std::span<const unsigned char> above, bool centre_is_above);
  void cross_triangles(std::span<const unsigned char> above, std::span<const vec3> points, std::uint32_t start);
  void link_triangles(std::span<const polygon_triangle> triangles, std::uint32_t start, std::uint32_t n);
  std::uint32_t next_crossed_edge(std::span<const unsigned char> above, std::uint32_t edge) const;
};

/// Whether the mean of some values is at least `level`.
bool mean_is_above(std::span<const double> values, double level);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/level_sets/detail/cut/polygon_crossings.ipp>
#endif
