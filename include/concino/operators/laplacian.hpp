// The Laplacian of functions on verts, as a sparse matrix.
#pragma once

#include <concino/core/assembly.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/operators/detail/element_assembly.hpp>
#include <concino/operators/weights.hpp>

namespace concino {

struct laplacian_options {
  concino::weights weights = concino::weights::standard;  // which entries L has
};

/// The matrix L of the Laplacian, integrated: u . L u is minus the integral of the squared gradient of u (with uniform weights minus the sum of
/// the squared differences along edges), and off the diagonal stand the weights by which L u compares u at a vert with others.
/// Needs:  PrimalGraph M; for cotangent weights an Embedded mesh of triangles or tets.
/// Result: vert_index_bound(m) rows and columns, by index_of; symmetric to the last bit, negative semidefinite, the constants of each component
///         (of polys joined at verts) in the kernel and nothing else where all polys are one. Entries join the ends of edges, with
///         standard weights also other verts of one poly. A vert without edges has a 0 on the diagonal and nothing else, a deleted
///         one an empty column. With standard weights linear functions are in the kernel at interior verts of planar surfaces and of
///         volumes, whatever the polys; polys turned inside out count as if they were not. In units of length to the dimension minus 2,
///         scaling exactly with powers of two.
/// Cost:   O(V + E + size of the polys) time and memory; with standard weights on other polys than triangles and tets by type the sum of the
///         squares of their numbers of verts. The polys are computed in parallel; the same bits for any number of threads.
/// Errors: invalid_mesh if weights are not uniform and a poly has no area or volume or points that are not finite; unsupported if they are
///         cotangent and some poly is no triangle or tet (it is named), virtual_refinement and one is not star-shaped about its virtual point,
///         de_goes and M is a volume, or if M has no polys or points and they need some, or if the matrix would be too large for 32-bit indices.
/// Source: Beirao da Veiga et al. 2013, "Basic principles of virtual element methods" (standard); Pinkall, Polthier 1993 (triangles);
///         Crane 2019, "The n-dimensional cotangent formula" (tets); Bunge, Herholz, Kazhdan, Botsch 2020, "Polygon Laplacian made simple"
///         (virtual_refinement); de Goes, Butts, Desbrun 2020, "Discrete differential operators on polygonal meshes"; paper section 2.2.
template<PrimalGraph M>
Eigen::SparseMatrix<double> laplacian(const M& m, const laplacian_options& options = {}) {
  return detail::with_weights(
      m, options.weights,
      [&](const auto& weights) {
        return core::assemble<core::whole_matrix>(
            m, weights, vert_index_bound(m), -1.0, [&](const vert_t<M>& v) { return static_cast<int>(index_of(m, v)); },
            [](int, const vert_t<M>&, double) {});
      },
      [&](auto make_element) { return detail::assemble_stiffness(m, make_element, -1.0); });
}

// What to write instead of calls that cannot compile.
template<class... T> void laplacian(mistake::no_mesh_traits<mistake::include_adapter>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or a sibling

}  // namespace concino
