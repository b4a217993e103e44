// Overhangs of a part that is printed layer by layer, and the supports that they need.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/print/detail/supports/overhang_search.hpp>
#include <concino/print/detail/supports/part_surface.hpp>

#include <optional>
#include <vector>

namespace concino {

struct overhang_options {
  vec3 direction = {0, 0, 1};          // in which the part grows, away from the plate; of any length but 0
  double max_angle_deg = 45;           // in [0, 90]: polys whose angle is smaller need supports, see overhangs
  std::optional<double> plate = {};    // height of the plate along the direction, in units of the mesh: at or below the
                                       // part; without it, at the lowest point
  double plate_tolerance = 1e-6;       // in [0, 0.1]: polys lie on the plate if they are this close, as a fraction of
                                       // the diagonal of the part
};

/// What overhangs. Polys are polys of a surface, or faces of a volume.
template<class M>
struct overhang_report {
  std::vector<polygon_t<M>> polys;    // that need supports, in the order of the mesh
  double area = 0;                    // of these
  double support_volume = 0;          // of straight supports below all of their area, down to the part or the plate
  double contact_area = 0;            // of the part with the supports: at their tops, and where they stand on the part
  double plate_area = 0;              // of the polys that lie on the plate
  double plate = 0;                   // the height of the plate
  double height = 0;                  // of the highest point above the plate
  std::vector<polygon_t<M>> ignored;  // polys without an area
};

/// The polys that overhang, and the supports that they need. For example: auto o = overhangs(m, {.direction = {0, 0,
/// 1}}); The angle of a poly is that between its outward normal and straight down: 0 of a ceiling, 90 of a wall. A poly
/// overhangs if it is smaller than max_angle_deg.
///
///       direction  ^    ________________
///                  |   |     part      /
///                  |   |             /  \   outward normal
///                  |   |           /|     v
///                  |   |         /  |       the angle: between the normal and the line straight down
///       -----------+---+-------+----v----------------------------------- plate
///
/// Needs:  EmbeddedMesh. A surface is closed, and its polys are counter-clockwise seen from outside; of a volume it is
///         the boundary. An open surface has the overhangs of its polys. Polys that are not planar have the normal of
///         their vector area.
/// Result: polys at the limit are not included, up to 1e-6 degrees; nor are those that lie on the plate. Supports end
///         at the next poly below that faces up: so the volume is right for surfaces that do not intersect themselves.
///         It is the exact integral of the heights over the projection of the overhanging polys, up to rounding: about
///         1e-12 of the cube of the diameter. Verts and edges that hang with steep polys around them, such as the tip
///         of a cone, need supports too, but have no area.
/// Cost:   O(n log n) for n polys of similar size, also where most are long and parallel; O(n^2) for long polys in many
///         directions; parallel.
/// Errors: invalid_mesh if a vert of a poly is not finite, or if a closed surface is inside out; invalid_argument if an
///         option is out of its range.
template<EmbeddedMesh M>
overhang_report<M> overhangs(const M& m, const overhang_options& options = {}) {
  const vec3 up = detail::checked_direction(options.direction, "overhangs");
  const detail::printed_part<M> part = detail::outer_surface(m, "overhangs");
  const detail::overhang_figures found = detail::find_overhangs(
      part.surface, up, {options.max_angle_deg, options.plate, options.plate_tolerance}, "overhangs");
  const detail::supports_size supports = detail::supports_below(part.surface, up, found);
  const auto& s = part.surface;
  return {part.elements(found.polygons),  s.to_mesh(found.area, 2),
          s.to_mesh(supports.volume, 3),  s.to_mesh(supports.contact_area, 2),
          s.to_mesh(found.plate_area, 2), s.height_to_mesh(found.plate, up),
          s.to_mesh(found.height, 1),     part.ignored};
}

// What to write instead of calls that cannot compile.
template<class... T> void overhangs(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void overhangs(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
