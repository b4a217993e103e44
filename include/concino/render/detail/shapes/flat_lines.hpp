// Reads polylines of any form into flat arrays: ranges of points, results of level sets and of integral lines, walks
// along a mesh.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/error.hpp>
#include <concino/core/vec3.hpp>
#include <concino/geometry/centroid.hpp>

#include <concepts>
#include <cstdint>
#include <iterator>
#include <limits>
#include <vector>

namespace concino::requirement {

/// A point p with p[0], p[1] and p[2], or an object with such a p.position, as mesh_point.
template<class P> concept has_coordinates = requires(const P& p) {
  { p[0] } -> std::convertible_to<double>;
  { p[1] } -> std::convertible_to<double>;
  { p[2] } -> std::convertible_to<double>;
};
template<class P> concept is_point = has_coordinates<P> || requires(const P& p) {
  requires has_coordinates<decltype(p.position)>;
};

/// A container, a view, an array or braces of points.
template<class R> concept is_point_range = requires(const R& r) {
  std::end(r);
  requires is_point<std::remove_cvref_t<decltype(*std::begin(r))>>;
};
/// A polyline: a range of points, or an object that has one as `points`.
template<class L> concept is_polyline = is_point_range<L> || requires(const L& l) {
  requires is_point_range<std::remove_cvref_t<decltype(l.points)>>;
};
template<class R> concept is_polyline_range = requires(const R& r) {
  std::end(r);
  requires is_polyline<std::remove_cvref_t<decltype(*std::begin(r))>>;
};
template<class L> concept is_lines = is_polyline<L> || is_polyline_range<L>;

/// A walk along a mesh: a range of its verts, a range of its polys, or an object that has a range of verts as `verts`,
/// as edge_walk.
template<class R, class X> concept is_range_of = requires(const R& r) {
  std::end(r);
  requires std::same_as<std::remove_cvref_t<decltype(*std::begin(r))>, X>;
};
template<class L, class M> concept is_vert_walk = is_range_of<L, vert_t<M>> || requires(const L& l) {
  requires is_range_of<std::remove_cvref_t<decltype(l.verts)>, vert_t<M>>;
};
template<class L, class M> concept is_poly_walk = EmbeddedMesh<M> && is_range_of<L, poly_t<M>>;
template<class L, class M> concept is_walk = is_vert_walk<L, M> || is_poly_walk<L, M>;
template<class R, class M> concept is_walk_range = requires(const R& r) {
  std::end(r);
  requires is_walk<std::remove_cvref_t<decltype(*std::begin(r))>, M>;
};

}  // namespace concino::requirement

namespace concino::detail {

template<requirement::is_point P>
vec3 position_of(const P& p) {
  if constexpr (requirement::has_coordinates<P>) return to_vec3(p);
  else return to_vec3(p.position);
}

/// Polylines, one after another.
struct flat_lines {
  std::vector<vec3> points;
  std::vector<std::uint32_t> ends;    // line i has the points from ends[i - 1] to ends[i]
  std::vector<std::uint8_t> closed;   // by line: 1 if its last point is joined to the first

  void end_line(bool is_closed) {
    if (points.size() >= std::numeric_limits<std::uint32_t>::max())
      throw unsupported("make_tubes: the lines have more than 4,294,967,294 points");
    ends.push_back(static_cast<std::uint32_t>(points.size()));
    closed.push_back(is_closed);
  }

  /// Adds a polyline. Whether it is closed is said by itself, or by `is_closed`.
  template<requirement::is_polyline L>
  void add(const L& line, bool is_closed) {
    if constexpr (requirement::is_point_range<L>) {
      for (const auto& p : line) points.push_back(position_of(p));
    } else {
      for (const auto& p : line.points) points.push_back(position_of(p));
    }
    if constexpr (requires { { line.closed } -> std::convertible_to<bool>; }) end_line(line.closed);
    else end_line(is_closed);
  }

  /// Adds a walk along m.
  template<class M, requirement::is_walk<M> L>
  void add(const M& m, const L& walk, bool is_closed) {
    if constexpr (requirement::is_poly_walk<L, M>) {
      for (const auto& p : walk) points.push_back(centroid(m, p));
    } else if constexpr (requirement::is_range_of<L, vert_t<M>>) {
      for (const auto& v : walk) points.push_back(to_vec3(point(m, v)));
    } else {
      for (const auto& v : walk.verts) points.push_back(to_vec3(point(m, v)));
    }
    if constexpr (requires { { walk.is_closed() } -> std::convertible_to<bool>; }) end_line(walk.is_closed());
    else end_line(is_closed);
  }
};

}  // namespace concino::detail
