// The Voronoi cells of points in a box, as a polyhedral mesh.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/generate/detail/voronoi/convex_walls.hpp>
#include <concino/generate/voronoi_polygons.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/mesh/polyhedralmesh.hpp>

namespace concino {

namespace detail {

inline polyhedralmesh polyhedra_of(const voronoi_complex<3>& cells) {
  polyhedra_arrays a;
  for (std::uint32_t v = 0; v < cells.num_verts(); ++v) a.points.push_back(cells.point(v));
  a.face_offsets.push_back(0);
  a.poly_offsets.push_back(0);
  std::vector<face_id> face_of;  // by loop
  for (std::uint32_t i = 0; i < cells.num_cells(); ++i) {
    for (std::uint32_t l = cells.first_loop(i); l < cells.first_loop(i + 1); ++l) {
      const std::uint32_t other = cells.beyond(l);
      if (other < i) {  // the face was added with the cell on its other side
        std::uint32_t there = cells.first_loop(other);
        while (cells.beyond(there) != i) ++there;
        face_of.push_back(face_of[there]);
      } else {
        face_of.push_back(face_id{a.num_faces()});
        for (const std::uint32_t v : cells.verts(l)) a.face_verts.push_back(vert_id{v});
        a.face_offsets.push_back(static_cast<std::uint32_t>(a.face_verts.size()));
      }
      a.poly_faces.push_back(face_of.back());
      a.outward.push_back(other > i);
    }
    a.poly_offsets.push_back(static_cast<std::uint32_t>(a.poly_faces.size()));
  }
  return polyhedralmesh(std::move(a));
}

}  // namespace detail

/// The Voronoi diagram of sites in a box: poly i is the set of points that are nearer to site i than to any other site.
/// Needs:  sites, a container of points or points in braces, inside the box or on its boundary; all different.
/// Result: a conforming mesh that fills the box. Its polys are convex, and its faces are planar up to rounding. If more
///         than four sites lie on one sphere, as in a grid, their cells share one vert, and faces and edges without
///         size are left out. Verts closer than 2^-39 of the longest side are merged, and sites are rounded to 2^-49 of
///         it. Scales exactly with powers of 2. The result does not depend on the number of threads.
/// Cost:   O(n) time and memory for sites of about even density, in parallel.
/// Errors: invalid_argument naming the site that is not finite, is outside, equals another, or whose cell is thinner
///         than the rounding. invalid_argument if there is no site, or if the box is empty, not finite, or more than
///         2^32 times as long as wide.
/// Source: as voronoi_polygons.
template<class Sites = std::initializer_list<vec3>>
  requires detail::PointRange<Sites>
polyhedralmesh voronoi_polyhedra(const Sites& sites, const box& domain, const voronoi_options& options = {}) {
  return detail::with_relaxed_sites<3>(sites, domain, options.relax, [](const std::vector<vec3>& x, const box& b) {
    const detail::site_lattice<3> lattice(x, b);
    const detail::voronoi_complex<3> cells(lattice);
    return detail::polyhedra_of(cells);
  });
}

/// The Voronoi diagram of sites inside a convex surface: cells are cut off at it.
/// Needs:  an Embedded SurfaceMesh that is closed and convex, with planar polys, oriented inward or outward; sites as
///         above, inside it or on it.
/// Result: as above, for the inside of the surface instead of a box. Polys of the surface in one plane are one wall of
///         the cells. Precise relative to the box around the surface, larger by an eighth.
/// Cost:   as above, and O(n walls) time for n sites.
/// Errors: as above. invalid_mesh that names the poly of the surface at which it is open, not convex or not oriented
///         consistently, or which is not planar or has no area. invalid_mesh if the surface is empty, not finite or in
///         several pieces. invalid_argument that names a site outside of it.
/// Source: as voronoi_polygons; cells cut by walls as by bisectors.
template<class Sites = std::initializer_list<vec3>, SurfaceMesh S>
  requires detail::PointRange<Sites> && Embedded<S>
polyhedralmesh voronoi_polyhedra(const Sites& sites, const S& surface, const voronoi_options& options = {}) {
    return detail::with_relaxed_sites<3>(
        sites, detail::box_around(surface), options.relax, [&](const std::vector<vec3>& x, const box& b) {
          const detail::site_lattice<3> lattice(x, b);
          const detail::convex_walls<S> walls(surface, lattice);
          const auto planes = walls.planes();
          detail::check_inside<3>(lattice, planes, "surface");
          polyhedralmesh m = detail::polyhedra_of(detail::voronoi_complex<3>(lattice, planes));
          if (!(std::abs(total_measure(m) - walls.enclosed_volume()) <= 1e-6 * walls.enclosed_volume()))
            throw invalid_mesh(
                "voronoi_polyhedra: the surface is not convex: it winds around its inside more than once");
          return m;
        });
}

// What to write instead of calls that cannot compile.
template<class Sites = std::initializer_list<vec3>> void voronoi_polyhedra(const Sites&, mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class Sites = std::initializer_list<vec3>> void voronoi_polyhedra(const Sites&, mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
