// The frames of tangent vectors at the verts of a surface, see tangent_vector.hpp.
#pragma once

#include <concino/core/tangent_vector.hpp>
#include <concino/geometry/support/unfolded_surface.hpp>

#include <cstddef>
#include <numbers>
#include <vector>

namespace concino::core {

/// Angles in the frame of a vert, from angles in the fan of triangles about it, and back.
struct tangent_frame {
  double zero = 0, scale = 1;  // the angle in the fan of angle 0; what angles of the fan are multiplied by
  bool is_reversed = false;    // whether angles of the frame increase where those of the fan decrease

  double angle_of(double fan_angle) const { return (is_reversed ? -scale : scale) * (fan_angle - zero); }
  double fan_angle_of(double angle) const { return zero + (is_reversed ? -angle : angle) / scale; }

  /// Whether the frame of the vert at corner c is oriented as the triangle is.
  bool is_oriented_as_triangle(const unfolded_triangles& t, int c) const {
    return (t.is_backward[static_cast<std::size_t>(c)] != 0) == is_reversed;
  }
};

/// first_edge: the index of the first edge of vert v, or -1.
/// Errors: unsupported that names the vert if the polys about it are not one fan.
inline tangent_frame make_tangent_frame(const unfolded_triangles& t, std::size_t v, int first_edge,
                                        const char* caller) {
  tangent_frame r;
  const int first = t.first_corner[v], end = t.first_corner[v + 1];
  if (first == end) return r;
  if (t.around[v] == unfolded_triangles::vert_fan::other)
    throw_joined<unsupported>({caller, ": the polys at vert ", v,
                               " are not one fan, so it has no tangent plane; give each fan a vert of its own by "
                               "split_vert_fans(m), and remove polys at edges with more than two"});
  r.is_reversed = t.is_backward[static_cast<std::size_t>(t.corner[static_cast<std::size_t>(first)])] != 0;
  if (t.around[v] == unfolded_triangles::vert_fan::fan) r.scale = 2 * std::numbers::pi / t.whole_turn[v];
  for (int k = first; k < end; ++k) {
    const int c = t.corner[static_cast<std::size_t>(k)];
    if (t.edge[static_cast<std::size_t>(c)] == first_edge) r.zero = t.fan_angle(c, 0);
    else if (t.edge[static_cast<std::size_t>(unfolded_triangles::previous(c))] == first_edge)
      r.zero = t.fan_angle(c, t.angle[static_cast<std::size_t>(c)]);
  }
  return r;
}
template<SurfaceMesh M>
tangent_frame make_tangent_frame(const M& m, const unfolded_triangles& t, const vert_t<M>& v, const char* caller) {
  int first_edge = -1;
  for (const edge_t<M> e : adj_v2e(m, v)) {
    first_edge = static_cast<int>(index_of(m, e));
    break;
  }
  return make_tangent_frame(t, index_of(m, v), first_edge, caller);
}

/// The frames of all verts, by index.
template<SurfaceMesh M>
std::vector<tangent_frame> make_tangent_frames(const M& m, const unfolded_triangles& t, const char* caller) {
  std::vector<tangent_frame> r(t.around.size());
  for (const vert_t<M> v : verts(m)) r[index_of(m, v)] = make_tangent_frame(m, t, v, caller);
  return r;
}

}  // namespace concino::core
