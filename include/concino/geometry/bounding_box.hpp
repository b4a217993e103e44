// Axis-aligned bounding boxes of a mesh, or of one poly, face or edge.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/concepts/primal_graph.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/core/vec3.hpp>

#include <limits>

namespace concino {

/// All points x with min <= x <= max in each coordinate; empty if min > max, as by default.
struct box {
  vec3 min{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
           std::numeric_limits<double>::infinity()};
  vec3 max = -min;

  bool is_empty() const { return !(min.x <= max.x && min.y <= max.y && min.z <= max.z); }
  vec3 centre() const { return 0.5 * min + 0.5 * max; }
  /// The length of the diagonal; 0 if empty.
  double diagonal() const { return is_empty() ? 0 : norm(max - min); }

  void add(const vec3& x) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (x[k] < min[k]) min[k] = x[k];
      if (x[k] > max[k]) max[k] = x[k];
    }
  }
};

/// The bounding box of all verts of m, including those of no poly.
/// Needs:  Embedded M with verts.      Result: a box, empty if there are no verts.      Cost: O(V).      Errors: none.
template<Embedded M>
  requires requirement::has_verts<M>
box bounding_box(const M& m) {
  box b;
  for (const vert_t<M> v : verts(m)) b.add(to_vec3(point(m, v)));
  return b;
}

/// The bounding box of the verts of poly p, face f or edge e. It contains every point of its edges, and of non-planar
/// faces spanned by its verts.
/// Needs:  Embedded M with adj_p2v, adj_f2v or adj_e2v.      Result: a box.      Cost: O(number of its verts).     
///         Errors: none.
template<Embedded M>
  requires requires(const M& m, poly_t<M> p) { adj_p2v(m, p); }
box bounding_box(const M& m, const poly_t<M>& p) {
  box b;
  for (const vert_t<M> v : adj_p2v(m, p)) b.add(to_vec3(point(m, v)));
  return b;
}
template<Embedded M>
  requires requires(const M& m, face_t<M> f) { adj_f2v(m, f); }
box bounding_box(const M& m, const face_t<M>& f) {
  box b;
  for (const vert_t<M> v : adj_f2v(m, f)) b.add(to_vec3(point(m, v)));
  return b;
}
template<Embedded M>
  requires requires(const M& m, edge_t<M> e) { adj_e2v(m, e); }
box bounding_box(const M& m, const edge_t<M>& e) {
  box b;
  for (const vert_t<M> v : adj_e2v(m, e)) b.add(to_vec3(point(m, v)));
  return b;
}

// What to write instead of calls that cannot compile.
template<class... T> void bounding_box(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void bounding_box(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
