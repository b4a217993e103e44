// map_distortion(m, uv): how much a map of a surface to the plane changes angles and areas, and where it is flipped.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/mesh/corner.hpp>
#include <concino/parametrize/detail/distortion.hpp>
#include <concino/parametrize/detail/read_polys.hpp>

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace concino {

/// The distortion of a map of a surface of type M to the plane.
template<class M>
struct map_distortion_result {
  poly_map<M, double> angle;    // the largest change of an angle between two directions, in radians from 0 to pi
  poly_map<M, double> area;     // the factor by which the area changes, divided by that of the whole surface; 1: as all
  poly_map<M, double> stretch;  // the larger one of the largest factor by which a length grows, and shrinks; 1 or more
  std::vector<poly_t<M>> flips;  // the polys with parts that are mirrored, or have no area in the plane
  std::size_t flipped = 0;       // their number
  double max_angle = 0, mean_angle = 0;  // of all polys; the mean is weighted by area on the surface
  double min_area = 1, max_area = 1;     // of all polys
  double max_stretch = 1;                // of all polys
  double scale = 0;  // the area in the plane, without regard to its sign, divided by that on the surface
};

/// Measures a map of a surface to the plane, such as lscm(m), poly by poly. Each poly is cut into triangles by
/// diagonals, and the map is linear on each of these. A value of a poly is the worst one of its triangles.
/// Needs:  SurfaceMesh M, Embedded, no temporary; it need not be a disk. uv: a map from verts to points of the plane,
///         or, for surfaces with seams, from corners.
/// Result: a conformal map has the angles 0; one that preserves areas up to scale has the areas 1; an isometry has the
///         stretches 1 as well. A mirrored triangle has the angle pi. A triangle that has no area on the surface is not
///         measured, but for the sign that it has in the plane. Angles, areas and flips do not change if m or uv is
///         scaled.
/// Cost:   O(corners) for most polys, see polygon_triangulator.
/// Errors: invalid_mesh if there are no polys, or a point is not finite; invalid_argument if a point of uv is not
///         finite.
/// Source: Floater, Hormann 2005, "Surface parameterization: a tutorial and survey"; Snyder 1987, "Map projections",
///         for the largest change of an angle.
template<class M, class U>
  requires detail::can_be_mapped<M> &&
      (detail::gives_uv<U, vert_t<M>> || detail::gives_uv<U, corner<std::remove_cvref_t<M>>>)
map_distortion_result<std::remove_cvref_t<M>> map_distortion(M&& m, const U& uv) {
  using mesh = std::remove_cvref_t<M>;
  const mesh& surface = m;
  detail::polys_of_mesh<mesh, detail::flat_polys> read(surface);
  detail::scale_polys(read.flat, "map_distortion");
  std::vector<uv_point> at_corner;
  at_corner.reserve(read.flat.corners.size());
  for (const poly_t<mesh> p : polys(surface)) {
    std::uint32_t k = 0;
    for (const vert_t<mesh> v : adj_p2v(surface, p)) {
      if constexpr (detail::gives_uv<U, vert_t<mesh>>) {
        const auto& x = uv[v];
        at_corner.push_back({static_cast<double>(x[0]), static_cast<double>(x[1])});
      } else {
        const auto& x = uv[corner<mesh>{p, k}];
        at_corner.push_back({static_cast<double>(x[0]), static_cast<double>(x[1])});
      }
      ++k;
    }
  }
  const detail::flat_distortion d = detail::distortion_of(read.flat, at_corner);
  map_distortion_result<mesh> result{make_poly_map<double>(surface, 0.0), make_poly_map<double>(surface, 1.0),
                                     make_poly_map<double>(surface, 1.0), {}};
  std::size_t i = 0;
  for (const poly_t<mesh> p : polys(surface)) {
    result.angle[p] = d.angle[i];
    result.area[p] = d.area[i];
    result.stretch[p] = d.stretch[i];
    if (d.is_flipped[i]) result.flips.push_back(p);
    ++i;
  }
  result.flipped = result.flips.size();
  result.max_angle = d.max_angle;
  result.mean_angle = d.mean_angle;
  result.min_area = d.min_area;
  result.max_area = d.max_area;
  result.max_stretch = d.max_stretch;
  result.scale = d.scale;
  return result;
}

// What to write instead of calls that cannot compile.
template<class... T> void map_distortion(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void map_distortion(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void map_distortion(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;

}  // namespace concino
