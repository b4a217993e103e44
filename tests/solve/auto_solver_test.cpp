#include <concino/solve/auto_solver.hpp>

#include <concino/solve/ldlt.hpp>
#include <concino/solve/multigrid.hpp>

#include <support/systems.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <thread>
#include <vector>

using namespace concino;
using namespace systems;

namespace {

/// Minus the Laplacian of a strip of n x width verts, plus `more` on the diagonal; lower triangle.
sparse strip(int n, int width, double more = 0.01) {
  std::vector<Eigen::Triplet<double>> entries;
  const auto edge = [&](int i, int j) {
    for (const int k : {i, j}) entries.emplace_back(k, k, 1.0);
    entries.emplace_back(i, j, -1);
  };
  for (int i = 0; i < n * width; ++i) {
    entries.emplace_back(i, i, more);
    if (i % width) edge(i, i - 1);
    if (i >= width) edge(i, i - width);
    if (i % width && i >= width) edge(i, i - width - 1);
  }
  return from(n * width, n * width, entries);
}

/// Multigrid answers one question about it, ldlt many.
const sparse& large() {
  static const sparse a = strip(210, 125);
  return a;
}

/// The same for n^3 verts, each with edges to up to 26 others.
sparse box(int n, double more) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < n * n * n; ++i) {
    entries.emplace_back(i, i, more);
    for (int dz = -1; dz <= 0; ++dz)
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
          const int x = i % n + dx, y = i / n % n + dy, z = i / n / n + dz, j = x + n * (y + n * z);
          if (j >= i || x < 0 || y < 0 || z < 0 || x >= n || y >= n) continue;
          for (const int k : {i, j}) entries.emplace_back(k, k, 1.0);
          entries.emplace_back(i, j, -1);
        }
  }
  return from(n * n * n, n * n * n, entries);
}

Eigen::VectorXd product(const sparse& lower, const Eigen::VectorXd& x) { return lower.selfadjointView<Eigen::Lower>() * x; }

std::string message_of(auto f) {
  try {
    f();
  } catch (const solver_error& e) {
    return e.what();
  }
  return "solved";
}

}  // namespace

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
  CHECK(below.used() == solver_used::multigrid);
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
  CHECK_THROWS_AS(auto_solver({.questions = -1}), invalid_argument);
}

TEST_CASE("auto_solver: the choice follows the size, the length of rows and the number of questions") {
  const auto choice = [](const sparse& a, const auto_solver_options& options = {}) {
    auto_solver solver(options);
    solver.factorize(a);
    return solver.used();
  };
  CHECK(choice(strip(99, 101)) == solver_used::ldlt);  // 9,999
  CHECK(choice(strip(100, 100)) == solver_used::multigrid);
  CHECK(choice(large(), {.questions = 9}) == solver_used::multigrid);
  CHECK(choice(large(), {.questions = 10}) == solver_used::ldlt);
  CHECK(choice(large(), {.max_factor_entries = 100'000, .questions = 100}) == solver_used::multigrid);
  CHECK(choice(strip(1999, 100), {.questions = 100}) == solver_used::ldlt);
  CHECK(choice(strip(2000, 100), {.questions = 100}) == solver_used::multigrid);
  CHECK(choice(box(9, 0.01)) == solver_used::ldlt);  // 729 unknowns
  CHECK(choice(box(10, 0.01)) == solver_used::multigrid);
  CHECK(choice(box(17, 0.01), {.questions = 10}) == solver_used::ldlt);  // 4,913
  CHECK(choice(box(18, 0.01), {.questions = 10}) == solver_used::multigrid);
  CHECK_THROWS_WITH_AS(auto_solver({.questions = 0}), "auto_solver: questions must be 1 or more", invalid_argument);
}

TEST_CASE("auto_solver: where multigrid fails, the factor solves") {
  auto_solver solver;
  ldlt direct;
  const auto check = [&](const sparse& a, double allowed) {
    solver.factorize(a);
    direct.factorize(a);
    const Eigen::VectorXd b = random_vector(a.cols()), x = direct.solve(b);
    CHECK(distance(solver.solve(b), x) <= allowed * x.cwiseAbs().maxCoeff());
    CHECK(solver.used() == solver_used::ldlt);
  };
  check(strip(210, 125, -0.01), 1e-8);  // indefinite
  sparse gap = large();
  gap.coeffRef(7, 7) = 0;
  check(gap, 1e-8);
  const sparse& a = large();
  auto_solver few({.iteration = {.max_iterations = 2}}), flagged({.iteration = {.max_iterations = 2, .accept_missed_tolerance = true}}),
      no_factor({.max_factor_entries = 100'000, .iteration = {.max_iterations = 2}});
  const Eigen::VectorXd x = random_vector(a.cols()), b = product(a, x);
  for (auto_solver* s : {&few, &flagged, &no_factor}) {
    s->factorize(a);
    CHECK(s->used() == solver_used::multigrid);
  }
  CHECK(distance(few.solve(b), x) < 1e-11);
  CHECK(few.used() == solver_used::ldlt);
  CHECK(few.has_replaced_multigrid());
  few.factorize(a);
  CHECK(few.used() == solver_used::ldlt);  // it remembers
  CHECK(few.has_replaced_multigrid());
  few.factorize(a * 2);
  CHECK(few.used() == solver_used::ldlt);
  flagged.solve(b);
  CHECK_FALSE(flagged.has_replaced_multigrid());
  CHECK(flagged.iterations() == 2);
  CHECK_FALSE(flagged.has_converged());
  CHECK(message_of([&] { no_factor.solve(b); }).find("multigrid: not converged after 2 iterations") == 0);
  CHECK(no_factor.used() == solver_used::multigrid);
}

TEST_CASE("auto_solver: a badly conditioned system is factorised after 40 iterations, where it may be") {
  const sparse laplacian = grid(122, 1e-7), b = laplacian * laplacian;  // of fourth order
  auto_solver solver;
  ldlt direct;
  solver.factorize(b);
  CHECK(solver.used() == solver_used::multigrid);
  direct.factorize(b);
  const Eigen::VectorXd load = random_vector(b.cols());
  CHECK(solver.solve(load) == direct.solve(load));
  CHECK(solver.used() == solver_used::ldlt);
  CHECK(solver.has_replaced_multigrid());
  CHECK(solver.iterations() == 0);
  auto_solver no_factor({.max_factor_entries = 200'000, .iteration = {.tolerance = 1e-6, .accept_missed_tolerance = true}});
  no_factor.factorize(b);
  no_factor.solve(load);
  CHECK(no_factor.used() == solver_used::multigrid);
  CHECK(no_factor.iterations() > 40);
  solver.factorize(grid(10));
  CHECK(solver.used() == solver_used::ldlt);
  CHECK_FALSE(solver.has_replaced_multigrid());
}

TEST_CASE("auto_solver: the errors of large singular systems are those of ldlt") {
  sparse a = large();  // with a component that is singular
  const int n = static_cast<int>(a.cols());
  a.conservativeResize(n + 2, n + 2);
  for (const int i : {n, n + 1}) a.coeffRef(i, i) = 1;
  a.coeffRef(n + 1, n) = -1;
  ldlt direct;
  auto_solver solver, no_factor({.max_factor_entries = 100'000});
  const std::string expected = message_of([&] { direct.factorize(a); });
  CHECK(expected.find("ldlt: the matrix is singular") == 0);
  CHECK_THROWS_AS(solver.factorize(a), core::singular_row);
  CHECK(message_of([&] { solver.factorize(a); }) == expected);
  CHECK(solver.used() == solver_used::none);
  const sparse neumann = strip(210, 125, 0);
  Eigen::VectorXd b = random_vector(n);
  Eigen::VectorXd x, y;
  const auto solve_with = [&](auto& s, Eigen::VectorXd& result) {
    return message_of([&] {
      s.factorize(neumann);
      result = s.solve(b);
    });
  };
  CHECK(solve_with(solver, x) == solve_with(direct, y));
  CHECK(x == y);
  no_factor.factorize(neumann);
  CHECK_THROWS_AS(no_factor.solve(b), solver_error);
  sparse gap = large();
  gap.coeffRef(7, 7) = 0;
  CHECK(message_of([&] { no_factor.factorize(gap); }).find("multigrid: the matrix is not positive definite: the diagonal entry of row 7") == 0);
  solver.factorize(large());
  CHECK_THROWS_AS(solver.solve(Eigen::VectorXd::Ones(3)), solver_error);
  b[3] = std::nan("");
  CHECK_THROWS_AS(solver.solve(b), solver_error);
}

TEST_CASE("auto_solver: several threads may solve at once") {
  const sparse a = box(16, 0.01);
  auto_solver solver;
  solver.factorize(a);
  std::vector<double> worst(2);
  std::vector<std::thread> threads;
  for (unsigned t = 0; t < worst.size(); ++t)
    threads.emplace_back([&, t] {
      for (unsigned i = 0; i < 25; ++i) {
        const Eigen::VectorXd x = random_vector(a.cols(), 100 * t + i);
        worst[t] = std::max(worst[t], distance(solver.solve(product(a, x)), x));
      }
    });
  for (std::thread& t : threads) t.join();
  for (const double w : worst) CHECK(w < 1e-9);
  CHECK(solver.used() == solver_used::multigrid);
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
      CHECK(solver.used() == (n == 3 ? solver_used::ldlt : solver_used::multigrid));
      const Eigen::VectorXd x = random_vector(n * n);
      CHECK(distance(solver.solve(grid(n, more) * x), x) < 1e-7);
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
  CHECK(small.used() == solver_used::multigrid);
}

TEST_CASE("auto_solver: reports an iteration, and nothing of it after a factorisation") {
  auto_solver solver({.max_factor_entries = 0, .iteration = {.max_iterations = 1, .accept_missed_tolerance = true}});
  multigrid same(solver.options().iteration);
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
