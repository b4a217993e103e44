// Access to a discretisation for matrix assembly: its weights of edges, or its matrices of polys.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/core/assembly.hpp>
#include <concino/operators/detail/element_assembly.hpp>
#include <concino/operators/discretisation.hpp>

#include <Eigen/SparseCore>

#include <cstddef>
#include <utility>

namespace concino {

namespace detail {

/// w(a, b) for neighbours a and b.
template<PrimalGraph M, class W>
struct weights_of_neighbours {
  const M& m;
  W weight;

  int num_neighbours(const vert_t<M>& v) const {
    int n = 0;
    for ([[maybe_unused]] const vert_t<M> w : adj_v2v(m, v)) ++n;
    return n;
  }
  template<class F>
  void for_each_neighbour(const vert_t<M>& v, F&& f) const {
    for (const vert_t<M> w : adj_v2v(m, v)) f(w, static_cast<double>(weight(v, w)));
  }
};

/// w[e] for edges e.
template<AnyMesh M, class W>
struct weights_of_edges {
  const M& m;
  W weight;

  int num_neighbours(const vert_t<M>& v) const {
    int n = 0;
    for ([[maybe_unused]] const edge_t<M> e : adj_v2e(m, v)) ++n;
    return n;
  }
  template<class F>
  void for_each_neighbour(const vert_t<M>& v, F&& f) const {
    for (const edge_t<M> e : adj_v2e(m, v)) {
      const auto [a, b] = end_verts(m, e);
      f(a == v ? b : a, static_cast<double>(weight[e]));
    }
  }
};

}  // namespace detail

/// Passes the weights or the matrices of a discretisation, whichever it has, to the function that assembles them.
/// Needs:  PrimalGraph M, Discretisation D. on_weights(w): w.num_neighbours(v) and w.for_each_neighbour(v, f) with
///         f(neighbour, weight), as core::assemble uses them. on_polys(make): make() creates a separate element for
///         each thread, as detail::assemble_elements requires.
/// Result: the return value of on_weights or on_polys.
/// Cost:   that of the discretisation's members, and of the called function.
/// Errors: those of the discretisation, and of the called function.
template<PrimalGraph M, Discretisation<M> D, class OnWeights, class OnPolys>
Eigen::SparseMatrix<double> with_stiffness(const M& m, const D& discretisation, const OnWeights& on_weights,
                                           const OnPolys& on_polys) {
  if constexpr (requirement::has_neighbour_weights<D, M>) {
    return on_weights(detail::weights_of_neighbours<M, decltype(discretisation.neighbour_weights(m))>{
        m, discretisation.neighbour_weights(m)});
  } else if constexpr (requirement::has_edge_weights<D, M>) {
    return on_weights(
        detail::weights_of_edges<M, decltype(discretisation.edge_weights(m))>{m, discretisation.edge_weights(m)});
  } else {
    const auto make = [&] { return discretisation.poly_matrices(m); };
    const auto make_operator = [&] { return detail::poly_operator_of<M>(make); };
    return on_polys(detail::make_poly_operator<M>(make_operator));
  }
}

/// The lower triangle of minus the Laplacian.
/// Needs:  PrimalGraph M, Discretisation D.
/// Result: minus that of laplacian, without the entries above the diagonal.
/// Cost:   as laplacian.      Errors: as laplacian.
template<PrimalGraph M, Discretisation<M> D>
Eigen::SparseMatrix<double> lower_stiffness(const M& m, const D& discretisation) {
  return with_stiffness(
      m, discretisation,
      [&](const auto& weights) {
        return core::assemble<core::lower_triangle>(
            m, weights, vert_index_bound(m), 1.0, [&](const vert_t<M>& v) { return static_cast<int>(index_of(m, v)); },
            [](int, const vert_t<M>&, double) {});
      },
      [&](auto make_element) { return detail::assemble_elements<M>(m, make_element); });
}

}  // namespace concino
