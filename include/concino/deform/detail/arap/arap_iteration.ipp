// Bodies of arap_problem.hpp: as rigid as possible: the edges of a shape with their weights, its unknown verts, and the
// two steps of an iteration.
#pragma once

#include <concino/core/parallel.hpp>
#include <concino/deform/detail/arap/arap_problem.hpp>
#include <concino/deform/detail/skin/best_rotation.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace concino::detail {

CONCINO_INLINE arap_problem::vert_sums arap_problem::rotate(std::size_t v, const std::vector<vec3>& x,
                                                            rotation_columns& rotation) const {
  moment_matrix moments;
  double whole = 0;
  for (std::uint32_t k = first_[v]; k < first_[v + 1]; ++k) {
    const vec3 e = rest_[to_[k]] - rest_[v], d = x[to_[k]] - x[v];
    if (polys_.is_empty()) moments.add(0.5 * weight_[k], e, d);
    else moments.add(1, out_[k], d);
    whole += 0.25 * weight_[k] * (dot(e, e) + dot(d, d));
  }
  // With polys only the sum of `whole` over all verts is a bound.
  rotation = best_rotation(moments, polys_.is_empty() ? whole : std::numeric_limits<double>::infinity());
  double products = 0;
  for (std::size_t c = 0; c < 3; ++c) products += dot(rotation[c], moments.of[c]);
  return {products, whole};
}

CONCINO_INLINE double arap_problem::local_step(const std::vector<vec3>& x,
                                               std::vector<rotation_columns>& rotations) const {
  std::vector<vert_sums> of_vert(x.size());
  parallel_for(
      x.size(), [&](std::size_t v) { of_vert[v] = rotate(v, x, rotations[v]); }, 256);
  vert_sums all;
  for (const vert_sums& s : of_vert) all.products += s.products, all.whole += s.whole;
  const double rest = all.whole - all.products;
  return rest > 1e-5 * all.whole ? 2 * rest : energy(x, rotations);
}

CONCINO_INLINE double arap_problem::energy(const std::vector<vec3>& x,
                                           const std::vector<rotation_columns>& rotations) const {
  if (!polys_.is_empty()) return polys_.energy(rest_, x, rotations);
  std::vector<double> of_vert(x.size());
  parallel_for(
      x.size(),
      [&](std::size_t v) {
        for (std::uint32_t k = first_[v]; k < first_[v + 1]; ++k) {
          const vec3 d = x[to_[k]] - x[v] - turned(rotations[v], rest_[to_[k]] - rest_[v]);
          of_vert[v] += 0.5 * weight_[k] * dot(d, d);
        }
      },
      256);
  double whole = 0;
  for (const double e : of_vert) whole += e;
  return whole;
}

CONCINO_INLINE vec3 arap_problem::right_side(std::size_t v, const std::vector<rotation_columns>& rotations) const {
  vec3 sum, own;
  if (polys_.is_empty()) {
    for (std::uint32_t k = first_[v]; k < first_[v + 1]; ++k) {
      const vec3 e = (0.5 * weight_[k]) * (rest_[v] - rest_[to_[k]]);
      own += e;
      sum += turned(rotations[to_[k]], e);
    }
  } else {
    own = own_[v];
    for (std::uint32_t k = first_[v]; k < first_[v + 1]; ++k) sum += turned(rotations[to_[k]], in_[k]);
  }
  return sum + turned(rotations[v], own);
}

CONCINO_INLINE void arap_problem::global_step(core::solver_ref solver, const Eigen::SparseMatrix<double>& lower,
                                              const std::vector<rotation_columns>& rotations, bool check,
                                              std::vector<vec3>& x) const {
  const auto n = static_cast<Eigen::Index>(num_unknowns());
  if (n == 0) return;
  std::array<Eigen::VectorXd, 3> b{Eigen::VectorXd(n), Eigen::VectorXd(n), Eigen::VectorXd(n)};
  parallel_for(
      num_unknowns(),
      [&](std::size_t row) {
        const std::uint32_t v = vert_of_unknown_[row];
        vec3 sum = right_side(v, rotations);
        for (std::uint32_t k = first_[v]; k < first_[v + 1]; ++k)
          if (unknown_[to_[k]] == not_unknown) sum += weight_[k] * x[to_[k]];
        for (std::size_t d = 0; d < 3; ++d) b[d][static_cast<Eigen::Index>(row)] = sum[d];
      },
      256);
  for (std::size_t d = 0; d < 3; ++d) {
    const Eigen::VectorXd solution =
        check ? core::solve_and_check(solver, lower, b[d], "prepare_deform") : solver.solve(b[d]);
    for (std::size_t row = 0; row < num_unknowns(); ++row)
      x[vert_of_unknown_[row]][d] = solution[static_cast<Eigen::Index>(row)];
  }
}

CONCINO_INLINE std::vector<double> arap_problem::iterate(core::solver_ref solver,
                                                         const Eigen::SparseMatrix<double>& lower,
                                                         const arap_limits& limits, std::vector<vec3>& points,
                                                         bool& has_converged) const {
  std::vector<vec3> x(points.size());
  for (std::size_t v = 0; v < x.size(); ++v) x[v] = points[v] / unit_;
  std::vector<rotation_columns> rotations(x.size());
  std::vector<double> energies{local_step(x, rotations)};
  double whole = 0;  // the energy of a shape that shrinks to a point: the measure of rounding errors
  for (std::size_t v = 0; v < rest_.size(); ++v)
    for (std::uint32_t k = first_[v]; k < first_[v + 1]; ++k) {
      const vec3 e = rest_[to_[k]] - rest_[v];
      whole += weight_[k] * dot(e, e);
    }
  const double rounding = 1e-26 * whole;
  has_converged = num_unknowns() == 0 || energies.back() <= rounding;
  std::vector<vec3> previous;
  for (int i = 0; i < limits.max_iterations && !has_converged; ++i) {
    previous = x;
    global_step(solver, lower, rotations, i == 0, x);
    const double energy = local_step(x, rotations), before = energies.back();
    has_converged = energy <= rounding || before - energy <= limits.tolerance * before;
    if (energy > before) {  // by rounding: nothing more to gain
      x = previous;
      break;
    }
    energies.push_back(energy);
  }
  for (std::size_t row = 0; row < num_unknowns(); ++row) {
    const std::uint32_t v = vert_of_unknown_[row];
    points[v] = unit_ * x[v];
  }
  for (double& e : energies) e *= weight_unit_ * unit_ * unit_;
  return energies;
}

}  // namespace concino::detail
