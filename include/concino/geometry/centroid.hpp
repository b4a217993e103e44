// Centres of polys: the mean of their verts, and the centre of mass.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/geometry/measure.hpp>

#include <cmath>

namespace concino {

namespace detail {

/// at(v): the point of vert v, here and below.
template<class V, class Loop, class At>
vec3 mean_of(const Loop& loop, const At& at) {
  vec3 sum;
  double n = 0;
  for (const V v : loop) {
    sum += at(v);
    n += 1;
  }
  return n > 0 ? sum / n : sum;
}

/// The mean of points whose sum overflows.
template<class M, class Loop>
vec3 large_mean_of(const M& m, const Loop& loop) {
  const local_frame frame = frame_of_loop(m, loop);
  const vec3 mean = mean_of<vert_t<M>>(loop, points_by_vert(m));
  return frame.is_finite() && !is_finite(mean) ? frame.from_local(mean_of<vert_t<M>>(loop, points_by_vert_in(m, frame)))
                                               : mean;
}
template<class M>
vec3 large_mean(const M& m, const poly_t<M>& p) {
  return large_mean_of(m, adj_p2v(m, p));
}

}  // namespace detail

/// The mean of the verts of poly p: cheap, and defined for every poly, including degenerate and non-planar ones.
/// Needs:  Embedded M with adj_p2v.      Result: a point, in units of the mesh.      Cost: O(verts of p).      Errors:
///         none.
template<Embedded M>
  requires requires(const M& m, poly_t<M> p) { adj_p2v(m, p); }
vec3 vert_mean(const M& m, const poly_t<M>& p) {
  const vec3 mean = detail::mean_of<vert_t<M>>(adj_p2v(m, p), detail::points_by_vert(m));
  if (is_finite(mean)) return mean;
  return detail::large_mean(m, p);
}

namespace detail {

/// First moments of the signed triangles of a polygon's fan about its mean (or of the tets from an origin to these
/// triangles).
struct moments {
  vec3 first;        // sum of measure times centre of the parts
  double total = 0;  // sum of the signed measures of the parts
  double size = 0;   // sum of the absolute measures: the scale of rounding errors

  void add(double part, const vec3& centre) {
    first += part * centre;
    total += part;
    size += std::abs(part);
  }
};

template<class V, class Loop, class At, class Part>
void for_each_fan_side_through(const Loop& loop, const At& at, Part&& part) {
  vec3 first, previous;
  bool any = false;
  for (const V v : loop) {
    const vec3 x = at(v);
    if (any) part(previous, x);
    else first = x;
    previous = x;
    any = true;
  }
  if (any) part(previous, first);
}
template<class M, class Loop, class Part>
void for_each_fan_side(const M& m, const Loop& loop, Part&& part) {
  for_each_fan_side_through<vert_t<M>>(loop, points_by_vert(m), part);
}

/// The moments about `origin` of a polygon projected along its vector area.
template<class V, class Loop, class At>
moments polygon_moments(const Loop& loop, const At& at, const vec3& origin) {
  const vec3 normal = area_vector_through<V>(loop, at);
  moments sum;
  // g++ would not inline it, which takes a fifth more time
  const auto add = [&](const vec3& a, const vec3& b) __attribute__((always_inline)) {
    sum.add(dot(cross(a - origin, b - origin), normal), ((a - origin) + (b - origin)) / 3);
  };
  for_each_fan_side_through<V>(loop, at, add);
  return sum;
}

template<class M, class At>
moments polyhedron_moments(const M& m, const poly_t<M>& p, const At& at, const vec3& origin) {
  moments sum;
  for (const face_t<M> f : adj_p2f(m, p)) {
    const vec3 c = shape_through<vert_t<M>>(adj_f2v(m, f), at).mean - origin;
    const double sign = face_is_outward(m, p, f) ? 1 : -1;
    for_each_fan_side_through<vert_t<M>>(adj_f2v(m, f), at, [&](const vec3& a, const vec3& b) {
      sum.add(sign * dot(c, cross(a - origin, b - origin)), (c + (a - origin) + (b - origin)) / 4);
    });
  }
  return sum;
}

/// The moments of a polygon or of a polyhedron.
template<class M, class At>
moments moments_of(const M& m, const poly_t<M>& p, const At& at, const vec3& origin) {
  // moments of an area or of a volume
  if constexpr (SurfaceMesh<M>) return polygon_moments<vert_t<M>>(adj_p2v(m, p), at, origin);
  else return polyhedron_moments(m, p, at, origin);
}
template<class M, class At>
moments moments_of(const M& m, const face_t<M>& f, const At& at, const vec3& origin) {
  return polygon_moments<vert_t<M>>(adj_f2v(m, f), at, origin);
}

/// The centre of mass; `origin`, a point near it, if the area or volume is only rounding errors.
inline vec3 centre_of(const moments& sum, const vec3& origin) {
  return std::abs(sum.total) > 1e-12 * sum.size ? origin + sum.first / sum.total : origin;
}

/// Whether the moments, including the first ones, are accurate to all digits.
inline bool moments_keep_digits(const moments& sum) { return sum.size > 1e-200 && sum.size < 1e200; }

/// The centre for numbers that would overflow or underflow: the moments are computed in a frame of a size near 1.
template<class M, class X>
vec3 centre_in(const local_frame& frame, const M& m, const X& x, const vec3& origin) {
  if (!frame.is_finite()) return centre_of(moments_of(m, x, points_by_vert(m), origin), origin);
  const vec3 local = frame(origin);
  const moments scaled = moments_of(m, x, points_by_vert_in(m, frame), local);
  if (!(std::abs(scaled.total) > 1e-12 * scaled.size)) return origin;
  const vec3 centre = frame.from_local(local + scaled.first / scaled.total);
  return is_finite(centre) ? centre : origin;
}
// Only the mesh and the element are passed, so that the common case keeps its sums in registers.
template<class M>
vec3 centroid_at_any_scale(const M& m, const poly_t<M>& p) {
  return centre_in(frame_of_poly(m, p), m, p, vert_mean(m, p));
}
template<class M>
vec3 face_centroid_at_any_scale(const M& m, const face_t<M>& f) {
  return centre_in(frame_of_loop(m, adj_f2v(m, f)), m, f, large_mean_of(m, adj_f2v(m, f)));
}

}  // namespace detail

/// The centre of mass of poly p with constant density. Non-planar polygons are projected along their vector area;
/// polyhedra have each face as a fan about its mean point, as in `volume`.
/// Needs:  EmbeddedMesh.
/// Result: a point, in units of the mesh; the mean of the verts if the area or volume of p is only rounding errors.
/// Cost:   O(verts of the polygon or of the faces).      Errors: none.
template<EmbeddedMesh M>
vec3 centroid(const M& m, const poly_t<M>& p) {
  const vec3 origin = detail::mean_of<vert_t<M>>(adj_p2v(m, p), detail::points_by_vert(m));
  const detail::moments sum = detail::moments_of(m, p, detail::points_by_vert(m), origin);
  if (detail::moments_keep_digits(sum)) return detail::centre_of(sum, origin);
  return detail::centroid_at_any_scale(m, p);
}

/// The centre of mass of face f of a volume, computed as for a polygon of a surface.
/// Needs:  Embedded VolumeMesh.      Result: a point, in units of the mesh; the mean of the verts if f has no area.
/// Cost:   O(verts of f).      Errors: none.
template<VolumeMesh M>
  requires Embedded<M>
vec3 centroid(const M& m, const face_t<M>& f) {
  const vec3 origin = shape_of(m, adj_f2v(m, f)).mean;
  const detail::moments sum = detail::moments_of(m, f, detail::points_by_vert(m), origin);
  if (detail::moments_keep_digits(sum)) return detail::centre_of(sum, origin);
  return detail::face_centroid_at_any_scale(m, f);
}

/// The centres of mass of all polys.
/// Needs:  EmbeddedMesh, no temporary.      Result: a map of vec3.      Cost: that of centroid for every poly;
///         parallel.      Errors: none.
template<class M>
  requires requirement::is_lvalue_or_view<M> && EmbeddedMesh<M>
poly_map<M, vec3> centroids(M&& m) {
  poly_map<M, vec3> centre(m, poly_index_bound(m), detail::unwritten{});
  parallel_for_each(polys(m), [&](const poly_t<M>& p) { centre[p] = centroid(m, p); });
  return centre;
}

// What to write instead of calls that cannot compile.
template<class... T> void centroid(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void centroid(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void centroid(mistake::any_mesh, mistake::number<mistake::name_the_element>, ...) = delete;  // elements have types: vert_id{0}, poly_id{0} ..., not 0
template<class... T> void centroids(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void centroids(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void centroids(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
