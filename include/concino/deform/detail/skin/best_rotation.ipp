// Bodies of best_rotation.hpp: the rotation nearest to a matrix.
#pragma once

#include <concino/deform/detail/skin/best_rotation.hpp>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace concino::detail {

/// A number for each of several sums. Loops over them are what compilers make fast.
struct numbers {
  double of[max_rotations];
};
template<class F>
numbers for_each_number(const F& f) {
  numbers r;
  for (std::size_t l = 0; l < max_rotations; ++l) r.of[l] = f(l);
  return r;
}
inline numbers operator+(const numbers& a, const numbers& b) {
  return for_each_number([&](std::size_t l) { return a.of[l] + b.of[l]; });
}
inline numbers operator-(const numbers& a, const numbers& b) {
  return for_each_number([&](std::size_t l) { return a.of[l] - b.of[l]; });
}
inline numbers operator*(const numbers& a, const numbers& b) {
  return for_each_number([&](std::size_t l) { return a.of[l] * b.of[l]; });
}
inline numbers operator*(double a, const numbers& b) {
  return for_each_number([&](std::size_t l) { return a * b.of[l]; });
}

/// The rotation of a quaternion of any length but 0.
CONCINO_INLINE rotation_columns rotation_of_quaternion(double w, double x, double y, double z) {
  const double s = 2 / (w * w + x * x + y * y + z * z);
  return {vec3{1 - s * (y * y + z * z), s * (x * y + w * z), s * (x * z - w * y)},
          vec3{s * (x * y - w * z), 1 - s * (x * x + z * z), s * (y * z + w * x)},
          vec3{s * (x * z + w * y), s * (y * z - w * x), 1 - s * (x * x + y * y)}};
}

/// Entry (row, column) of the adjugate of a symmetric 4 x 4 matrix.
template<class T>
T adjugate_entry(const T (&k)[4][4], int row, int column) {
  const int r0 = row == 0 ? 1 : 0, r1 = row <= 1 ? 2 : 1, r2 = row <= 2 ? 3 : 2;
  const int a0 = column == 0 ? 1 : 0, a1 = column <= 1 ? 2 : 1, a2 = column <= 2 ? 3 : 2;
  const T det = k[r0][a0] * (k[r1][a1] * k[r2][a2] - k[r1][a2] * k[r2][a1]) -
                k[r0][a1] * (k[r1][a0] * k[r2][a2] - k[r1][a2] * k[r2][a0]) +
                k[r0][a2] * (k[r1][a0] * k[r2][a1] - k[r1][a1] * k[r2][a0]);
  return (row + column) % 2 == 0 ? det : -1.0 * det;
}

/// By eigenvectors. Of an eigenspace of several dimensions, the vector nearest to the identity.
CONCINO_INLINE rotation_columns rotation_by_eigenvectors(const double (&k)[4][4]) {
  Eigen::Matrix4d matrix;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) matrix(i, j) = k[i][j];
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(matrix);
  const Eigen::Vector4d& values = solver.eigenvalues();
  const double size = std::max(std::abs(values[0]), std::abs(values[3]));
  Eigen::Vector4d q = Eigen::Vector4d::Zero();
  for (int i = 0; i < 4; ++i)
    if (values[i] >= values[3] - 1e-12 * size) q += solver.eigenvectors()(0, i) * solver.eigenvectors().col(i);
  if (!(q.norm() > 1e-8)) q = solver.eigenvectors().col(3);
  return rotation_of_quaternion(q[0], q[1], q[2], q[3]);
}

/// By the longest column of the adjugate of K - root.
CONCINO_INLINE rotation_columns rotation_by_longest_column(const double (&shifted)[4][4]) {
  double longest = 0, q[4] = {1, 0, 0, 0};
  for (int column = 0; column < 4; ++column) {
    double v[4];
    for (int row = 0; row < 4; ++row) v[row] = adjugate_entry(shifted, row, column);
    const double length = v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + v[3] * v[3];
    if (length > longest) longest = length, std::copy(v, v + 4, q);
  }
  return rotation_of_quaternion(q[0], q[1], q[2], q[3]);
}

/// The symmetric matrices of quaternions q for which q . K q is the sum of R(q) a . b (Horn 1987), for sums of size 1,
/// and the largest roots of their characteristic polynomials.
struct quaternion_problem {
  numbers k[4][4], largest, root, slope;  // slope: at the root, the product of its distances from the others
  bool has_converged[max_rotations];

  quaternion_problem(std::size_t n, const moment_matrix* moments, const double* bounds) {
    numbers s[3][3], bound;
    for (std::size_t l = 0; l < max_rotations; ++l) {
      const moment_matrix& m = moments[std::min(l, n - 1)];
      double size = 0;
      for (const vec3& column : m.of)
        size = std::max({size, std::abs(column.x), std::abs(column.y), std::abs(column.z)});
      largest.of[l] = size;
      const double unit = size > 0 ? 1 / size : 0;
      for (std::size_t i = 0; i < 3; ++i) {
        s[i][0].of[l] = unit * m.of[i].x;
        s[i][1].of[l] = unit * m.of[i].y;
        s[i][2].of[l] = unit * m.of[i].z;
      }
      bound.of[l] = bounds[std::min(l, n - 1)] * unit * (1 + 1e-12);
    }
    k[0][0] = s[0][0] + s[1][1] + s[2][2];
    k[1][1] = s[0][0] - s[1][1] - s[2][2];
    k[2][2] = s[1][1] - s[0][0] - s[2][2];
    k[3][3] = s[2][2] - s[0][0] - s[1][1];
    k[0][1] = k[1][0] = s[1][2] - s[2][1];
    k[0][2] = k[2][0] = s[2][0] - s[0][2];
    k[0][3] = k[3][0] = s[0][1] - s[1][0];
    k[1][2] = k[2][1] = s[0][1] + s[1][0];
    k[1][3] = k[3][1] = s[2][0] + s[0][2];
    k[2][3] = k[3][2] = s[1][2] + s[2][1];
    find_root(s, bound);
  }

 private:
  /// By Newton's method from above on the characteristic polynomial x^4 + b x^2 + c x + d.
  void find_root(const numbers (&s)[3][3], const numbers& bound) {
    numbers squares{};
    for (const auto& column : s)
      for (const numbers& entry : column) squares = squares + entry * entry;
    const numbers b = -2.0 * squares;
    const numbers c =
        -8.0 * (s[0][0] * (s[1][1] * s[2][2] - s[1][2] * s[2][1]) + s[0][1] * (s[1][2] * s[2][0] - s[1][0] * s[2][2]) +
                s[0][2] * (s[1][0] * s[2][1] - s[1][1] * s[2][0]));
    const auto minor = [&](int r0, int r1, int c0, int c1) { return k[r0][c0] * k[r1][c1] - k[r0][c1] * k[r1][c0]; };
    const numbers d = minor(0, 1, 0, 1) * minor(2, 3, 2, 3) - minor(0, 1, 0, 2) * minor(2, 3, 1, 3) +
                      minor(0, 1, 0, 3) * minor(2, 3, 1, 2) + minor(0, 1, 1, 2) * minor(2, 3, 0, 3) -
                      minor(0, 1, 1, 3) * minor(2, 3, 0, 2) + minor(0, 1, 2, 3) * minor(2, 3, 0, 1);
    root = for_each_number([&](std::size_t l) { return std::min(std::sqrt(3 * squares.of[l]), bound.of[l]); });
    slope = root;
    double is_open[max_rotations], is_found[max_rotations] = {};  // 1 or 0: such loops are fast
    std::fill(is_open, is_open + max_rotations, 1.0);
    double num_open = 1;
    for (int step = 0; step < 30 && num_open > 0; ++step) {
      num_open = 0;
      for (std::size_t l = 0; l < max_rotations; ++l) {
        const double x = root.of[l], value = ((x * x + b.of[l]) * x + c.of[l]) * x + d.of[l];
        const double rise = (4 * x * x + 2 * b.of[l]) * x + c.of[l];
        const bool is_simple = rise > 1e-3 * squares.of[l] * x;  // else nearly a double root
        const double change = is_simple ? value / rise : 0;
        const bool is_near = change <= 1e-15 * (x - change);  // from above, a step upwards is rounding
        root.of[l] = is_open[l] > 0 ? x - change : x;
        slope.of[l] = is_open[l] > 0 ? rise : slope.of[l];
        is_found[l] = is_open[l] > 0 && is_simple && is_near ? 1.0 : is_found[l];
        is_open[l] = is_simple && !is_near ? is_open[l] : 0.0;
        num_open += is_open[l];
      }
    }
    for (std::size_t l = 0; l < max_rotations; ++l) has_converged[l] = is_found[l] > 0;
  }
};

CONCINO_INLINE void best_rotations(std::size_t n, const moment_matrix* moments, const double* bounds,
                                   rotation_columns* rotations) {
  if (n == 0) return;
  quaternion_problem all(n, moments, bounds);
  numbers shifted[4][4];
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) shifted[i][j] = i == j ? all.k[i][j] - all.root : all.k[i][j];
  // The eigenvector q: the adjugate of K - root is q q^T times the slope. Its first column is long enough unless the
  // angle is above 120 degrees; then the longest is taken.
  numbers q[4];
  for (int row = 0; row < 4; ++row) q[row] = adjugate_entry(shifted, row, 0);
  for (std::size_t l = 0; l < n; ++l) {
    const auto of_one = [&](const numbers(&from)[4][4], double(&to)[4][4]) {
      for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) to[i][j] = from[i][j].of[l];
    };
    double one[4][4];
    if (!(all.largest.of[l] > 0)) {
      rotations[l] = {vec3{1, 0, 0}, vec3{0, 1, 0}, vec3{0, 0, 1}};
    } else if (!all.has_converged[l]) {
      of_one(all.k, one);
      rotations[l] = rotation_by_eigenvectors(one);
    } else if (!(std::abs(q[0].of[l]) > 0.25 * all.slope.of[l])) {
      of_one(shifted, one);
      rotations[l] = rotation_by_longest_column(one);
    } else {
      rotations[l] = rotation_of_quaternion(q[0].of[l], q[1].of[l], q[2].of[l], q[3].of[l]);
    }
  }
}

CONCINO_INLINE rotation_columns best_rotation(const moment_matrix& moments, double bound) {
  rotation_columns r;
  best_rotations(1, &moments, &bound, &r);
  return r;
}

}  // namespace concino::detail
