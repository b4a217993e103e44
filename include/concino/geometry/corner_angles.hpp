// Angles at the corners of polygons, and angle defects at verts.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/message.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/geometry/normals.hpp>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace concino {

namespace detail {

/// The angle from the vector at -> after to the vector at -> before, in [0, pi]; more than pi if it turns against
/// `normal`. A triangle has no such corner, so a normal of 0 skips this check.
inline double angle_at_corner(const vec3& before, const vec3& at, const vec3& after, const vec3& normal) {
  vec3 out = after - at, back = before - at, turn = cross(out, back);
  double cosine = dot(out, back);
  if (!keeps_digits(dot(turn, turn) + cosine * cosine)) {
    out = rescaled_step(at, after);
    back = rescaled_step(at, before);
    turn = cross(out, back);
    cosine = dot(out, back);
  }
  const double angle = std::atan2(norm(turn), cosine);
  if (!(dot(turn, normal) < 0)) return angle;
  const double outer = 2 * std::numbers::pi - angle;
  return outer < 2 * std::numbers::pi ? outer : 0;  // rounding may turn nearly a whole turn into a whole one
}

/// Calls f(k, before, at, after) for each corner of a polygon, the first one last; k is its position in the loop.
template<class M, class Loop, class F>
void for_each_corner(const M& m, const Loop& loop, F&& f) {
  vec3 first, second, before, at;
  std::size_t n = 0;
  for (const vert_t<M> v : loop) {
    const vec3 x = to_vec3(point(m, v));
    if (n == 0) first = x;
    else if (n == 1) second = x;
    else f(n - 1, before, at, x);
    before = at;
    at = x;
    ++n;
  }
  if (n < 2) return;
  f(n - 1, before, at, first);
  f(std::size_t{0}, at, first, second);
}

template<class M, class Loop>
std::size_t num_corners(const M&, const Loop& loop) {
  std::size_t n = 0;
  for ([[maybe_unused]] const vert_t<M> v : loop) ++n;
  return n;
}

/// The normal that decides whether corners of the polygon are concave; 0 for a triangle, which has no concave corner.
template<class M, class Loop>
vec3 normal_for_angles(const M& m, const Loop& loop, std::size_t corners) {
  return corners <= 3 ? vec3{} : direction_of_areas(m, [&](const auto& visit) { visit(loop, 1.0); });
}

template<class M, class Loop>
double angle_in_loop(const M& m, const Loop& loop, const vert_t<M>& v, const char* what, std::size_t which) {
  std::size_t n = 0, corner = 0;
  bool found = false;
  for (const vert_t<M> w : loop) {
    if (w == v) {
      corner = n;
      found = true;
    }
    ++n;
  }
  if (!found)
    core::throw_joined<invalid_argument>(
        {"corner_angle: vert ", index_of(m, v), " is not a vert of ", what, " ", which, "; take one of its own verts"});
  const vec3 normal = normal_for_angles(m, loop, n);
  double angle = 0;
  for_each_corner(m, loop, [&](std::size_t k, const vec3& before, const vec3& at, const vec3& after) {
    if (k == corner) angle = angle_at_corner(before, at, after, normal);
  });
  return angle;
}

}  // namespace detail

/// The angle inside poly p of a surface, or inside face f of a volume, at its corner v.
/// Needs:  Embedded SurfaceMesh (poly) or Embedded VolumeMesh (face) with index_of.
/// Result: in radians, in [0, 2 pi): the angle in space between the two edges at v, more than pi if the corner is
///         concave in the projection along the vector area. The angles of a planar polygon of n verts sum to (n - 2)
///         pi. Independent of scale; 0 if an edge at v has no length; not a number only if points are not finite.
/// Cost:   O(verts of the polygon).      Errors: invalid_argument if v is no vert of the polygon.
template<SurfaceMesh M>
  requires Embedded<M>
double corner_angle(const M& m, const poly_t<M>& p, const vert_t<M>& v) {
  return detail::angle_in_loop(m, adj_p2v(m, p), v, "poly", index_of(m, p));
}
template<VolumeMesh M>
  requires Embedded<M>
double corner_angle(const M& m, const face_t<M>& f, const vert_t<M>& v) {
  return detail::angle_in_loop(m, adj_f2v(m, f), v, "face", index_of(m, f));
}

/// The angle defect at each vert, a discrete Gaussian curvature: 2 pi (or pi at the border) minus the sum of the corner
/// angles there.
/// Needs:  Embedded SurfaceMesh, no temporary.
/// Result: a map of double, in radians: 2 pi minus the sum of angles in the interior, pi minus the sum at the border.
///         In general each edge at v with k polys adds (k - 2) pi / 2 to the first. So if polys are planar, the sum
///         over all verts is 2 pi times the Euler characteristic, on non-manifold surfaces too. Verts of no poly have 0
///         and do not count in it.
/// Cost:   O(corners + edges of verts), parallel but for the sums; the same for any number of threads.      Errors:
///         none.
/// Source: Descartes' theorem; Gauss-Bonnet for polyhedral surfaces, Banchoff 1967, "Critical points and curvature for
///         embedded polyhedra".
template<class M>
  requires requirement::is_lvalue_or_view<M> && SurfaceMesh<M> && Embedded<M>
vert_map<M, double> angle_defects(M&& m) {
  auto defect = make_vert_map<double>(m, 0.0);
  std::vector<std::size_t> first(poly_index_bound(m));
  std::size_t corners = 0;
  for (const poly_t<M> p : polys(m)) {
    first[index_of(m, p)] = corners;
    corners += detail::num_corners(m, adj_p2v(m, p));
  }
  std::vector<double> angle(corners);
  parallel_for_each(polys(m), [&](const poly_t<M>& p) {
    const auto& loop = adj_p2v(m, p);
    const vec3 normal = detail::normal_for_angles(m, loop, detail::num_corners(m, loop));
    double* const own = angle.data() + first[index_of(m, p)];
    detail::for_each_corner(m, loop, [&](std::size_t k, const vec3& before, const vec3& at, const vec3& after) {
      own[k] = detail::angle_at_corner(before, at, after, normal);
    });
  });
  const double* next = angle.data();
  for (const poly_t<M> p : polys(m))
    for (const vert_t<M> v : adj_p2v(m, p)) defect[v] += *next++;
  parallel_for_each(verts(m), [&](const vert_t<M>& v) {
    double quarters = 4;
    bool any = false;
    for (const edge_t<M> e : adj_v2e(m, v)) {
      quarters -= 2;
      for ([[maybe_unused]] const poly_t<M> p : adj_e2p(m, e)) {
        quarters += 1;
        any = true;
      }
    }
    if (any) defect[v] = quarters * (std::numbers::pi / 2) - defect[v];
  });
  return defect;
}

// What to write instead of calls that cannot compile.
template<class... T> void corner_angle(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void corner_angle(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void corner_angle(mistake::any_mesh, mistake::number<mistake::name_the_element>, ...) = delete;  // elements have types: vert_id{0}, poly_id{0} ..., not 0
template<class... T> void angle_defects(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void angle_defects(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void angle_defects(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
