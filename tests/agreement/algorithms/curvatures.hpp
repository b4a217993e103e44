// Compares principal curvatures.
#pragma once

#include <agreement/matched.hpp>

#include <concino/directions/principal_curvatures.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace concino::agreement {

struct curvatures {
  static constexpr const char* name = "principal_curvatures";
  template<class M> static constexpr bool runs_on = SurfaceMesh<M> && Embedded<M>;

  template<class B, class In>
  static bool check(const B& both, const In&) {
    const auto here = principal_curvatures(both.native);
    const auto there = principal_curvatures(both.other);
    for (const auto v : both.verts.all) {
      const auto &a = here[v], &b = there[both.verts.to(v)];
      const double largest = std::max({1.0, std::abs(a.k1), std::abs(a.k2)});
      expect(std::abs(a.k1 - b.k1) + std::abs(a.k2 - b.k2) < 1e-6 * largest, "the curvatures");
    }
    return !both.verts.all.empty();
  }
};

}  // namespace concino::agreement
