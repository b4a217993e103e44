// A tree of boxes over the polys of any mesh: the nearest one, those that a ray or a box meets, the one that holds a point, inside or outside.
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

/// Made by bounding_tree(m); answers for the mesh as it was then. Polygons of more than three verts are the triangles of triangulate_polygon;
/// polyhedra are solid, each face of more than three verts fanned about its mean point as in `volume`. What is called exact is so as far as orient2d
/// and orient3d are, for coordinates divided by the largest one.
///
/// Queries may come from several threads at once. Of several polys that answer equally well the first in polys(m) is given. Every query takes
/// O(log n) time where polys are well spread, plus the size of its answer; a polyhedron that is looked at costs as many steps as its faces have
/// verts.
/// Errors of every query: invalid_argument where a point is not finite.
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
    if constexpr (SurfaceMesh<M>) facts_ = detail::facts_of(m, pieces_);  // volumes know inside from outside by their polys
    std::vector<std::uint32_t> order;
    boxes_ = detail::build_box_tree(pieces_.size(), pieces::leaf_size, [&](std::size_t i) { return pieces_.box_of(i); }, order);
    pieces_.arrange(order);
  }

  const M& mesh() const { return mesh_.get(); }

  /// The point of the surface, or of the solid polys of the volume, that is nearest to x.
  /// Result: x itself at distance 0 inside a volume; false if there are no polys.
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

  /// Where the ray from `origin` first meets a poly, rims included: it slips through no edge or vert. Surfaces are met from both sides; a polygon
  /// seen from its edge is not, but its neighbours are. In a solid poly the ray begins to meet it at its origin.
  /// Result: parameter in lengths of `direction`, which may have any; 0 exactly where the origin lies on or in a poly.
  /// Errors: invalid_argument if the direction is 0 or not finite or max_parameter is negative or not a number.
  crossing_hit<M> ray(const vec3& origin, const vec3& direction, const ray_options& options = {}) const {
    const detail::tree_ray r(pieces_, boxes_, origin, direction, options);
    const auto [rank, crossing] = r.first();
    return crossing ? r.template hit<M>(rank, crossing) : crossing_hit<M>{};
  }

  /// All polys that the ray meets, each where it is met first, in the order of their parameters.      Errors: as ray.
  std::vector<crossing_hit<M>> ray_all(const vec3& origin, const vec3& direction, const ray_options& options = {}) const {
    const detail::tree_ray r(pieces_, boxes_, origin, direction, options);
    std::vector<crossing_hit<M>> hits;
    for (const auto& [rank, crossing] : r.all()) hits.push_back(r.template hit<M>(rank, crossing));
    return hits;
  }

  /// All polys that have a point in common with the box, its sides included, in the order of polys(m). Exact.
  /// Result: none for an empty box; sides may be infinite.      Errors: none.
  std::vector<poly_t<M>> in_box(const box& wanted) const {
    std::vector<poly_t<M>> met;
    for (const std::size_t rank : detail::pieces_in_box(pieces_, boxes_, pieces_.to_tree(wanted))) met.push_back(pieces_.poly(rank));
    return met;
  }

  /// The poly that holds x. Exact: where polys tile, one of them is found for every point, those on shared faces, edges and verts included, and
  /// always the same; where polys overlap, one of those that hold x.
  /// Volumes:  the poly in which x lies; nothing outside of all.
  /// Surfaces: the poly in which x lies as seen along the coordinate axis along which the surface shows the largest area, counted with sign (z for a
  ///           closed surface); of several over one another, the nearest. So for a surface in a plane x need not be in the plane to the last bit; for
  ///           a terrain it is the poly under x. Nothing where x is beside the surface in that view. Polys seen from their edge hold nothing.
  std::optional<poly_t<M>> locate(const vec3& x) const {
    require_finite(x, "locate");
    const vec3 y = pieces_.to_tree(x);
    auto found = detail::containing_piece(pieces_, boxes_, facts_.axis, y, detail::point_location::perturbed);
    if (!found) found = detail::containing_piece(pieces_, boxes_, facts_.axis, y, detail::point_location::unperturbed);
    return found ? std::optional<poly_t<M>>(pieces_.poly(*found)) : std::nullopt;
  }

  /// Whether x is inside of a closed surface or on it, or in some poly of a volume. Exact, also where the way out passes edges and verts.
  /// Errors: invalid_mesh if the surface has an edge with an odd number of polys: it has no inside.
  bool is_inside(const vec3& x, [[maybe_unused]] const inside_options& options = {}) const {
    require_finite(x, "is_inside");
    if constexpr (pieces::are_solid) return locate(x).has_value();
    if (facts_.open_edge != detail::surface_facts::none)
      core::throw_joined<invalid_mesh>({"is_inside: the surface is open at edge ", facts_.open_edge, "; only closed surfaces have an inside"});
    const auto around = detail::surface_around(pieces_, boxes_, pieces_.to_tree(x));
    return around.touches || (options.rule == inside_rule::winding ? around.winding != 0 : around.crossings % 2 != 0);
  }

 private:
  static void require_finite(const vec3& x, const char* query) {
    if (!is_finite(x)) core::throw_joined<invalid_argument>({query, ": the point is not finite"});
  }
};

/// A tree over the polys of m.
/// Needs:  EmbeddedMesh, no temporary; of any shape, concave, non-planar, degenerate, open or not manifold.
/// Result: a poly_tree, with the queries closest, ray, ray_all, in_box, locate and is_inside. It keeps copies of the points and does not follow later
///         changes of m.
/// Cost:   O(n log n) time for n triangles of a surface or polys of a volume, in parallel; some 70 bytes a triangle, 100 a tet.
/// Errors: invalid_mesh where a vert of a poly is not finite.
/// Source: MacDonald and Booth 1990 for the tree; the queries name theirs.
template<class M>
  requires requirement::is_lvalue_or_view<M> && EmbeddedMesh<M>
poly_tree<std::remove_cvref_t<M>> bounding_tree(M&& m) {
  return poly_tree<std::remove_cvref_t<M>>(m);
}

// What to write instead of calls that cannot compile.
template<class... T> void bounding_tree(mistake::no_mesh_traits<mistake::include_adapter>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or a sibling
template<class... T> void bounding_tree(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void bounding_tree(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
