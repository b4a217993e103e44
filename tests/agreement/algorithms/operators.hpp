// Compares laplacian and harmonic_map, uniform and with cotangents; gradient and divergence.
#pragma once

#include <agreement/matched.hpp>

#include <concino/fields/harmonic_map.hpp>
#include <concino/graph/components.hpp>
#include <concino/operators/divergence.hpp>
#include <concino/operators/divergence_matrix.hpp>
#include <concino/operators/gradient.hpp>
#include <concino/operators/gradient_matrix.hpp>
#include <concino/operators/laplacian.hpp>
#include <concino/operators/vert_gradient_matrix.hpp>

namespace concino::agreement {

/// Whether all polys are triangles or tets.
template<class In, class M>
bool has_cotangents(const In& in, const M& m) {
  if constexpr (EmbeddedMesh<M>) {
    for (const auto p : polys(m)) {
      int n = 0;
      for ([[maybe_unused]] const auto v : adj_p2v(m, p)) ++n;
      if (n != dimension_v<M> + 1) return false;
    }
    return in.manifold && num_polys(m) > 0;
  }
  return false;
}

/// Checks that each entry of one matrix equals that of the other, to 1e-12 of the largest; row(i) and column(i) are the positions of i there.
template<class Row, class Column>
void expect_same_matrix(const Eigen::SparseMatrix<double>& expected, const Eigen::SparseMatrix<double>& found, const Row& row, const Column& column,
                        const char* what) {
  expect(expected.nonZeros() == found.nonZeros(), "as many entries");
  double largest = 0;
  for (Eigen::Index k = 0; k < expected.nonZeros(); ++k) largest = std::max(largest, std::abs(expected.valuePtr()[k]));
  for (int c = 0; c < expected.outerSize(); ++c)
    for (Eigen::SparseMatrix<double>::InnerIterator it(expected, c); it; ++it)
      expect_close(it.value(), found.coeff(row(it.row()), column(it.col())), largest, what);
}

struct laplacians {
  static constexpr const char* name = "laplacian";
  template<class M> static constexpr bool runs_on = PrimalGraph<M>;

  template<class B, class In>
  static bool check(const B& both, const In&) {
    compare(both, uniform);
    return true;
  }

  template<class B, class D>
  static void compare(const B& both, const D& which) {
    const auto expected = laplacian(both.native, which);
    const auto found = laplacian(both.other, which);
    expect(std::size_t(found.rows()) == vert_index_bound(both.other), "as many rows");
    const auto row = [&](Eigen::Index i) {
      return static_cast<Eigen::Index>(index_of(both.other, both.verts.to(vert_t<typename B::native_mesh>{i})));
    };
    expect_same_matrix(expected, found, row, row, "an entry of the Laplacian");
  }
};

struct harmonic {
  static constexpr const char* name = "harmonic_map";
  template<class M> static constexpr bool runs_on = PrimalGraph<M>;

  template<class B, class In>
  static bool check(const B& both, const In&) {
    if (both.verts.empty()) return false;
    compare(both, uniform);
    compare(both, uniform, {.exponent = 2});
    return true;
  }

  template<class B, class D>
  static void compare(const B& both, const D& which, const harmonic_map_options& options = {}) {
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
    const auto expected = harmonic_map(both.native, here, which, options);
    const auto found = harmonic_map(both.other, there, which, options);
    const double largest = largest_of(both.verts.all, [&](const auto v) { return expected[v]; });
    for (const auto v : both.verts.all) expect_close(expected[v], found[both.verts.to(v)], largest, "the harmonic map");
  }
};

/// The same with the weights of triangles and tets; on other meshes there is nothing to compare.
struct cotangents {
  static constexpr const char* name = "cotangents";
  static constexpr bool needs_a_shape = true;
  template<class M> static constexpr bool runs_on = EmbeddedMesh<M>;

  template<class B, class In>
  static bool check(const B& both, const In& in) {
    if constexpr (Discretisation<cotangent_t, typename B::other_mesh>) {
      if (!has_cotangents(in, both.other)) return false;
      laplacians::compare(both, cotangent);
      harmonic::compare(both, cotangent);
      harmonic::compare(both, cotangent, {.exponent = 2});
      return true;
    }
    return false;
  }
};

/// The row or column of values at verts, and of three numbers at verts or polys, in a matrix of the other mesh.
template<class B>
auto vert_place(const B& both) {
  return [&both](Eigen::Index i) { return static_cast<Eigen::Index>(index_of(both.other, both.verts.to(vert_t<typename B::native_mesh>{i}))); };
}
template<class B>
auto poly_place(const B& both) {
  return [&both](Eigen::Index i) { return static_cast<Eigen::Index>(index_of(both.other, both.polys.to(poly_t<typename B::native_mesh>{i}))); };
}
template<class Place>
auto three_of(const Place& place) {
  return [place](Eigen::Index i) { return 3 * place(i / 3) + i % 3; };
}

/// A function on the verts of both meshes, of the number of the native vert.
template<class B, class M, class Number>
auto waves(const B& both, const M& m, const Number& number) {
  auto u = make_vert_map<double>(m, 0.0);
  for (const auto v : both.verts.all) u[number(v)] = std::sin(1.0 + v.raw());
  return u;
}

struct gradients {
  static constexpr const char* name = "gradient";
  template<class M> static constexpr bool runs_on = EmbeddedMesh<M>;

  template<class B, class In>
  static bool check(const B& both, const In&) {
    const auto vert = vert_place(both);
    expect_same_matrix(gradient_matrix(both.native), gradient_matrix(both.other), three_of(poly_place(both)), vert, "an entry of the gradient");
    expect_same_matrix(vert_gradient_matrix(both.native), vert_gradient_matrix(both.other), three_of(vert), vert, "an entry of those at verts");
    const auto here = waves(both, both.native, [](const auto v) { return v; });
    const auto there = waves(both, both.other, [&](const auto v) { return both.verts.to(v); });
    const auto expected = gradient(both.native, here);
    const auto found = gradient(both.other, there);
    const double largest = largest_of(both.polys.all, [&](const auto p) { return norm(expected[p]); });
    for (const auto p : both.polys.all) expect_same_vector(expected[p], found[both.polys.to(p)], largest);
    const auto expected_at = vert_gradient(both.native, here);
    const auto found_at = vert_gradient(both.other, there);
    const double largest_at = largest_of(both.verts.all, [&](const auto v) { return norm(expected_at[v]); });
    for (const auto v : both.verts.all) expect_same_vector(expected_at[v], found_at[both.verts.to(v)], largest_at);
    return true;
  }

  static void expect_same_vector(const vec3& a, const vec3& b, double largest) {
    for (std::size_t k = 0; k < 3; ++k) expect_close(a[k], b[k], largest, "the gradient of a function");
  }
};

struct divergences {
  static constexpr const char* name = "divergence";
  template<class M> static constexpr bool runs_on = EmbeddedMesh<M>;

  template<class B, class In>
  static bool check(const B& both, const In&) {
    expect_same_matrix(divergence_matrix(both.native), divergence_matrix(both.other), vert_place(both), three_of(poly_place(both)),
                       "an entry of the divergence");
    auto here = make_poly_map<vec3>(both.native);
    auto there = make_poly_map<vec3>(both.other);
    for (const auto p : both.polys.all) here[p] = there[both.polys.to(p)] = {std::sin(1.0 + p.raw()), std::cos(2.0 * p.raw()), 1};
    const auto expected = divergence(both.native, here);
    const auto found = divergence(both.other, there);
    const double largest = largest_of(both.verts.all, [&](const auto v) { return expected[v]; });
    for (const auto v : both.verts.all) expect_close(expected[v], found[both.verts.to(v)], largest, "the divergence of a field");
    return true;
  }
};

}  // namespace concino::agreement
