// The cotangent weights of one triangle or tet.
#pragma once

#include <concino/core/vec3.hpp>

#include <array>
#include <cmath>
#include <cstddef>

namespace concino::detail {

/// A triangle (D = 2) or tet (D = 3) and the weights it contributes to its edges.
///
/// In any dimension the gradient of the hat function of corner i is -s_i / (D |p|), where s_i is the facet opposite i
/// as an outward vector, so the weight of edge ij is -|p| grad_i . grad_j = -s_i . s_j / (D^2 |p|).
template<int D>
struct simplex_weights {
  std::array<vec3, D + 1> facet;
  double factor = 0;  // not finite for a degenerate simplex

  explicit simplex_weights(const std::array<vec3, D + 1>& x) {
    if constexpr (D == 2) {
      facet = {x[2] - x[1], x[0] - x[2], x[1] - x[0]};  // edges replace their normals in the plane: they have the same
                                                        // lengths and angles
      factor = -0.5 / norm(cross(facet[1], facet[2]));
    } else {
      const vec3 a = x[1] - x[0], b = x[2] - x[0], c = x[3] - x[0];
      facet = {vec3{}, cross(b, c), cross(c, a), cross(a, b)};
      facet[0] = -(facet[1] + facet[2] + facet[3]);
      factor = -1 / (6 * std::abs(dot(a, facet[1])));
    }
  }

  double operator()(std::size_t i, std::size_t j) const { return factor * dot(facet[i], facet[j]); }
};

}  // namespace concino::detail
