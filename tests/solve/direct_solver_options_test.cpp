#include <concino/solve/direct_solver_options.hpp>

#include <concino/solve/ldlt.hpp>
#include <concino/solve/llt.hpp>

#include <doctest/doctest.h>

#include <cstddef>
#include <initializer_list>
#include <vector>

#include <support/systems.hpp>

using namespace concino;
using namespace systems;

TEST_CASE("ldlt: takes the order that it is given, keeps it, and passes it on") {
  static int calls = 0;
  const elimination_ordering backwards = [](const Eigen::SparseMatrix<double>& matrix) {
    ++calls;
    std::vector<int> order(static_cast<std::size_t>(matrix.cols()));
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(order.size() - 1 - i);
    return order;
  };
  ldlt solver({.ordering = backwards}), other({.ordering = backwards}), automatic;
  const sparse a = grid(12), twice = 2 * a;
  const Eigen::VectorXd b = random_vector(a.cols());
  solver.factorize(a);
  automatic.factorize(a);
  const Eigen::VectorXd x = automatic.solve(b);
  CHECK(distance(solver.solve(b), x) < 1e-12);
  solver.factorize(twice);
  CHECK(distance(2 * solver.solve(b), x) < 1e-12);
  other.use_order_of(solver);
  other.factorize(a);
  CHECK(calls == 1);
  CHECK(distance(other.solve(b), x) < 1e-12);
  CHECK((other.options().ordering == backwards));
  for (const elimination_ordering wrong : std::initializer_list<elimination_ordering>{
           [](const Eigen::SparseMatrix<double>&) { return std::vector<int>{0, 1}; }, [](const Eigen::SparseMatrix<double>&) { return std::vector<int>{0, 1, 1, 2}; },
           [](const Eigen::SparseMatrix<double>&) { return std::vector<int>{0, 1, 2, 4}; }, [](const Eigen::SparseMatrix<double>&) { return std::vector<int>{0, -1, 1, 2}; }}) {
    ldlt broken({.ordering = wrong});
    CHECK_THROWS_WITH_AS(broken.factorize(grid(2)), doctest::Contains("no permutation"), invalid_argument);
    CHECK_THROWS_AS(broken.solve(Eigen::VectorXd::Ones(4)), solver_error);
  }
}

TEST_CASE("llt: takes the order that it is given, and that of another") {
  const elimination_ordering forwards = [](const Eigen::SparseMatrix<double>& matrix) {
    std::vector<int> order(static_cast<std::size_t>(matrix.cols()));
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
    return order;
  };
  llt solver({.ordering = forwards}), other, automatic;
  automatic.factorize(grid(12));
  solver.factorize(grid(12));
  other.use_order_of(solver);
  CHECK_THROWS_AS(other.solve(random_vector(144)), solver_error);
  other.factorize(grid(12));
  const Eigen::VectorXd b = random_vector(144), x = solver.solve(b);
  CHECK(other.solve(b) == x);
  CHECK(distance(automatic.solve(b), x) < 1e-12);
  CHECK((solver.options().ordering == forwards));
}
