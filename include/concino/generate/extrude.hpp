// Extrusion: the volume between a surface and its copy moved by a vector.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/generate/detail/common/construct_from_arrays.hpp>
#include <concino/generate/detail/common/inverted_polys.hpp>
#include <concino/generate/detail/sweep/swept_surface.hpp>
#include <concino/geometry/normals.hpp>

#include <cmath>

namespace concino {

struct extrude_options {
  bool properties = true;                             // whether named properties of verts, of polys and of the mesh are
                                                      // transferred, if m has any
  concino::correspondence* correspondence = nullptr;  // unless null, filled with the vert or poly of m of which each
                                                      // vert and poly was made
  std::vector<poly_id>* inverted = nullptr;           // unless null, filled with the polys of the result whose scaled
                                                      // Jacobian is not above 0
};

namespace detail {

/// A vector of any size, which is not 0, scaled to length 1.
inline vec3 direction_of_length_1(const vec3& a) {
  const vec3 b = a / std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)});
  return b / norm(b);
}

/// Whether a poly is clockwise seen from where a vert of it moves to; the angle between the poly and the motion must be
/// 1e-12 or more.
struct sweep_direction {
  const char* caller;

  /// Errors: invalid_mesh that names a poly without area; invalid_argument that names one that the motion is parallel
  ///         to.
  bool is_reversed(std::size_t poly, const vec3& normal, const vec3& direction) const {
    if (normal == vec3()) core::throw_joined<invalid_mesh>({caller, ": poly ", poly, " has no area; remove it first"});
    const double height = dot(normal, direction);
    if (!(std::abs(height) > 1e-12))
      core::throw_joined<invalid_argument>(
          {caller, ": poly ", poly,
           " moves parallel to itself, so that its cells would have no volume; choose another direction"});
    return height < 0;
  }
};

}  // namespace detail

/// The volume that a surface passes through when it moves by the vector `direction`: extrude(m, {0, 0, 1}, 10). Each
/// poly gives a column of `layers` prisms.
/// Needs:  Embedded SurfaceMesh; polys that share an edge move to the same side of the surface, as all do if m is a
///         graph over a plane across the direction.
/// Result: a hexmesh if M has quads only by type, else a polyhedralmesh. Verts are those of verts(m) for each of layers
///         + 1 levels, from m on, level by level, and polys those of polys(m) for each layer. All cells have a positive
///         volume, whichever way the direction points: polys with normals against it are reversed. Cells of polygons
///         that are not convex are inverted at a corner, though their volume is right; options.inverted lists them.
///         Properties of verts and polys, and of the mesh, are transferred by their rules.
/// Cost:   O(size of the result); the points in parallel.
/// Errors: invalid_argument if layers is 0, if direction is 0 or not finite, or if the result would have too many
///         elements. It names a poly parallel to the direction, and two polys that share an edge and face the direction
///         with different sides. invalid_mesh that names a poly without area, a vert whose point is not finite, an edge
///         of more than two polys, or one along which two polys run in the same direction.
template<SurfaceMesh M>
  requires Embedded<M> detail::swept_mesh<M> extrude(const M& m, const vec3& direction, std::size_t layers = 1,
                                                     const extrude_options& options = {}) {
    detail::check_at_least("extrude", "layers", layers, 1);
    detail::check_finite("extrude", "direction", direction);
    if (direction == vec3()) core::throw_joined<invalid_argument>({"extrude: direction is 0; it must have a length"});
    detail::check_sweep_counts("extrude", "layers", layers, num_verts(m), num_polys(m), detail::num_poly_corners(m));
    const vec3 unit = detail::direction_of_length_1(direction);
    const detail::sweep_direction towards{"extrude"};
    const auto s = detail::read_swept_surface(
        "extrude", m, [&](const poly_t<M>& p) { return towards.is_reversed(index_of(m, p), normal(m, p), unit); });
    const detail::sweep_layers all{s.points.size(), layers};
    const auto at = [&](std::size_t level, std::uint32_t v) {
      return level == layers ? s.points[v] + direction
                             : s.points[v] + (static_cast<double>(level) / static_cast<double>(layers)) * direction;
    };
    auto result = detail::construct_swept(m, s, all, at, options.properties, options.correspondence);
    if (options.inverted) *options.inverted = detail::inverted_polys(result);
    return result;
  }

// What to write instead of calls that cannot compile.
template<class... T> void extrude(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void extrude(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
