// Compares circles, balls, kernels and widths of polys.
#pragma once

#include <agreement/algorithms/sizes.hpp>

#include <concino/geometry/enclosing_ball.hpp>
#include <concino/geometry/inscribed_circle.hpp>
#include <concino/geometry/kernel.hpp>
#include <concino/geometry/width.hpp>
#include <concino/quality/poly_quality.hpp>

namespace concino::agreement {

struct circles {
  static constexpr const char* name = "circles";
  template<class M> static constexpr bool runs_on = EmbeddedMesh<M>;

  template<class B, class In>
  static bool check(const B& both, const In&) {
    const auto& n = both.native;
    const auto& m = both.other;
    const double coordinate = largest_in(bounding_box(n)), size = coordinate * coordinate;
    expect_close(enclosing_ball(n).radius, enclosing_ball(m).radius, coordinate, "the ball around all verts");
    for (const auto p : both.polys.all) {
      const auto& q = both.polys.to(p);
      expect_close(enclosing_ball(n, p).radius, enclosing_ball(m, q).radius, coordinate, "the ball around a poly");
      if (std::abs(measure(n, p)) < 1e-9) continue;  // the plane of a polygon without area consists of rounding errors
      expect_close(width(n, p).width, width(m, q).width, coordinate, "the width");
      if constexpr (SurfaceMesh<typename B::other_mesh>) {
        expect_close(enclosing_circle(n, p).radius, enclosing_circle(m, q).radius, coordinate, "the circle around a poly");
        const auto inside = unless_refused<invalid_mesh>([&] { return inscribed_circle(n, p); });
        const auto same = unless_refused<invalid_mesh>([&] { return inscribed_circle(m, q); });
        expect(inside.has_value() == same.has_value(), "the same polys have a circle inside");
        // either is the largest up to the tolerance
        if (inside) expect(std::abs(inside->radius - same->radius) <= 2e-9 * inside->max_radius, "the radius of the circle inside");
        expect(std::abs(quality(n, p, metric::circle_ratio) - quality(m, q, metric::circle_ratio)) <= 4e-9, "circle_ratio");
        expect_close(quality(n, p, metric::area_perimeter_ratio), quality(m, q, metric::area_perimeter_ratio), 1, "area_perimeter_ratio");
      }
      const auto seen = unless_refused<invalid_mesh>([&] { return kernel(n, p); });
      const auto found = unless_refused<invalid_mesh>([&] { return kernel(m, q); });
      expect(seen.has_value() == found.has_value(), "the same polys have a kernel");
      if (!seen) continue;
      if constexpr (SurfaceMesh<typename B::other_mesh>) expect_close(seen->area, found->area, size, "the area of the kernel");
      else expect_close(seen->volume, found->volume, size * coordinate, "the volume of the kernel");
    }
    return true;
  }
};

}  // namespace concino::agreement
