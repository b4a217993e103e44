// A convex polygon in the plane, as the domain of a Voronoi diagram.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/generate/detail/voronoi/half_spaces.hpp>

#include <vector>

namespace concino::detail {

/// The corners of a convex polygon, in either direction. z of the first one is the height of the plane.
class convex_outline {
  std::vector<vec3> points_;

 public:
  /// Errors: invalid_argument if there are fewer than 3 points, or one is not finite.
  explicit convex_outline(std::vector<vec3> points);

  /// A box around the outline, with a margin, so that all its walls are outside.
  box domain() const;

  /// The lines of its segments. Segments in one line are one wall.
  /// Errors: invalid_argument that names the point at which the outline is not convex; if it has no area or winds
  ///         around its inside more than once.
  std::vector<lattice_plane<2>> walls(const site_lattice<2>& lattice) const;
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/generate/detail/voronoi/convex_outline.ipp>
#endif
