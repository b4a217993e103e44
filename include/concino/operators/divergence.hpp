// The divergence of a vector field on polys, without a matrix.
#pragma once

#include <concino/concepts/maps.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/core/poly_chunks.hpp>
#include <concino/mesh/element_map.hpp>
#include <concino/operators/simplex_gradients.hpp>

namespace concino {

/// The divergence of a field, integrated with the hat function of each vert: divergence_matrix(m) times the field.
/// Needs:  EmbeddedMesh, no temporary; field[p] of every poly, a vec3 or anything with [0], [1], [2], readable from
///         several threads.
/// Result: a map of double, see divergence_matrix; 0 at verts of no poly. If a vector is not finite, neither are the
///         results at the verts of their polys.
/// Cost:   O(size of the polys) time and memory, in parallel; the same for any number of threads.
/// Errors: invalid_mesh that names a poly without area or volume or with points that are not finite.
/// Source: as divergence_matrix.
template<class M, class Field>
  requires requirement::is_lvalue_or_view<M> && EmbeddedMesh<M> && requirement::gives_points<Field, poly_t<M>>
vert_map<M, double> divergence(M&& m, const Field& field) {
  using mesh = std::remove_cvref_t<M>;
  auto result = make_vert_map<double>(m, 0.0);
  const core::poly_chunks<mesh> chunks(m, [&](const poly_t<mesh>& p) {
    std::size_t n = 0;
    for ([[maybe_unused]] const vert_t<mesh> v : adj_p2v(m, p)) ++n;
    return n;
  });
  std::vector<double> part(chunks.num_corners());
  chunks.template for_each<poly_gradients<mesh>>([&](auto& local, const poly_t<mesh>& p, std::size_t corner) {
    local.visit(m, p);
    if (!local.has_gradients()) detail::throw_no_measure("divergence", m, p);
    const vec3 flow = std::abs(local.measure) * to_vec3(field[p]);
    for (std::size_t i = 0; i < local.verts.size(); ++i) part[corner + i] = dot(local.gradient[i], flow);
    return local.verts.size();
  });
  std::size_t corner = 0;
  for (const poly_t<mesh> p : polys(m))
    for (const vert_t<mesh> v : adj_p2v(m, p)) result[v] -= part[corner++];
  return result;
}

// What to write instead of calls that cannot compile.
template<class... T> void divergence(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void divergence(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void divergence(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class M, class U, class R = mistake::remedy<mistake::give_vectors_at_polys>>
  requires(EmbeddedMesh<M> && !requirement::gives_points<U, poly_t<M>>)
void divergence(M&&, const U&, ...) = delete;  // a vector at each poly: make_poly_map<vec3>(m)

}  // namespace concino
