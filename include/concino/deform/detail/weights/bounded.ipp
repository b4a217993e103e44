// Bodies of bounded.hpp: bounded biharmonic weights of handles, by quadratic programs.
#pragma once

#include <concino/core/error.hpp>
#include <concino/deform/detail/weights/bounded.hpp>
#include <concino/core/residual.hpp>
#include <concino/optimize/qp.hpp>
#include <concino/solve/ldlt.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace concino::detail {

/// The handle of each vert; -1 of those without neighbours, -2 of the unknown ones.
/// Errors: invalid_argument if a vert is in two handles, solver_error if a component has none.
CONCINO_INLINE std::vector<int> handles_of_verts(const Eigen::SparseMatrix<double>& laplacian,
                                                 const std::vector<std::vector<std::size_t>>& handles) {
  constexpr const char* caller = "bounded_biharmonic_weights";
  std::vector<int> handle(static_cast<std::size_t>(laplacian.cols()), -1);
  for (int c = 0; c < laplacian.outerSize(); ++c)
    if (laplacian.coeff(c, c) != 0) handle[static_cast<std::size_t>(c)] = -2;
  std::vector<int> open;
  std::vector<bool> is_reached(handle.size(), false);
  for (std::size_t j = 0; j < handles.size(); ++j) {
    if (handles[j].empty()) core::throw_joined<invalid_argument>({caller, ": handle ", j, " has no verts"});
    for (const std::size_t v : handles[j]) {
      if (handle[v] >= 0 && handle[v] != static_cast<int>(j))
        core::throw_joined<invalid_argument>({caller, ": vert ", v, " is in handles ", handle[v], " and ", j});
      handle[v] = static_cast<int>(j);
      is_reached[v] = true;
      open.push_back(static_cast<int>(v));
    }
  }
  while (!open.empty()) {
    const int c = open.back();
    open.pop_back();
    for (Eigen::SparseMatrix<double>::InnerIterator it(laplacian, c); it; ++it)
      if (const auto row = static_cast<std::size_t>(it.row()); it.value() != 0 && !is_reached[row])
        is_reached[row] = true, open.push_back(static_cast<int>(it.row()));
  }
  for (std::size_t v = 0; v < handle.size(); ++v)
    if (handle[v] == -2 && !is_reached[v])
      core::throw_joined<solver_error>({caller, ": the component of vert ", v, " has no vert of a handle"});
  return handle;
}

/// The energy of the biharmonic equation for the unknown verts, and the loads of the handles, at a size near 1.
struct bounded_program {
  std::vector<std::size_t> vert_of;  // of each unknown
  Eigen::SparseMatrix<double> h;
  Eigen::MatrixXd loads;
};

/// Errors: invalid_mesh if a vert with neighbours has no mass.
CONCINO_INLINE bounded_program make_bounded_program(const Eigen::SparseMatrix<double>& laplacian,
                                                    const std::vector<double>& mass, const std::vector<int>& handle,
                                                    std::size_t num_handles) {
  Eigen::VectorXd inverse = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(mass.size()));
  bounded_program program;
  std::vector<int> unknown(mass.size(), -1);
  for (std::size_t v = 0; v < mass.size(); ++v) {
    if (handle[v] == -1) continue;
    if (laplacian.coeff(static_cast<int>(v), static_cast<int>(v)) != 0) {
      if (!(mass[v] > 0))
        core::throw_joined<invalid_mesh>({"bounded_biharmonic_weights: vert ", v, " has no mass"});
      inverse[static_cast<Eigen::Index>(v)] = 1 / mass[v];
    }
    if (handle[v] == -2) unknown[v] = static_cast<int>(program.vert_of.size()), program.vert_of.push_back(v);
  }
  const Eigen::SparseMatrix<double> scaled = inverse.asDiagonal() * laplacian;
  const Eigen::SparseMatrix<double> whole = laplacian * scaled;
  const auto n = static_cast<Eigen::Index>(program.vert_of.size());
  double largest = 0;
  for (int c = 0; c < whole.outerSize(); ++c) largest = std::max(largest, whole.coeff(c, c));
  if (!(largest > 0)) largest = 1;
  std::vector<Eigen::Triplet<double>> entries;
  program.loads = Eigen::MatrixXd::Zero(n, static_cast<Eigen::Index>(num_handles));
  for (int c = 0; c < whole.outerSize(); ++c)
    for (Eigen::SparseMatrix<double>::InnerIterator it(whole, c); it; ++it) {
      const int row = unknown[static_cast<std::size_t>(it.row())], column = unknown[static_cast<std::size_t>(c)];
      if (row < 0) continue;
      // the mean of both triangles, which differ by rounding
      const double value = 0.5 * (it.value() + whole.coeff(c, it.row())) / largest;
      if (column >= 0) entries.emplace_back(row, column, value);
      else if (const int j = handle[static_cast<std::size_t>(c)]; j >= 0) program.loads(row, j) += value;
    }
  program.h.resize(n, n);
  program.h.setFromTriplets(entries.begin(), entries.end());
  return program;
}

CONCINO_INLINE skin_weights make_bounded_weights(const Eigen::SparseMatrix<double>& laplacian,
                                                 const std::vector<double>& mass,
                                                 const std::vector<std::vector<std::size_t>>& handles,
                                                 const bounded_limits& limits, const progress& on_progress) {
  constexpr const char* caller = "bounded_biharmonic_weights";
  if (handles.empty()) core::throw_joined<invalid_argument>({caller, ": there are no handles"});
  const auto [vert_of, h, loads] =
      make_bounded_program(laplacian, mass, handles_of_verts(laplacian, handles), handles.size());
  const Eigen::Index num_unknowns = h.rows();
  Eigen::SparseMatrix<double> identity(num_unknowns, num_unknowns);
  identity.setIdentity();
  const Eigen::VectorXd zeros = Eigen::VectorXd::Zero(num_unknowns), ones = Eigen::VectorXd::Ones(num_unknowns);
  ldlt unbounded;
  if (num_unknowns > 0) {
    const Eigen::SparseMatrix<double> lower = h.triangularView<Eigen::Lower>();
    core::factorize_over_verts(unbounded, lower, caller,
                               [&verts = vert_of](Eigen::Index row) { return verts[static_cast<std::size_t>(row)]; });
  }
  std::vector<skin_weight> all;
  for (std::size_t j = 0; j < handles.size(); ++j) {
    report_progress(on_progress, static_cast<double>(j) / static_cast<double>(handles.size()), "weights of handles");
    for (const std::size_t v : handles[j]) all.push_back({v, j, 1});
    if (num_unknowns == 0) continue;
    // Where the minimum without bounds is within them, it is the result; else it is near.
    const Eigen::VectorXd load = loads.col(static_cast<Eigen::Index>(j));
    Eigen::VectorXd w = -unbounded.solve(load);
    if (w.minCoeff() < 0 || w.maxCoeff() > 1) {
      const auto found = solve_qp(h, load, identity, zeros, ones,
                                  {.tolerance = limits.tolerance, .max_iterations = limits.max_iterations,
                                   .x = w.cwiseMax(0.0).cwiseMin(1.0)});
      if (found.status != qp_status::solved)
        core::throw_joined<solver_error>({caller, ": the weights of handle ", j, " have not converged after ",
                                          found.iterations, " iterations; allow more, or a larger tolerance"});
      w = found.x;
    }
    for (Eigen::Index i = 0; i < num_unknowns; ++i) {
      const double x = std::min(1.0, w[i]);
      if (x > limits.min_weight) all.push_back({vert_of[static_cast<std::size_t>(i)], j, x});
    }
  }
  return skin_weights(mass.size(), handles.size(), all);
}

}  // namespace concino::detail
