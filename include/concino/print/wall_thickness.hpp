// Walls that are too thin to be printed, and gaps that are too narrow.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/print/detail/supports/part_surface.hpp>

#include <optional>
#include <vector>

namespace concino {

struct wall_options {
  std::optional<double> spacing = {};  // above 0, in units of the mesh: of the rays of large polys; without it, a
                                       // hundredth of the diagonal of the part
  double max_tilt_deg = 45;            // in [0, 90]: the two polys of a wall or gap are parallel up to this angle
};

/// The shortest distance that was measured between a poly and one opposite to it. Polys are polys of a surface, or
/// faces of a volume.
template<class M>
struct poly_thickness {
  polygon_t<M> poly{};
  double thickness = 0;
  polygon_t<M> opposite{};
  vec3 from, to;  // where it was measured: a point of poly, and one of opposite
};

namespace detail {

struct polygon_thickness {
  std::uint32_t polygon = 0, opposite = 0;
  double thickness = 0;
  vec3 from, to;
};

/// Thicknesses below `limit`, in units of the mesh. Rays start inward, or outward for gaps.
std::vector<polygon_thickness> find_thin_places(const part_surface& part, double limit, bool outward,
                                                const wall_options& options, const char* caller);

template<class M>
std::vector<poly_thickness<M>> thin_places(const M& m, double limit, bool outward, const wall_options& options,
                                           const char* caller) {
  const printed_part<M> part = outer_surface(m, caller);
  std::vector<poly_thickness<M>> result;
  for (const polygon_thickness& t : find_thin_places(part.surface, limit, outward, options, caller))
    result.push_back({part.polygons[t.polygon], t.thickness, part.polygons[t.opposite], t.from, t.to});
  return result;
}

}  // namespace detail

/// The polys behind which the part is thinner than `thickness`: for (const auto& w : thin_walls(m, 0.8)) ... w.poly,
/// w.thickness
/// Needs:  EmbeddedMesh. A surface is closed, and its polys are counter-clockwise seen from outside; of a volume it is
///         the boundary. An infinite thickness measures all polys.
/// Result: one entry for each poly that is thinner, in the order of the mesh, with the smallest thickness that was
///         measured. Rays start at points of the poly against its normal, and end where they leave the part; so a place
///         that is thin between the rays may be missed. Where a ray ends at a poly with a tilt above max_tilt_deg, as
///         at the edge of a wedge, there is no wall. Polys without an area are not measured.
/// Cost:   O(log n) for each ray: one at least for each triangle of each of n polys; parallel.
/// Errors: invalid_mesh as overhangs; invalid_argument if `thickness` is not above 0, or an option is out of its range.
/// Source: the ray method; Patil and Ravi 2005, "Voxel-based representation, display and thickness analysis of
///         intricate shapes", compare it with others.
template<EmbeddedMesh M>
std::vector<poly_thickness<M>> thin_walls(const M& m, double thickness, const wall_options& options = {}) {
  return detail::thin_places(m, thickness, false, options, "thin_walls");
}

/// The polys in front of which there is a gap narrower than `width`.
/// Needs:  as thin_walls.      Result: as thin_walls, but rays start along the normal and end where they enter the
///         part.
/// Cost:   as thin_walls.      Errors: as thin_walls.
template<EmbeddedMesh M>
std::vector<poly_thickness<M>> narrow_gaps(const M& m, double width, const wall_options& options = {}) {
  return detail::thin_places(m, width, true, options, "narrow_gaps");
}

// What to write instead of calls that cannot compile.
template<class... T> void thin_walls(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void thin_walls(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void narrow_gaps(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void narrow_gaps(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/print/detail/supports/wall_thickness.ipp>
#endif
