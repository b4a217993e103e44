// Find out why a solve failed: every failing solve returns or throws its reason. The failures here are on purpose.
#include <concino/fields.hpp>
#include <concino/generate.hpp>
#include <concino/mesh.hpp>
#include <concino/optimize.hpp>
#include <concino/solve.hpp>

#include <fmt/core.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace cn = concino;
using sparse = Eigen::SparseMatrix<double>;

sparse matrix(int rows, int columns, const std::vector<Eigen::Triplet<double>>& entries) {
  sparse a(rows, columns);
  a.setFromTriplets(entries.begin(), entries.end());
  return a;
}

template<class F>
void attempt(const char* what, F f) {
  fmt::print("{}:\n  ", what);
  try {
    f();
    fmt::print("solved\n");
  } catch (const cn::error& e) {
    fmt::print("{}\n", e.what());
  }
}

int main() {
  // Two triangles that do not touch, and an isolated vert.
  const cn::trimesh m({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}, {9, 9, 9}}, {{0, 1, 2}, {3, 4, 5}});
  const cn::vert_id a{0}, b{4}, alone{6};
  attempt("a component without a prescribed value", [&] { cn::harmonic_map(m, {{a, 1.0}}); });
  attempt("a vert without edges needs none", [&] {
    const auto u = cn::harmonic_map(m, {{a, 1.0}, {b, 2.0}}, {.isolated_value = -1});
    fmt::print("u is {} there; ", u[alone]);
  });

  // Two matrices: row 2 of `gap` is empty; [1 2; 2 1] has a negative eigenvalue.
  const Eigen::VectorXd one = Eigen::VectorXd::Ones(3);
  const sparse gap = matrix(3, 3, {{0, 0, 1.0}, {1, 1, 1.0}}), indefinite = matrix(2, 2, {{0, 0, 1.0}, {0, 1, 2.0}, {1, 0, 2.0}, {1, 1, 1.0}});
  attempt("singular", [&] { cn::ldlt().factorize(gap); });
  attempt("singular, but the value of unknown 2 is prescribed", [&] { cn::solve_with_values(gap, one, {{2, 7.0}}); });
  attempt("indefinite, for llt", [&] { cn::llt().factorize(indefinite); });
  attempt("indefinite, for ldlt", [&] { cn::ldlt().factorize(indefinite); });
  attempt("not a number", [&] { cn::ldlt().factorize(gap * std::numeric_limits<double>::quiet_NaN()); });

  // Too few iterations. The message states the residual, and the solver returns it.
  const auto sphere = cn::icosphere(3);
  cn::conjugate_gradients few({.max_iterations = 3});
  try {
    cn::harmonic_map(sphere, {{cn::vert_id{0}, 0.0}, {cn::vert_id{1}, 1.0}}, {}, few);
  } catch (const cn::solver_error& e) {
    fmt::print("not converged:\n  {}...\n", std::string(e.what()).substr(0, 54));
    fmt::print("  iterations {}, residual above the tolerance: {}\n", few.iterations(), few.residual() > few.options().tolerance);
  }
  cn::auto_solver solver({.max_factor_entries = 1000});  // too few for the factor
  cn::harmonic_map(sphere, {{cn::vert_id{0}, 0.0}, {cn::vert_id{1}, 1.0}}, {}, solver);
  fmt::print("auto_solver took {}\n", solver.used() == cn::solver_used::ldlt ? "ldlt" : "multigrid");

  // Constraints: x + y = 1; then 2x + 2y = 2 is redundant, and x + y = 3 contradicts it.
  const sparse k = matrix(2, 2, {{0, 0, 1.0}, {1, 1, 1.0}});
  const sparse c = matrix(3, 2, {{0, 0, 1.0}, {0, 1, 1.0}, {1, 0, 2.0}, {1, 1, 2.0}, {2, 0, 1.0}, {2, 1, 1.0}});
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(2);
  attempt("redundant constraints, and a contradictory one", [&] {
    fmt::print("redundant for the right-hand side 1, 2, 1: {}\n  ", cn::solve_with_constraints(k, zero, c, Eigen::Vector3d(1, 2, 1)).redundant);
    cn::solve_with_constraints(k, zero, c, Eigen::Vector3d(1, 2, 3));
  });

  // A quadratic program returns a status. Here x + y >= 3 contradicts x, y <= 1.
  const double inf = std::numeric_limits<double>::infinity();
  const sparse rows = matrix(3, 2, {{0, 0, 1.0}, {0, 1, 1.0}, {1, 0, 1.0}, {2, 1, 1.0}});
  const auto z = cn::solve_qp(k, zero, rows, Eigen::Vector3d(3, -inf, -inf), Eigen::Vector3d(inf, 1, 1));
  fmt::print("infeasible: {}; rows that contradict each other:", z.status == cn::qp_status::infeasible);
  for (int i = 0; i < 3; ++i)
    if (std::abs(z.certificate[i]) > 0.1 * z.certificate.cwiseAbs().maxCoeff()) fmt::print(" {}", i);
  fmt::print("\n");
}
