// The Voronoi cells of points in a rectangle or a convex outline, as a polygon mesh.
#pragma once

#include <concino/generate/detail/voronoi/convex_outline.hpp>
#include <concino/generate/detail/voronoi/relax_sites.hpp>
#include <concino/mesh/polygonmesh.hpp>

#include <initializer_list>

namespace concino {

struct voronoi_options {
  unsigned relax = 0;  // number of Lloyd iterations: sites move to the centroids of their cells, so that cells become
                       // rounder and more uniform
};

namespace detail {

/// The cells of a diagram in the plane, which have one loop each.
inline polygonmesh polygons_of_cells(const voronoi_complex<2>& cells) {
  surface_arrays a;
  for (std::uint32_t v = 0; v < cells.num_verts(); ++v) a.points.push_back(cells.point(v));
  a.offsets.push_back(0);
  for (std::uint32_t i = 0; i < cells.num_cells(); ++i) {
    for (const std::uint32_t v : cells.verts(i)) a.verts.push_back(vert_id{v});
    a.offsets.push_back(static_cast<std::uint32_t>(a.verts.size()));
  }
  return polygonmesh(std::move(a));
}

}  // namespace detail

/// The Voronoi diagram of sites in a rectangle: poly i is the set of points that are nearer to site i than to any other
/// site.
/// Needs:  sites, a container of points (z is ignored) or points in braces, inside the rectangle (x and y of `domain`)
///         or on its border; all different.
/// Result: a conforming mesh in the plane z = domain.min.z that fills the rectangle. Its polys are convex and
///         counter-clockwise. If four or more sites lie on one circle, as in a grid, their cells share one vert. Verts
///         closer than 2^-39 of the longest side are merged, and sites are rounded to 2^-49 of it. Scales exactly with
///         powers of 2. The result does not depend on the number of threads.
/// Cost:   O(n) time and memory for sites of about even density, in parallel.
/// Errors: invalid_argument naming the site that is not finite, is outside, equals another, or whose cell is thinner
///         than the rounding. invalid_argument if there is no site, or if the rectangle is empty, is more than 2^32
///         times as long as wide, or is not finite, min.z included.
/// Source: Ray, Sokolov, Lefebvre and Levy 2018; Lloyd 1982.
template<class Sites = std::initializer_list<vec3>>
  requires detail::PointRange<Sites>
polygonmesh voronoi_polygons(const Sites& sites, const box& domain, const voronoi_options& options = {}) {
    if (!std::isfinite(domain.min.z))
      throw invalid_argument(
          "voronoi_polygons: min.z of the box is not finite; it is the height of the plane of the polygons");
    return detail::with_relaxed_sites<2>(sites, domain, options.relax, [](const std::vector<vec3>& x, const box& b) {
      const detail::site_lattice<2> lattice(x, b);
      return detail::polygons_of_cells(detail::voronoi_complex<2>(lattice));
    });
}

/// The Voronoi diagram of sites inside a convex polygon: cells are cut off at it.
/// Needs:  the corners of a convex polygon, a container of at least 3 points in either direction; z of the first one is
///         the height of the mesh, and z of the others is ignored. Points within its segments are allowed. Sites as
///         above, inside the polygon or on its border.
/// Result: as above, for the inside of the polygon instead of a rectangle. Precise relative to the box around the
///         polygon, larger by an eighth.
/// Cost:   as above, and O(n m) time for n sites and m corners.
/// Errors: as above. invalid_argument that names a point of the outline that is not finite or at which it is not
///         convex, or a site outside of it. The same if the outline has less than 3 points, no area, or winds around
///         its inside more than once.
/// Source: as above; cells cut by walls as by bisectors.
template<class Sites = std::initializer_list<vec3>, class Outline>
  requires detail::PointRange<Sites> && detail::PointRange<Outline>
polygonmesh voronoi_polygons(const Sites& sites, const Outline& outline, const voronoi_options& options = {}) {
  const detail::convex_outline domain(detail::points_of_sites(outline));
  return detail::with_relaxed_sites<2>(sites, domain.domain(), options.relax,
                                       [&](const std::vector<vec3>& x, const box& b) {
                                         const detail::site_lattice<2> lattice(x, b);
                                         const auto walls = domain.walls(lattice);
                                         detail::check_inside<2>(lattice, walls, "outline");
                                         return detail::polygons_of_cells(detail::voronoi_complex<2>(lattice, walls));
                                       });
}

}  // namespace concino
