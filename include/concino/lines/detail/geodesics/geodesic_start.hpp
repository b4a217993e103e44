// Where a geodesic starts, and in which triangle.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/tangent_vector.hpp>
#include <concino/geometry/closest_point.hpp>
#include <concino/lines/detail/geodesics/geodesic_surface.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <type_traits>
#include <variant>
#include <vector>

namespace concino::detail {

/// Finds the first triangle of a geodesic. State with side -1: the direction leads out of the surface.
template<SurfaceMesh M>
class geodesic_start {
  static constexpr double nearly_along = 1e-12;  // directions along the boundary do not lead out because of rounding
  const M& m_;
  const geodesic_surface<M>& s_;
  const char* caller_;

  const core::unfolded_triangles& triangles() const { return s_.triangles(); }

  static void turn_to_unit_length(walk_state& w) {
    const double size = std::hypot(w.dx, w.dy);
    w.dx /= size;
    w.dy /= size;
  }

  walk_state from(const vert_t<M>& v, const tangent_vector& d) const {
    const std::size_t i = index_of(m_, v);
    const core::tangent_frame frame = core::make_tangent_frame(m_, triangles(), v, caller_);
    const bool is_closed = triangles().around[i] == core::unfolded_triangles::vert_fan::fan;
    return leave_vert(triangles(), static_cast<int>(i), frame.fan_angle_of(angle(d)),
                      is_closed ? triangles().whole_turn[i] : 2 * std::numbers::pi);
  }

  struct nearest_direction {
    walk_state state;
    double along = -std::numeric_limits<double>::infinity();  // the part of the wanted direction along this one
    bool leads_out = false;                                   // whether the wanted one is beyond the boundary
  };

  nearest_direction nearest_to(std::size_t v, const vec3& d) const {
    nearest_direction best;
    for (int k = triangles().first_corner[v]; k < triangles().first_corner[v + 1]; ++k) {
      const int c = triangles().corner[static_cast<std::size_t>(k)];
      const auto axis = s_.axes(c);
      const double x = dot(d, axis[0]), y = dot(d, axis[1]), whole = triangles().angle[static_cast<std::size_t>(c)];
      const double wanted = std::atan2(y, x);
      const bool is_inside = wanted >= 0 && wanted <= whole,
                 is_before = !is_inside && std::cos(wanted) > std::cos(wanted - whole);
      const double turn = is_inside ? wanted : is_before ? 0 : whole;  // the nearer one of both sides
      const double cosine = std::cos(turn), sine = std::sin(turn), along = x * cosine + y * sine;
      if (along <= best.along) continue;
      const int side = is_before ? c : core::unfolded_triangles::previous(c);
      const double beyond = std::remainder(wanted - turn, 2 * std::numbers::pi);
      best = {{c, 0, 0, cosine, sine, walk_state::location::at_start}, along, false};
      best.leads_out = triangles().twin[static_cast<std::size_t>(side)] == side && std::abs(beyond) > nearly_along &&
                       std::hypot(x, y) > nearly_along;
    }
    return best;
  }

  /// The tangent direction that is nearest to d, unless d leads out of the surface. On a sharp tip all may have parts
  /// against d; then it is the nearest to what d has perpendicular to the normal.
  walk_state from(const vert_t<M>& v, const vec3& d) const {
    const std::size_t i = index_of(m_, v);
    nearest_direction r = nearest_to(i, d);
    if (r.leads_out) return {};
    if (r.along > 0) return r.state;
    vec3 normal;
    for (int k = triangles().first_corner[i]; k < triangles().first_corner[i + 1]; ++k) {
      const int c = triangles().corner[static_cast<std::size_t>(k)];
      const auto axis = s_.axes(c);
      const vec3 of_triangle = triangles().angle[static_cast<std::size_t>(c)] * cross(axis[0], axis[1]);
      normal += dot(of_triangle, normal) < 0 ? -of_triangle : of_triangle;
    }
    const double size = norm(normal);
    const vec3 flat = size > 0 ? d - (dot(d, normal) / (size * size)) * normal : vec3();
    if (!(norm(flat) > 1e-12))
      core::throw_joined<invalid_argument>({caller_, ": the direction at vert ", i,
                                            " is perpendicular to the surface, or there is no poly; choose another"});
    r = nearest_to(i, flat);
    return r.leads_out ? walk_state() : r.state;
  }

  /// The sides of triangles along an edge, first that of the first poly.
  std::vector<int> incidences_of(const edge_t<M>& e) const {
    std::vector<int> sides;
    const int number = static_cast<int>(index_of(m_, e));
    for (const poly_t<M> p : adj_e2p(m_, e))
      for_each_side(p, [&](int side) {
        if (triangles().edge[static_cast<std::size_t>(side)] == number) sides.push_back(side);
      });
    if (sides.empty())
      core::throw_joined<invalid_mesh>({caller_, ": edge ", number, " has no poly, so no geodesic can start there"});
    return sides;
  }

  template<class F>
  void for_each_side(const poly_t<M>& p, F&& f) const {
    const int number = static_cast<int>(index_of(m_, p));
    const auto& poly_of = s_.unfolded.poly_of;
    for (auto k = static_cast<std::size_t>(s_.unfolded.triangle_of[static_cast<std::size_t>(number)]);
         k < poly_of.size() && poly_of[k] == number; ++k)
      for (int side = 0; side < 3; ++side) f(3 * static_cast<int>(k) + side);
  }

  bool is_along(const edge_t<M>& e, int side) const {
    for (const vert_t<M> v : adj_e2v(m_, e)) return static_cast<int>(index_of(m_, v)) == triangles().start(side);
    return true;
  }

  walk_state on_edge(const edge_point<M>& e, int side, double along, double into) const {
    const bool forward = is_along(e.edge, side);
    walk_state w{side, (forward ? e.parameter : 1 - e.parameter) * triangles().length[static_cast<std::size_t>(side)],
                 0,    forward ? along : -along,
                 into, walk_state::location::on_side};
    turn_to_unit_length(w);
    return w;
  }

  walk_state from(const edge_point<M>& e, const tangent_vector& d) const {
    const std::vector<int> sides = incidences_of(e.edge);
    if (d.y >= 0) return on_edge(e, sides[0], d.x, d.y);
    if (sides.size() != 2) return {};
    return on_edge(e, sides[1], d.x, -d.y);
  }

  walk_state from(const edge_point<M>& e, const vec3& d) const {
    const std::vector<int> sides = incidences_of(e.edge);
    int best = -1;
    double into = -std::numeric_limits<double>::infinity();
    for (const int side : sides)
      if (const double y = dot(d, s_.axes(side)[1]); y > into) {
        into = y;
        best = side;
      }
    const vec3 x = s_.axes(best)[0];
    const double along = is_along(e.edge, best) ? dot(d, x) : -dot(d, x);
    if (sides.size() == 1 && into < -nearly_along * norm(d)) return {};
    if (along == 0 && !(into > 0)) throw_perpendicular();
    return on_edge(e, best, along, std::max(into, 0.0));
  }

  [[noreturn, gnu::noinline, gnu::cold]] void throw_perpendicular() const {
    core::throw_joined<invalid_argument>({caller_, ": the direction is perpendicular to the surface; choose another"});
  }

  /// In the triangle of p that is nearest to x.
  walk_state inside(const poly_t<M>& p, const vec3& position, const vec3& d) const {
    const vec3 x = std::ldexp(1.0, -triangles().exponent) * position;
    int best = -1;
    double nearest = std::numeric_limits<double>::infinity();
    for_each_side(p, [&](int side) {
      if (side % 3 != 0) return;
      const vec3 apex = s_.start_of(core::unfolded_triangles::previous(side));
      const double off = distance(x, closest_point(x, s_.start_of(side), s_.end_of(side), apex));
      if (off >= nearest) return;
      nearest = off;
      best = side;
    });
    const auto axis = s_.axes(best);
    const vec3 to =
        closest_point(x, s_.start_of(best), s_.end_of(best), s_.start_of(core::unfolded_triangles::previous(best))) -
        s_.start_of(best);
    walk_state w{
        best, dot(to, axis[0]), dot(to, axis[1]), dot(d, axis[0]), dot(d, axis[1]), walk_state::location::inside};
    if (!(std::hypot(w.dx, w.dy) > 0)) throw_perpendicular();
    turn_to_unit_length(w);
    return w;
  }

  /// The axes of the frame of a poly in space.
  vec3 in_space(const poly_t<M>& p, const tangent_vector& d) const {
    vec3 first, before, x, area;
    std::size_t n = 0;
    for (const vert_t<M> v : adj_p2v(m_, p)) {
      const vec3 here = s_.points[index_of(m_, v)];
      if (n == 0) first = here;
      if (n == 1) x = here - first;
      if (n > 1) area += cross(before - first, here - first);
      before = here;
      ++n;
    }
    const vec3 y = cross(area, x);
    return (d.x / norm(x)) * x + (d.y / norm(y)) * y;
  }

  vec3 in_space(const edge_t<M>& e, const tangent_vector& d) const {
    const int side = incidences_of(e)[0];
    const auto axis = s_.axes(side);
    return (is_along(e, side) ? d.x : -d.x) * axis[0] + d.y * axis[1];
  }

  /// From a vert or an edge of p, by a direction in the plane of p. Over an edge it leads as if the other poly lay in
  /// that plane.
  walk_state from_frame_of(const poly_t<M>& p, const mesh_point<M>& start, const vec3& d) const {
    if (const auto* v = std::get_if<vert_t<M>>(&start.element)) return from(*v, d);
    const auto& e = std::get<edge_point<M>>(start.element);
    std::vector<int> sides = incidences_of(e.edge);
    std::stable_partition(sides.begin(), sides.end(), [&](int side) { return s_.poly_of(side) == p; });
    const auto axis = s_.axes(sides[0]);
    const double along = is_along(e.edge, sides[0]) ? dot(d, axis[0]) : -dot(d, axis[0]), into = dot(d, axis[1]);
    if (into >= -nearly_along * norm(d)) return on_edge(e, sides[0], along, std::max(into, 0.0));
    return sides.size() == 2 ? on_edge(e, sides[1], along, -into) : walk_state();
  }

 public:
  geodesic_start(const M& m, const geodesic_surface<M>& surface, const char* caller)
      : m_(m), s_(surface), caller_(caller) {}

  /// Direction: a tangent_vector or a vec3, not 0; a tangent_vector is in the frame of the element of `given`. start:
  /// the lowest element of `given`.
  /// Errors: invalid_argument if the direction is perpendicular to the surface; unsupported if the frame of a vert has
  ///         no angles.
  template<class Direction>
  walk_state operator()(const mesh_point<M>& start, const Direction& d, const mesh_point<M>& given) const {
    if constexpr (std::is_same_v<Direction, tangent_vector>) {
      if (start.element.index() != given.element.index()) {
        if (const auto* p = std::get_if<poly_t<M>>(&given.element)) return from_frame_of(*p, start, in_space(*p, d));
        return from(std::get<vert_t<M>>(start.element), in_space(std::get<edge_point<M>>(given.element).edge, d));
      }
    }
    if (const auto* v = std::get_if<vert_t<M>>(&start.element)) return from(*v, d);
    if (const auto* e = std::get_if<edge_point<M>>(&start.element)) return from(*e, d);
    const poly_t<M>& p = std::get<poly_t<M>>(start.element);
    if constexpr (std::is_same_v<Direction, tangent_vector>) return inside(p, start.position, in_space(p, d));
    else return inside(p, start.position, d);
  }

  /// The start as the first point of a geodesic. Its position is that of its element.
  mesh_point<M> first_point(const mesh_point<M>& start, const walk_state& state) const {
    if (const auto* v = std::get_if<vert_t<M>>(&start.element)) return s_.at_vert(static_cast<int>(index_of(m_, *v)));
    if (const auto* e = std::get_if<edge_point<M>>(&start.element)) {
      const int side = incidences_of(e->edge)[0];
      return s_.on_side(m_, side, is_along(e->edge, side) ? e->parameter : 1 - e->parameter);
    }
    return s_.inside(state.side, state.x, state.y);
  }
};

}  // namespace concino::detail
