// Areas of polygons, volumes of polyhedra, and the measure of a poly or facet in either dimension.
#pragma once

#include <concino/concepts/facets.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/core/parallel.hpp>
#include <concino/geometry/detail/any_scale.hpp>
#include <concino/geometry/edge_length.hpp>
#include <concino/geometry/polygon.hpp>
#include <concino/mesh/element_map.hpp>

#include <cmath>
#include <cstddef>
#include <limits>

namespace concino {

namespace detail {

/// The vector area for points so far apart that the sum overflows.
template<class M, class Loop>
vec3 large_area_vector(const M& m, const Loop& loop, const vec3& otherwise) {
  const local_frame frame = frame_of_loop(m, loop);
  if (!frame.is_finite()) return otherwise;
  const vec3 a = area_vector_through<vert_t<M>>(loop, points_by_vert_in(m, frame));
  return {frame.from_local(a.x, 2), frame.from_local(a.y, 2), frame.from_local(a.z, 2)};
}
template<class M, class Loop>
vec3 safe_area_vector(const M& m, const Loop& loop) {
  const vec3 a = area_vector_of(m, loop);
  if (is_finite(a)) return a;
  return large_area_vector(m, loop, a);
}

template<class M, class Loop>
double safe_area(const M& m, const Loop& loop) {
  const vec3 a = area_vector_of(m, loop);
  const double size = norm(a);
  if (size <= std::numeric_limits<double>::max()) return size;
  return norm(large_area_vector(m, loop, a));
}

/// at(v): the point of vert v.
template<class M, class At>
inline double volume_through(const M& m, const poly_t<M>& p, const At& at) {
  if constexpr (TetMesh<M>) {  // faster: a determinant
    vec3 x[4];
    std::size_t n = 0;
    for (const vert_t<M> v : adj_p2v(m, p)) x[n++] = at(v);
    return dot(cross(x[1] - x[0], x[2] - x[0]), x[3] - x[0]) / 6;
  } else {
    vec3 origin;
    double sum = 0;
    bool first = true;
    for (const face_t<M> f : adj_p2f(m, p)) {
      const polygon_shape s = shape_through<vert_t<M>>(adj_f2v(m, f), at);
      if (first) origin = s.mean;
      first = false;
      const double part = dot(s.mean - origin, s.area);
      sum += face_is_outward(m, p, f) ? part : -part;
    }
    return sum / 3;
  }
}

/// The area or volume of p with the points at(v).
template<class M, class At>
inline double measure_through(const M& m, const poly_t<M>& p, const At& at) {
  // an area needs the cycle of verts, a volume the faces
  if constexpr (SurfaceMesh<M>) return norm(area_vector_through<vert_t<M>>(adj_p2v(m, p), at));
  else return volume_through(m, p, at);
}

template<class M>
double large_volume(const M& m, const poly_t<M>& p, double otherwise) {
  const local_frame frame = frame_of_poly(m, p);
  return frame.is_finite() ? frame.from_local(volume_through(m, p, points_by_vert_in(m, frame)), 3) : otherwise;
}
template<class M>
double large_total_measure(const M& m, double otherwise) {
  const local_frame frame([&](auto&& visit) {
    for (const poly_t<M> p : polys(m)) for_each_point_of(m, p, visit);
  });
  if (!frame.is_finite()) return otherwise;
  double sum = 0;
  for (const poly_t<M> p : polys(m)) sum += measure_through(m, p, points_by_vert_in(m, frame));
  return frame.from_local(sum, SurfaceMesh<M> ? 2 : 3);
}

}  // namespace detail

/// The vector area of poly p of a surface, or of face f of a volume: normal to it, with its area as length.
/// Needs:  Embedded SurfaceMesh (poly) or Embedded VolumeMesh (face, in the order of adj_f2v).
/// Result: half the sum of the cross products along the boundary; for a non-planar polygon it is shorter than the area
///         of any surface that it bounds. Units of length^2, scales exactly; 0 for a degenerate polygon. Components too
///         large for a double are infinite.
/// Cost:   O(verts of the polygon).      Errors: none.
/// Source: Sunday 2002, "Fast polygon area and Newell normal computation"; paper section 2.2.
template<SurfaceMesh M>
  requires Embedded<M>
vec3 area_vector(const M& m, const poly_t<M>& p) {
  return detail::safe_area_vector(m, adj_p2v(m, p));
}
template<VolumeMesh M>
  requires Embedded<M>
vec3 area_vector(const M& m, const face_t<M>& f) {
  return detail::safe_area_vector(m, adj_f2v(m, f));
}

/// The area of poly p of a surface, or of face f of a volume: the length of its vector area.
/// Needs:  as area_vector.      Result: 0 or more, in units of length^2; +inf if too large.      Cost: O(verts of the
///         polygon).      Errors: none.
template<SurfaceMesh M>
  requires Embedded<M>
double area(const M& m, const poly_t<M>& p) {
  return detail::safe_area(m, adj_p2v(m, p));
}
template<VolumeMesh M>
  requires Embedded<M>
double area(const M& m, const face_t<M>& f) {
  return detail::safe_area(m, adj_f2v(m, f));
}

/// The volume of poly p: enclosed by its faces. Each face, planar or not, is a fan about its mean point, so that
/// neighbours tile space without gap or overlap.
/// Needs:  Embedded VolumeMesh; the faces of p are closed.
/// Result: positive if face_is_outward is right, negative for an inverted poly; in units of length^3, scales exactly;
///         0 for a degenerate poly; infinite if it is too large for a double, but never NaN for finite points.
/// Cost:   O(verts of the faces of p).      Errors: none.
/// Source: the divergence theorem: a fan of triangles about c, from the origin o, encloses (c - o) . A / 3 with A its
///         vector area.
template<VolumeMesh M>
  requires Embedded<M>
double volume(const M& m, const poly_t<M>& p) {
  const double size = detail::volume_through(m, p, detail::points_by_vert(m));
  if (std::isfinite(size)) return size;
  return detail::large_volume(m, p, size);
}

/// The measure of a poly: the area of a polygon or the volume of a polyhedron. For algorithms on both surfaces and
/// volumes.
/// Needs:  EmbeddedMesh.      Result: as area and volume.      Cost: as those.      Errors: none.
template<EmbeddedMesh M>
double measure(const M& m, const poly_t<M>& p) {
  if constexpr (SurfaceMesh<M>) return area(m, p);  // the measure depends on the dimension
  else return volume(m, p);
}

/// The measure of a facet: the length of an edge of a surface or the area of a face of a volume.
/// Needs:  EmbeddedMesh.      Result: as edge_length and area.      Cost: as those.      Errors: none.
template<SurfaceMesh M>
  requires Embedded<M>
double measure(const M& m, const edge_t<M>& e) { return edge_length(m, e); }
template<VolumeMesh M>
  requires Embedded<M>
double measure(const M& m, const face_t<M>& f) { return area(m, f); }

/// The measures of all polys.
/// Needs:  EmbeddedMesh, no temporary.      Result: a map of double.      Cost: that of measure for every poly;
///         parallel.      Errors: none.
template<class M>
  requires requirement::is_lvalue_or_view<M> && EmbeddedMesh<M>
poly_map<M, double> measures(M&& m) {
  poly_map<M, double> size(m, poly_index_bound(m), detail::unwritten{});
  parallel_for_each(polys(m), [&](const poly_t<M>& p) { size[p] = measure(m, p); });
  return size;
}

/// The sum of the measures of all polys: the area of a surface, the volume of a volume.
/// Needs:  EmbeddedMesh.
/// Result: inverted polys count negative; infinite if the sum is too large.      Cost: O(size of the mesh).     
///         Errors: none.
template<EmbeddedMesh M>
double total_measure(const M& m) {
  double sum = 0;
  for (const poly_t<M> p : polys(m)) sum += detail::measure_through(m, p, detail::points_by_vert(m));
  if (std::isfinite(sum)) return sum;
  return detail::large_total_measure(m, sum);
}

// What to write instead of calls that cannot compile.
template<class... T> void area(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void area(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void area(mistake::any_mesh, mistake::number<mistake::name_the_element>, ...) = delete;  // elements have types: vert_id{0}, poly_id{0} ..., not 0
template<class... T> void volume(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void volume(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void volume(mistake::any_mesh, mistake::number<mistake::name_the_element>, ...) = delete;  // elements have types: vert_id{0}, poly_id{0} ..., not 0
template<class... T> void measure(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void measure(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void measure(mistake::any_mesh, mistake::number<mistake::name_the_element>, ...) = delete;  // elements have types: vert_id{0}, poly_id{0} ..., not 0
template<class... T> void measures(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void measures(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void measures(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void total_measure(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void total_measure(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
