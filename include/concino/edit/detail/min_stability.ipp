// The body of min_stability.hpp.
#pragma once

#include <concino/edit/detail/proposed_mesh.hpp>
#include <concino/edit/min_stability.hpp>
#include <concino/operators/stability.hpp>

namespace concino {

CONCINO_INLINE permission min_stability::operator()(const proposed_edit& e) const {
  for (std::size_t k = 0; k < e.num_new_polys(); ++k) {
    const double value = detail::mesh_dimension(e) == 2 ? stability(detail::new_polygon(e, k), poly_id{0})
                                                      : stability(detail::new_polyhedron(e, k), poly_id{0});
    if (!(value >= limit))
      return {refusal::invariant, "min_stability: a new poly would have less than the minimum stability"};
  }
  return {};
}

}  // namespace concino
