// The errors of iterative solvers, against a factorisation with one step of refinement, on meshes of every kind.
#include <concino/graph/boundary_verts.hpp>
#include <concino/operators/laplacian.hpp>
#include <concino/solve/auto_solver.hpp>
#include <concino/solve/conjugate_gradients.hpp>
#include <concino/solve/ldlt.hpp>
#include <concino/solve/multigrid.hpp>

#include <support/kinds.hpp>
#include <support/systems.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <type_traits>
#include <vector>

using namespace concino;
using namespace systems;

namespace {

/// The solution by a factor, before and after one step of refinement with an exact residual.
struct direct_solution {
  Eigen::VectorXd plain, refined;

  direct_solution(const sparse& a, const Eigen::VectorXd& b) {
    ldlt solver;
    solver.factorize(a);
    plain = solver.solve(b);
    std::vector<long double> residual(b.begin(), b.end());
    for (int c = 0; c < a.cols(); ++c)
      for (sparse::InnerIterator i(a, c); i; ++i)
        residual[static_cast<std::size_t>(i.row())] -= static_cast<long double>(i.value()) * static_cast<long double>(plain[c]);
    Eigen::VectorXd rest(b.size());
    for (Eigen::Index i = 0; i < b.size(); ++i) rest[i] = static_cast<double>(residual[static_cast<std::size_t>(i)]);
    refined = plain + solver.solve(rest);
  }
};

/// A system whose penalties, if any, are left out of `energy`.
struct problem {
  std::string name;
  sparse matrix, energy;
  Eigen::VectorXd load;
  bool has_large_penalties = false;

  double norm(const Eigen::VectorXd& x) const { return std::sqrt(std::max(0.0, x.dot(energy * x))); }
};

std::vector<bool> boundary_rows(const auto& m) {
  std::vector<bool> is_boundary(vert_index_bound(m));
  const auto boundary = boundary_verts(m);
  for (const auto v : verts(m)) is_boundary[index_of(m, v)] = boundary[v];
  return is_boundary;
}

/// Values given at the boundary, by elimination and by penalties; the same with a mass at each vert; loads that are smooth, random, and at one vert.
template<class M>
std::vector<problem> problems_on(const M& m) {
  std::vector<problem> all;
  const sparse a = -laplacian(m);
  const std::vector<bool> is_boundary = boundary_rows(m);
  const auto is_fixed = [&](Eigen::Index i) { return is_boundary[static_cast<std::size_t>(i)]; };
  Eigen::VectorXd given(a.cols()), point_load = Eigen::VectorXd::Zero(a.cols());
  for (const auto v : verts(m)) {
    const vec3 x = to_vec3(point(m, v));
    given[static_cast<Eigen::Index>(index_of(m, v))] = 1 + x.x * x.x - x.y + x.x * x.z;
  }
  point_load[a.cols() / 2] = 1;
  sparse fixed = a, massive = a;
  fixed.prune([&](Eigen::Index i, Eigen::Index j, double) { return i == j || !(is_fixed(i) || is_fixed(j)); });
  for (Eigen::Index i = 0; i < a.cols(); ++i) massive.coeffRef(i, i) *= 1.01;
  for (const sparse& s : {fixed, massive}) {
    const std::string name = &s == &fixed ? "fixed" : "massive";
    all.push_back({name + ", random load", s, s, random_vector(a.cols())});
    all.push_back({name + ", random solution", s, s, s * random_vector(a.cols(), 5)});
    all.push_back({name + ", smooth solution", s, s, s * given});
    all.push_back({name + ", load at one vert", s, s, point_load});
  }
  for (const double penalty : {10.0, 1e2, 1e4, 1e8, 1e12}) {
    problem p{"penalty " + std::to_string(penalty), a, a, Eigen::VectorXd::Zero(a.cols())};
    for (Eigen::Index i = 0; i < a.cols(); ++i)
      if (is_fixed(i)) {
        p.load[i] = penalty * a.coeff(i, i) * given[i];
        p.matrix.coeffRef(i, i) += penalty * a.coeff(i, i);
      }
    p.has_large_penalties = penalty >= 1e4;
    all.push_back(p);
  }
  return all;
}

/// make(tolerance): a solver.
template<class Make>
void check_accuracy(const problem& p, const direct_solution& expected, const std::string& name, const Make& make) {
  const Eigen::VectorXd& x = expected.refined;
  const double range = x.maxCoeff() - x.minCoeff();
  for (const double tolerance : {1e-6, 1e-9, 1e-12}) {
    INFO(name << ", " << p.name << ", tolerance " << tolerance);
    auto solver = make(tolerance);
    solver.factorize(p.matrix.triangularView<Eigen::Lower>());
    const Eigen::VectorXd error = solver.solve(p.load) - x;
    CHECK(solver.has_converged());
    CHECK(p.norm(error) <= 10 * std::max(tolerance * p.norm(x), p.norm(expected.plain - x)));
    if (p.has_large_penalties) CHECK(error.cwiseAbs().maxCoeff() <= 1e-6 * range);
  }
}

}  // namespace

TEST_CASE_TEMPLATE("iterative solvers: errors are at most ten times the tolerance or the error of ldlt, with penalties too", M, CONCINO_ALL_KINDS) {
  const bool has_large_polys = std::is_same_v<M, polygonmesh> || std::is_same_v<M, polyhedralmesh>;  // of several cells of the grid
  const M m = testing::grid<M>(dimension_v<M> == 2 ? (has_large_polys ? 6 : 14) : (has_large_polys ? 3 : 4));
  for (const problem& p : problems_on(m)) {
    const direct_solution expected(p.matrix, p.load);
    check_accuracy(p, expected, "multigrid", [](double tolerance) { return multigrid({.tolerance = tolerance}); });
    check_accuracy(p, expected, "conjugate_gradients", [](double tolerance) { return conjugate_gradients({.tolerance = tolerance}); });
    check_accuracy(p, expected, "auto_solver", [](double tolerance) { return auto_solver({.iteration = {.tolerance = tolerance}}); });
    check_accuracy(p, expected, "auto_solver by iteration",
                   [](double tolerance) { return auto_solver({.max_factor_entries = 0, .iteration = {.tolerance = tolerance}}); });
  }
}
