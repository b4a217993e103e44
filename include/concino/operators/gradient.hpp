// The gradient of a function on verts, per poly or per vert, without a matrix.
#pragma once

#include <concino/concepts/maps.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/core/poly_chunks.hpp>
#include <concino/mesh/element_map.hpp>
#include <concino/operators/simplex_gradients.hpp>

namespace concino {

namespace detail {

/// The sum of u_i g_i. It uses differences of u, so constants have gradient exactly 0 and large constants lose no
/// digits.
template<class Local, class U>
vec3 gradient_of(const Local& local, const U& u) {
  vec3 sum;
  if (local.verts.size() == 0) return sum;
  const double first = static_cast<double>(u[local.verts[0]]);
  for (std::size_t i = 1; i < local.verts.size(); ++i)
    sum += (static_cast<double>(u[local.verts[i]]) - first) * local.gradient[i];
  return sum;
}

template<class M, class U>
poly_map<M, vec3> find_gradient(const M& m, const U& u) {
  auto result = make_poly_map<vec3>(m);
  core::poly_chunks<M>(m).template for_each<poly_gradients<M>>(
      [&](auto& local, const poly_t<M>& p, std::size_t) {
        local.visit(m, p);
        if (!local.has_gradients()) throw_no_measure("gradient", m, p);
        result[p] = gradient_of(local, u);
        return 0;
      });
  return result;
}

template<class M, class U>
vert_map<M, vec3> find_vert_gradient(const M& m, const U& u) {
  struct weighted {
    vec3 sum;
    double size = 0;
  };
  std::vector<weighted> of_poly(poly_index_bound(m)), of_vert(vert_index_bound(m));
  core::poly_chunks<M>(m).template for_each<poly_gradients<M>>(
      [&](auto& local, const poly_t<M>& p, std::size_t) {
        local.visit(m, p);
        if (!local.has_gradients()) throw_no_measure("vert_gradient", m, p);
        const double size = std::abs(local.measure);
        of_poly[index_of(m, p)] = {size * gradient_of(local, u), size};
        return 0;
      });
  for (const poly_t<M> p : polys(m)) {
    const weighted& w = of_poly[index_of(m, p)];
    for (const vert_t<M> v : adj_p2v(m, p)) {
      weighted& at = of_vert[index_of(m, v)];
      at.sum += w.sum;
      at.size += w.size;
    }
  }
  auto result = make_vert_map<vec3>(m);
  for (std::size_t i = 0; i < of_vert.size(); ++i)
    if (of_vert[i].size > 0) result.values()[i] = of_vert[i].sum / of_vert[i].size;
  return result;
}

}  // namespace detail

/// The mean gradient of u over each poly: gradient_matrix(m) times u.
/// Needs:  EmbeddedMesh, no temporary; u[v] of every vert of a poly, a number, readable from several threads.
/// Result: a map of vec3, in units of u over length; see gradient_matrix. If values are not finite, neither are the
///         gradients of their polys.
/// Cost:   O(size of the polys) time, in parallel, O(P) memory; the same for any number of threads.
/// Errors: invalid_mesh, naming a poly without area or volume or with points that are not finite.
/// Source: as gradient_matrix.
template<class M, class U>
  requires requirement::is_lvalue_or_view<M> && EmbeddedMesh<M> && requirement::gives_numbers<U, vert_t<M>>
poly_map<M, vec3> gradient(M&& m, const U& u) {
  return detail::find_gradient(m, u);
}

/// The gradient of u at each vert: the mean over the polys around it, weighted by their areas or volumes;
/// vert_gradient_matrix(m) times u.
/// Needs:  as gradient.
/// Result: a map of vec3, in units of u over length; exact on linear functions on planar surfaces and in volumes, at
///         the boundary too; 0 at verts of no poly.
/// Cost:   as gradient, and O(V) memory.      Errors: as gradient.
/// Source: Mancinelli, Livesu, Puppo 2019, "A comparison of methods for gradient field estimation on simplicial meshes"
///         (AGS).
template<class M, class U>
  requires requirement::is_lvalue_or_view<M> && EmbeddedMesh<M> && requirement::gives_numbers<U, vert_t<M>>
vert_map<M, vec3> vert_gradient(M&& m, const U& u) {
  return detail::find_vert_gradient(m, u);
}

// What to write instead of calls that cannot compile.
template<class... T> void gradient(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void gradient(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void gradient(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void vert_gradient(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void vert_gradient(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void vert_gradient(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class M, class U, class R = mistake::remedy<mistake::give_numbers_at_verts>>
  requires(EmbeddedMesh<M> && !requirement::gives_numbers<U, vert_t<M>>)
void gradient(M&&, const U&, ...) = delete;  // a number at each vert: make_vert_map<double>(m)
template<class M, class U, class R = mistake::remedy<mistake::give_numbers_at_verts>>
  requires(EmbeddedMesh<M> && !requirement::gives_numbers<U, vert_t<M>>)
void vert_gradient(M&&, const U&, ...) = delete;  // a number at each vert: make_vert_map<double>(m)

}  // namespace concino
