// Helpers for tests of differential operators: functions sampled at verts, interior verts, scales for rounding errors.
#pragma once

#include <concino/geometry/measure.hpp>

#include <doctest/doctest.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace concino::testing {

/// Checks that a compressed matrix is valid: sorted columns, no duplicate rows, rows in range, finite entries.
inline void check_compressed(const Eigen::SparseMatrix<double>& a) {
  CHECK(a.isCompressed());
  for (Eigen::Index c = 0; c < a.cols(); ++c) {
    Eigen::Index last = -1;
    for (Eigen::SparseMatrix<double>::InnerIterator it(a, c); it; ++it) {
      REQUIRE(it.row() > last);
      REQUIRE(std::isfinite(it.value()));
      last = it.row();
    }
    REQUIRE(last < a.rows());
  }
}

/// Whether two matrices have the same entries at the same positions, to the last bit.
inline bool same_entries(const Eigen::SparseMatrix<double>& a, const Eigen::SparseMatrix<double>& b, double factor = 1) {
  if (a.rows() != b.rows() || a.cols() != b.cols() || a.nonZeros() != b.nonZeros()) return false;
  if (!std::equal(a.outerIndexPtr(), a.outerIndexPtr() + a.cols() + 1, b.outerIndexPtr())) return false;
  for (Eigen::Index k = 0; k < a.nonZeros(); ++k)
    if (a.innerIndexPtr()[k] != b.innerIndexPtr()[k] || a.valuePtr()[k] != factor * b.valuePtr()[k]) return false;
  return true;
}
/// The largest difference of two entries, as a multiple of the largest entry.
inline double difference(const Eigen::SparseMatrix<double>& a, const Eigen::SparseMatrix<double>& b) {
  const auto largest = [](const Eigen::SparseMatrix<double>& x) {
    double r = 0;
    for (Eigen::Index c = 0; c < x.cols(); ++c)
      for (Eigen::SparseMatrix<double>::InnerIterator it(x, c); it; ++it) r = std::max(r, std::abs(it.value()));
    return r;
  };
  const double size = largest(b);
  return largest(a - b) / (size > 0 ? size : 1);
}

/// The vector of f(point of v) at index_of(v); 0 elsewhere.
template<class M, class F>
Eigen::VectorXd at_verts(const M& m, F&& f) {
  Eigen::VectorXd u = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(vert_index_bound(m)));
  for (const auto v : verts(m)) u[static_cast<Eigen::Index>(index_of(m, v))] = f(to_vec3(point(m, v)));
  return u;
}
/// The vector in rows 3i, 3i + 1 and 3i + 2.
inline vec3 vector_at(const Eigen::VectorXd& x, std::size_t i) {
  const auto k = static_cast<Eigen::Index>(3 * i);
  return {x[k], x[k + 1], x[k + 2]};
}

/// By index_of: whether a vert belongs to polys, and each facet at it has exactly two polys.
template<class M>
std::vector<bool> interior_verts(const M& m) {
  std::vector<bool> inside(vert_index_bound(m), false);
  for (const auto p : polys(m))
    for (const auto v : adj_p2v(m, p)) inside[index_of(m, v)] = true;
  const auto look_at = [&](const auto& sides, const auto& corners) {
    int n = 0;
    for ([[maybe_unused]] const auto p : sides) ++n;
    if (n != 2)
      for (const auto v : corners) inside[index_of(m, v)] = false;
  };
  if constexpr (SurfaceMesh<M>) {
    for (const auto e : edges(m)) look_at(adj_e2p(m, e), adj_e2v(m, e));
  } else {
    for (const auto f : faces(m)) look_at(adj_f2p(m, f), adj_f2v(m, f));
  }
  return inside;
}

/// The centre of the bounding box and the length of its diagonal.
template<class M>
std::pair<vec3, double> centre_and_diagonal(const M& m) {
  vec3 low{HUGE_VAL, HUGE_VAL, HUGE_VAL}, high = -low;
  for (const auto v : verts(m))
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], static_cast<double>(point(m, v)[k]));
      high[k] = std::max(high[k], static_cast<double>(point(m, v)[k]));
    }
  return {0.5 * (low + high), norm(high - low)};
}
/// Area over longest edge, or volume over largest face: at most the height of a triangle or tet.
template<class M>
double height(const M& m, const poly_t<M>& p) {
  double largest = 0;
  if constexpr (SurfaceMesh<M>) {
    for (const auto e : adj_p2e(m, p)) {
      std::vector<vec3> x;
      for (const auto v : adj_e2v(m, e)) x.push_back(to_vec3(point(m, v)));
      largest = std::max(largest, distance(x[0], x[1]));
    }
  } else {
    for (const auto f : adj_p2f(m, p)) largest = std::max(largest, area(m, f));
  }
  return std::abs(measure(m, p)) / largest;
}

/// The error of a gradient matrix on linear functions and constants: that of the worst poly, as a multiple of 1e-14 x diagonal / height. On surfaces
/// the expected gradient has no component along the vector area.
template<class M>
double linear_error(const M& m, const Eigen::SparseMatrix<double>& g) {
  const auto [centre, diagonal] = centre_and_diagonal(m);
  const Eigen::VectorXd one = g * Eigen::VectorXd::Ones(g.cols());
  double worst = 0;
  for (const vec3 a : {vec3{0.6, -0.64, 0.48}, vec3{0, 0, 1}}) {
    const Eigen::VectorXd gu = g * at_verts(m, [&, c = centre](const vec3& x) { return dot(a, x - c); });
    for (const auto p : polys(m)) {
      vec3 expected = a;
      if constexpr (SurfaceMesh<M>) {
        const vec3 n = area_vector(m, p) / area(m, p);
        expected -= dot(a, n) * n;
      }
      const double tolerance = 1e-14 * diagonal / height(m, p);
      const double error = distance(vector_at(gu, index_of(m, p)), expected) + diagonal * norm(vector_at(one, index_of(m, p)));
      if (std::isnan(error)) return error;
      worst = std::max(worst, error / tolerance);
    }
  }
  return worst;
}
/// The largest divergence of a constant field at an interior vert, as a multiple of diagonal^(dimension - 1). Surfaces lie in a plane z = const.
template<class M>
double constant_divergence(const M& m, const Eigen::SparseMatrix<double>& d) {
  Eigen::VectorXd x(d.cols());
  for (Eigen::Index i = 0; i < x.size(); ++i) x[i] = i % 3 == 0 ? 0.6 : i % 3 == 1 ? -0.64 : VolumeMesh<M> ? 0.48 : 0;
  const Eigen::VectorXd div = d * x;
  const auto inside = interior_verts(m);
  double worst = 0;
  for (const auto v : verts(m))
    if (inside[index_of(m, v)]) worst = std::max(worst, std::abs(div[static_cast<Eigen::Index>(index_of(m, v))]));
  return worst / std::pow(centre_and_diagonal(m).second, dimension_v<M> - 1);
}

/// Rotates points about an axis that is not an axis of symmetry; the same for maps of vectors.
inline vec3 turned(const vec3& x) {
  const double a = 0.7, b = 1.1;
  const vec3 y{std::cos(a) * x.x - std::sin(a) * x.y, std::sin(a) * x.x + std::cos(a) * x.y, x.z};
  return {y.x, std::cos(b) * y.y - std::sin(b) * y.z, std::sin(b) * y.y + std::cos(b) * y.z};
}
template<class Arrays>
Arrays turned_arrays(Arrays a) {
  for (vec3& x : a.points) x = turned(x);
  return a;
}
template<class Arrays>
Arrays scaled_arrays(Arrays a, double factor) {
  for (vec3& x : a.points) x *= factor;
  return a;
}

/// Maps the unit cube smoothly so that planes z = const stay planes: hexes become frustums with planar faces.
template<class Arrays>
Arrays as_frustum(Arrays a) {
  for (vec3& x : a.points) x = {(x.x - 0.4) * (2 - x.z), (x.y - 0.3) * (2 - x.z), x.z};
  return a;
}

}  // namespace concino::testing
