// Bodies of best_rotation.hpp: the rotation nearest to a matrix.
#pragma once

#include <concino/deform/detail/skin/best_rotation.hpp>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace concino::detail {

/// The rotation of a quaternion of any length but 0.
CONCINO_INLINE rotation_columns rotation_of_quaternion(double w, double x, double y, double z) {
  const double s = 2 / (w * w + x * x + y * y + z * z);
  return {vec3{1 - s * (y * y + z * z), s * (x * y + w * z), s * (x * z - w * y)},
          vec3{s * (x * y - w * z), 1 - s * (x * x + z * z), s * (y * z + w * x)},
          vec3{s * (x * z + w * y), s * (y * z - w * x), 1 - s * (x * x + y * y)}};
}

/// The symmetric matrix of quaternions q for which q . K q is the sum of R(q) a . b (Horn 1987).
CONCINO_INLINE void quaternion_matrix(const moment_matrix& m, double (&k)[4][4]) {
  const auto s = [&](std::size_t a, std::size_t b) { return m.of[a][b]; };
  k[0][0] = s(0, 0) + s(1, 1) + s(2, 2);
  k[1][1] = s(0, 0) - s(1, 1) - s(2, 2);
  k[2][2] = s(1, 1) - s(0, 0) - s(2, 2);
  k[3][3] = s(2, 2) - s(0, 0) - s(1, 1);
  k[0][1] = k[1][0] = s(1, 2) - s(2, 1);
  k[0][2] = k[2][0] = s(2, 0) - s(0, 2);
  k[0][3] = k[3][0] = s(0, 1) - s(1, 0);
  k[1][2] = k[2][1] = s(0, 1) + s(1, 0);
  k[1][3] = k[3][1] = s(2, 0) + s(0, 2);
  k[2][3] = k[3][2] = s(1, 2) + s(2, 1);
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

CONCINO_INLINE rotation_columns best_rotation(const moment_matrix& input, double bound) {
  double largest = 0;
  for (const vec3& column : input.of)
    largest = std::max({largest, std::abs(column.x), std::abs(column.y), std::abs(column.z)});
  if (!(largest > 0)) return {vec3{1, 0, 0}, vec3{0, 1, 0}, vec3{0, 0, 1}};
  moment_matrix m;
  for (std::size_t i = 0; i < 3; ++i) m.of[i] = input.of[i] / largest;
  double k[4][4];
  quaternion_matrix(m, k);
  // The largest root of the characteristic polynomial x^4 + b x^2 + c x + d, by Newton's method from above.
  const double squares = dot(m.of[0], m.of[0]) + dot(m.of[1], m.of[1]) + dot(m.of[2], m.of[2]);
  const double b = -2 * squares, c = -8 * dot(m.of[0], cross(m.of[1], m.of[2]));
  const auto minor = [&](int r0, int r1, int c0, int c1) { return k[r0][c0] * k[r1][c1] - k[r0][c1] * k[r1][c0]; };
  const double d = minor(0, 1, 0, 1) * minor(2, 3, 2, 3) - minor(0, 1, 0, 2) * minor(2, 3, 1, 3) +
                   minor(0, 1, 0, 3) * minor(2, 3, 1, 2) + minor(0, 1, 1, 2) * minor(2, 3, 0, 3) -
                   minor(0, 1, 1, 3) * minor(2, 3, 0, 2) + minor(0, 1, 2, 3) * minor(2, 3, 0, 1);
  double x = std::min(std::sqrt(3 * squares), bound / largest * (1 + 1e-12));
  bool has_converged = false;
  double slope = 0;  // at the root, the product of its distances from the others
  for (int step = 0; step < 30 && !has_converged; ++step) {
    const double value = ((x * x + b) * x + c) * x + d;
    slope = (4 * x * x + 2 * b) * x + c;
    if (!(slope > 1e-3 * squares * x)) break;  // nearly a double root
    const double change = value / slope;
    x -= change;
    has_converged = change <= 1e-15 * x;  // from above, a step upwards is rounding
  }
  if (!has_converged) return rotation_by_eigenvectors(k);
  // The eigenvector q: the adjugate of K - x is q q^T times the slope. Its first column is long enough unless the angle
  // is above 120 degrees; then the longest is taken.
  for (int i = 0; i < 4; ++i) k[i][i] -= x;
  double longest = 0, q[4] = {1, 0, 0, 0};
  for (int column = 0; column < 4; ++column) {
    const int a0 = column == 0 ? 1 : 0, a1 = column <= 1 ? 2 : 1, a2 = column <= 2 ? 3 : 2;
    double v[4];
    for (int row = 0; row < 4; ++row) {
      const int r0 = row == 0 ? 1 : 0, r1 = row <= 1 ? 2 : 1, r2 = row <= 2 ? 3 : 2;
      const double det = k[r0][a0] * (k[r1][a1] * k[r2][a2] - k[r1][a2] * k[r2][a1]) -
                         k[r0][a1] * (k[r1][a0] * k[r2][a2] - k[r1][a2] * k[r2][a0]) +
                         k[r0][a2] * (k[r1][a0] * k[r2][a1] - k[r1][a1] * k[r2][a0]);
      v[row] = (row + column) % 2 == 0 ? det : -det;
    }
    const double length = v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + v[3] * v[3];
    if (length > longest) longest = length, std::copy(v, v + 4, q);
    if (column == 0 && std::abs(v[0]) > 0.25 * slope) break;
  }
  return rotation_of_quaternion(q[0], q[1], q[2], q[3]);
}

}  // namespace concino::detail
