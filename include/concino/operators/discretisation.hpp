// Discretisations of the Laplacian: types that are passed as tags, as in laplacian(m, uniform). The concept for those
// of the library and your own.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/concepts/primal_graph.hpp>

#include <concepts>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace concino {

/// A symmetric matrix over the verts of one poly, n x n. One object serves for many polys, so that nothing is allocated
/// for each.
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
concept has_poly_matrices = AnyMesh<M> &&
    requires(const D& d, const M& m, const poly_t<M>& p, local_matrix<vert_t<M>>& k) {
  d.poly_matrices(m)(p, k);
};
template<class D, class M>
concept has_masses = requires(const D& d, const M& m, const vert_t<M>& v) {
  { d.masses(m)[v] } -> std::convertible_to<double>;
};

/// A discretisation that declares this: scaling the mesh by s multiplies its entries by s to the dimension minus 2.
template<class D> concept scales_with_mesh = requires { requires bool(D::scales_with_mesh); };

template<class D, class M>
concept has_weights_or_matrices = has_neighbour_weights<D, M> || has_edge_weights<D, M> || has_poly_matrices<D, M>;
struct weights_or_matrices_requirement {
  template<class D, class M>
  static constexpr bool holds = has_weights_or_matrices<std::remove_cvref_t<D>, std::remove_cvref_t<M>>;
  template<class D, class M> static consteval void explain() {
    static_assert(
        !requires(const D& d, const M& m) { d.neighbour_weights(m); } || detail::missing<D, M>,
        "concino: neighbour_weights(m) is there, but what it returns does not give a number for two verts");
    static_assert(
        !requires(const D& d, const M& m) { d.edge_weights(m); } || AnyMesh<M> || detail::missing<D, M>,
        "concino: edge_weights(m) is there, but M has no edges: it is not an AnyMesh");
    static_assert(
        !requires(const D& d, const M& m) { d.edge_weights(m); } || !AnyMesh<M> || detail::missing<D, M>,
        "concino: edge_weights(m) is there, but what it returns does not give a number at each edge");
    static_assert(
        !requires(const D& d, const M& m) { d.poly_matrices(m); } || AnyMesh<M> || detail::missing<D, M>,
        "concino: poly_matrices(m) is there, but M has no polys with verts: it is not an AnyMesh");
    static_assert(
        !requires(const D& d, const M& m) { d.poly_matrices(m); } || !AnyMesh<M> || detail::missing<D, M>,
        "concino: poly_matrices(m) is there, but what it returns cannot be called with a poly and a local_matrix");
    static_assert(
        detail::missing<D, M>,
        "concino: Discretisation needs auto neighbour_weights(const M&) const, of meshes also edge_weights or poly_matrices: a callable w, w(a, b) is the weight of two verts joined by an edge");
  }
};

template<class D, class M> concept has_masses_or_points = has_masses<D, M> || EmbeddedMesh<M>;
struct masses_or_points_requirement {
  template<class D, class M>
  static constexpr bool holds = has_masses_or_points<std::remove_cvref_t<D>, std::remove_cvref_t<M>>;
  template<class D, class M> static consteval void explain() {
    static_assert(
        !requires(const D& d, const M& m) { d.masses(m); } || detail::missing<D, M>,
        "concino: masses(m) is there, but what it returns does not give a number at each vert");
    static_assert(
        detail::missing<D, M>,
        "concino: Discretisation needs auto masses(const M&) const; a map, mass[v] > 0 at each vert: only an EmbeddedMesh has masses without it");
  }
};

// M models at least PrimalGraph.
struct graph_requirement {
  template<class, class M> static constexpr bool holds = PrimalGraph<M>;
};
template<class D, class M>
struct check<graph_requirement, D, M> : check<primal_graph_requirements, M> {
  using first_missing = bound<primal_graph_requirements, M>;
};

using discretisation_requirements =
    list<graph_requirement, weights_or_matrices_requirement, masses_or_points_requirement>;

}  // namespace requirement

/// A discretisation of the Laplacian on M: a type with one of three members, and optionally a fourth.
///
///     d.neighbour_weights(m)   of any graph: a callable w; w(a, b) is the weight of two verts joined by an edge, w(b,
///     a) the same d.edge_weights(m)        of a mesh: a readable map w; w[e] is the weight of edge e
///     d.poly_matrices(m)       of a mesh: a callable k; k(p, out) fills in the local_matrix of poly p: symmetric, rows
///     that sum to 0 d.masses(m)              a readable map; mass[v] > 0 of each vert that has edges
///
/// If several of the three exist, the first is used. Weights add w (u(a) - u(b))^2 to the energy u . (-L) u; matrices
/// add u . K u. Single terms may be negative, but not the sum. The returned objects live while a matrix is assembled.
/// Callables w are shared by several threads. Each thread has its own k, which may reuse memory.
///
/// Without masses, those of the mesh are used: the discretisation is integrated, in units of length to the dimension
/// minus 2. With masses, weights and masses are taken as they are: if they have no unit, as those of `uniform`, times
/// and amounts have none.
///
/// The members get the mesh unchanged. A discretisation that takes any M may set `static constexpr bool
/// scales_with_mesh = true;` if its entries grow with the scale s of the mesh as s to the dimension minus 2. Its
/// members then get a view of the mesh at a size near 1, so that very small and very large meshes are solved equally
/// accurately. Do not set it if entries depend on positions, as a conductivity may.
///
/// explain_discretisation<D, M>() names what is missing.
template<class D, class M>
concept Discretisation =
    PrimalGraph<M> && requirement::has_weights_or_matrices<std::remove_cvref_t<D>, std::remove_cvref_t<M>> &&
    requirement::has_masses_or_points<std::remove_cvref_t<D>, std::remove_cvref_t<M>>;

/// Fails to compile with one sentence: the first requirement of Discretisation that D or M lacks, and what to write.
template<class D, class M>
consteval void explain_discretisation() {
  if constexpr (!Discretisation<D, M>)
    requirement::first_missing<requirement::discretisation_requirements, D, M>::template explain<D, M>();
}

}  // namespace concino
