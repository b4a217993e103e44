// Compares the operators that support polys of every shape: the standard Laplacian, the Galerkin mass, and the problems that use them by default.
#pragma once

#include <agreement/algorithms/operators.hpp>

#include <concino/fields/heat_flow.hpp>
#include <concino/fields/poisson.hpp>
#include <concino/fields/smooth.hpp>
#include <concino/operators/mass_matrix.hpp>

namespace concino::agreement {

/// Whether the operators are defined: a poly without a measure has no gradient.
template<class M>
bool all_polys_have_measure(const M& m) {
  for (const auto p : polys(m))
    if (!(std::abs(measure(m, p)) > 0)) return false;
  return num_polys(m) > 0;
}

struct standard {
  static constexpr const char* name = "standard";
  template<class M> static constexpr bool runs_on = EmbeddedMesh<M>;

  template<class B, class In>
  static bool check(const B& both, const In& in) {
    if (!all_polys_have_measure(both.native)) return false;
    laplacians::compare(both, virtual_elements);
    harmonic::compare(both, virtual_elements);
    if (in.manifold) harmonic::compare(both, virtual_elements, {.exponent = 2});
    const auto vert = vert_place(both);
    expect_same_matrix(mass_matrix(both.native, {.lumped = false}), mass_matrix(both.other, {.lumped = false}), vert, vert, "an entry of the mass");
    compare_poisson(both);
    compare_flow(both);
    return true;
  }

  /// Every third edge or face on the boundary.
  template<class B, class Facets, class PolysOf, class Add>
  static void some_boundary(const B& both, const Facets& facets, const PolysOf& polys_of, const Add& add) {
    for (const auto x : facets.all) {
      int n = 0;
      for ([[maybe_unused]] const auto p : polys_of(both.native, x)) ++n;
      if (n == 1 && x.raw() % 3 == 0) add(x, facets.to(x));
    }
  }

  template<class B>
  static void compare_poisson(const B& both) {
    std::vector<std::pair<vert_t<typename B::native_mesh>, double>> here;
    std::vector<std::pair<vert_t<typename B::other_mesh>, double>> there;
    const auto parts = connected_components(both.native);
    int next = 0;
    for (const auto v : both.verts.all)
      if (parts[v] == next) {
        here.push_back({v, ++next});
        there.push_back({both.verts.to(v), next});
      }
    std::vector<std::pair<facet_t<typename B::native_mesh>, double>> out_here;
    std::vector<std::pair<facet_t<typename B::other_mesh>, double>> out_there;
    const auto add = [&](const auto& x, const auto& y) {
      out_here.push_back({x, 0.5});
      out_there.push_back({y, 0.5});
    };
    if constexpr (SurfaceMesh<typename B::native_mesh>) some_boundary(both, both.edges, adj_e2p, add);
    else some_boundary(both, both.faces, adj_f2p, add);
    const auto expected = poisson(both.native, waves(both, both.native, [](const auto v) { return v; }), {.values = here, .fluxes = out_here});
    const auto found = poisson(both.other, waves(both, both.other, [&](const auto v) { return both.verts.to(v); }), {.values = there, .fluxes = out_there});
    const double largest = largest_of(both.verts.all, [&](const auto v) { return expected[v]; });
    for (const auto v : both.verts.all) expect_close(expected[v], found[both.verts.to(v)], largest, "the solution of Poisson's equation");
  }

  template<class B>
  static void compare_flow(const B& both) {
    const auto here = waves(both, both.native, [](const auto v) { return v; });
    const auto there = waves(both, both.other, [&](const auto v) { return both.verts.to(v); });
    const auto expected = heat_flow(both.native, here, 0.1, {.steps = 2}), smoothed = smooth(both.native, here, 0.1);
    const auto found = heat_flow(both.other, there, 0.1, {.steps = 2}), found_smoothed = smooth(both.other, there, 0.1);
    const double largest = largest_of(both.verts.all, [&](const auto v) { return here[v]; });  // heat decays; rounding is relative to the initial values
    for (const auto v : both.verts.all) {
      expect_close(expected[v], found[both.verts.to(v)], largest, "the heat");
      expect_close(smoothed[v], found_smoothed[both.verts.to(v)], largest, "what is smoothed");
    }
  }
};

}  // namespace concino::agreement
