// Why did my solve fail? Every failing solve returns or throws its reason. Here each one fails on purpose.
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
  // Two triangles that do not touch, and a vert of no polygon.
  const cn::trimesh m({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}, {9, 9, 9}}, {{0, 1, 2}, {3, 4, 5}});
  const cn::vert_id a{0}, b{4}, alone{6};
  attempt("a component without a condition", [&] { cn::harmonic_map(m, {{a, 1.0}}); });
  attempt("a vert without edges needs none", [&] {
    const auto u = cn::harmonic_map(m, {{a, 1.0}, {b, 2.0}}, {.isolated_value = -1});
    fmt::print("u is {} there; ", u[alone]);
  });

  // Matrices: in row 2 there is nothing; [1 2; 2 1] has a negative eigenvalue.
  const Eigen::VectorXd one = Eigen::VectorXd::Ones(3);
  const sparse gap = matrix(3, 3, {{0, 0, 1.0}, {1, 1, 1.0}}), indefinite = matrix(2, 2, {{0, 0, 1.0}, {0, 1, 2.0}, {1, 0, 2.0}, {1, 1, 1.0}});
  attempt("singular", [&] { cn::ldlt().factorize(gap); });
  attempt("singular, but the value of unknown 2 is given", [&] { cn::solve_with_values(gap, one, {{2, 7.0}}); });
  attempt("indefinite, for llt", [&] { cn::llt().factorize(indefinite); });
  attempt("indefinite, for ldlt", [&] { cn::ldlt().factorize(indefinite); });
  attempt("not a number", [&] { cn::ldlt().factorize(gap * std::numeric_limits<double>::quiet_NaN()); });

  // Too few iterations. The message has the residual; so has the solver.
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
  fmt::print("auto_solver took {}\n", solver.used() == cn::solver_used::ldlt ? "ldlt" : "conjugate_gradients");

  // Constraints: x + y = 1; then 2x + 2y = 2 is redundant, and x + y = 3 contradicts it.
  const sparse k = matrix(2, 2, {{0, 0, 1.0}, {1, 1, 1.0}});
  const sparse c = matrix(3, 2, {{0, 0, 1.0}, {0, 1, 1.0}, {1, 0, 2.0}, {1, 1, 2.0}, {2, 0, 1.0}, {2, 1, 1.0}});
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(2);
  attempt("a redundant constraint, and one that contradicts", [&] {
    fmt::print("redundant with the right sides 1, 2, 1: {}\n  ", cn::solve_with_constraints(k, zero, c, Eigen::Vector3d(1, 2, 1)).redundant);
    cn::solve_with_constraints(k, zero, c, Eigen::Vector3d(1, 2, 3));
  });

  // A quadratic program answers with a status: x + y >= 3, but x, y <= 1.
  const double inf = std::numeric_limits<double>::infinity();
  const sparse rows = matrix(3, 2, {{0, 0, 1.0}, {0, 1, 1.0}, {1, 0, 1.0}, {2, 1, 1.0}});
  const auto z = cn::solve_qp(k, zero, rows, Eigen::Vector3d(3, -inf, -inf), Eigen::Vector3d(inf, 1, 1));
  fmt::print("no point fulfils all bounds: {}; rows that contradict each other:", z.status == cn::qp_status::infeasible);
  for (int i = 0; i < 3; ++i)
    if (std::abs(z.certificate[i]) > 0.1 * z.certificate.cwiseAbs().maxCoeff()) fmt::print(" {}", i);
  fmt::print("\n");
}
