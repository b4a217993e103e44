// The uniform discretisation: weight 1 on every edge of any graph.
#pragma once

#include <concino/operators/discretisation.hpp>

namespace concino {

namespace detail {

/// A map that has 1 at every vert.
struct all_ones {
  template<class X>
  constexpr double operator[](const X&) const { return 1; }
};

}  // namespace detail

/// The graph Laplacian: the weight 1 on every edge, the mass 1 at every vert, whatever the points. Needs a PrimalGraph.
/// Without unit.
struct uniform_t {
  template<PrimalGraph M>
  constexpr auto neighbour_weights(const M&) const {
    return [](const vert_t<M>&, const vert_t<M>&) { return 1.0; };
  }
  template<PrimalGraph M>
  constexpr detail::all_ones masses(const M&) const { return {}; }
};
inline constexpr uniform_t uniform{};

}  // namespace concino
