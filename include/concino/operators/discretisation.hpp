// Discretisations of the Laplacian are types, passed as tags: laplacian(m, uniform). The concept of the library's, and of your own.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/concepts/primal_graph.hpp>

#include <concepts>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace concino {

/// A symmetric matrix over the verts of one poly, n x n. Used again for poly after poly, so that nothing is allocated for each.
template<class Vert>
struct local_matrix {
  std::vector<Vert> verts;      // of the poly, each once, in any order
  std::vector<double> entries;  // the lower triangle, row after row: entry (i, j) with j <= i at i (i + 1) / 2 + j

  std::size_t size() const { return verts.size(); }
  double& at(std::size_t i, std::size_t j) { return entries[i * (i + 1) / 2 + j]; }
  double at(std::size_t i, std::size_t j) const { return entries[i * (i + 1) / 2 + j]; }
};

namespace requirement {

template<class D, class M>
concept has_neighbour_weights = requires(const D& d, const M& m, const vert_t<M>& v) {
  { d.neighbour_weights(m)(v, v) } -> std::convertible_to<double>;
};
template<class D, class M>
concept has_edge_weights = AnyMesh<M> && requires(const D& d, const M& m, const edge_t<M>& e) {
  { d.edge_weights(m)[e] } -> std::convertible_to<double>;
};
template<class D, class M>
concept has_poly_matrices = AnyMesh<M> && requires(const D& d, const M& m, const poly_t<M>& p, local_matrix<vert_t<M>>& k) { d.poly_matrices(m)(p, k); };
template<class D, class M>
concept has_masses = requires(const D& d, const M& m, const vert_t<M>& v) {
  { d.masses(m)[v] } -> std::convertible_to<double>;
};

/// For one that says so, the mesh times s has s to the dimension minus 2 times its entries.
template<class D> concept scales_with_mesh = requires { requires bool(D::scales_with_mesh); };

template<class D, class M> concept has_weights_or_matrices = has_neighbour_weights<D, M> || has_edge_weights<D, M> || has_poly_matrices<D, M>;
template<class D, class M> concept has_masses_or_points = has_masses<D, M> || EmbeddedMesh<M>;

}  // namespace requirement

/// A discretisation of the Laplacian on M: a type with one of three members, and perhaps a fourth.
///
///     d.neighbour_weights(m)   of any graph: a callable w; w(a, b) is the weight of two verts joined by an edge, w(b, a) the same
///     d.edge_weights(m)        of a mesh: a readable map w; w[e] is the weight of edge e
///     d.poly_matrices(m)       of a mesh: a callable k; k(p, out) fills in the local_matrix of poly p: symmetric, rows that sum to 0
///     d.masses(m)              a readable map; mass[v] > 0 of each vert that has edges
///
/// Of several of the three the first is used. Weights add to the energy u . (-L) u as w (u(a) - u(b))^2, matrices as u . K u; neither needs to be
/// positive term by term, but the sum must not be negative. What the members return is kept while a matrix is assembled; callables w are read from
/// several threads, while each thread has a k of its own, which may hold memory that it uses again.
///
/// Without masses, those of the mesh are used: the discretisation is integrated, in units of length to the dimension minus 2. With masses, weights
/// and masses are taken as they are: where they have no unit, as those of `uniform`, times and amounts have none.
///
/// The members are asked about the mesh as it is. One that takes any M, and whose entries on the mesh times s are s to the dimension minus 2 times as
/// large, may say so by `static constexpr bool scales_with_mesh = true;`: then they are given a view of the mesh at a size near 1, so that problems are
/// solved as well for very small and very large meshes. What depends on places, as a conductivity may, must not say so.
template<class D, class M>
concept Discretisation = PrimalGraph<M> && requirement::has_weights_or_matrices<std::remove_cvref_t<D>, std::remove_cvref_t<M>> &&
                         requirement::has_masses_or_points<std::remove_cvref_t<D>, std::remove_cvref_t<M>>;

}  // namespace concino
