#include <concino/solve/conjugate_gradients.hpp>

#include <support/systems.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace concino;
using namespace systems;

TEST_CASE("conjugate_gradients: fulfils the laws of solvers") {
  conjugate_gradients solver;
  check_solver(solver, 40);
  check_scaling(solver);
}

namespace {

double energy_norm(const sparse& a, const Eigen::VectorXd& x) { return std::sqrt(x.dot(a * x)); }

/// The largest |b - A x|_i / (|b|_i + a_ii max|x|), or the same after scaling the diagonal to 1.
double largest_residual(const sparse& a, const Eigen::VectorXd& b, const Eigen::VectorXd& x) {
  const Eigen::VectorXd r = b - a * x, d = a.diagonal(), root = d.cwiseSqrt();
  const double largest = x.cwiseAbs().maxCoeff(), scaled = root.cwiseProduct(x).cwiseAbs().maxCoeff();
  double worst = 0;
  for (Eigen::Index i = 0; i < x.size(); ++i) worst = std::max(worst, std::abs(r[i]) / (std::abs(b[i]) + std::min(d[i] * largest, root[i] * scaled)));
  return worst;
}

/// Minus the Laplacian of a square of n x n verts, of quads divided by a diagonal, with a constrained boundary. `stretch` scales the height of its upper half.
sparse stretched(int n, double stretch) {
  std::vector<Eigen::Triplet<double>> entries;
  const auto edge = [&](int i, int j, double weight) {
    for (const int k : {i, j})
      if (k >= 0) entries.emplace_back(k, k, weight);
    if (i < 0 || j < 0) return;
    entries.emplace_back(i, j, -weight);
    entries.emplace_back(j, i, -weight);
  };
  const auto vert = [&](int i, int j) { return i < 0 || i >= n || j < 0 || j >= n ? -1 : n * j + i; };
  for (int j = -1; j <= n; ++j)
    for (int i = -1; i <= n; ++i) {
      const double height = j < n / 2 ? 1 : stretch, below = j - 1 < n / 2 ? 1 : stretch;
      edge(vert(i, j), vert(i + 1, j), (height + below) / 2);
      edge(vert(i, j), vert(i, j + 1), 1 / height);
    }
  return from(n * n, n * n, entries);
}

}  // namespace

TEST_CASE("conjugate_gradients: reports iterations, error and residual, and meets the tolerance") {
  conjugate_gradients fine, coarse({.tolerance = 1e-3});
  const sparse a = grid(30, 0.01);
  fine.factorize(a);
  coarse.factorize(a);
  const Eigen::VectorXd b = random_vector(900), x = fine.solve(b), y = coarse.solve(b);
  CHECK(largest_residual(a, b, x) == doctest::Approx(fine.residual()).epsilon(1e-2));
  CHECK(largest_residual(a, b, y) == doctest::Approx(coarse.residual()));
  CHECK(fine.residual() <= 1e-12);
  CHECK(fine.error() <= 1e-12);
  CHECK(coarse.residual() <= 1e-3);
  CHECK(coarse.error() <= 1e-3);
  CHECK(coarse.error() > 1e-8);
  CHECK((fine.has_converged() && coarse.has_converged()));
  CHECK(coarse.iterations() < fine.iterations());
  fine.solve(Eigen::VectorXd::Zero(900));
  CHECK(fine.iterations() == 0);
  CHECK(fine.residual() == 0);
  CHECK(fine.error() == 0);
}

TEST_CASE("conjugate_gradients: the estimated error is close to the true one") {
  for (const sparse& a : {grid(40, 1e-4), grid(40, 1.0), stretched(40, 30), sparse(grid(16) * grid(16))}) {
    const Eigen::VectorXd x = random_vector(a.cols()), b = a * x;
    for (const double tolerance : {1e-2, 1e-4, 1e-7, 1e-10}) {
      conjugate_gradients solver({.tolerance = tolerance});
      solver.factorize(a);
      const double error = energy_norm(a, solver.solve(b) - x) / energy_norm(a, x);
      CHECK(error <= 10 * solver.error());
      CHECK(error <= tolerance);
      CHECK(solver.error() <= 1000 * error);
    }
  }
}

TEST_CASE("conjugate_gradients: large entries of some rows do not hide the others") {
  const int n = 30;
  for (const double penalty : {1e6, 1e12}) {
    sparse a = grid(n, 0);
    Eigen::VectorXd b = Eigen::VectorXd::Zero(n * n), expected(n * n);
    for (int i = 0; i < n * n; ++i) expected[i] = 1 + i % n;
    for (int i = 0; i < n * n; ++i) {  // constrained at both ends by penalties
      if (i % n != 0 && i % n != n - 1) continue;
      a.coeffRef(i, i) += penalty;
      b[i] = (a.row(i) * expected)[0];
    }
    conjugate_gradients solver;
    solver.factorize(a);
    CHECK(distance(solver.solve(b), expected) < 1e-9);
  }
  for (const double stretch : {1e3, 1e9}) {
    const sparse a = stretched(n, stretch);
    Eigen::VectorXd x(n * n);
    for (int i = 0; i < n * n; ++i) x[i] = std::sin(0.1 * (i % n)) + 0.02 * (i / n);
    conjugate_gradients solver;
    solver.factorize(a);
    CHECK(distance(solver.solve(a * x), x) < 1e-10);
  }
}

TEST_CASE("conjugate_gradients: the error is small in the energy without penalties too, where a relative residual is not enough") {
  check_penalties(30, 10, [](double tolerance, int max_iterations) {
    return conjugate_gradients({.tolerance = tolerance, .max_iterations = max_iterations, .accept_missed_tolerance = true});
  });
}

TEST_CASE("conjugate_gradients: error and iterations hardly depend on the units of the unknowns") {
  const sparse a = grid(30, 0.01);
  const Eigen::VectorXd x = random_vector(900);
  std::mt19937 random(7);
  Eigen::VectorXd unit(900);
  for (double& u : unit) u = std::ldexp(1.0, static_cast<int>(random() % 41) - 20);
  const sparse scaled = unit.asDiagonal() * a * unit.asDiagonal();
  conjugate_gradients solver, solver_scaled;
  solver.factorize(a);
  solver_scaled.factorize(scaled);
  solver.solve(a * x);
  CHECK(distance(unit.cwiseProduct(solver_scaled.solve(unit.cwiseProduct(a * x))), x) < 1e-10);
  CHECK(solver_scaled.iterations() < 3 * solver.iterations());
}

TEST_CASE("conjugate_gradients: a missed tolerance is an error, or by option a flag") {
  const sparse a = grid(30, 0.01);
  const Eigen::VectorXd b = random_vector(900);
  conjugate_gradients few({.max_iterations = 20}), flagged({.max_iterations = 20, .accept_missed_tolerance = true});
  few.factorize(a);
  flagged.factorize(a);
  CHECK_THROWS_WITH_AS(few.solve(b), doctest::Contains("not converged after 20 iterations: the error is estimated as "), solver_error);
  CHECK_FALSE(few.has_converged());
  const Eigen::VectorXd x = flagged.solve(b);
  CHECK_FALSE(flagged.has_converged());
  CHECK(flagged.iterations() == 20);
  CHECK(flagged.error() == few.error());
  CHECK(flagged.error() > 1e-12);
  CHECK(flagged.error() < 1);
  CHECK(largest_residual(a, b, x) == doctest::Approx(flagged.residual()));
  flagged.solve(Eigen::VectorXd::Zero(900));
  CHECK(flagged.has_converged());
}

TEST_CASE("conjugate_gradients: consistent singular systems are solved, others fail early") {
  const int n = 60;
  conjugate_gradients solver;
  solver.factorize(grid(n, 0));
  Eigen::VectorXd b = random_vector(n * n);
  b.array() -= b.mean();
  CHECK(distance(grid(n, 0) * solver.solve(b), b) < 1e-9);
  b[3] += 2;
  CHECK_THROWS_WITH_AS(solver.solve(b), doctest::Contains("not converged"), solver_error);
  CHECK(solver.iterations() < 1500);
  const sparse twice = from(2, 2, {{0, 0, 1.0}, {1, 0, 1.0}, {0, 1, 1.0}, {1, 1, 1.0}});
  solver.factorize(twice);
  CHECK_THROWS_AS(solver.solve(Eigen::Vector2d(1, 3)), solver_error);
}

TEST_CASE("conjugate_gradients: reads only the lower triangle") {
  conjugate_gradients solver;
  solver.factorize(grid(6).triangularView<Eigen::Lower>());
  const Eigen::VectorXd x = random_vector(36);
  CHECK(distance(solver.solve(grid(6) * x), x) < 1e-10);
}

TEST_CASE("conjugate_gradients: missing convergence and indefinite matrices are errors") {
  conjugate_gradients few({.max_iterations = 3}), solver;
  few.factorize(grid(30, 0.01));
  CHECK_THROWS_WITH_AS(few.solve(random_vector(900)), doctest::Contains("not converged after 3 iterations: the error is estimated as "), solver_error);
  CHECK(few.iterations() == 3);
  CHECK(few.residual() > 1e-12);
  CHECK_THROWS_WITH_AS(solver.factorize(from(2, 2, {{0, 0, 1.0}, {1, 1, -1.0}})),
                       doctest::Contains("the diagonal entry of row 1 is -1"), solver_error);
  solver.factorize(grid(6, 0));  // singular: not solvable for every right-hand side
  CHECK_THROWS_WITH_AS(solver.solve(Eigen::VectorXd::Ones(36)), doctest::Contains("not converged"), solver_error);
}

TEST_CASE("conjugate_gradients: takes few iterations in any order of rows, also if sums of rows are negative") {
  std::vector<int> place(2500);
  for (std::size_t i = 0; i < place.size(); ++i) place[i] = static_cast<int>(i);
  std::shuffle(place.begin(), place.end(), std::mt19937(2));
  const sparse ordered = grid(50, 1e-3);
  std::vector<Eigen::Triplet<double>> entries;
  for (int c = 0; c < 2500; ++c)
    for (sparse::InnerIterator it(ordered, c); it; ++it)
      entries.emplace_back(place[static_cast<std::size_t>(it.row())], place[static_cast<std::size_t>(c)], it.value());
  conjugate_gradients solver;
  for (const sparse& a : {ordered, from(2500, 2500, entries)}) {
    solver.factorize(a);
    CHECK(solver.has_pattern_of(a));
    solver.solve(random_vector(2500));
    CHECK(solver.iterations() < 80);
  }
  const sparse square = grid(12) * grid(12);  // entries of both signs, for which the first incomplete factorisations fail
  solver.factorize(square);
  const Eigen::VectorXd x = random_vector(144);
  CHECK(distance(solver.solve(square * x), x) < 1e-8);
  const sparse near_singular = from(2, 2, {{0, 0, 1.0}, {1, 0, 1 - 1e-9}, {0, 1, 1 - 1e-9}, {1, 1, 1.0}});
  solver.factorize(near_singular);
  CHECK(distance(near_singular * solver.solve(Eigen::Vector2d(1, 3)), Eigen::Vector2d(1, 3)) < 1e-5);
}

TEST_CASE("conjugate_gradients: rows connected to all others cost time proportional to their entries") {
  for (const int hubs : {1, 2}) {
    const int n = 50000;  // a second for each hub and preconditioner if time grew with the square
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < n; ++i) entries.emplace_back(i, i, i < hubs ? n : hubs + 2.5);
    const auto edge = [&](int i, int j) { entries.emplace_back(i, j, -1.0), entries.emplace_back(j, i, -1.0); };
    for (int i = hubs; i < n; ++i) {
      for (int hub = 0; hub < hubs; ++hub) edge(hub, i);
      edge(i, i + 1 < n ? i + 1 : hubs);
    }
    const sparse a = from(n, n, entries);
    conjugate_gradients solver;
    solver.factorize(a);
    const Eigen::VectorXd x = random_vector(n);
    CHECK(distance(solver.solve(a * x), x) < 1e-9);
    CHECK(solver.iterations() < 40);
  }
  // a long column whose rows are connected to each other too: the same preconditioner as for short ones, up to rounding
  std::vector<int> iterations;
  for (const int n : {200, 256, 257, 300}) {
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        if (i == j || i == 0 || j == 0 || std::abs(i - j) % 7 == 1) entries.emplace_back(i, j, i == j ? 0.3 * n : -1.0);
    const sparse a = from(n, n, entries);
    conjugate_gradients solver;
    solver.factorize(a);
    const Eigen::VectorXd x = random_vector(n);
    CHECK(distance(solver.solve(a * x), x) < 1e-9);
    iterations.push_back(solver.iterations());
  }
  CHECK(*std::max_element(iterations.begin(), iterations.end()) <= *std::min_element(iterations.begin(), iterations.end()) + 2);
}

TEST_CASE("conjugate_gradients: make_similar_solver and copies work") {
  conjugate_gradients one({.tolerance = 1e-4, .max_iterations = 70});
  const conjugate_gradients another(one.options());
  CHECK(another.options().tolerance == 1e-4);
  CHECK(another.options().max_iterations == 70);
  one.factorize(grid(9));
  const conjugate_gradients copy = one;
  const Eigen::VectorXd b = random_vector(81), x = one.solve(b);
  one.factorize(grid(4));
  CHECK(copy.solve(b) == x);
}

TEST_CASE("conjugate_gradients: rounding errors of a long row do not prevent convergence") {
  conjugate_gradients solver;
  check_wheel(solver, 6000);
}

TEST_CASE("conjugate_gradients: options out of range throw") {
  for (const double tolerance : {0.0, 1.0, -1.0, std::nan("")}) CHECK_THROWS_AS(conjugate_gradients({.tolerance = tolerance}), invalid_argument);
  CHECK_THROWS_AS(conjugate_gradients({.max_iterations = -1}), invalid_argument);
}
