// laplacian and harmonic_map, with uniform weights and with cotangents.
#pragma once

#include <agreement/matched.hpp>

#include <concino/fields/harmonic_map.hpp>
#include <concino/graph/components.hpp>
#include <concino/operators/laplacian.hpp>

namespace concino::agreement {

/// Whether all polys are triangles or tets.
template<class In, class M>
bool has_cotangents(const In& in, const M& m) {
  if constexpr (AnyMesh<M> && Embedded<M>) {
    for (const auto p : polys(m)) {
      int n = 0;
      for ([[maybe_unused]] const auto v : adj_p2v(m, p)) ++n;
      if (n != dimension_v<M> + 1) return false;
    }
    return in.manifold && num_polys(m) > 0;
  }
  return false;
}

struct laplacians {
  static constexpr const char* name = "laplacian";
  template<class M> static constexpr bool runs_on = PrimalGraph<M>;

  template<class B, class In>
  static bool check(const B& both, const In&) {
    compare(both, weights::uniform);
    return true;
  }

  template<class B>
  static void compare(const B& both, weights which) {
    const auto expected = laplacian(both.native, {.weights = which});
    const auto found = laplacian(both.other, {.weights = which});
    expect(std::size_t(found.rows()) == vert_index_bound(both.other) && expected.nonZeros() == found.nonZeros(), "as many entries");
    const auto row = [&](Eigen::Index i) {
      return static_cast<Eigen::Index>(index_of(both.other, both.verts.to(vert_t<typename B::native_mesh>{i})));
    };
    for (int c = 0; c < expected.outerSize(); ++c)
      for (Eigen::SparseMatrix<double>::InnerIterator it(expected, c); it; ++it)
        expect_close(it.value(), found.coeff(row(it.row()), row(it.col())), "an entry of the Laplacian");
  }
};

struct harmonic {
  static constexpr const char* name = "harmonic_map";
  template<class M> static constexpr bool runs_on = PrimalGraph<M>;

  template<class B, class In>
  static bool check(const B& both, const In&) {
    if (both.verts.empty()) return false;
    compare(both, {});
    compare(both, {.exponent = 2});
    return true;
  }

  template<class B>
  static void compare(const B& both, const harmonic_map_options& options) {
    std::vector<std::pair<vert_t<typename B::native_mesh>, double>> here;
    std::vector<std::pair<vert_t<typename B::other_mesh>, double>> there;
    const auto give = [&](const auto v, double x) {
      here.push_back({v, x});
      there.push_back({both.verts.to(v), x});
    };
    const auto parts = connected_components(both.native);
    int next = 0;  // the first vert of each component, and one in five of the others
    for (const auto v : both.verts.all) {
      if (parts[v] == next) give(v, ++next);
      else if (v.raw() % 5 == 4) give(v, -1);
    }
    const auto expected = harmonic_map(both.native, here, options);
    const auto found = harmonic_map(both.other, there, options);
    for (const auto v : both.verts.all) expect_close(expected[v], found[both.verts.to(v)], "the harmonic map");
  }
};

/// The same with the weights of triangles and tets; on other meshes there is nothing to compare.
struct cotangents {
  static constexpr const char* name = "cotangents";
  static constexpr bool needs_simplices = true;
  template<class M> static constexpr bool runs_on = AnyMesh<M> && Embedded<M>;

  template<class B, class In>
  static bool check(const B& both, const In& in) {
    if (!has_cotangents(in, both.other)) return false;
    laplacians::compare(both, weights::cotangent);
    harmonic::compare(both, {.weights = weights::cotangent});
    harmonic::compare(both, {.weights = weights::cotangent, .exponent = 2});
    return true;
  }
};

}  // namespace concino::agreement
