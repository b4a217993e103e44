// A vert in a search for shortest paths: the length of its path, and the curvature of the front of paths there.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

namespace concino::detail {

/// What a search for shortest paths knows at a vert.
struct distance_node {
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  double path_length = infinity;
  double before = 0;
  double curvature_deficit = 0;  // 1 / distance minus the curvature of the front: 0 on a plane; if step is not 0, the
                                 // value one step earlier
  double radius = 0, step = 0;
  double mean_curvature = 0;  // of the surface, over that step
  double curvature = 0;
  int source = -1;
  std::uint8_t state = 0;  // bit 0: settled; the rest counts later improvements, which are limited
  bool is_settled() const { return state & 1; }

  /// Riccati's equation c' = -c^2 - K for the curvature c of a front, with c = 1 / radius - curvature_deficit. A
  /// front that is as narrow as a step is too uncertain.
  void update_curvature_deficit() {
    if (!(step > 0)) return;
    const double rate = mean_curvature - 2 * curvature_deficit / std::max(radius, step) +
                        curvature_deficit * curvature_deficit,
                 most = 1 / step;
    curvature_deficit = std::clamp(curvature_deficit + step * rate, -most, most);
    step = 0;
  }
};

}  // namespace concino::detail
