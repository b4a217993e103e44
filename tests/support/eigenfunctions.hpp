// Checks eigenfunctions on a kind of mesh against known eigenvalues. compute(m, count) computes them, by any method.
#pragma once

#include <concino/generate/sphere.hpp>
#include <concino/operators/mass_matrix.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace concino::testing {

/// The largest relative error of eigenvalues 1 to 4 of the unit square or cube, which are sums of squares times pi^2.
template<class M, class F>
double error_on_square_or_cube(unsigned n, const F& compute) {
  std::vector<double> known;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      for (int k = 0; k < (VolumeMesh<M> ? 4 : 1); ++k) known.push_back((i * i + j * j + k * k) * std::numbers::pi * std::numbers::pi);
  std::sort(known.begin(), known.end());
  const M m = grid<M>(n);
  const auto r = compute(m, 5);
  CHECK(std::abs(r.values[0]) < 1e-9);
  for (const auto v : verts(m)) CHECK(r.functions[0][v] == doctest::Approx(1).epsilon(1e-9));  // over a measure of 1
  double worst = 0;
  for (std::size_t k = 0; k < 5; ++k) {
    if (k > 0) worst = std::max(worst, std::abs(r.values[k] / known[k] - 1));
    CHECK(r.residuals[k] < 1e-7);
  }
  return worst;
}

/// Checks the eigenvalues of a sphere or ball: value l has multiplicity 2 l + 1, for l up to the number of known values.
template<class M, class F>
void check_sphere(const M& m, const std::vector<double>& known, double relative_error, const F& compute) {
  const std::size_t count = (known.size() + 1) * (known.size() + 1);
  const auto r = compute(m, count);
  CHECK(std::abs(r.values[0]) < 1e-9);
  std::size_t k = 1;
  for (std::size_t l = 1; l <= known.size(); ++l)
    for (std::size_t i = 0; i < 2 * l + 1; ++i) CHECK(r.values[k++] == doctest::Approx(known[l - 1]).epsilon(relative_error));
  const auto mass = vert_masses(m);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      double product = 0;
      for (const auto v : verts(m)) product += mass[v] * r.functions[i][v] * r.functions[j][v];
      CHECK(std::abs(product - (i == j)) < 1e-12);
    }
}

/// Checks two grids of n cells along each side and an isolated vert.
template<class M, class F>
void check_components(unsigned n, const F& compute) {
  const M m = two_grids<M>(n);
  const auto r = compute(m, 4);
  CHECK(r.isolated == 1);
  CHECK(std::abs(r.values[0]) < 1e-9);
  CHECK(std::abs(r.values[1]) < 1e-9);
  CHECK(r.values[2] > 5);
  for (std::size_t k = 0; k < 2; ++k)
    for (const auto v : verts(m))
      for (const auto w : adj_v2v(m, v)) CHECK(r.functions[k][v] == doctest::Approx(r.functions[k][w]).epsilon(1e-7));
  CHECK(r.functions[2][vert_id{static_cast<unsigned>(num_verts(m) - 1)}] == 0);
}

/// Checks that scaling the mesh scales eigenvalues to the last bit, and functions too if the factor of the measure has an exact square root.
template<class M, class F>
void check_scaling(unsigned n, const F& compute) {
  const auto arrays = jittered(grid_arrays<M>(n), 0.06 / n, VolumeMesh<M>);
  const M m(arrays);
  const auto r = compute(m, 4);
  for (const int power : {20, -20, 21}) {
    auto scaled = arrays;
    for (vec3& x : scaled.points) x *= std::ldexp(1.0, power);
    const M other(scaled);
    const auto s = compute(other, 4);
    for (std::size_t k = 0; k < 4; ++k) {
      CHECK(s.values[k] == std::ldexp(r.values[k], -2 * power));
      CHECK(s.residuals[k] == std::ldexp(r.residuals[k], -2 * power));
      if (power * dimension_v<M> % 2 == 0)
        for (const auto v : verts(m)) CHECK(s.functions[k][v] == std::ldexp(r.functions[k][v], -power * dimension_v<M> / 2));
    }
  }
}

}  // namespace concino::testing
