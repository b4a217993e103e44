// The density of the symmetric Dirichlet energy of a map of the plane, with its derivatives.
#pragma once

#include <concino/parametrize/detail/poly_triangles.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace concino::detail {

/// The density of the symmetric Dirichlet energy, |J|^2 + |J^-1|^2, with its derivatives by the entries of J, which are
/// ordered xx, xy, yx, yy. Negative eigenvalues of the second derivative are replaced.
struct dirichlet_density {
  std::array<double, 4> first{};
  std::array<std::array<double, 4>, 4> second{};

  explicit dirichlet_density(const plane_matrix& j) {
    // J = U diag(p, q) V^T with rotations U and V; p, q > 0
    const double e = (j.xx + j.yy) / 2, h = (j.yx - j.xy) / 2, k = (j.xx - j.yy) / 2, g = (j.yx + j.xy) / 2;
    const double same = std::hypot(e, h), mirrored = std::hypot(k, g), p = same + mirrored;
    const double q = j.determinant() / p;  // more accurate than the difference
    const double sum = std::atan2(g, k), difference = std::atan2(h, e);
    const double b = (sum + difference) / 2, c = (sum - difference) / 2;
    const double u[2] = {std::cos(b), std::sin(b)}, v[2] = {std::cos(c), std::sin(c)};
    const auto outer = [&](double pp, double pq, double qp, double qq) {  // U (pp pq; qp qq) V^T
      const double u1[2] = {u[0], u[1]}, u2[2] = {-u[1], u[0]}, v1[2] = {v[0], v[1]}, v2[2] = {-v[1], v[0]};
      std::array<double, 4> m{};
      for (std::size_t r = 0; r < 2; ++r)
        for (std::size_t s = 0; s < 2; ++s)
          m[2 * r + s] = pp * u1[r] * v1[s] + pq * u1[r] * v2[s] + qp * u2[r] * v1[s] + qq * u2[r] * v2[s];
      return m;
    };
    const double p3 = 1 / (p * p * p), q3 = 1 / (q * q * q), half = std::sqrt(0.5);
    first = outer(2 * (p - p3), 0, 0, 2 * (q - q3));
    const double turn = 2 * (1 - (p3 + q3) / (p + q)), mirror = 2 * (1 + (p * p + p * q + q * q) * p3 * q3);
    constexpr double smallest = 1e-8;  // turns of an isometry cost nothing, and are to be unique
    add(outer(1, 0, 0, 0), 2 * (1 + 3 * p3 / p));
    add(outer(0, 0, 0, 1), 2 * (1 + 3 * q3 / q));
    add(outer(0, -half, half, 0), std::max(turn, smallest));
    add(outer(0, half, half, 0), mirror);
  }

 private:
  void add(const std::array<double, 4>& direction, double value) {
    for (std::size_t r = 0; r < 4; ++r)
      for (std::size_t s = 0; s < 4; ++s) second[r][s] += value * direction[r] * direction[s];
  }
};

}  // namespace concino::detail
