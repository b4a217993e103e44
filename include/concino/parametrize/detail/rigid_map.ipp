// Bodies of rigid_map.hpp: maps of disks to the plane that are as rigid as possible, from flat arrays.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/number_text.hpp>
#include <concino/parametrize/detail/rigid_map.hpp>
#include <concino/solve/ldlt.hpp>

#include <algorithm>
#include <cmath>

namespace concino::detail {

CONCINO_INLINE void check_limits(const iteration_limits& limits, const char* caller) {
  if (limits.max_iterations < 0)
    core::throw_joined<invalid_argument>(
        {caller, ": max_iterations is ", limits.max_iterations, "; it must be 0 or more"});
  if (!(limits.tolerance >= 0 && limits.tolerance <= 1))
    core::throw_joined<invalid_argument>(
        {caller, ": tolerance is ", core::number_text(limits.tolerance), "; it must be from 0 to 1"});
}

/// The cosine and sine of the rotation of each triangle that is nearest to the derivative of the map.
class nearest_rotations {
  const flat_disk& f_;
  const poly_triangles& cut_;

 public:
  std::vector<uv_point> values;
  double energy = 0;

  nearest_rotations(const flat_disk& f, const poly_triangles& cut) : f_(f), cut_(cut), values(cut.triangles.size()) {}

  void fit(const plane_points& uv) {
    energy = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const plane_triangle& t = cut_.triangles[i];
      const auto at = [&](std::size_t k) { return uv[f_.corners[t.corner[k]]]; };
      const plane_matrix j = t.derivative(at(0), at(1), at(2));
      const double x = j.xx + j.yy, y = j.yx - j.xy, size = std::hypot(x, y);
      values[i] = size > 0 ? uv_point{x / size, y / size} : uv_point{1, 0};
      const auto& [c, s] = values[i];
      const double a = j.xx - c, b = j.xy + s, d = j.yx - s, e = j.yy - c;
      energy += t.area * (a * a + b * b + d * d + e * e);
    }
    energy /= cut_.area;
  }
};

/// The second step: the verts that fit rotated triangles best.
class triangle_fit {
  const flat_disk& f_;
  const poly_triangles& cut_;
  plane_unknowns unknown_;
  Eigen::MatrixXd of_fixed_;  // what fixed verts add to the right-hand side
  ldlt solver_;

 public:
  triangle_fit(const flat_disk& f, const poly_triangles& cut, const fixed_points& fixed)
      : f_(f), cut_(cut), unknown_(f.points.size(), fixed), of_fixed_(Eigen::MatrixXd::Zero(unknown_.count, 2)) {
    if (unknown_.count == 0) return;
    plane_points at(f.points.size());
    for (const auto& [v, x] : fixed) at[v] = x;
    std::vector<Eigen::Triplet<double>> entries, reduced;
    add_gradient_terms(f, cut, 0, 0, entries);
    for (const auto& e : entries) {
      const int row = unknown_.number[static_cast<std::size_t>(e.row())];
      const int column = unknown_.number[static_cast<std::size_t>(e.col())];
      if (row < 0) continue;
      if (column >= 0) reduced.emplace_back(row, column, e.value());
      else
        for (std::size_t k = 0; k < 2; ++k)
          of_fixed_(row, static_cast<Eigen::Index>(k)) -= e.value() * at[static_cast<std::size_t>(e.col())][k];
    }
    Eigen::SparseMatrix<double> system(unknown_.count, unknown_.count);
    system.setFromTriplets(reduced.begin(), reduced.end());
    solver_.factorize(system);
  }

  bool has_unknowns() const { return unknown_.count > 0; }

  void fit(const nearest_rotations& rotations, plane_points& uv) const {
    Eigen::MatrixXd right = of_fixed_;
    for (std::size_t i = 0; i < cut_.triangles.size(); ++i) {
      const plane_triangle& t = cut_.triangles[i];
      const auto& [c, s] = rotations.values[i];
      for (std::size_t k = 0; k < 3; ++k) {
        const int row = unknown_.number[f_.corners[t.corner[k]]];
        if (row < 0) continue;
        const auto& g = t.gradient[k];
        right(row, 0) += t.area * (c * g[0] - s * g[1]);
        right(row, 1) += t.area * (s * g[0] + c * g[1]);
      }
    }
    for (Eigen::Index k = 0; k < 2; ++k) {
      const Eigen::VectorXd x = solver_.solve(right.col(k));
      for (std::size_t v = 0; v < uv.size(); ++v)
        if (unknown_.number[v] >= 0) uv[v][static_cast<std::size_t>(k)] = x[unknown_.number[v]];
    }
  }
};

CONCINO_INLINE iterated_map local_global_map(const flat_disk& f, const fixed_points& fixed,
                                             const iteration_limits& limits) {
  check_limits(limits, "arap_map");
  const poly_triangles cut(f);
  cut.check_areas(f, "arap_map");
  iterated_map result{conformal_map(f, cut, fixed, "arap_map"), {}};
  nearest_rotations rotations(f, cut);
  rotations.fit(result.uv);
  result.energies.push_back(rotations.energy);
  const fixed_points first_alone{{far_pair(f).first, {0, 0}}};
  const triangle_fit step(f, cut, fixed.empty() ? first_alone : fixed);
  result.has_converged = !step.has_unknowns();
  plane_points next = result.uv;
  for (int round = 0; round < limits.max_iterations && !result.has_converged; ++round) {
    report_progress(limits.on_progress, static_cast<double>(round) / limits.max_iterations, "arap_map");
    step.fit(rotations, next);
    rotations.fit(next);
    const double before = result.energies.back(), fall = before - rotations.energy;
    constexpr double rounding = 1e-26;  // the energy of rounding errors
    result.has_converged = fall <= limits.tolerance * before || rotations.energy <= rounding;
    if (fall < 0) break;  // rounding errors
    result.uv = next;
    result.energies.push_back(rotations.energy);
  }
  if (fixed.empty()) place_upright(f, result.uv);
  report_progress(limits.on_progress, 1, "arap_map");
  return result;
}

}  // namespace concino::detail
