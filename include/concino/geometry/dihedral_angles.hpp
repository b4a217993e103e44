// Dihedral angles: between two polys of a surface, or two faces of a polyhedron, at their common edge.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/message.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/geometry/normals.hpp>

#include <cmath>
#include <numbers>

namespace concino {

namespace detail {

/// An edge with a direction: its start and its unit direction.
template<class M>
struct directed_edge {
  vert_t<M> from, to;
  vec3 direction;  // length 1; 0 for an edge without length

  directed_edge(const M& m, const edge_t<M>& e) {
    const auto& ends = adj_e2v(m, e);
    auto it = ends.begin();
    from = *it;
    ++it;
    to = *it;
    direction = unit_vector(rescaled_step(to_vec3(point(m, from)), to_vec3(point(m, to))));
  }

  /// 1 if the loop traverses the edge in its direction, -1 if in the opposite one, 0 if neither.
  template<class Loop>
  int traversal_sign(const Loop& loop) const {
    bool from_first = false, to_first = false, at_from = false, at_to = false, any = false;
    for (const vert_t<M> v : loop) {
      const bool is_from = v == from, is_to = v == to;
      if (at_from && is_to) return 1;
      if (at_to && is_from) return -1;
      if (!any) {
        from_first = is_from;
        to_first = is_to;
      }
      any = true;
      at_from = is_from;
      at_to = is_to;
    }
    return at_from && to_first ? 1 : at_to && from_first ? -1 : 0;
  }
};

/// A polygon at an edge: the direction from the edge into the polygon, orthogonal to the edge and to the normal.
struct polygon_at_edge {
  vec3 inward;
  int sign = 0;  // of its traversal of the edge, as seen from the side of its outward normal

  polygon_at_edge() = default;
  polygon_at_edge(const vec3& normal, const vec3& direction, int loop_sign, bool outward)
      : inward(static_cast<double>(loop_sign) * cross(normal, direction)), sign(outward ? loop_sign : -loop_sign) {}
};

/// The angle from a to b, on the side opposite to a's normal.
inline double interior_angle(const polygon_at_edge& a, const polygon_at_edge& b, const vec3& direction) {
  const double cosine = dot(a.inward, b.inward),
               sine = -static_cast<double>(a.sign) * dot(cross(a.inward, b.inward), direction);
  if (cosine == 0 && sine == 0) return std::numbers::pi;
  const double angle = std::atan2(sine, cosine);
  if (!(angle < 0)) return angle + 0.0;  // turns -0 into 0
  const double outer = angle + 2 * std::numbers::pi;
  return outer < 2 * std::numbers::pi ? outer : 0;  // rounding may turn nearly a whole turn into a whole one
}

/// normal_of(p): the normal of poly p.
template<class M, class Normal>
double dihedral_angle_with(const M& m, const edge_t<M>& e, const Normal& normal_of) {
  polygon_at_edge two[2];
  const directed_edge<M> edge(m, e);
  int n = 0;
  for (const poly_t<M> p : adj_e2p(m, e)) {
    if (n == 2) return std::numbers::pi;
    two[n++] = {normal_of(p), edge.direction, edge.traversal_sign(adj_p2v(m, p)), true};
  }
  return n == 2 ? interior_angle(two[0], two[1], edge.direction) : std::numbers::pi;
}

}  // namespace detail

/// The interior angle of a surface at edge e: the angle between its two polys on the side opposite to their normals.
/// Needs:  Embedded SurfaceMesh.
/// Result: in radians, in [0, 2 pi): pi where the surface is flat, less where it is convex, such as pi / 2 on a cube,
///         more where it is concave. The planes of polygons are those of their vector areas. pi, as on a flat surface,
///         where there is no angle: at edges without exactly two polys, or without length, and at polys without area.
///         If the two polys are wound against each other, the side is that of the first of adj_e2p. Independent of
///         scale; not a number only if points are not finite.
/// Cost:   O(verts of the two polys).      Errors: none.
template<SurfaceMesh M>
  requires Embedded<M>
double dihedral_angle(const M& m, const edge_t<M>& e) {
  return detail::dihedral_angle_with(m, e, [&](const poly_t<M>& p) { return normal(m, p); });
}

/// The interior angle of polyhedron p at its edge e, between its two faces there.
/// Needs:  Embedded VolumeMesh.
/// Result: in radians, in [0, 2 pi), more than pi where p is concave. The planes of faces are those of their vector
///         areas, so the angles of the polys all around an edge sum to 2 pi, with planar faces or not. pi if e has no
///         length or a face there no area, or if p does not have exactly two faces at e. Independent of scale; not a
///         number only if points are not finite.
/// Cost:   O(verts of the faces of p).      Errors: invalid_argument if e is no edge of p.
template<VolumeMesh M>
  requires Embedded<M>
double dihedral_angle(const M& m, const poly_t<M>& p, const edge_t<M>& e) {
  detail::polygon_at_edge two[2];
  const detail::directed_edge<M> edge(m, e);
  int n = 0;
  for (const face_t<M> f : adj_p2f(m, p)) {
    const int sign = edge.traversal_sign(adj_f2v(m, f));
    if (sign == 0) continue;
    if (n < 2) two[n] = {normal(m, f), edge.direction, sign, face_is_outward(m, p, f)};
    ++n;
  }
  if (n == 0)
    core::throw_joined<invalid_argument>({"dihedral_angle: edge ", index_of(m, e), " is not an edge of poly ",
                                          index_of(m, p), "; take one from adj_p2e(m, p)"});
  return n == 2 ? detail::interior_angle(two[0], two[1], edge.direction) : std::numbers::pi;
}

/// The interior angles of a surface at all edges.
/// Needs:  Embedded SurfaceMesh, no temporary.      Result: a map of double, as dihedral_angle.
/// Cost:   O(corners) for polys with few verts: every normal is computed once; otherwise times the verts of polys.
///         Parallel.      Errors: none.
template<class M>
  requires requirement::is_lvalue_or_view<M> && SurfaceMesh<M> && Embedded<M>
edge_map<M, double> dihedral_angles(M&& m) {
  edge_map<M, double> angle(m, edge_index_bound(m), detail::unwritten{});
  const auto normals = poly_normals(m);
  const auto normal_of = [&](const poly_t<M>& p) { return normals[p]; };
  parallel_for_each(edges(m), [&](const edge_t<M>& e) { angle[e] = detail::dihedral_angle_with(m, e, normal_of); });
  return angle;
}

// What to write instead of calls that cannot compile.
template<class... T> void dihedral_angle(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void dihedral_angle(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void dihedral_angle(mistake::any_mesh, mistake::number<mistake::name_the_element>, ...) = delete;  // elements have types: vert_id{0}, poly_id{0} ..., not 0
template<class... T> void dihedral_angles(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void dihedral_angles(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void dihedral_angles(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
