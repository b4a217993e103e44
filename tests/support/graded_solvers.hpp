// Harmonic maps on graded grids by an iterative solver, compared with a factorisation or with a known solution.
#pragma once

#include <concino/fields/harmonic_map.hpp>
#include <concino/generate/grade.hpp>
#include <concino/generate/grid.hpp>
#include <concino/geometry/bounding_box.hpp>
#include <concino/mesh/hexmesh.hpp>
#include <concino/mesh/tetmesh.hpp>
#include <concino/mesh/trimesh.hpp>
#include <concino/solve/auto_solver.hpp>
#include <concino/solve/ldlt.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace graded_solvers {

using namespace concino;

template<class M>
M graded(std::size_t cells, double power) {
  M m = make_grid<M>({.cells = {cells, cells, cells}});
  grade(m, {power, power, power});
  return m;
}

/// The values of f at the verts on all sides of the bounding box, or on the two perpendicular to x.
template<class M, class F>
std::vector<std::pair<vert_t<M>, double>> values_at_sides(const M& m, bool all, F f) {
  const box b = bounding_box(m);
  std::vector<std::pair<vert_t<M>, double>> r;
  for (const auto v : verts(m)) {
    const vec3 p = to_vec3(point(m, v));
    for (const std::size_t k : {0u, 1u, 2u})
      if ((k == 0 || all) && b.min[k] < b.max[k] && (p[k] == b.min[k] || p[k] == b.max[k])) {
        r.emplace_back(v, f(p));
        break;
      }
  }
  return r;
}

/// The largest difference between the results of a factorisation and of the iteration, relative to the largest value.
template<class M>
double difference(const M& m, bool all) {
  const auto values = values_at_sides(m, all, [](const vec3& p) { return std::exp(p.x) * std::cos(p.y) + p.z; });
  auto_solver iteration({.max_factor_entries = 0});
  const auto u = harmonic_map(m, values, {}, ldlt{}), w = harmonic_map(m, values, {}, iteration);
  CHECK(iteration.used() == solver_used::multigrid);
  CHECK(iteration.has_converged());
  double worst = 0, largest = 0;
  for (const auto v : verts(m)) {
    worst = std::max(worst, std::abs(u[v] - w[v]));
    largest = std::max(largest, std::abs(u[v]));
  }
  return worst / largest;
}

/// The same for the known solutions 1 + 2x and, if all sides are constrained, 3y - z, instead of a factorisation.
template<class M>
double distance_from_linear(const M& m, bool all) {
  const auto linear = [&](const vec3& p) { return 1 + 2 * p.x + (all ? 3 * p.y - p.z : 0); };
  auto_solver iteration({.max_factor_entries = 0});
  const auto u = harmonic_map(m, values_at_sides(m, all, linear), {}, iteration);
  double worst = 0, largest = 0;
  for (const auto v : verts(m)) {
    worst = std::max(worst, std::abs(u[v] - linear(to_vec3(point(m, v)))));
    largest = std::max(largest, std::abs(u[v]));
  }
  return worst / largest;
}

}  // namespace graded_solvers
