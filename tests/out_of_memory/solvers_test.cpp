// A factorisation that runs out of memory throws, leaves the solver without a factorisation, and can be repeated.
#include <concino/solve.hpp>

#include <support/failing_allocations.hpp>

#include <doctest/doctest.h>

namespace cn = concino;

namespace {

/// The Laplacian of a grid of n x n verts with prescribed boundary values.
Eigen::SparseMatrix<double> grid_matrix(int n) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < n * n; ++i) {
    entries.emplace_back(i, i, 4.0 + 0.1 * i);
    if (i % n + 1 < n) entries.emplace_back(i, i + 1, -1), entries.emplace_back(i + 1, i, -1);
    if (i + n < n * n) entries.emplace_back(i, i + n, -1), entries.emplace_back(i + n, i, -1);
  }
  Eigen::SparseMatrix<double> a(n * n, n * n);
  a.setFromTriplets(entries.begin(), entries.end());
  return a;
}

template<class S>
S solver_of_most(std::int64_t most) {
  if constexpr (std::same_as<S, cn::auto_solver>) return S({.max_factor_entries = most});
  else return S();
}

}  // namespace

TEST_CASE_TEMPLATE("a solver that runs out of memory throws std::bad_alloc, and works afterwards", S,
                   cn::ldlt, cn::llt, cn::lu, cn::qr, cn::conjugate_gradients, cn::multigrid, cn::bicgstab,
                   cn::auto_solver) {
  constexpr int n = std::same_as<S, cn::multigrid> || std::same_as<S, cn::auto_solver> ? 18 : 5;  // multigrid solves small systems directly
  const Eigen::SparseMatrix<double> first = grid_matrix(n), second = grid_matrix(n - 1);
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(second.cols(), 1, 2);
  for (const std::int64_t most : {10'000, 10}) {
    S fresh = solver_of_most<S>(most);
    fresh.factorize(second);
    const Eigen::VectorXd x = fresh.solve(b);
    std::size_t wrong = 0;
    const auto result = cn::testing::for_each_failing_allocation([&](const auto& attempt) {
      S solver = solver_of_most<S>(most);
      solver.factorize(first);
      if (attempt([&] { solver.factorize(second); })) {
        bool refused = false;
        try {
          (void)solver.solve(b);
        } catch (const cn::solver_error&) {
          refused = true;
        }
        wrong += !refused;
        solver.factorize(second);
      }
      wrong += solver.solve(b) != x;
      attempt([&] { (void)solver.solve(b); });
      wrong += solver.solve(b) != x;
    });
    CHECK(wrong == 0);
    CHECK(result.failed > 0);
    CHECK(result.leaks == 0);
  }
}

TEST_CASE("a solver without memory for the order of another computes its own") {
  const Eigen::SparseMatrix<double> small = grid_matrix(3), large = grid_matrix(5);
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(9, 1, 2);
  cn::ldlt other;
  other.factorize(large);
  cn::ldlt fresh;
  fresh.factorize(small);
  const Eigen::VectorXd x = fresh.solve(b);
  const auto result = cn::testing::for_each_failing_allocation([&](const auto& attempt) {
    cn::ldlt solver;
    solver.factorize(small);
    attempt([&] { solver.use_order_of(other); });
    solver.factorize(small);
    CHECK(solver.solve(b) == x);
  });
  CHECK(result.failed > 0);
  CHECK(result.leaks == 0);
}
