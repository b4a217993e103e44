// The frames of tangent vectors at the verts of a surface, see tangent_vector.hpp.
#pragma once

#include <concino/core/tangent_vector.hpp>
#include <concino/geometry/unfolded_surface.hpp>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace concino::core {

/// Angles in frames of verts, from angles in the fans of triangles about them, and back.
struct tangent_frames {
  std::vector<double> zero, scale;        // by vert: the angle in the fan of angle 0; what angles of the fan are multiplied by
  std::vector<unsigned char> is_reversed;  // by vert: whether angles of the frame increase where those of the fan decrease

  double angle_of(int vert, double fan_angle) const {
    const auto v = static_cast<std::size_t>(vert);
    const double turned = scale[v] * (fan_angle - zero[v]);
    return is_reversed[v] ? -turned : turned;
  }

  /// In [0, whole turn) where the fan is closed.
  double fan_angle_of(int vert, double angle) const {
    const auto v = static_cast<std::size_t>(vert);
    return zero[v] + (is_reversed[v] ? -angle : angle) / scale[v];
  }

  /// Whether the frame of the vert at corner c is oriented as the triangle is.
  bool is_oriented_as_triangle(const unfolded_triangles& t, int c) const {
    return t.is_backward[static_cast<std::size_t>(c)] == is_reversed[static_cast<std::size_t>(t.start(c))];
  }
};

/// Errors: unsupported that names a vert about which the polys are not one fan.
template<SurfaceMesh M>
tangent_frames make_tangent_frames(const M& m, const unfolded_triangles& t, const char* caller) {
  tangent_frames r{std::vector<double>(t.around.size()), std::vector<double>(t.around.size(), 1.0), std::vector<unsigned char>(t.around.size())};
  for (const vert_t<M> vert : verts(m)) {
    const std::size_t v = index_of(m, vert);
    const int first = t.first_corner[v], end = t.first_corner[v + 1];
    if (first == end) continue;
    if (t.around[v] == unfolded_triangles::vert_fan::other)
      throw_joined<unsupported>({caller, ": the polys at vert ", v, " are not one fan, so it has no tangent plane; give each fan a vert of its own by "
                                 "split_vert_fans(m), and remove polys at edges with more than two"});
    r.is_reversed[v] = t.is_backward[static_cast<std::size_t>(t.corner[static_cast<std::size_t>(first)])];
    if (t.around[v] == unfolded_triangles::vert_fan::fan) r.scale[v] = 2 * std::numbers::pi / t.whole_turn[v];
    int edge = -1;
    for (const edge_t<M> e : adj_v2e(m, vert)) {
      edge = static_cast<int>(index_of(m, e));
      break;
    }
    for (int k = first; k < end; ++k) {
      const int c = t.corner[static_cast<std::size_t>(k)];
      if (t.edge[static_cast<std::size_t>(c)] == edge) r.zero[v] = t.fan_angle(c, 0);
      else if (t.edge[static_cast<std::size_t>(unfolded_triangles::previous(c))] == edge) r.zero[v] = t.fan_angle(c, t.angle[static_cast<std::size_t>(c)]);
    }
  }
  return r;
}

}  // namespace concino::core
