// A surface as flat arrays with polys of one orientation, with a frame of tangent vectors at each vert.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/compiled.hpp>
#include <concino/core/error.hpp>
#include <concino/core/vec3.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace concino::detail {

/// Verts and edges have the numbers of the mesh; polys are numbered in its order, from 0. All polys of a component
/// have the orientation of its first. Corner c is one of vert[c], and stands for the edge from there to the next
/// corner.
///
/// Frames: angle 0 of a vert is along its first edge in the mesh, and angles increase counter-clockwise as its
/// component is oriented. Angles are those of the polys. Inside the surface they are multiplied by a number that makes
/// a full turn 2 pi; at the boundary by 1.
struct oriented_surface {
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  std::vector<vec3> points;                      // in units of 2^exponent; of verts without polys 0
  int exponent = 0;
  std::vector<std::uint32_t> first{0};           // the corners of poly p: first[p] to first[p + 1]
  std::vector<std::uint32_t> poly_index;         // in the mesh
  std::vector<unsigned char> is_turned;          // by poly: whether its corners run against those of the mesh
  std::vector<std::uint32_t> vert, edge, poly;   // by corner
  std::vector<std::uint32_t> next, previous;     // by corner
  std::vector<std::uint32_t> twin;               // by corner: the other corner of its edge; none at the boundary
  std::vector<std::uint32_t> first_edge;         // by vert: the edge of angle 0
  std::vector<std::uint32_t> component;          // by vert; none at verts without polys
  std::uint32_t num_components = 0;

  std::vector<std::uint32_t> around;             // by vert: a corner of it, at the boundary the first in the fan
  std::vector<unsigned char> on_boundary;        // by vert
  std::vector<double> angle;                     // by corner, in the frame of its vert
  std::vector<double> from;                      // by corner: the angle in this frame of the edge to the next corner
  std::vector<std::array<vec3, 2>> axes;         // by vert: directions of angle 0 and pi/2 in space, of length 1
  std::vector<double> mass;                      // by vert: the share in the areas, in units of the points

  std::size_t num_polys() const { return poly_index.size(); }
  std::size_t num_verts() const { return points.size(); }
  std::size_t num_edges = 0;                     // the index bound of edges in the mesh

  /// The next corner of the same vert, counter-clockwise; none at the boundary.
  std::uint32_t counter_clockwise(std::uint32_t c) const { return twin[previous[c]]; }

  /// The angle, in the frame at the end of the edge of corner c, of the edge back.
  double back(std::uint32_t c) const { return from[next[c]] + angle[next[c]]; }

  /// By how much angles grow from the frame of vert[c] to that of the next corner under parallel transport along the
  /// edge.
  double transport(std::uint32_t c) const;

  /// The angle by which the frames turn around poly p: 2 pi times its part of the Euler characteristic.
  double holonomy(std::size_t p) const;

  /// The sum of the vectors of areas of a poly.
  vec3 vector_area(std::size_t p) const;

  /// Call it after points, first, vert, edge, poly_index, first_edge are filled.
  /// Errors: invalid_mesh if there are no polys, or one has no area or a point that is not finite; unsupported if an
  ///         edge has more than two polys, a vert several fans, or a component is not orientable.
  void complete(const char* caller);

 private:
  void number_corners();
  void pair_edges(const char* caller);
  void orient(const char* caller);
  void turn_poly(std::size_t p);
  [[noreturn, gnu::cold]] void throw_no_area(std::size_t p, const char* caller) const;
  void scale(const char* caller);
  void label_components();
  void measure_angles(const char* caller);
  void walk_fans(const char* caller);
  void place_axes();
};

/// Reads a mesh.      Errors: those of complete.
template<SurfaceMesh M>
  requires Embedded<M>
oriented_surface read_oriented_surface(const M& m, const char* caller) {
  oriented_surface s;
  s.points.assign(vert_index_bound(m), vec3{});
  s.first_edge.assign(vert_index_bound(m), oriented_surface::none);
  s.num_edges = edge_index_bound(m);
  for (const poly_t<M> p : polys(m)) {
    for (const vert_t<M> v : adj_p2v(m, p)) {
      const std::size_t i = index_of(m, v);
      s.points[i] = to_vec3(point(m, v));
      s.vert.push_back(static_cast<std::uint32_t>(i));
      if (s.first_edge[i] != oriented_surface::none) continue;
      for (const edge_t<M> e : adj_v2e(m, v)) {
        s.first_edge[i] = static_cast<std::uint32_t>(index_of(m, e));
        break;
      }
    }
    for (const edge_t<M> e : adj_p2e(m, p)) s.edge.push_back(static_cast<std::uint32_t>(index_of(m, e)));
    s.first.push_back(static_cast<std::uint32_t>(s.vert.size()));
    s.poly_index.push_back(static_cast<std::uint32_t>(index_of(m, p)));
  }
  s.complete(caller);
  return s;
}

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/directions/detail/surface/oriented_surface.ipp>
#endif
