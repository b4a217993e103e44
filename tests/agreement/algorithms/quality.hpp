// Compares quality metrics that are defined for polys of all shapes, and the worst poly.
#pragma once

#include <agreement/matched.hpp>

#include <concino/quality/worst.hpp>

namespace concino::agreement {

struct qualities {
  static constexpr const char* name = "quality";
  template<class M> static constexpr bool runs_on = EmbeddedMesh<M>;

  template<class B, class In>
  static bool check(const B& both, const In&) {
    const auto& n = both.native;
    const auto& m = both.other;
    const auto size = quality(n, dimension_v<typename B::other_mesh> == 2 ? metric::area : metric::volume);
    for (const metric what : {metric::scaled_jacobian, metric::mean_ratio, metric::planarity, metric::star_shapedness, metric::edge_ratio, metric::relative_size_squared}) {
      const auto a = quality(n, what);
      const auto b = quality(m, what);
      const double largest = largest_of(both.polys.all, [&](const auto p) { return a[p]; });
      for (const auto p : both.polys.all) {
        expect(shape_of_poly(n, p) == shape_of_poly(m, both.polys.to(p)), "the shape of a poly");
        if (std::abs(size[p]) < 1e-9) continue;  // directions of polys without area consist of rounding errors
        expect_close(a[p], b[both.polys.to(p)], largest, "quality");
        expect_close(a[p], quality(m, both.polys.to(p), what), largest, "quality of a poly");
      }
    }
    if (!both.polys.all.empty()) {
      const auto w = worst(m, metric::edge_ratio);
      expect_close(worst(n, metric::edge_ratio).value, w.value, w.value, "the worst edge ratio");
    }
    return true;
  }
};

}  // namespace concino::agreement
