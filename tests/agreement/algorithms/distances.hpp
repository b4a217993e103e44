// Compares heat_geodesics: from a vert, from two verts with initial distances, and from a point in a poly.
#pragma once

#include <agreement/algorithms/virtual_elements.hpp>

#include <concino/fields/heat_geodesics.hpp>

namespace concino::agreement {

struct distances {
  static constexpr const char* name = "heat_geodesics";
  template<class M> static constexpr bool runs_on = EmbeddedMesh<M>;

  template<class B, class In>
  static bool check(const B& both, const In&) {
    if (!all_polys_have_measure(both.native)) return false;
    const auto here = prepare_heat_geodesics(both.native);
    const auto there = prepare_heat_geodesics(both.other);
    const auto expect_same = [&](const auto& expected, const auto& found) {
      for (const auto v : both.verts.all) {
        const double a = expected[v], b = found[both.verts.to(v)];
        INFO(a << " and " << b);
        expect(a == b || std::abs(a - b) <= 1e-9 * std::max(1.0, std::abs(a)), "the distance");
      }
    };
    const auto v = both.verts.all.front(), w = both.verts.all[both.verts.all.size() / 3];
    expect_same(here.distance_from(v), there.distance_from(both.verts.to(v)));
    expect_same(here.distance_from({{v, 0.0}, {w, 0.25}}), there.distance_from({{both.verts.to(v), 0.0}, {both.verts.to(w), 0.25}}));
    const auto p = both.polys.all.back();
    const vec3 x = centroid(both.native, p);
    expect_same(here.distance_from(p, x), there.distance_from(both.polys.to(p), x));
    return true;
  }
};

}  // namespace concino::agreement
