// The Laplacian of functions on verts, as a sparse matrix.
#pragma once

#include <concino/operators/detail/assembly.hpp>
#include <concino/operators/weights.hpp>

namespace concino {

struct laplacian_options {
  concino::weights weights = concino::weights::uniform;
};

/// The matrix L with the weight of edge ij at (i, j) and minus the sum of the weights at i on the diagonal, so that L u compares u at a
/// vert with its neighbours.
/// Needs:  PrimalGraph M; for cotangent weights an Embedded mesh of triangles or tets.
/// Result: vert_index_bound(m) rows and columns, by index_of; symmetric to the last bit, negative semidefinite, constants in the kernel.
///         A vert without edges has a 0 on the diagonal and nothing else, a deleted one an empty column. With cotangent weights
///         linear functions are in the kernel at the interior verts of planar surfaces and of volumes, edges of the boundary
///         have the one term they have polys for, and tets turned inside out count as if they were not.
/// Cost:   O(V + E + size of the polys) time and memory.
/// Errors: unsupported if weights are cotangent and some poly is no triangle or tet (it is named) or M has no polys or points;
///         invalid_mesh if they are and a poly has no area or volume.
/// Source: Pinkall, Polthier 1993 (triangles); Crane 2019, "The n-dimensional cotangent formula" (tets); paper section 2.2.
template<PrimalGraph M>
Eigen::SparseMatrix<double> laplacian(const M& m, const laplacian_options& options = {}) {
  return detail::with_weights(m, options.weights, [&](const auto& weights) {
    return detail::assemble<detail::whole_matrix>(
        m, weights, static_cast<std::size_t>(vert_index_bound(m)), -1.0, [&](const vert_t<M>& v) { return static_cast<int>(index_of(m, v)); },
        [](int, const vert_t<M>&, double) {});
  });
}

}  // namespace concino
