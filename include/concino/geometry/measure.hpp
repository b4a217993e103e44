// How large elements are: areas of polygons, volumes of polyhedra, and the measure of a poly that is one or the other.
#pragma once

#include <concino/geometry/polygon.hpp>
#include <concino/mesh/element_map.hpp>
#include <concino/parallel.hpp>

namespace concino {

/// The vector area of poly p of a surface, or of face f of a volume: normal to it and as long as its area.
/// Needs:  Embedded SurfaceMesh (poly) or Embedded VolumeMesh (face, walked as adj_f2v does).
/// Result: half the sum of the cross products along the boundary; for a polygon that is not planar it is shorter than any surface
///         spanned by it. Units of length^2, scales exactly; 0 for a degenerate polygon.
/// Cost:   O(verts of the polygon).      Errors: none.
/// Source: Sunday 2002, "Fast polygon area and Newell normal computation"; paper section 2.2.
template<SurfaceMesh M>
  requires Embedded<M>
vec3 area_vector(const M& m, const poly_t<M>& p) {
  return area_vector_of(m, adj_p2v(m, p));
}
template<VolumeMesh M>
  requires Embedded<M>
vec3 area_vector(const M& m, const face_t<M>& f) {
  return area_vector_of(m, adj_f2v(m, f));
}

/// The area of poly p of a surface, or of face f of a volume: the length of its vector area.
/// Needs:  as area_vector.      Result: 0 or more, in units of length^2.      Cost: O(verts of the polygon).      Errors: none.
template<SurfaceMesh M>
  requires Embedded<M>
double area(const M& m, const poly_t<M>& p) {
  return norm(area_vector(m, p));
}
template<VolumeMesh M>
  requires Embedded<M>
double area(const M& m, const face_t<M>& f) {
  return norm(area_vector(m, f));
}

/// The volume of poly p: enclosed by its faces, each of them, planar or not, fanned from its mean point, so that neighbours tile space
/// without gap or overlap.
/// Needs:  Embedded VolumeMesh; faces of p that close up.
/// Result: positive where face_is_outward tells the truth, negative for a poly turned inside out; in units of length^3, scales exactly;
///         0 for a degenerate poly.
/// Cost:   O(verts of the faces of p).      Errors: none.
/// Source: the divergence theorem: a fan of triangles about c, seen from o, encloses (c - o) . A / 3 with A its vector area.
template<VolumeMesh M>
  requires Embedded<M>
double volume(const M& m, const poly_t<M>& p) {
  if constexpr (TetMesh<M>) {
    vec3 x[4];
    std::size_t n = 0;
    for (const vert_t<M> v : adj_p2v(m, p)) x[n++] = to_vec3(point(m, v));
    return dot(cross(x[1] - x[0], x[2] - x[0]), x[3] - x[0]) / 6;
  } else {
    vec3 origin;
    double sum = 0;
    bool first = true;
    for (const face_t<M> f : adj_p2f(m, p)) {
      const polygon_shape s = shape_of(m, adj_f2v(m, f));
      if (first) origin = s.mean;
      first = false;
      const double part = dot(s.mean - origin, s.area);
      sum += face_is_outward(m, p, f) ? part : -part;
    }
    return sum / 3;
  }
}

/// The area of a polygon or the volume of a polyhedron: what algorithms on surfaces and volumes alike call the size of a poly.
/// Needs:  Embedded AnyMesh.      Result: as area and volume.      Cost: as those.      Errors: none.
template<AnyMesh M>
  requires Embedded<M>
double measure(const M& m, const poly_t<M>& p) {
  if constexpr (SurfaceMesh<M>) return area(m, p);
  else return volume(m, p);
}

/// The measures of all polys.
/// Needs:  Embedded AnyMesh, no temporary.      Result: a map of double.      Cost: that of measure for every poly; parallel.      Errors: none.
template<class M>
  requires requirement::is_no_temporary<M> && AnyMesh<M> && Embedded<M>
poly_map<M, double> measures(M&& m) {
  poly_map<M, double> size(m, poly_index_bound(m), detail::unwritten{});
  parallel_for_each(polys(m), [&](const poly_t<M>& p) { size[p] = measure(m, p); });
  return size;
}

/// The sum of the measures of all polys: the area of a surface, the volume of a volume.
/// Needs:  Embedded AnyMesh.
/// Result: polys that are turned inside out count negative.      Cost: O(size of the mesh).      Errors: none.
template<AnyMesh M>
  requires Embedded<M>
double total_measure(const M& m) {
  double sum = 0;
  for (const poly_t<M> p : polys(m)) sum += measure(m, p);
  return sum;
}

}  // namespace concino
