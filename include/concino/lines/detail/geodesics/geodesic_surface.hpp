// A surface for geodesics: its triangles, and the elements of the mesh to which they belong.
#pragma once

#include <concino/concepts/surface_mesh.hpp>
#include <concino/core/vec3.hpp>
#include <concino/geometry/support/tangent_frames.hpp>
#include <concino/geometry/support/unfolded_surface.hpp>
#include <concino/lines/detail/geodesics/geodesic_walker.hpp>
#include <concino/mesh/mesh_point.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace concino::detail {

template<SurfaceMesh M>
struct geodesic_surface {
  core::unfolded_surface unfolded;
  std::vector<vec3> points;  // by vert, in units of the triangles
  std::vector<vert_t<M>> vert;
  std::vector<edge_t<M>> edge;
  std::vector<poly_t<M>> poly;

  /// Errors: those of unfold_surface.
  geodesic_surface(const M& m, const char* caller) : unfolded(core::unfold_surface(m, caller)) {
    const double unit = std::ldexp(1.0, -unfolded.triangles.exponent);
    vert.resize(vert_index_bound(m));
    points.resize(vert.size());
    for (const vert_t<M> v : verts(m)) {
      vert[index_of(m, v)] = v;
      points[index_of(m, v)] = unit * to_vec3(point(m, v));
    }
    edge.resize(edge_index_bound(m));
    for (const edge_t<M> e : edges(m)) edge[index_of(m, e)] = e;
    poly.resize(poly_index_bound(m));
    for (const poly_t<M> p : polys(m)) poly[index_of(m, p)] = p;
  }

  const core::unfolded_triangles& triangles() const { return unfolded.triangles; }
  const vec3& start_of(int side) const { return points[static_cast<std::size_t>(triangles().start(side))]; }
  const vec3& end_of(int side) const { return points[static_cast<std::size_t>(triangles().end(side))]; }
  const poly_t<M>& poly_of(int side) const {
    return poly[static_cast<std::size_t>(unfolded.poly_of[static_cast<std::size_t>(side / 3)])];
  }
  vec3 in_units_of_mesh(const vec3& x) const { return std::ldexp(1.0, triangles().exponent) * x; }

  /// The axes of the frame of a side: along it, and into the triangle.
  std::array<vec3, 2> axes(int side) const {
    const vec3 origin = start_of(side), along = end_of(side) - origin, x = along / norm(along);
    const vec3 to_apex = start_of(core::unfolded_triangles::previous(side)) - origin, y = to_apex - dot(to_apex, x) * x;
    return {x, y / norm(y)};
  }

  mesh_point<M> at_vert(int v) const {
    return {vert[static_cast<std::size_t>(v)], in_units_of_mesh(points[static_cast<std::size_t>(v)])};
  }

  mesh_point<M> on_side(const M& m, int side, double along) const {
    const vec3 x = in_units_of_mesh((1 - along) * start_of(side) + along * end_of(side));
    if (unfolded.is_diagonal(side)) return {poly_of(side), x};
    const edge_t<M> e = edge[static_cast<std::size_t>(triangles().edge[static_cast<std::size_t>(side)])];
    bool is_along = true;
    for (const vert_t<M> v : adj_e2v(m, e)) {
      is_along = static_cast<int>(index_of(m, v)) == triangles().start(side);
      break;
    }
    return {edge_point<M>{e, is_along ? along : 1 - along}, x};
  }

  mesh_point<M> inside(int side, double x, double y) const {
    const std::array<vec3, 2> axis = axes(side);
    return {poly_of(side), in_units_of_mesh(start_of(side) + x * axis[0] + y * axis[1])};
  }

  mesh_point<M> point_of(const M& m, const walk_stop& s) const {
    if (s.vert >= 0) return at_vert(s.vert);
    return s.is_inside ? inside(s.side, s.along, s.inward) : on_side(m, s.side, s.along);
  }

  vec3 direction_of(const walk_state& s) const {
    const std::array<vec3, 2> axis = axes(s.side);
    const vec3 d = s.dx * axis[0] + s.dy * axis[1];
    return d / norm(d);
  }
};

}  // namespace concino::detail
