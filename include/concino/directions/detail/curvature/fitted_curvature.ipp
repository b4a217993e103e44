// Bodies of fitted_curvature.hpp: a quadratic polynomial by least squares, and its curvatures.
#pragma once

#include <concino/directions/detail/curvature/fitted_curvature.hpp>
#include <concino/directions/detail/frames/octahedral.hpp>

#include <Eigen/Core>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace concino::detail {

CONCINO_INLINE principal_curvature fit_curvature(std::span<const vec3> points, const vec3& normal) {
  const orthonormal_frame f = some_frame(normal);
  double radius = 0;
  for (const vec3& p : points) radius = std::max(radius, norm(p));
  if (!(radius > 0)) return {0, 0, f[1], f[2]};
  Eigen::MatrixXd a(static_cast<Eigen::Index>(points.size()), 5);
  Eigen::VectorXd z(static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const vec3 p = points[i] / radius;
    const double x = dot(p, f[1]), y = dot(p, f[2]);
    const auto row = static_cast<Eigen::Index>(i);
    // the mixed term is scaled so that the smallest coefficients are the smallest matrix H in any basis
    a(row, 0) = x, a(row, 1) = y, a(row, 2) = x * x / 2, a(row, 3) = x * y / std::sqrt(2.0), a(row, 4) = y * y / 2;
    z(row) = dot(p, f[0]);
  }
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> fit;
  fit.setThreshold(1e-8);
  fit.compute(a);
  const Eigen::VectorXd c = fit.solve(z);

  // The shape operator in an orthonormal basis of the tangent plane: -W H W / w, where W = (1 + g g^T)^(-1/2).
  const double gx = c(0), gy = c(1), gg = gx * gx + gy * gy, w = std::sqrt(1 + gg);
  const double t = -1 / (w * (1 + w));  // W = 1 + t g g^T
  const Eigen::Matrix2d root{{1 + t * gx * gx, t * gx * gy}, {t * gx * gy, 1 + t * gy * gy}};
  const double mixed = c(3) / std::sqrt(2.0);
  const Eigen::Matrix2d h{{c(2), mixed}, {mixed, c(4)}};
  const Eigen::Matrix2d s = root * h * root / -(w * radius);
  const double mean = (s(0, 0) + s(1, 1)) / 2, half = (s(0, 0) - s(1, 1)) / 2, deviation = std::hypot(half, s(0, 1));
  const double angle = std::atan2(s(0, 1), half) / 2;
  const auto direction = [&](double x, double y) {  // of the surface, from one of that basis
    const double u = root(0, 0) * x + root(0, 1) * y, v = root(1, 0) * x + root(1, 1) * y;
    return u * f[1] + v * f[2] + (gx * u + gy * v) * f[0];
  };
  const double cosine = std::cos(angle), sine = std::sin(angle);
  return {mean + deviation, mean - deviation, direction(cosine, sine), direction(-sine, cosine)};
}

}  // namespace concino::detail
