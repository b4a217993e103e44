// Virtual elements of one poly, from positions and gradients of its verts; see virtual_elements.hpp.
#pragma once

#include <concino/operators/detail/virtual_elements.hpp>

#include <cmath>
#include <cstddef>
#include <vector>

namespace concino::detail {

CONCINO_INLINE void thin_poly_coordinates::find(const std::vector<vec3>& points, const vec3& normal,
                                                std::size_t dimension) {
  const auto longest = [&](auto&& part) {
    vec3 best;
    for (const vec3& y : points)
      if (const vec3 x = part(y); dot(x, x) > dot(best, best)) best = x;
    return best / norm(best);
  };
  const auto without = [](const vec3& x, const vec3& a) { return x - dot(a, x) * a; };
  axis[0] = longest([&](const vec3& y) { return without(y, normal); });
  if (dimension == 2) {
    axis[1] = cross(normal, axis[0]);
  } else {
    axis[1] = longest([&](const vec3& y) { return without(without(y, axis[0]), axis[0]); });
    axis[2] = cross(axis[0], axis[1]);
  }
  q.assign(points.size(), vec3{});
  is_regular = true;
  const double n = static_cast<double>(points.size());
  for (std::size_t k = 0; k < dimension; ++k) {
    for (std::size_t i = 0; i < q.size(); ++i) q[i][k] = dot(axis[k], points[i]);
    for (auto& row : r) row[k] = 0;
    for (int round = 0; round < 2; ++round) {  // Gram-Schmidt orthogonalisation, twice for accuracy
      double mean = 0;
      for (const vec3& x : q) mean += x[k] / n;
      for (vec3& x : q) x[k] -= mean;
      for (std::size_t l = 0; l < k; ++l) {
        double along = 0;
        for (const vec3& x : q) along += x[l] * x[k];
        for (vec3& x : q) x[k] -= along * x[l];
        r[l][k] += along;
      }
    }
    double squares = 0;
    for (const vec3& x : q) squares += x[k] * x[k];
    r[k][k] = std::sqrt(squares);
    is_regular &= r[k][k] > 0 && std::isfinite(r[k][k]);
    for (vec3& x : q) x[k] /= r[k][k];
  }
}

CONCINO_INLINE vec3 thin_poly_coordinates::solve(vec3 a, std::size_t dimension) const {
  for (std::size_t k = dimension; k-- > 0;) {
    for (std::size_t l = k + 1; l < dimension; ++l) a[k] -= r[k][l] * a[l];
    a[k] /= r[k][k];
  }
  return a;
}

/// entry(i, j) = g_i . form g_j + factor (delta_ij - 1/n - y_i . g_j - y_j . g_i), where `form` already includes factor
/// times the sum of y y^T. The term with `factor` is the sum of the squares of u - P u.
CONCINO_INLINE void fill_projected(const corner_gradient_arrays& poly, const symmetric3& form, double factor,
                                   double constant, std::vector<vec3>& image, std::vector<double>& entries) {
  const std::size_t n = poly.points.size();
  entries.resize(n * (n + 1) / 2);
  image.resize(n);
  for (std::size_t i = 0; i < n; ++i) image[i] = form * poly.gradient[i];
  constant -= factor / static_cast<double>(n);
  double* row = entries.data();
  for (std::size_t i = 0; i < n; row += ++i) {
    for (std::size_t j = 0; j <= i; ++j)
      row[j] = dot(image[i], poly.gradient[j]) -
               factor * (dot(poly.points[i], poly.gradient[j]) + dot(poly.points[j], poly.gradient[i])) + constant;
    row[i] += factor;
  }
}

/// The stiffness of thin polys, where y . g is a difference of much larger numbers. Let y = Q R and h_i = R (g_i - R^-1
/// q_i), minus the constant and linear parts of h, which are rounding errors. Then the sum of squares of u - P u is the
/// sum of squares of u - Q Q^T u - mean plus that of the sum of u_i h_i. As a sum of squares term by term, it is not
/// negative.
template<std::size_t Dimension>
bool stiffness_of_poly<Dimension>::fill_thin(const corner_gradient_arrays& poly, double size,
                                             std::vector<double>& entries) {
  constexpr std::size_t d = Dimension;
  const std::size_t n = poly.points.size();
  thin_.find(poly.points, d == 2 ? poly.normal / norm(poly.normal) : vec3{}, d);
  if (!thin_.is_regular) return false;
  gradient_.resize(n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < 3; ++k) gradient_[i][k] = k < d ? dot(thin_.axis[k], poly.gradient[i]) : 0.0;
  for (int round = 0; round < 2; ++round) {
    vec3 mean, seen[3];
    for (std::size_t i = 0; i < n; ++i) {
      mean += gradient_[i] / static_cast<double>(n);
      for (std::size_t k = 0; k < d; ++k) seen[k] += thin_.q[i][k] * gradient_[i];
    }
    for (std::size_t i = 0; i < n; ++i) {
      gradient_[i] -= mean;
      for (std::size_t k = 0; k < d; ++k) gradient_[i] -= thin_.q[i][k] * seen[k];
    }
  }
  unseen_.assign(n, vec3{});
  double squares = 0, least = 0;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < d; ++k)
      for (std::size_t l = k; l < d; ++l) unseen_[i][k] += thin_.r[k][l] * gradient_[i][l];
    const vec3 linear = thin_.solve(thin_.q[i], d);
    gradient_[i] += linear;
    squares += dot(gradient_[i], gradient_[i]);
    least += dot(linear, linear);
  }
  const double factor = size * (d == 2 ? squares : least) * stabilisation_factor(static_cast<double>(n)),
               constant = factor / static_cast<double>(n);
  entries.resize(n * (n + 1) / 2);
  double* row = entries.data();
  for (std::size_t i = 0; i < n; row += ++i) {
    for (std::size_t j = 0; j <= i; ++j)
      row[j] = size * dot(gradient_[i], gradient_[j]) +
               factor * (dot(unseen_[i], unseen_[j]) - dot(thin_.q[i], thin_.q[j])) - constant;
    row[i] += factor;
  }
  return true;
}

template<std::size_t Dimension>
void stiffness_of_poly<Dimension>::fill(const corner_gradient_arrays& poly, std::vector<double>& entries) {
  constexpr double thin = 0x1p16;  // squared ratio of length to thickness: some hundreds, squared
  const double size = std::abs(poly.measure);
  double factor = 0;
  symmetric3 form{size, 0, 0, size, 0, size};
  if (poly.points.size() != Dimension + 1) {  // not a simplex
    const auto n = static_cast<double>(poly.points.size());
    double squares = 0;
    for (const vec3& g : poly.gradient) squares += dot(g, g);
    symmetric3 scatter;
    for (const vec3& y : poly.points) scatter.add(1, y);
    if (squares * scatter.trace() > thin && fill_thin(poly, size, entries)) return;
    if constexpr (Dimension == 3) {  // in polygons the scatter along the normal is 0
      const double least = scatter.trace_of_inverse();
      if (least > 0 && least < squares) squares = least;  // in nearly flat polys this difference is only rounding
    }
    factor = size * squares * stabilisation_factor(n);
    form.add(factor, scatter);
  }
  fill_projected(poly, form, factor, 0, image_, entries);
}

#ifdef CONCINO_COMPILED
template class stiffness_of_poly<2>;
template class stiffness_of_poly<3>;
#endif

}  // namespace concino::detail
