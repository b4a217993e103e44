// Compares persistence, simplified and regions_of_maxima of any graph; critical_points and reeb_graph.
#pragma once

#include <agreement/matched.hpp>

#include <concino/fields/critical_points.hpp>
#include <concino/fields/persistence.hpp>
#include <concino/fields/reeb_graph.hpp>
#include <concino/fields/regions_of_maxima.hpp>
#include <concino/fields/simplified.hpp>

namespace concino::agreement {

/// The same different values at corresponding verts, so that orders of indices do not matter.
template<class B>
auto rough_values(const B& both) {
  auto here = make_vert_map<double>(both.native);
  auto there = make_vert_map<double>(both.other);
  double k = 0;
  for (const auto v : both.verts.all) {
    here[v] = std::sin(k * k) + 1e-4 * k;
    there[both.verts.to(v)] = here[v];
    ++k;
  }
  return std::pair(std::move(here), std::move(there));
}

struct pairs_of_extrema {
  static constexpr const char* name = "persistence";
  template<class M> static constexpr bool runs_on = PrimalGraph<M>;

  template<class B, class In>
  static bool check(const B& both, const In&) {
    const auto [here, there] = rough_values(both);
    const auto expect_same = [&](const auto& expected, const auto& found) {
      expect(expected.size() == found.size(), "as many pairs");
      for (std::size_t k = 0; k < expected.size(); ++k) {
        expect(both.verts.to(expected[k].extremum) == found[k].extremum, "the extremum");
        expect(expected[k].saddle.has_value() == found[k].saddle.has_value(), "whether there is a saddle");
        if (expected[k].saddle) expect(both.verts.to(*expected[k].saddle) == *found[k].saddle, "the saddle");
      }
    };
    const auto a = persistence(both.native, here);
    const auto b = persistence(both.other, there);
    expect_same(a.minima, b.minima);
    expect_same(a.maxima, b.maxima);
    const auto u = simplified(both.native, here, {.maxima_below = 0.5});
    const auto w = simplified(both.other, there, {.maxima_below = 0.5});
    const auto regions = regions_of_maxima(both.native, here);
    const auto others = regions_of_maxima(both.other, there);
    for (const auto v : both.verts.all) {
      expect_close(u[v], w[both.verts.to(v)], 1, "the simplified function");
      expect(regions[v] == others[both.verts.to(v)], "the region");
    }
    return true;
  }
};

struct critical_verts {
  static constexpr const char* name = "critical_points";
  template<class M> static constexpr bool runs_on = AnyMesh<M>;

  template<class B, class In>
  static bool check(const B& both, const In& in) {
    if (dimension_v<typename B::native_mesh> == 3 && !in.manifold) return false;  // it has polyhedra that are not closed
    const auto [here, there] = rough_values(both);
    const auto a = critical_points(both.native, here);
    const auto b = critical_points(both.other, there);
    for (const auto v : both.verts.all) expect(a[v] == b[both.verts.to(v)], "the multiplicities");
    const auto expected = reeb_graph(both.native, here);
    const auto found = reeb_graph(both.other, there);
    expect(expected.nodes.size() == found.nodes.size() && expected.arcs.size() == found.arcs.size(), "as many nodes and arcs");
    for (std::size_t k = 0; k < expected.nodes.size(); ++k) expect(both.verts.to(expected.nodes[k]) == found.nodes[k], "the node");
    for (std::size_t k = 0; k < expected.arcs.size(); ++k) expect(expected.arcs[k].upper == found.arcs[k].upper, "the upper end of the arc");
    return true;
  }
};

}  // namespace concino::agreement
