// A bounding volume hierarchy of the polys of any mesh. Queries: nearest poly, polys hit by a ray or a box, poly that
// contains a point, inside or outside.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/geometry/detail/box_tree_build.hpp>
#include <concino/geometry/detail/polygon_pieces.hpp>
#include <concino/geometry/detail/solid_pieces.hpp>
#include <concino/geometry/detail/surface_facts.hpp>
#include <concino/geometry/detail/tree_queries.hpp>
#include <concino/geometry/detail/tree_ray.hpp>
#include <concino/geometry/tree_hits.hpp>
#include <concino/mesh/element_map.hpp>

#include <optional>
#include <type_traits>
#include <vector>

namespace concino {

namespace detail {

template<class M> struct pieces_of;
template<SurfaceMesh M> struct pieces_of<M> { using type = polygon_pieces<M>; };
template<VolumeMesh M> struct pieces_of<M> { using type = polyhedron_pieces<M>; };
template<VolumeMesh M>
  requires TetMesh<M>
struct pieces_of<M> { using type = tet_pieces<M>; };

}  // namespace detail

/// The result of bounding_tree(m), for the mesh as it was then. Polygons of more than three verts are the triangles of
/// triangulate_polygon; polyhedra are solid, with each face of more than three verts as a fan about its mean point as
/// in `volume`. Results called exact are as exact as orient2d and orient3d, for coordinates divided by the largest one.
///
/// Several threads may query at once. If several polys are equally good answers, the result is the first of them in
/// polys(m). Every query takes O(log n) time if polys are well distributed, plus the size of its result. Testing one
/// polyhedron takes time proportional to the total number of verts of its faces.
/// Errors of every query: invalid_argument if a point is not finite.
template<class M>
class poly_tree {
  using pieces = typename detail::pieces_of<M>::type;

  detail::mesh_ref<M> mesh_;
  pieces pieces_;
  detail::box_tree boxes_;
  detail::surface_facts facts_;

 public:
  using mesh_type = M;

  explicit poly_tree(const M& m) : mesh_(m), pieces_(m) {
    // volumes need no such facts: their polys define inside and outside
    if constexpr (SurfaceMesh<M>) facts_ = detail::facts_of(m, pieces_);
    std::vector<std::uint32_t> order;
    boxes_ = detail::build_box_tree(
        pieces_.size(), pieces::leaf_size, [&](std::size_t i) { return pieces_.box_of(i); }, order);
    pieces_.arrange(order);
  }

  const M& mesh() const { return mesh_.get(); }

  /// The point of the surface, or of the solid polys of the volume, nearest to x.
  /// Result: x itself at distance 0 inside a volume; converts to false if there are no polys.
  closest_hit<M> closest(const vec3& x) const {
    require_finite(x, "closest");
    if constexpr (pieces::are_solid)
      if (const auto p = locate(x)) return {*p, x, 0, true};
    const vec3 y = pieces_.to_tree_within_reach(x);
    const auto found = detail::nearest_piece(pieces_, boxes_, y);
    if (!found) return {};
    const vec3 nearest = pieces_.to_mesh(found->second);
    return {pieces_.poly(found->first), nearest, pieces_.distance_in_mesh(x, nearest, y, found->second), true};
  }

  /// The first hit of the ray from `origin` with a poly, including its boundary: the ray passes through no edge or vert
  /// unnoticed. Surfaces are hit from both sides. A polygon seen edge-on is not hit, but its neighbours are. A ray that
  /// starts in a solid poly hits it at its origin.
  /// Result: parameter in lengths of `direction`, which may have any length; exactly 0 if the origin lies on or in a
  ///         poly.
  /// Errors: invalid_argument if the direction is 0 or not finite or max_parameter is negative or not a number.
  crossing_hit<M> ray(const vec3& origin, const vec3& direction, const ray_options& options = {}) const {
    const detail::tree_ray r(pieces_, boxes_, origin, direction, options);
    const auto [rank, crossing] = r.first();
    return crossing ? r.template hit<M>(rank, crossing) : crossing_hit<M>{};
  }

  /// The first hit of the ray with each poly that it hits, sorted by parameter.      Errors: as ray.
  std::vector<crossing_hit<M>> ray_all(const vec3& origin, const vec3& direction,
                                       const ray_options& options = {}) const {
    const detail::tree_ray r(pieces_, boxes_, origin, direction, options);
    std::vector<crossing_hit<M>> hits;
    for (const auto& [rank, crossing] : r.all()) hits.push_back(r.template hit<M>(rank, crossing));
    return hits;
  }

  /// All polys that have a point in common with the box, including its boundary, in the order of polys(m). Exact.
  /// Result: none for an empty box; bounds may be infinite.      Errors: none.
  std::vector<poly_t<M>> in_box(const box& wanted) const {
    std::vector<poly_t<M>> hit_polys;
    for (const std::size_t rank : detail::pieces_in_box(pieces_, boxes_, pieces_.to_tree(wanted)))
      hit_polys.push_back(pieces_.poly(rank));
    return hit_polys;
  }

  /// The poly that contains x. Exact. If polys tile a domain, every point of it has a result, always the same poly,
  /// even on shared faces, edges and verts. If polys overlap, it is one of those that contain x.
  /// Volumes:  the poly in which x lies; none if x is outside of all.
  /// Surfaces: the poly that contains x in the projection along a coordinate axis: the axis along which the surface
  /// shows the largest signed area (z for a
  ///           closed surface). If there are several, the nearest. So x need not be exactly in the plane of a planar
  ///           surface; for a terrain it is the poly under x. None if x is beside the surface in that projection. Polys
  ///           seen edge-on contain nothing.
  std::optional<poly_t<M>> locate(const vec3& x) const {
    require_finite(x, "locate");
    const vec3 y = pieces_.to_tree(x);
    auto found = detail::containing_piece(pieces_, boxes_, facts_.axis, y, detail::point_location::perturbed);
    if (!found) found = detail::containing_piece(pieces_, boxes_, facts_.axis, y, detail::point_location::unperturbed);
    return found ? std::optional<poly_t<M>>(pieces_.poly(*found)) : std::nullopt;
  }

  /// Whether x is inside or on a closed surface, or in some poly of a volume. Exact, even for points in line with edges
  /// and verts.
  /// Errors: invalid_mesh if the surface has an edge with an odd number of polys: it then has no inside.
  bool is_inside(const vec3& x, [[maybe_unused]] const inside_options& options = {}) const {
    require_finite(x, "is_inside");
    if constexpr (pieces::are_solid) return locate(x).has_value();
    if (facts_.open_edge != detail::surface_facts::none)
      core::throw_joined<invalid_mesh>(
          {"is_inside: the surface is open at edge ", facts_.open_edge, "; only closed surfaces have an inside"});
    const auto around = detail::surface_around(pieces_, boxes_, pieces_.to_tree(x));
    return around.touches || (options.rule == inside_rule::winding ? around.winding != 0 : around.crossings % 2 != 0);
  }

 private:
  static void require_finite(const vec3& x, const char* query) {
    if (!is_finite(x)) core::throw_joined<invalid_argument>({query, ": the point is not finite"});
  }
};

/// A bounding volume hierarchy of the polys of m.
/// Needs:  EmbeddedMesh, no temporary; of any shape: concave, non-planar, degenerate, open or non-manifold.
/// Result: a poly_tree, with the queries closest, ray, ray_all, in_box, locate and is_inside. It contains copies of the
///         points and ignores later changes of m.
/// Cost:   O(n log n) time for n triangles of a surface or polys of a volume, in parallel; some 70 bytes per triangle,
///         100 per tet.
/// Errors: invalid_mesh if a vert of a poly is not finite.
/// Source: MacDonald and Booth 1990 for the tree; for the queries see there.
template<class M>
  requires requirement::is_lvalue_or_view<M> && EmbeddedMesh<M>
poly_tree<std::remove_cvref_t<M>> bounding_tree(M&& m) {
  return poly_tree<std::remove_cvref_t<M>>(m);
}

// What to write instead of calls that cannot compile.
template<class... T> void bounding_tree(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void bounding_tree(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void bounding_tree(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
