// make_balls: points, and the verts of meshes and graphs, as small balls.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/render/detail/shapes/flat_lines.hpp>
#include <concino/render/drawable.hpp>

#include <initializer_list>
#include <optional>
#include <span>
#include <vector>

namespace concino {

struct ball_options {
  double radius = 0;                         // in units of the mesh, 0 or more; 0: 0.8 % of the diagonal of the
                                             // bounding box of all points
  rgb color = srgb(0.84f, 0.13f, 0.14f);     // if there are neither colours nor values
  std::span<const double> values = {};       // one for each point: the balls have the colours of `map`
  std::span<const rgb> colors = {};          // one for each point
  std::span<const double> radii = {};        // one for each point, instead of `radius`: each above 0
  colormap map = colormap::blue_to_yellow;   // of the values
  std::optional<value_scale> scale = {};     // from values to positions in the map, such as that of a mesh; empty:
                                             // linear over the finite values
  double opacity = 1;                        // in [0, 1]
  int triangles = 0;                         // of each ball: 20, 80, 320 or 1280; 0: 1280 for up to 50 balls, 320 for
                                             // up to 1,000, 80 for up to 10,000, else 20
};

namespace detail {

drawable balls_at(std::span<const vec3> centers, const ball_options& options);

}  // namespace detail

/// Balls at points: cn::make_balls(points, {.radius = 0.01, .color = {1, 0, 0}}).
/// Needs:  points: a range of points p with p[0], p[1], p[2] or with such a p.position.
/// Result: a drawable of closed surfaces with smooth normals. `polys` has the number of the point of each polygon.
///         Values that are not finite have the colour look.no_value.
/// Cost:   about 90 bytes for each triangle; O(triangles).
/// Errors: invalid_argument if a point is not finite, naming it; if an option is out of its range; if there are values,
///         colours or radii, but not one for each point. unsupported if there are too many triangles for 32-bit
///         numbers.
/// Source: an icosahedron whose triangles are split into four.
template<class P = std::initializer_list<vec3>>
  requires requirement::is_point_range<P>
drawable make_balls(const P& points, const ball_options& options = {}) {
  std::vector<vec3> centers;
  for (const auto& p : points) centers.push_back(detail::position_of(p));
  return detail::balls_at(centers, options);
}

/// Balls at the verts of a mesh or a graph, in the order of verts(m).
/// Needs:  Embedded M with verts.
/// Result: as above.      Cost: as above.      Errors: as above.
template<Embedded M>
  requires requirement::has_verts<M>
drawable make_balls(const M& m, const ball_options& options = {}) {
  std::vector<vec3> centers;
  for (const vert_t<M> v : verts(m)) centers.push_back(to_vec3(point(m, v)));
  return detail::balls_at(centers, options);
}

// What to write instead of calls that cannot compile.
template<class... T> void make_balls(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void make_balls(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/render/detail/shapes/balls.ipp>
#endif
