// Exact geodesic distances and shortest paths over triangle meshes, to rounding.
#pragma once

#include <concino/concepts/surface_mesh.hpp>
#include <concino/core/message.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/fields/detail/exact/exact_windows.hpp>
#include <concino/fields/detail/heat/geodesic_sources.hpp>
#include <concino/fields/exact_paths.hpp>
#include <concino/geometry/lowest_element.hpp>
#include <concino/geometry/support/unfolded_surface.hpp>
#include <concino/mesh/element_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace concino {

namespace detail {

/// Errors: as exact_geodesics.
template<SurfaceMesh M>
core::unfolded_surface prepare_exact(const M& m) {
  for (const poly_t<M> p : polys(m)) {
    std::size_t n = 0;
    for ([[maybe_unused]] const vert_t<M> v : adj_p2v(m, p)) ++n;
    if (n != 3)
      core::throw_joined<unsupported>({"exact_geodesics: poly ", index_of(m, p), " has ", n,
                                       " verts; all polys must be triangles: triangulate it, or use heat_geodesics"});
  }
  return core::unfold_surface(m, "exact_geodesics");
}

}  // namespace detail

/// A surface prepared by prepare_exact_geodesics for distance and path queries. Several threads may query it. Copies
/// share the prepared data.
template<class M>
class prepared_exact_geodesics {
  detail::mesh_ref<M> mesh_;
  std::shared_ptr<const core::unfolded_surface> prepared_;

  const core::unfolded_triangles& triangles() const { return prepared_->triangles; }

  struct start {
    int vert;
    double distance;
  };

  void add_start(std::vector<start>& starts, const vert_t<M>& v, double distance) const {
    if (!contains(mesh_.get(), v))
      throw invalid_mesh("exact_geodesics: a source is not a vert of the mesh; take it from verts(m)");
    const int i = static_cast<int>(index_of(mesh_.get(), v));
    if (!std::isfinite(distance))
      core::throw_joined<invalid_argument>(
          {"exact_geodesics: the initial distance at vert ", static_cast<std::size_t>(i), " is not finite"});
    starts.push_back({i, distance});
  }

  vert_map<M, double> solve(detail::exact_windows& windows, double least, int target = -1) const {
    const std::vector<double>& d = windows.run(target);
    auto r = make_vert_map<double>(mesh_.get(), std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < d.size(); ++i) r.values()[i] = least + std::ldexp(d[i], triangles().exponent);
    return r;
  }

  template<class S>
  vert_map<M, double> solve_from(const S& sources, detail::path_tree* paths = nullptr, int target = -1) const {
    std::vector<start> starts;
    detail::for_each_distance_source<M>(sources, [&](const vert_t<M>& v, double d) { add_start(starts, v, d); });
    if (starts.empty()) throw invalid_argument("exact_geodesics: there is no source; give at least one vert");
    double least = starts.front().distance;
    for (const start& s : starts) least = std::min(least, s.distance);
    detail::exact_windows windows(triangles(), paths);
    for (const start& s : starts) windows.add_vert(s.vert, std::ldexp(s.distance - least, -triangles().exponent));
    return solve(windows, least, target);
  }
  /// source_point: set to the source, at the lowest element of p that contains x.
  vert_map<M, double> solve_from(const poly_t<M>& p, const vec3& x, mesh_point<M>& source_point,
                                 detail::path_tree* paths = nullptr) const;

  detail::path_tree empty_tree() const { return detail::path_tree(triangles().around.size()); }
  exact_paths<M> with_paths(vert_map<M, double> distances, detail::path_tree tree,
                            std::optional<mesh_point<M>> source_point = {}) const {
    return {std::move(distances), prepared_, std::move(tree), std::move(source_point)};
  }

 public:
  explicit prepared_exact_geodesics(const M& m)
      : mesh_(m), prepared_(std::make_shared<const core::unfolded_surface>(detail::prepare_exact(m))) {}

  const M& mesh() const { return mesh_.get(); }

  /// The distances of all verts from one vert or from the nearest of several. Sources may be pairs of a vert and an
  /// initial distance: then the distance is the minimum over all sources of the initial distance plus the distance from
  /// there.
  /// Needs:  a vert, a container of verts or of pairs, or braces of either: {v, w}, {{v, 0.5}, {w, 0.0}}. The mesh has
  ///         not changed since it was prepared.
  /// Result: a map of double, in units of length; +inf at verts that no path over polys reaches.
  /// Cost:   see exact_geodesics.
  /// Errors: invalid_argument if there is no source or a number is not finite; invalid_mesh if a source is not a vert
  ///         of the mesh.
  template<class S>
    requires(detail::gives_verts<M, S> || detail::gives_distances<M, S>)
  vert_map<M, double> distance_from(const S& sources) const {
    return solve_from(sources);
  }
  vert_map<M, double> distance_from(std::initializer_list<vert_t<M>> sources) const {
    return distance_from<std::initializer_list<vert_t<M>>>(sources);
  }
  vert_map<M, double> distance_from(std::initializer_list<std::pair<vert_t<M>, double>> sources) const {
    return distance_from<std::initializer_list<std::pair<vert_t<M>, double>>>(sources);
  }
  void distance_from(mistake::number<mistake::name_the_element>, ...) const = delete;  // elements have types: vert_id{0}, not 0

  /// The distances of all verts from the point x of poly p, as a place of its lowest element.
  /// Result, cost: as above.      Errors: those of lowest_element.
  vert_map<M, double> distance_from(const poly_t<M>& p, const vec3& x) const {
    mesh_point<M> source_point{p, x};
    return solve_from(p, x, source_point);
  }

  /// The shortest paths to all verts. It takes the same sources as distance_from.
  /// Result: an object with distances() and path_to(v).
  /// Cost:   as distance_from, and memory for the windows on some path.      Errors: as distance_from.
  template<class S>
    requires(detail::gives_verts<M, S> || detail::gives_distances<M, S>)
  exact_paths<M> paths_from(const S& sources) const {
    detail::path_tree tree = empty_tree();
    auto distances = solve_from(sources, &tree);
    return with_paths(std::move(distances), std::move(tree));
  }
  exact_paths<M> paths_from(std::initializer_list<vert_t<M>> sources) const {
    return paths_from<std::initializer_list<vert_t<M>>>(sources);
  }
  exact_paths<M> paths_from(std::initializer_list<std::pair<vert_t<M>, double>> sources) const {
    return paths_from<std::initializer_list<std::pair<vert_t<M>, double>>>(sources);
  }
  exact_paths<M> paths_from(const poly_t<M>& p, const vec3& x) const {
    detail::path_tree tree = empty_tree();
    mesh_point<M> source_point{p, x};
    auto distances = solve_from(p, x, source_point, &tree);
    return with_paths(std::move(distances), std::move(tree), std::move(source_point));
  }

  /// The shortest path between two verts.
  /// Result: see geodesic_path.      Cost: as distance_from, but the search ends at the target.
  /// Errors: invalid_mesh if source or target is not a vert of the mesh.
  geodesic_path<M> path_between(const vert_t<M>& source, const vert_t<M>& target) const {
    if (!contains(mesh_.get(), target))
      throw invalid_mesh("exact_geodesics: the target is not a vert of the mesh; take it from verts(m)");
    detail::path_tree tree = empty_tree();
    auto distances = solve_from(source, &tree, static_cast<int>(index_of(mesh_.get(), target)));
    return with_paths(std::move(distances), std::move(tree)).path_to(target);
  }
};

template<class M>
vert_map<M, double> prepared_exact_geodesics<M>::solve_from(const poly_t<M>& p, const vec3& x,
                                                            mesh_point<M>& source_point,
                                                            detail::path_tree* paths) const {
  const M& m = mesh_.get();
  source_point = detail::lowest_element_of(m, mesh_point<M>{p, x}, "exact_geodesics", "source");
  detail::exact_windows windows(triangles(), paths);
  if (const auto* v = std::get_if<vert_t<M>>(&source_point.element)) {
    windows.add_vert(static_cast<int>(index_of(m, *v)), 0);
    return solve(windows, 0);
  }
  std::array<vec3, 3> corner;
  std::size_t n = 0;
  const double unit = std::ldexp(1.0, -triangles().exponent);
  for (const vert_t<M> v : adj_p2v(m, p)) corner[n++] = unit * to_vec3(point(m, v));
  const vec3 side = corner[1] - corner[0], to = unit * source_point.position - corner[0];
  const double length = norm(side);
  windows.add_point(3 * prepared_->triangle_of[index_of(m, p)], dot(to, side) / length, norm(cross(side, to)) / length);
  return solve(windows, 0);
}

/// Prepares exact distances and shortest paths over a triangle mesh, for many queries: auto exact =
/// prepare_exact_geodesics(m); auto d = exact.distance_from(v). Then d[w] is the length of a shortest path over the
/// surface, to rounding; exact.path_between(v, w) is the path.
/// Needs:  Embedded SurfaceMesh of triangles, by type or in fact; not a temporary, and not changed later. It may have a
///         boundary; paths may run along it. It may be non-oriented or non-manifold: at an edge of more than two
///         triangles, paths pass from each triangle to every other. A vert may have several fans.
/// Result: an object with distance_from(...), paths_from(...) and path_between(...). It only uses the lengths of edges,
///         which rounding changes by parts in 10^16. A triangle with an angle of a radians makes a length uncertain by
///         about 10^-16 / a of it.
/// Cost:   O(n) to prepare, for n triangles. A query takes O(n^2 log n) at worst if no edge has more than two
///         triangles, on common surfaces about n^1.7: 0.1 s for 2 10^4 triangles, 1.4 s for 8 10^4, twice that on flat
///         surfaces. The heat method is faster and takes any polys, but it is not exact: see prepare_heat_geodesics.
/// Errors: unsupported if a poly is no triangle; invalid_mesh if one has no area or points that are not finite.
/// Source: Mitchell, Mount, Papadimitriou 1987; windows and their order: Surazhsky, Surazhsky, Kirsanov, Gortler, Hoppe
///         2005, "Fast exact and approximate geodesics on meshes"; which windows are dropped: Chen and Han 1990, Xin
///         and Wang 2009.
template<class M>
  requires SurfaceMesh<M> && Embedded<M> && requirement::is_lvalue_or_view<M>
prepared_exact_geodesics<std::remove_cvref_t<M>> prepare_exact_geodesics(M&& m) {
  return prepared_exact_geodesics<std::remove_cvref_t<M>>(m);
}

/// Exact distances over a triangle mesh, for a single query: from one vert, from the nearest of several, or from a
/// point of a poly.
/// Needs:  as prepare_exact_geodesics; sources as for its distance_from.
/// Result: a map of double, in units of length; +inf at verts that no path over polys reaches.
/// Cost:   as prepare_exact_geodesics and its distance_from.
/// Errors: as prepare_exact_geodesics and its distance_from.
/// Source: as prepare_exact_geodesics.
template<class M, class S = std::initializer_list<vert_t<M>>>
  requires SurfaceMesh<M> && Embedded<M> && requirement::is_lvalue_or_view<M> &&
           (detail::gives_verts<std::remove_cvref_t<M>, S> || detail::gives_distances<std::remove_cvref_t<M>, S>)
vert_map<std::remove_cvref_t<M>, double> exact_geodesics(M&& m, const S& sources) {
  return prepare_exact_geodesics(m).distance_from(sources);
}
template<class M>
  requires SurfaceMesh<M> && Embedded<M> && requirement::is_lvalue_or_view<M> vert_map < std::remove_cvref_t<M>,
double > exact_geodesics(M&& m, std::initializer_list<std::pair<vert_t<M>, double>> sources) {
  return prepare_exact_geodesics(m).distance_from(sources);
}
template<class M>
  requires SurfaceMesh<M> && Embedded<M> && requirement::is_lvalue_or_view<M>
vert_map<std::remove_cvref_t<M>, double> exact_geodesics(M&& m, const poly_t<M>& p, const vec3& x) {
  return prepare_exact_geodesics(m).distance_from(p, x);
}

// What to write instead of calls that cannot compile.
template<class... T> void prepare_exact_geodesics(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void prepare_exact_geodesics(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void prepare_exact_geodesics(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void prepare_exact_geodesics(mistake::any_mesh, mistake::number<mistake::name_the_element>, ...) = delete;  // elements have types: vert_id{0}, poly_id{0} ..., not 0
template<class... T> void exact_geodesics(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void exact_geodesics(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void exact_geodesics(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void exact_geodesics(mistake::any_mesh, mistake::number<mistake::name_the_element>, ...) = delete;  // elements have types: vert_id{0}, poly_id{0} ..., not 0

}  // namespace concino
