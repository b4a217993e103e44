// The divergence of vector fields on polys, integrated about each vert, as a sparse matrix.
#pragma once

#include <concino/core/assembly.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/core/poly_chunks.hpp>
#include <concino/operators/detail/compressed_columns.hpp>
#include <concino/operators/simplex_gradients.hpp>

namespace concino {

/// The matrix D = -G^T M_p, with G the gradient_matrix and M_p the poly_mass_matrix. Row v of D times a vector field on
/// polys is its divergence, integrated with the hat function of v. Columns 3p, 3p + 1, 3p + 2 take x, y and z of the
/// vector of poly p. Divide by vert_masses for the divergence at a point.
/// Needs:  as gradient_matrix.
/// Result: vert_index_bound(m) rows, 3 poly_index_bound(m) columns, by index_of; an entry for every vert of every poly,
///         rows sorted in each column; those of deleted elements and of verts of no poly are empty. It is the adjoint
///         of the gradient. Flow out through the boundary counts as a sink at its verts, so each column sums to 0.
///         Constant fields have divergence 0 at the interior verts of planar surfaces and of volumes without inverted
///         polys, for every kind of poly. D G is the cotangent Laplacian on triangles and tets. In units of length
///         (surfaces) or length^2, scales exactly.
/// Cost:   O(size of the polys) time and memory, in parallel; the same for any number of threads.
/// Errors: as gradient_matrix.
/// Source: the weak form of the finite element method; paper section 2.2, "transposing the gradient matrix".
template<EmbeddedMesh M>
Eigen::SparseMatrix<double> divergence_matrix(const M& m) {
  constexpr const char* caller = "divergence_matrix";
  auto d = detail::empty_columns(caller, vert_index_bound(m), 3 * poly_index_bound(m));
  int* const begin = d.outerIndexPtr();
  const core::poly_chunks<M> chunks(m, [&](const poly_t<M>& p) {
    int n = 0;
    for ([[maybe_unused]] const vert_t<M> v : adj_p2v(m, p)) ++n;
    const std::size_t c = 3 * index_of(m, p);
    begin[c + 1] = begin[c + 2] = begin[c + 3] = n;
    return n;
  });
  detail::make_room(caller, d);
  chunks.template for_each<poly_gradients<M>>([&](auto& local, const poly_t<M>& p, std::size_t) {
    local.visit(m, p);
    if (!local.has_gradients()) detail::throw_no_measure(caller, m, p);
    const double size = -std::abs(local.measure);
    const std::size_t n = local.verts.size();
    for (std::size_t k = 0; k < 3; ++k) {
      int* const rows = d.innerIndexPtr() + begin[3 * index_of(m, p) + k];
      double* const values = d.valuePtr() + (rows - d.innerIndexPtr());
      for (std::size_t i = 0; i < n; ++i) {
        rows[i] = static_cast<int>(index_of(m, local.verts[i]));
        values[i] = size * local.gradient[i][k];
      }
      core::sort_column(rows, values, n);
    }
    return n;
  });
  return d;
}

// What to write instead of calls that cannot compile.
template<class... T> void divergence_matrix(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void divergence_matrix(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
