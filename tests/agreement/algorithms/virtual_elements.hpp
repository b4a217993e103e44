// What is right on polys of every shape: the standard Laplacian, the Galerkin mass, and the problems that are solved with them by default.
#pragma once

#include <agreement/algorithms/operators.hpp>

#include <concino/fields/poisson.hpp>
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
  template<class M> static constexpr bool runs_on = AnyMesh<M> && Embedded<M>;

  template<class B, class In>
  static bool check(const B& both, const In& in) {
    if (!all_polys_have_measure(both.native)) return false;
    laplacians::compare(both, weights::standard);
    harmonic::compare(both, {});
    if (in.manifold) harmonic::compare(both, {.exponent = 2});
    const auto vert = vert_place(both);
    expect_same_matrix(mass_matrix(both.native, {.lumped = false}), mass_matrix(both.other, {.lumped = false}), vert, vert, "an entry of the mass");
    compare_poisson(both);
    return true;
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
    const auto expected = poisson(both.native, waves(both, both.native, [](const auto v) { return v; }), here);
    const auto found = poisson(both.other, waves(both, both.other, [&](const auto v) { return both.verts.to(v); }), there);
    for (const auto v : both.verts.all) expect_close(expected[v], found[both.verts.to(v)], "the solution of Poisson's equation");
  }
};

}  // namespace concino::agreement
