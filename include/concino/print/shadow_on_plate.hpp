// The shadow of a part on the plate: what the part covers, seen along the direction in which it grows.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/print/detail/supports/part_surface.hpp>
#include <concino/print/planar_regions.hpp>
#include <concino/print/polygon_clipper.hpp>

#include <optional>

namespace concino {

struct shadow_options {
  vec3 direction = {0, 0, 1};        // in which the part grows, away from the plate; of any length but 0
  std::optional<double> plate = {};  // height of the plate along the direction, in units of the mesh: at or below the
                                     // part; without it, at the lowest point
};

/// Regions of the plate: their point (a, b) is origin + a step_x + b step_y in space.
struct plate_shadow : planar_regions {
  vec3 origin;          // in the plate
  vec3 step_x, step_y;  // of length 1 and perpendicular to each other and to the direction
};

namespace detail {

plate_shadow find_shadow(const part_surface& part, const shadow_options& options, const polygon_clipper& back_end);

}  // namespace detail

/// What a part covers of the plate: shadow_on_plate(m, clipper).area(). A brim is an offset of it: region_offset(
/// shadow_on_plate(m, clipper), 5, clipper)
/// Needs:  EmbeddedMesh, of any shape; surfaces may be open. Of a volume it is the boundary. A back end such as
///         concino::clipper.
/// Result: the union of the projections of all polys; polygons of more than three verts are the triangles of
///         triangulate_polygon. Regions do not overlap. For the direction of z, their coordinates are x and y of the
///         mesh. They are snapped to a unit, a power of two with 2^40 units or more in the size of the part, or their
///         last digit. Polys seen edge-on, and those without an area, have no shadow.
/// Cost:   O(n log n) for n polys, and that of the back end for the edges between what faces up and what does not.
/// Errors: invalid_mesh as overhangs; invalid_argument if an option is out of its range. unsupported if the back end
///         cannot hold the coordinates.
template<EmbeddedMesh M>
plate_shadow shadow_on_plate(const M& m, const polygon_clipper& back_end, const shadow_options& options = {}) {
  return detail::find_shadow(detail::outer_surface(m, "shadow_on_plate").surface, options, back_end);
}

// What to write instead of calls that cannot compile.
template<EmbeddedMesh M> void shadow_on_plate(const M&) = delete;                         // pass a back end: shadow_on_plate(m, clipper), with #include <concino/adapters/clipper.hpp> (Debian: libpolyclipping-dev)
template<EmbeddedMesh M> void shadow_on_plate(const M&, const shadow_options&) = delete;  // pass a back end: shadow_on_plate(m, clipper, {...}), with #include <concino/adapters/clipper.hpp> (Debian: libpolyclipping-dev)
template<class... T> void shadow_on_plate(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void shadow_on_plate(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/print/detail/supports/shadow_on_plate.ipp>
#endif
