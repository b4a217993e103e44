#include <concino/solve/auto_solver.hpp>

#include <concino/solve/conjugate_gradients.hpp>
#include <concino/solve/ldlt.hpp>

#include <Eigen/SparseCholesky>

#include <support/systems.hpp>

using namespace concino;
using namespace systems;

TEST_CASE("auto_solver: fulfils the laws of solvers, by factorisation and by iteration") {
  auto_solver direct, iterative({.max_factor_entries = 0});
  check_solver(direct, 30);
  check_solver(iterative, 30);
}

TEST_CASE("auto_solver: factorises up to the limit, and reports its choice") {
  const sparse path = from(3, 3, {{0, 0, 2.0}, {1, 0, -1.0}, {0, 1, -1.0}, {1, 1, 2.0}, {2, 1, -1.0}, {1, 2, -1.0}, {2, 2, 2.0}});  // no fill-in
  const Eigen::VectorXd b = Eigen::VectorXd::Ones(3);
  auto_solver at({.max_factor_entries = 2}), below({.max_factor_entries = 1});
  CHECK(at.used() == solver_used::none);
  at.factorize(path);
  CHECK(at.used() == solver_used::ldlt);
  below.factorize(path);
  CHECK(below.used() == solver_used::conjugate_gradients);
  CHECK(distance(at.solve(b), below.solve(b)) < 1e-11);
  CHECK(at.iterations() == 0);
  below.factorize(grid(10));
  below.solve(Eigen::VectorXd::Ones(100));
  CHECK(below.iterations() > 0);
  CHECK(below.residual() < 1e-11);
  below.factorize(from(3, 3, {{0, 0, 1.0}, {1, 1, 1.0}, {2, 2, 4.0}}));
  CHECK(below.used() == solver_used::ldlt);
  CHECK(below.iterations() == 0);
  CHECK_THROWS_AS(at.factorize(sparse(2, 3)), solver_error);
  CHECK(at.used() == solver_used::none);
  CHECK_THROWS_AS(auto_solver({.max_factor_entries = -1}), invalid_argument);
}

TEST_CASE("auto_solver: make_similar_solver and a new matrix with the same pattern work") {
  auto_solver solver({.max_factor_entries = 100, .iteration = {.tolerance = 1e-9}});
  const auto_solver another(solver.options());
  CHECK(another.options().max_factor_entries == 100);
  CHECK(another.options().iteration.tolerance == 1e-9);
  CHECK_THROWS_AS(auto_solver({.iteration = {.tolerance = 2}}), invalid_argument);
  for (const int n : {3, 20, 20, 3, 3, 20})
    for (const double more : {0.5, 2.0}) {
      solver.factorize(grid(n, more));
      CHECK(solver.used() == (n == 3 ? solver_used::ldlt : solver_used::conjugate_gradients));
      const Eigen::VectorXd x = random_vector(n * n);
      CHECK(distance(solver.solve(grid(n, more) * x), x) < 1e-7);
    }
}

TEST_CASE("auto_solver: counts the entries of the factor") {
  for (const int n : {1, 2, 7, 20}) {
    const Eigen::SimplicialLDLT<sparse> factors(grid(n));
    detail::elimination_order order;
    order.find(grid(n));
    const auto all = factors.matrixL().nestedExpression().nonZeros();
    detail::sparse_factor counted;
    CHECK(counted.analyse(order(grid(n)), all));
    CHECK(counted.lower().nonZeros() == all);
    if (all > 0) CHECK(!counted.analyse(order(grid(n)), all - 1));
  }
}

TEST_CASE("auto_solver: an order copied from another obeys its own limit") {
  const sparse a = grid(10);
  const Eigen::VectorXd b = Eigen::VectorXd::Ones(a.rows());
  auto_solver first, second, small({.max_factor_entries = 100});
  first.factorize(a);
  for (auto_solver* s : {&second, &small}) {
    s->use_order_of(first);
    CHECK(s->used() == solver_used::none);
    s->factorize(a);
    CHECK(distance(s->solve(b), first.solve(b)) < 1e-9);
  }
  CHECK(second.used() == solver_used::ldlt);
  CHECK(small.used() == solver_used::conjugate_gradients);
}

TEST_CASE("auto_solver: reports an iteration, and nothing of it after a factorisation") {
  auto_solver solver({.max_factor_entries = 0, .iteration = {.max_iterations = 1, .accept_missed_tolerance = true}});
  conjugate_gradients same(solver.options().iteration);
  solver.factorize(grid(10));
  same.factorize(grid(10));
  CHECK(solver.solve(random_vector(100)) == same.solve(random_vector(100)));
  CHECK(solver.iterations() == 1);
  CHECK((solver.error() > 0 && solver.error() == same.error()));
  CHECK((solver.residual() > 0 && solver.residual() == same.residual()));
  CHECK_FALSE(solver.has_converged());
  solver.factorize(from(2, 2, {{0, 0, 1.0}, {1, 1, 4.0}}));
  CHECK(solver.used() == solver_used::ldlt);
  CHECK(solver.iterations() == 0);
  CHECK(solver.error() == 0);
  CHECK(solver.residual() == 0);
  CHECK(solver.has_converged());
  auto_solver enough({.max_factor_entries = 0});
  enough.factorize(grid(10));
  enough.solve(random_vector(100));
  CHECK(enough.is_iterative());
  CHECK(enough.has_converged());
}
