// The Laplacian of functions on verts, as a sparse matrix.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/operators/cotangent.hpp>
#include <concino/operators/discretisation.hpp>
#include <concino/operators/stiffness.hpp>
#include <concino/operators/uniform.hpp>
#include <concino/operators/virtual_elements.hpp>

namespace concino {

/// The integrated Laplacian as a matrix L: u . L u is minus the integral of the squared gradient of u; with `uniform`,
/// minus the sum of the squared differences along edges. Off-diagonal entries are the weights of the differences
/// between u at two verts. The default discretisation is virtual_elements, which gives the cotangent weights on
/// triangles and tets.
/// Needs:  EmbeddedMesh M, or a discretisation: laplacian(m, uniform) of any PrimalGraph, laplacian(m, cotangent) of
///         triangles or tets, those of <concino/operators/virtual_refinement.hpp> and <concino/operators/de_goes.hpp>,
///         or your own, see Discretisation.
/// Result: vert_index_bound(m) rows and columns, by index_of; symmetric to the last bit and negative semidefinite. The
///         constants of each component (of polys joined at verts) are in the kernel, and nothing else if all polys form
///         one component. Entries join the ends of edges and, with matrices of polys, other verts of one poly. A vert
///         without edges has only a 0 on the diagonal, a deleted one an empty column. In units of length to the
///         dimension minus 2, scaling exactly with powers of two.
/// Cost:   O(V + E + size of the polys) time and memory. With matrices of polys it is the sum of the squares of their
///         numbers of verts: virtual_elements have them unless polys are triangles or tets by type. Polys are computed
///         in parallel; any number of threads gives the same bits.
/// Errors: those of the discretisation, see virtual_elements and cotangent; unsupported if the matrix would be too
///         large for 32-bit indices.
/// Source: that of the discretisation; paper section 2.2.
template<PrimalGraph M, Discretisation<M> D>
Eigen::SparseMatrix<double> laplacian(const M& m, const D& discretisation) {
  return with_stiffness(
      m, discretisation,
      [&](const auto& weights) {
        return core::assemble<core::whole_matrix>(
            m, weights, vert_index_bound(m), -1.0, [&](const vert_t<M>& v) { return static_cast<int>(index_of(m, v)); },
            [](int, const vert_t<M>&, double) {});
      },
      [&](auto make_element) { return detail::assemble_stiffness<M>(m, make_element, -1.0); });
}
template<EmbeddedMesh M>
Eigen::SparseMatrix<double> laplacian(const M& m) {
  return laplacian(m, virtual_elements);
}

// What to write instead of calls that cannot compile.
template<class... T> void laplacian(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void laplacian(mistake::bare_graph<mistake::name_discretisation>, ...) = delete;  // needs point(m, v) and polys; else write laplacian(m, uniform)

}  // namespace concino
