// Paths along edges, made straight.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/iterable.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/fields/exact_paths.hpp>
#include <concino/lines/detail/geodesics/flip_out.hpp>
#include <concino/lines/detail/geodesics/geodesic_surface.hpp>
#include <concino/lines/detail/geodesics/geodesic_walker.hpp>
#include <concino/mesh/element_map.hpp>

#include <cmath>
#include <concepts>
#include <cstddef>
#include <initializer_list>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino {

struct straighten_options {
  bool closed = false;  // whether the last vert is joined to the first one
};

namespace detail {

template<SurfaceMesh M>
struct surface_with_lengths {
  geodesic_surface<M> surface;
  intrinsic_triangles intrinsic;

  surface_with_lengths(const M& m, const char* caller) : surface(m, caller), intrinsic(surface.triangles(), caller) {}
};

/// Straightens one path; flips edges of a copy.
template<SurfaceMesh M>
class path_on_surface {
  static constexpr const char* caller = "straighten";
  const M& m_;
  const geodesic_surface<M>& surface_;
  intrinsic_triangles intrinsic_;

  const core::unfolded_triangles& triangles() const { return surface_.triangles(); }

  int half_edge(int from, int to) const {
    const core::unfolded_triangles& t = triangles();
    const auto v = static_cast<std::size_t>(from);
    for (int k = t.first_corner[v]; k < t.first_corner[v + 1]; ++k) {
      const int c = t.corner[static_cast<std::size_t>(k)];
      for (const int side : {c, core::unfolded_triangles::previous(c)})
        for (const int h : {side, intrinsic_.twin[static_cast<std::size_t>(side)]})
          if (intrinsic_.start[static_cast<std::size_t>(h)] == from && intrinsic_.end(h) == to &&
              !surface_.unfolded.is_diagonal(side))
            return h;
    }
    core::throw_joined<invalid_argument>({caller, ": no edge with polys joins vert ", static_cast<std::size_t>(from),
                                          " to vert ", static_cast<std::size_t>(to),
                                          "; give the verts of a path along edges, such as that of shortest_path"});
  }

  /// Half-edge h as a walk over the surface; without its start, ending near its end.
  walk_result walk_along(int h) const {
    const core::unfolded_triangles& t = triangles();
    const auto i = static_cast<std::size_t>(h), v = static_cast<std::size_t>(intrinsic_.start[i]);
    const double whole = t.whole_turn[v],
                 turn = t.around[v] == core::unfolded_triangles::vert_fan::fan ? whole : whole + 1;
    const walk_state from = leave_vert(t, intrinsic_.start[i], intrinsic_.fan_angle[i], turn);
    return walk_straight(surface_.triangles(), from, intrinsic_.length[i], t.vert.size());
  }

  /// Whether the point is at vert v, but for rounding.
  bool is_near(const walk_stop& s, int v) const {
    constexpr double tolerance = 1e-7;
    if (s.vert >= 0) return s.vert == v;
    if (s.is_inside) return true;
    return (triangles().start(s.side) == v && s.along < tolerance) ||
           (triangles().end(s.side) == v && s.along > 1 - tolerance);
  }

  void add_points(int h, std::vector<mesh_point<M>>& points) const {
    const int target = intrinsic_.end(h);
    std::vector<walk_stop> stops = walk_along(h).stops;
    for (std::size_t k = 0; k < stops.size(); ++k)
      if (stops[k].vert == target) stops.resize(k);
    while (!stops.empty() && is_near(stops.back(), target)) stops.pop_back();
    for (const walk_stop& s : stops) points.push_back(surface_.point_of(m_, s));
    points.push_back(surface_.at_vert(target));
  }

 public:
  path_on_surface(const M& m, const surface_with_lengths<M>& prepared)
      : m_(m), surface_(prepared.surface), intrinsic_(prepared.intrinsic) {}

  template<class P>
  geodesic_path<M> straightened(const P& path, bool is_closed) {
    std::vector<int> number, half_edges;
    for (const vert_t<M>& v : path) {
      if (!contains(m_, v))
        core::throw_joined<invalid_mesh>(
            {caller, ": the path has a vert that is not one of the mesh; take it from verts(m)"});
      const int i = static_cast<int>(index_of(m_, v));
      if (number.empty() || number.back() != i) number.push_back(i);
    }
    if (is_closed && number.size() > 1 && number.front() == number.back()) number.pop_back();
    for (std::size_t k = 1; k < number.size(); ++k) half_edges.push_back(half_edge(number[k - 1], number[k]));
    if (is_closed && number.size() > 1) half_edges.push_back(half_edge(number.back(), number.front()));
    const std::vector<int> straight = flip_out(intrinsic_, half_edges, is_closed);
    geodesic_path<M> r;
    if (number.empty()) return r;
    r.length = 0;
    if (straight.empty() && is_closed) return r;
    r.points.push_back(surface_.at_vert(
        straight.empty() ? number.front() : intrinsic_.start[static_cast<std::size_t>(straight.front())]));
    for (const int h : straight) {
      r.length += intrinsic_.length[static_cast<std::size_t>(h)];
      add_points(h, r.points);
    }
    if (is_closed) r.points.pop_back();
    r.length = std::ldexp(r.length, triangles().exponent);
    return r;
  }
};

template<class M, class P> concept gives_path = core::iterable<P> && requires(const P& path) {
  { *path.begin() } -> std::convertible_to<vert_t<M>>;
};

}  // namespace detail

/// A surface prepared by prepare_straighten. Several threads may query it. Copies share the prepared data.
template<SurfaceMesh M>
  requires Embedded<M>
class prepared_straighten {
  detail::mesh_ref<M> mesh_;
  std::shared_ptr<const detail::surface_with_lengths<M>> prepared_;

 public:
  explicit prepared_straighten(const M& m)
      : mesh_(m), prepared_(std::make_shared<const detail::surface_with_lengths<M>>(m, "straighten")) {}

  const M& mesh() const { return mesh_.get(); }

  /// The path, made straight.
  /// Needs:  as straighten. The mesh has not changed since it was prepared.
  /// Result: that of straighten.
  /// Cost:   the flips, and a copy of the lengths and links of all edges.      Errors: as straighten, about the path.
  template<class P>
    requires detail::gives_path<M, P>
  geodesic_path<M> straighten(const P& path, const straighten_options& options = {}) const {
    return detail::path_on_surface<M>(mesh_.get(), *prepared_).straightened(path, options.closed);
  }
  geodesic_path<M> straighten(std::initializer_list<vert_t<M>> path, const straighten_options& options = {}) const {
    return straighten<std::initializer_list<vert_t<M>>>(path, options);
  }
  void straighten(mistake::number<mistake::name_the_element>, ...) const = delete;  // elements have types: vert_id{0}, not 0
};

/// Prepares a surface for many paths: auto s = prepare_straighten(m); auto g = s.straighten(path).
/// Needs:  as straighten; the mesh must not change afterwards.
/// Result: an object with straighten(path).      Cost: O(size of the mesh).      Errors: as straighten, except those
///         about the path.
template<class M>
  requires SurfaceMesh<M> && Embedded<M> && requirement::is_lvalue_or_view<M>
prepared_straighten<std::remove_cvref_t<M>> prepare_straighten(M&& m) {
  return prepared_straighten<std::remove_cvref_t<M>>(m);
}

/// A path along edges of a surface, shortened over the surface until it is straight: auto g = straighten(m,
/// shortest_path(m, v, w)). It passes to either side of the verts on its way, but never over one that is a bump or a
/// hole.
/// Needs:  Embedded SurfaceMesh, not a temporary, orientable, with or without boundary. The polys at each vert are one
///         fan. path: a container of verts, or braces; consecutive verts are joined by edges. With .closed the last one
///         is joined to the first one, too.
/// Result: a path between the same verts, or a closed one, whose last point is joined to the first one. It is a
///         geodesic that can be reached from the path by shortening, and never longer than the path. If the shortest
///         path can be reached, and there are no others, it is that. See geodesic_path; where it crosses a diagonal of
///         a polygon that is not a triangle, the point is in the poly. Polygons are triangulated. A closed path that
///         shrinks to a vert has no points. One that ends as a single loop at a vert may have a corner there. Where the
///         path crosses itself at a vert, it may keep a corner.
/// Cost:   O(size of the mesh) to prepare, see prepare_straighten, and a number of flips that depends on the path: in
///         practice proportional to the edges between both paths.
/// Errors: invalid_argument if consecutive verts are not joined by an edge of a poly. invalid_mesh if a vert is not one
///         of the mesh, or a poly has no area or points that are not finite. unsupported if the surface is not
///         orientable, or the polys at a vert are not one fan.
/// Source: Sharp, Crane 2020, "You can find geodesic paths in triangle meshes by just flipping edges".
template<class M, class P>
  requires SurfaceMesh<M> && Embedded<M> && requirement::is_lvalue_or_view<M> && detail::gives_path<M, P>
geodesic_path<std::remove_cvref_t<M>> straighten(M&& m, const P& path, const straighten_options& options = {}) {
  return prepare_straighten(m).straighten(path, options);
}
template<class M>
  requires SurfaceMesh<M> && Embedded<M> && requirement::is_lvalue_or_view<M> geodesic_path<std::remove_cvref_t<M>>
  straighten(M&& m, std::initializer_list<vert_t<M>> path, const straighten_options& options = {}) {
    return prepare_straighten(m).straighten(path, options);
  }

// What to write instead of calls that cannot compile.
template<class... T> void prepare_straighten(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void prepare_straighten(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void prepare_straighten(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void straighten(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void straighten(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void straighten(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void straighten(mistake::any_mesh, mistake::number<mistake::name_the_element>, ...) = delete;  // elements have types: vert_id{0}, not 0

}  // namespace concino
