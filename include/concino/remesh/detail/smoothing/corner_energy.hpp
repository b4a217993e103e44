// The shape energy of the corners at a vert as a function of its point, with a barrier that keeps corners from turning
// inside out.
#pragma once

#include <concino/core/vec3.hpp>
#include <concino/remesh/detail/smoothing/corner_frames.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace concino::detail {

/// A symmetric matrix.
struct symmetric_matrix {
  double xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;
  void add_product(double s, const vec3& a) {
    xx += s * a.x * a.x, yy += s * a.y * a.y, zz += s * a.z * a.z;
    xy += s * a.x * a.y, xz += s * a.x * a.z, yz += s * a.y * a.z;
  }
  void add_identity(double s) { xx += s, yy += s, zz += s; }
  vec3 operator*(const vec3& a) const {
    return {xx * a.x + xy * a.y + xz * a.z, xy * a.x + yy * a.y + yz * a.z, xz * a.x + yz * a.y + zz * a.z};
  }
  /// The solution of (this) x = b by Cholesky's factors; b itself if it is not positive definite.
  vec3 solve(const vec3& b) const {
    const double a = std::sqrt(xx), p = xy / a, q = xz / a, c = std::sqrt(yy - p * p), r = (yz - p * q) / c,
                 d = std::sqrt(zz - q * q - r * r);
    if (!(a > 0 && c > 0 && d > 0)) return b;
    const double u = b.x / a, v = (b.y - p * u) / c, w = (b.z - q * u - r * v) / d;
    const double z = w / d, y = (v - r * z) / c;
    return {(u - p * y - q * z) / a, y, z};
  }
};

/// What is computed at a vert: the sum over its corners of |S|^2 / (d det(S)^(2/d)), 1 for each ideal corner and
/// infinite for flat ones, where the matrix S maps the ideal corner to the corner and d is the dimension. Where corners
/// are inverted, det is replaced by a positive function of it.
struct corner_energy {
  double value = 0;
  double largest = 0;  // 1 / shape of the corners that are not inverted
  unsigned num_inverted = 0;
  vec3 gradient;
  symmetric_matrix hessian;
};

/// The columns of the matrix of a corner, and its determinant; in surfaces the third column is the normal.
template<unsigned D>
struct corner_matrix {
  vec3 s[3];
  corner_matrix(const corner_frame& f, const ideal_corner& ideal, const std::vector<vec3>& points, const vec3& normal,
                unsigned moving, const vec3& x) {
    for (unsigned i = 0; i <= D; ++i) {
      const vec3& y = f.verts[i] == moving ? x : points[f.verts[i]];
      for (unsigned j = 0; j < D; ++j) s[j] += ideal.weights[i][j] * y;
    }
    if constexpr (D == 2) s[2] = normal;  // so that the determinant is a signed area
  }
  double determinant() const { return dot(s[0], cross(s[1], s[2])); }
  double squares() const { return dot(s[0], s[0]) + dot(s[1], s[1]) + (D == 3 ? dot(s[2], s[2]) : 0); }
  /// The mean ratio, if the corner is not inverted.
  double shape() const {
    if constexpr (D == 2) return 2 * norm(cross(s[0], s[1])) / squares();
    const double root = std::cbrt(determinant());
    return 3 * root * root / squares();
  }
};

/// The energy at vert number v if its point is x. normal_of(k): the normal of the corner that k, as in corner_frames,
/// points to. delta: 0, or a positive number if corners may be inverted.
template<unsigned D, class M, class F>
corner_energy energy_at(const corner_frames<M>& all, const std::vector<vec3>& points, const F& normal_of, unsigned v,
                        const vec3& x, double delta, bool has_derivatives) {
  corner_energy e;
  constexpr double power = 2.0 / D;
  for (const unsigned* k = all.begin(v); k != all.end(v); ++k) {
    const corner_frame& f = all.frames[*k];
    const ideal_corner& ideal = all.ideals[f.ideal];
    const corner_matrix<D> c(f, ideal, points, normal_of(k), v, x);
    const double det = c.determinant(), squares = c.squares(), root = std::sqrt(det * det + 4 * delta * delta);
    const double h = delta > 0 ? 0.5 * (det + root) : det;
    if (!(det > 0)) ++e.num_inverted;
    if (!(h > 0)) {
      e.value = std::numeric_limits<double>::infinity();
      return e;
    }
    const double value = squares / (D * (D == 2 ? h : std::cbrt(h * h)));
    e.value += value;
    if (det > 0) e.largest = std::max(e.largest, 1 / c.shape());
    if (!has_derivatives) continue;
    const auto& w = ideal.weights[static_cast<std::size_t>(std::find(f.verts, f.verts + D, v) - f.verts)];
    vec3 of_squares, of_det;
    double weight = 0;
    for (unsigned j = 0; j < D; ++j) {
      of_squares += 2 * w[j] * c.s[j];
      of_det += w[j] * cross(c.s[(j + 1) % 3], c.s[(j + 2) % 3]);
      weight += w[j] * w[j];
    }
    // of h by det
    const double slope = delta > 0 ? h / root : 1, bend = delta > 0 ? 2 * delta * delta / (root * root * root) : 0;
    const vec3 a = of_squares / squares, b = (slope / h) * of_det, g = a - power * b;
    e.gradient += value * g;
    e.hessian.add_product(value, g);
    e.hessian.add_product(-value, a);
    e.hessian.add_product(value * power, b);
    e.hessian.add_product(-value * power * bend / h, of_det);
    e.hessian.add_identity(value * 2 * weight / squares);
  }
  return e;
}

}  // namespace concino::detail
