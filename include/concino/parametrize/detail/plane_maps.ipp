// Bodies of plane_maps.hpp: maps of disks to the plane by linear systems, from flat arrays: conformal ones, and what
// all maps share.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/lexicographic.hpp>
#include <concino/parametrize/detail/plane_maps.hpp>
#include <concino/solve/ldlt.hpp>

#include <algorithm>
#include <cmath>

namespace concino::detail {

CONCINO_INLINE plane_unknowns::plane_unknowns(std::size_t num_verts, const fixed_points& fixed) : number(num_verts, 0) {
  for (const auto& [v, x] : fixed) number[v] = -1;
  for (int& n : number)
    if (n == 0) n = count++;
}

CONCINO_INLINE void add_gradient_terms(const flat_disk& f, const poly_triangles& cut, int row, int column,
                                       std::vector<Eigen::Triplet<double>>& entries) {
  for (const plane_triangle& t : cut.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        const double product = t.gradient[i][0] * t.gradient[j][0] + t.gradient[i][1] * t.gradient[j][1];
        entries.emplace_back(row + static_cast<int>(f.corners[t.corner[i]]),
                             column + static_cast<int>(f.corners[t.corner[j]]), t.area * product);
      }
}

CONCINO_INLINE std::pair<std::uint32_t, std::uint32_t> far_pair(const flat_disk& f) {
  const std::uint32_t second = f.loop[farthest_in_loop(f)];
  std::uint32_t first = f.loop[0];
  for (const std::uint32_t v : f.loop) {
    const double x = distance(f.points[first], f.points[second]), y = distance(f.points[v], f.points[second]);
    constexpr double rounding = 1e-12;
    if (y > x * (1 + rounding) ||
        (y >= x * (1 - rounding) && core::is_lexicographically_less(f.points[v], f.points[first])))
      first = v;
  }
  return {first, second};
}

CONCINO_INLINE double area_of_loop(const flat_disk& f, const plane_points& uv) {
  double twice = 0;
  const uv_point& o = uv[f.loop[0]];
  for (std::size_t i = 1; i + 1 < f.loop.size(); ++i) twice += twice_area(o, uv[f.loop[i]], uv[f.loop[i + 1]]);
  return twice / 2;
}

CONCINO_INLINE void place_upright(const flat_disk& f, plane_points& uv) {
  const auto [first, second] = far_pair(f);
  const uv_point o = uv[first], d{uv[second][0] - o[0], uv[second][1] - o[1]};
  const double length = std::hypot(d[0], d[1]);
  const double c = length > 0 ? d[0] / length : 1, s = length > 0 ? d[1] / length : 0;
  for (uv_point& x : uv) {
    const double a = x[0] - o[0], b = x[1] - o[1];
    x = {c * a + s * b, c * b - s * a};
  }
}

CONCINO_INLINE void scale_to_area(const flat_disk& f, const poly_triangles& cut, plane_points& uv) {
  const double area = area_of_loop(f, uv);
  if (!(area > 0)) return;
  const double factor = std::sqrt(cut.area / area);
  for (uv_point& x : uv) x = {factor * x[0], factor * x[1]};
}

CONCINO_INLINE uv_point scaled_point(const uv_point& x, int exponent) {
  return {std::ldexp(x[0], exponent), std::ldexp(x[1], exponent)};
}
CONCINO_INLINE void scale_by(plane_points& uv, int exponent) {
  for (uv_point& x : uv) x = scaled_point(x, exponent);
}

/// Twice the conformal energy of a map: that of the gradients of u and of v, minus the area. Rows of u, then of v.
inline std::vector<Eigen::Triplet<double>> conformal_energy(const flat_disk& f, const poly_triangles& cut) {
  const int n = static_cast<int>(f.points.size());
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(18 * cut.triangles.size() + 4 * f.loop.size());
  add_gradient_terms(f, cut, 0, 0, entries);
  add_gradient_terms(f, cut, n, n, entries);
  for (std::size_t i = 0; i < f.loop.size(); ++i) {
    const int a = static_cast<int>(f.loop[i]), b = static_cast<int>(f.loop[(i + 1) % f.loop.size()]);
    entries.emplace_back(a, n + b, -0.5);
    entries.emplace_back(n + b, a, -0.5);
    entries.emplace_back(b, n + a, 0.5);
    entries.emplace_back(n + a, b, 0.5);
  }
  return entries;
}

CONCINO_INLINE plane_points conformal_map(const flat_disk& f, const poly_triangles& cut,
                                                    const fixed_points& fixed, const char* caller) {
  const bool is_free = fixed.empty();
  fixed_points at = fixed;
  if (is_free) {
    const auto [first, second] = far_pair(f);
    at = {{first, {0, 0}}, {second, {distance(f.points[first], f.points[second]), 0}}};
  }
  if (at.size() == 1)
    core::throw_joined<invalid_argument>({caller, ": one vert is fixed; fix two or more, or none"});
  const int n = static_cast<int>(f.points.size());
  const plane_unknowns unknown(f.points.size(), at);
  plane_points uv(f.points.size());
  for (const auto& [v, x] : at) uv[v] = x;
  if (unknown.count == 0) return uv;
  const auto row_of = [&](int i) {
    const int k = unknown.number[static_cast<std::size_t>(i < n ? i : i - n)];
    return k < 0 ? -1 : i < n ? k : unknown.count + k;
  };
  std::vector<Eigen::Triplet<double>> reduced;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(2 * unknown.count);
  for (const auto& e : conformal_energy(f, cut)) {
    const int row = row_of(e.row()), column = row_of(e.col());
    if (row < 0) continue;
    if (column >= 0) reduced.emplace_back(row, column, e.value());
    else right[row] -= e.value() * uv[static_cast<std::size_t>(e.col() % n)][e.col() < n ? 0 : 1];
  }
  Eigen::SparseMatrix<double> system(2 * unknown.count, 2 * unknown.count);
  system.setFromTriplets(reduced.begin(), reduced.end());
  ldlt solver;
  solver.factorize(system);
  Eigen::VectorXd x = solver.solve(right);
  x += solver.solve(right - system * x);  // once more, for the digits that a large factor has lost
  for (std::size_t v = 0; v < uv.size(); ++v)
    if (const int k = unknown.number[v]; k >= 0) uv[v] = {x[k], x[unknown.count + k]};
  if (is_free) {
    scale_to_area(f, cut, uv);
    place_upright(f, uv);
  }
  return uv;
}

CONCINO_INLINE plane_points smallest_conformal_mode(const flat_disk& f, const poly_triangles& cut,
                                                    const progress& on_progress) {
  const int n = static_cast<int>(f.points.size());
  // Each vert of the boundary has half of the lengths of its edges there as its mass.
  Eigen::VectorXd mass = Eigen::VectorXd::Zero(n);
  for (std::size_t i = 0; i < f.loop.size(); ++i) {
    const std::uint32_t a = f.loop[i], b = f.loop[(i + 1) % f.loop.size()];
    const double half = distance(f.points[a], f.points[b]) / 2;
    mass[static_cast<int>(a)] += half;
    mass[static_cast<int>(b)] += half;
  }
  const double total = mass.sum();
  auto entries = conformal_energy(f, cut);
  constexpr double shift = 1e-6;  // so that translations, whose energy is 0, are not singular
  for (int i = 0; i < n; ++i) {
    if (!(mass[i] > 0)) continue;
    entries.emplace_back(i, i, shift * mass[i] / total);
    entries.emplace_back(n + i, n + i, shift * mass[i] / total);
  }
  Eigen::SparseMatrix<double> system(2 * n, 2 * n);
  system.setFromTriplets(entries.begin(), entries.end());
  ldlt solver;
  solver.factorize(system);
  const plane_points start = conformal_map(f, cut, {}, "spectral_conformal");
  Eigen::VectorXd x(2 * n);
  for (int v = 0; v < n; ++v)
    for (std::size_t k = 0; k < 2; ++k) x[static_cast<int>(k) * n + v] = start[static_cast<std::size_t>(v)][k];
  const auto normalise = [&](Eigen::VectorXd& y) {
    for (int k = 0; k < 2; ++k) y.segment(k * n, n).array() -= y.segment(k * n, n).dot(mass) / total;
    const double size = y.head(n).dot(mass.cwiseProduct(y.head(n))) + y.tail(n).dot(mass.cwiseProduct(y.tail(n)));
    y /= std::sqrt(size / total);
  };
  normalise(x);
  constexpr int max_iterations = 500;
  constexpr double tolerance = 1e-11;
  double change = 1;
  for (int i = 0; i < max_iterations && change > tolerance; ++i) {
    report_progress(on_progress, static_cast<double>(i) / max_iterations, "spectral_conformal");
    Eigen::VectorXd right(2 * n);
    right << mass.cwiseProduct(x.head(n)), mass.cwiseProduct(x.tail(n));
    Eigen::VectorXd next = solver.solve(right / total);
    normalise(next);
    change = (next - x).lpNorm<Eigen::Infinity>();
    x = std::move(next);
  }
  if (change > 1e-6)
    throw solver_error("spectral_conformal: the smallest eigenvalues are too close to the next ones; see lscm");
  plane_points uv(f.points.size());
  for (int v = 0; v < n; ++v) uv[static_cast<std::size_t>(v)] = {x[v], x[n + v]};
  scale_to_area(f, cut, uv);
  place_upright(f, uv);
  return uv;
}

}  // namespace concino::detail
