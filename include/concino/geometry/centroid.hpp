// Where polys lie: the mean of their verts, and their centre of mass.
#pragma once

#include <concino/geometry/measure.hpp>

#include <cmath>

namespace concino {

/// The mean of the verts of poly p: a point that exists for every poly, degenerate and non-planar ones included, and that is cheap.
/// Needs:  Embedded M with adj_p2v.      Result: a point, in units of the mesh.      Cost: O(verts of p).      Errors: none.
template<Embedded M>
  requires requires(const M& m, poly_t<M> p) { adj_p2v(m, p); }
vec3 vert_mean(const M& m, const poly_t<M>& p) {
  vec3 sum;
  double n = 0;
  for (const vert_t<M> v : adj_p2v(m, p)) {
    sum += to_vec3(point(m, v));
    n += 1;
  }
  return n > 0 ? sum / n : sum;
}

namespace detail {

/// First moments of the signed triangles (or, seen from an origin, tets) of the fan of a polygon about its mean.
struct moments {
  vec3 first;        // sum of part x centre of the part
  double total = 0;  // sum of parts
  double size = 0;   // sum of |parts|: what rounding errors are measured by

  void add(double part, const vec3& centre) {
    first += part * centre;
    total += part;
    size += std::abs(part);
  }
};

template<class M, class Loop, class Part>
void for_each_fan_side(const M& m, const Loop& loop, Part&& part) {
  vec3 first, previous;
  bool any = false;
  for (const vert_t<M> v : loop) {
    const vec3 x = to_vec3(point(m, v));
    if (any) part(previous, x);
    else first = x;
    previous = x;
    any = true;
  }
  if (any) part(previous, first);
}

/// The centre of mass of a polygon seen along its vector area; `origin`, a point near it, where it has no area.
template<class M, class Loop>
vec3 polygon_centroid(const M& m, const Loop& loop, const vec3& origin) {
  const vec3 normal = area_vector_of(m, loop);
  moments sum;
  for_each_fan_side(m, loop, [&](const vec3& a, const vec3& b) {
    sum.add(dot(cross(a - origin, b - origin), normal), ((a - origin) + (b - origin)) / 3);
  });
  return std::abs(sum.total) > 1e-12 * sum.size ? origin + sum.first / sum.total : origin;
}

}  // namespace detail

/// The centre of mass of poly p, filled with constant density. Polygons that are not planar are seen along their vector area; polyhedra
/// have each face fanned from its mean point, as `volume` does.
/// Needs:  Embedded AnyMesh.
/// Result: a point, in units of the mesh; the mean of the verts where p has no area or volume but rounding errors.
/// Cost:   O(verts of the polygon or of the faces).      Errors: none.
template<AnyMesh M>
  requires Embedded<M>
vec3 centroid(const M& m, const poly_t<M>& p) {
  const vec3 origin = vert_mean(m, p);
  if constexpr (SurfaceMesh<M>) {
    return detail::polygon_centroid(m, adj_p2v(m, p), origin);
  } else {
    detail::moments sum;
    for (const face_t<M> f : adj_p2f(m, p)) {
      const vec3 c = shape_of(m, adj_f2v(m, f)).mean - origin;
      const double sign = face_is_outward(m, p, f) ? 1 : -1;
      detail::for_each_fan_side(m, adj_f2v(m, f), [&](const vec3& a, const vec3& b) {
        sum.add(sign * dot(c, cross(a - origin, b - origin)), (c + (a - origin) + (b - origin)) / 4);
      });
    }
    return std::abs(sum.total) > 1e-12 * sum.size ? origin + sum.first / sum.total : origin;
  }
}

/// The centre of mass of face f of a volume, as that of a polygon of a surface.
/// Needs:  Embedded VolumeMesh.      Result: a point, in units of the mesh; the mean of the verts where f has no area.
/// Cost:   O(verts of f).      Errors: none.
template<VolumeMesh M>
  requires Embedded<M>
vec3 centroid(const M& m, const face_t<M>& f) {
  return detail::polygon_centroid(m, adj_f2v(m, f), shape_of(m, adj_f2v(m, f)).mean);
}

/// The centres of mass of all polys.
/// Needs:  Embedded AnyMesh, no temporary.      Result: a map of vec3.      Cost: that of centroid for every poly; parallel.      Errors: none.
template<class M>
  requires requirement::is_no_temporary<M> && AnyMesh<M> && Embedded<M>
poly_map<M, vec3> centroids(M&& m) {
  poly_map<M, vec3> centre(m, poly_index_bound(m), detail::unwritten{});
  parallel_for_each(polys(m), [&](const poly_t<M>& p) { centre[p] = centroid(m, p); });
  return centre;
}

}  // namespace concino
