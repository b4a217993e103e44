// Finds the polys that are inverted at a corner.
#pragma once

#include <concino/quality/poly_quality.hpp>

#include <vector>

namespace concino::detail {

/// The polys whose scaled Jacobian is not above 0.
template<class M>
std::vector<poly_id> inverted_polys(const M& m) {
  std::vector<poly_id> inverted;
  const auto value = quality(m, metric::scaled_jacobian);
  for (const poly_id p : polys(m))
    if (!(value[p] > 0)) inverted.push_back(p);
  return inverted;
}

}  // namespace concino::detail
