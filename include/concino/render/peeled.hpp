// The criterion for polys that remain if layers are peeled off the boundary.
#pragma once

#include <concino/concepts/facets.hpp>
#include <concino/core/error.hpp>
#include <concino/render/criterion.hpp>

namespace concino {

/// Polys that remain after a number of layers has been removed from the boundary.
struct peeled_criterion : criterion_base {
  int layers = 0;

  template<AnyMesh M>
  auto prepare(const M& m) const {
    detail::evaluated_criterion<M> remains(m, true);
    std::vector<poly_t<M>> layer, next;
    if (layers > 0)
      for (const poly_t<M> p : polys(m))
        if (is_boundary(m, p)) layer.push_back(p), remains.mask[index_of(m, p)] = 0;
    for (int k = 1; k < layers && !layer.empty(); ++k, layer.swap(next)) {
      next.clear();
      for (const poly_t<M>& p : layer)
        for (const poly_t<M> q : adj_p2p(m, p))
          if (unsigned char& stays = remains.mask[index_of(m, q)]; stays) next.push_back(q), stays = 0;
    }
    return remains;
  }
};

/// Polys that remain after n layers have been peeled off the boundary. The first layer are the polys with a facet on
/// the boundary, the next one the polys that share a facet with it, and so on. Parts without boundary, such as closed
/// surfaces, have no layers.
/// Needs:  n >= 0.      Result: a criterion for any AnyMesh.      Cost: O(1); to evaluate it, O(polys and their
///         facets).
/// Errors: invalid_argument if n < 0.
inline peeled_criterion peeled(int n) {
  if (n < 0) throw invalid_argument("peeled: the number of layers must not be negative");
  return {{}, n};
}

}  // namespace concino
