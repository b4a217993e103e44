// Bodies of heat.hpp: weights of bones by heat: the bones nearest to verts, and the system of equations.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/residual.hpp>
#include <concino/deform/detail/weights/heat.hpp>
#include <concino/geometry/closest_point.hpp>
#include <concino/solve/ldlt.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace concino::detail {

CONCINO_INLINE nearest_bones bones_nearest_to(const std::vector<std::array<vec3, 2>>& bones, const vec3& x) {
  std::vector<double> distances;
  double smallest = std::numeric_limits<double>::infinity();
  for (const auto& [a, b] : bones) {
    distances.push_back(distance(x, closest_point(x, a, b)));
    smallest = std::min(smallest, distances.back());
  }
  nearest_bones found{{}, smallest, {}};
  for (std::size_t j = 0; j < bones.size(); ++j) {
    if (!(distances[j] <= smallest * (1 + 1e-9))) continue;
    if (found.bones.empty()) found.point = closest_point(x, bones[j][0], bones[j][1]);
    found.bones.push_back(static_cast<std::uint32_t>(j));
  }
  return found;
}

/// Errors: solver_error if a vert with neighbours is in a component without heat.
CONCINO_INLINE void check_heat_of_components(const Eigen::SparseMatrix<double>& laplacian,
                                             const std::vector<std::size_t>& used, const std::vector<double>& heat) {
  std::vector<bool> is_warm(heat.size(), false);
  std::vector<int> open;
  for (const std::size_t v : used)
    if (heat[v] > 0) is_warm[v] = true, open.push_back(static_cast<int>(v));
  while (!open.empty()) {
    const int c = open.back();
    open.pop_back();
    for (Eigen::SparseMatrix<double>::InnerIterator it(laplacian, c); it; ++it)
      if (it.value() != 0 && !is_warm[static_cast<std::size_t>(it.row())])
        is_warm[static_cast<std::size_t>(it.row())] = true, open.push_back(static_cast<int>(it.row()));
  }
  for (const std::size_t v : used)
    if (!is_warm[v] && laplacian.coeff(static_cast<int>(v), static_cast<int>(v)) != 0)
      core::throw_joined<solver_error>({"heat_weights: no vert in the component of vert ", v,
                                        " sees its nearest bone; set visible = false, or move the bones inside"});
}

CONCINO_INLINE computed_weights diffuse_heat(const Eigen::SparseMatrix<double>& laplacian,
                                             const std::vector<double>& mass, const bone_heat_rows& rows,
                                             std::size_t num_bones, double amount, double min_weight) {
  const std::size_t n = mass.size();
  std::vector<double> heat(n, 0);
  for (std::size_t i = 0; i < rows.used.size(); ++i) {
    if (rows.nearest[i].bones.empty()) continue;
    const double d = std::max(rows.nearest[i].distance, 1e-6 * rows.size);
    heat[rows.used[i]] = amount * mass[rows.used[i]] / (d * d);
  }
  check_heat_of_components(laplacian, rows.used, heat);
  // Rows of verts without neighbours are 1 on the diagonal.
  std::vector<Eigen::Triplet<double>> entries;
  for (int c = 0; c < laplacian.outerSize(); ++c) {
    double diagonal = heat[static_cast<std::size_t>(c)];
    for (Eigen::SparseMatrix<double>::InnerIterator it(laplacian, c); it; ++it) {
      if (it.row() == c) diagonal -= it.value();
      else if (it.row() > c) entries.emplace_back(static_cast<int>(it.row()), c, -it.value());
    }
    entries.emplace_back(c, c, diagonal > 0 ? diagonal : 1);
  }
  Eigen::SparseMatrix<double> lower(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n));
  lower.setFromTriplets(entries.begin(), entries.end());
  ldlt solver;
  core::factorize_over_verts(solver, lower, "heat_weights", [](Eigen::Index row) { return row; });
  std::vector<skin_weight> all;
  computed_weights result;
  Eigen::VectorXd b(static_cast<Eigen::Index>(n));
  for (std::size_t j = 0; j < num_bones; ++j) {
    b.setZero();
    bool any = false;
    for (std::size_t i = 0; i < rows.used.size(); ++i) {
      const auto& bones = rows.nearest[i].bones;
      if (std::find(bones.begin(), bones.end(), j) == bones.end()) continue;
      b[static_cast<Eigen::Index>(rows.used[i])] = heat[rows.used[i]] / static_cast<double>(bones.size());
      any = any || heat[rows.used[i]] > 0;
    }
    if (!any) continue;
    const Eigen::VectorXd w = core::solve_and_check(solver, lower, b, "heat_weights");
    for (const std::size_t v : rows.used) {
      const double x = w[static_cast<Eigen::Index>(v)];
      result.num_negative += x < -1e-9;
      if (x > min_weight) all.push_back({v, j, x});
    }
  }
  for (std::size_t i = 0; i < rows.used.size(); ++i) {
    const std::size_t v = rows.used[i];
    if (laplacian.coeff(static_cast<int>(v), static_cast<int>(v)) == 0 && heat[v] == 0)
      for (const std::uint32_t j : rows.fallback[i].bones) all.push_back({v, j, 1});
  }
  result.weights = skin_weights(n, num_bones, all);
  return result;
}

}  // namespace concino::detail
