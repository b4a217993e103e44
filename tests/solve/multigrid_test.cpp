#include <concino/solve/multigrid.hpp>

#include <concino/fields/harmonic_map.hpp>
#include <concino/fields/poisson.hpp>
#include <concino/generate/grade.hpp>
#include <concino/generate/grid.hpp>
#include <concino/generate/random_points.hpp>
#include <concino/generate/voronoi_polygons.hpp>
#include <concino/graph/boundary_verts.hpp>
#include <concino/operators/laplacian.hpp>
#include <concino/solve/ldlt.hpp>

#include <support/kinds.hpp>
#include <support/systems.hpp>
#include <support/threads.hpp>
#include <support/values_at_verts.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace concino;
using namespace systems;

namespace {

double energy_norm(const sparse& a, const Eigen::VectorXd& x) { return std::sqrt(x.dot(a * x)); }

/// Minus the Laplacian of a mesh, plus `shift` times the largest diagonal entry on the diagonal.
template<class M>
sparse shifted_laplacian(const M& m, double shift) {
  sparse a = -laplacian(m);
  const double largest = a.diagonal().maxCoeff();
  for (Eigen::Index i = 0; i < a.cols(); ++i) a.coeffRef(i, i) += shift * largest;
  return a;
}

/// Minus the Laplacian of a mesh; values at the boundary are 0.
template<class M>
sparse fixed_boundary(const M& m) {
  sparse a = -laplacian(m);
  const auto is_fixed = boundary_verts(m);
  std::vector<bool> fixed(static_cast<std::size_t>(a.cols()));
  for (const auto v : verts(m)) fixed[index_of(m, v)] = is_fixed[v];
  a.prune([&](Eigen::Index i, Eigen::Index j, double) { return i == j || !(fixed[static_cast<std::size_t>(i)] || fixed[static_cast<std::size_t>(j)]); });
  return a;
}

/// Compares with ldlt; returns the number of iterations.
int check_solution(const sparse& a, double allowed) {
  const Eigen::VectorXd x = random_vector(a.cols()), b = a * x;
  multigrid solver;
  ldlt direct;
  solver.factorize(a.triangularView<Eigen::Lower>());
  direct.factorize(a);
  const Eigen::VectorXd y = solver.solve(b), z = direct.solve(b);
  CHECK(solver.has_converged());
  CHECK(energy_norm(a, y - x) <= 10 * std::max(1e-12 * energy_norm(a, x), energy_norm(a, z - x)));
  CHECK(distance(y, x) < allowed);
  return solver.iterations();
}

template<class M>
M graded_grid(std::size_t cells, double power) {
  M m = make_grid<M>({.cells = {cells, cells, cells}});
  grade(m, {power, power, power});
  return m;
}

}  // namespace

TEST_CASE("multigrid: fulfils the laws of solvers") {
  multigrid solver;
  CHECK(solver.levels() == 0);
  check_solver(solver, 40);
  check_scaling(solver);
}

TEST_CASE_TEMPLATE("multigrid: agrees with a factorisation on Laplacians of all kinds of mesh", M, CONCINO_ALL_KINDS) {
  const unsigned n = dimension_v<M> == 2 ? 40 : 10;
  const M m = testing::grid<M>(n);
  for (const double shift : {1e-6, 1e-2, 10.0}) CHECK(check_solution(shifted_laplacian(m, shift), 1e-7) < 30);
  sparse a = shifted_laplacian(m, 0);
  for (int i = 0; i < a.cols(); i += 7) a.coeffRef(i, i) += 1e8 * a.coeff(i, i);  // penalties
  CHECK(check_solution(a, 1e-9) < 30);
  CHECK(check_solution(shifted_laplacian(M(testing::two_grids_arrays<M>(n / 2)), 1e-4), 1e-9) < 30);
}

TEST_CASE_TEMPLATE("multigrid: takes few iterations on graded and stretched grids", M, trimesh, quadmesh, tetmesh, hexmesh) {
  const std::size_t n = dimension_v<M> == 2 ? 60 : 14;
  CHECK(check_solution(fixed_boundary(graded_grid<M>(n, 3)), 1e-8) < 30);
  CHECK(check_solution(fixed_boundary(make_grid<M>({.cells = {n, n, n}, .max = {100, 1, 1}})), 1e-8) < 30);
}

TEST_CASE("multigrid: takes at most three times as many iterations on stretched Voronoi polygons as on even ones") {
  const box square{{0, 0, 0}, {1, 1, 0}};
  polygonmesh m = voronoi_polygons(random_points(2500, square), square);
  std::vector<int> iterations;
  for (const double length : {1.0, 100.0}) {
    for (const auto v : verts(m)) {
      vec3 x = point(m, v);
      x.x *= length;
      set_point(m, v, x);
    }
    multigrid solver({.tolerance = 1e-10});
    const sparse a = fixed_boundary(m);
    solver.factorize(a);
    solver.solve(random_vector(a.cols()));
    iterations.push_back(solver.iterations());
  }
  CHECK(iterations[0] <= 18);
  CHECK(iterations[1] <= 27);
}

TEST_CASE("multigrid: iterations hardly depend on the number of unknowns") {
  std::vector<int> iterations;
  for (const std::size_t n : {30u, 90u, 270u}) {
    multigrid solver({.tolerance = 1e-10});
    const sparse a = fixed_boundary(make_grid<trimesh>({.cells = {n, n, n}}));
    solver.factorize(a);
    solver.solve(random_vector(a.cols()));
    iterations.push_back(solver.iterations());
  }
  CHECK(iterations[0] >= 8);
  CHECK(iterations[2] <= 18);
  CHECK(2 * iterations[2] <= 3 * iterations[0]);
}

TEST_CASE("multigrid: the coarsest level is solved directly, rows with a dominant diagonal by Gauss-Seidel") {
  multigrid solver;
  solver.factorize(grid(10));
  CHECK(solver.levels() == 1);
  solver.solve(random_vector(100));
  CHECK(solver.iterations() <= 2);
  solver.factorize(grid(120, 1e-3));
  CHECK(solver.levels() >= 3);
  const sparse dominant = grid(60, 100);
  solver.factorize(dominant);
  CHECK(solver.levels() == 1);
  const Eigen::VectorXd x = random_vector(3600);
  CHECK(distance(solver.solve(dominant * x), x) < 1e-11);
  sparse diagonal(1000, 1000);
  for (int i = 0; i < 1000; ++i) diagonal.insert(i, i) = 1 + i;
  solver.factorize(diagonal);
  CHECK(distance(solver.solve(diagonal * x.head(1000)), x.head(1000)) < 1e-12);
}

TEST_CASE("multigrid: works with positive entries off the diagonal, and a row that is connected to all others") {
  const sparse square = grid(20) * grid(20), nearly_singular = grid(24, 1e-3) * grid(24, 1e-3);
  for (const sparse& a : {square, nearly_singular}) CHECK(check_solution(a, 1e-5) < 200);
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < 2000; ++i) {
    entries.emplace_back(i, i, i == 0 ? 1e3 : 2.5);
    entries.emplace_back(i, (i + 1) % 2000, 1.0);
    entries.emplace_back((i + 1) % 2000, i, 1.0);
  }
  check_solution(from(2000, 2000, entries), 1e-9);  // only positive ones
  entries.clear();
  for (int i = 0; i < 2000; ++i) entries.emplace_back(i, i, i == 0 ? 2000.0 : 3.001);
  for (int i = 1; i < 2000; ++i)
    for (const int j : {0, i % 1999 + 1}) entries.emplace_back(i, j, -1.0), entries.emplace_back(j, i, -1.0);
  check_solution(from(2000, 2000, entries), 1e-7);
}

TEST_CASE("multigrid: the estimated error is close to the true one, and meets the tolerance") {
  for (const sparse& a : {grid(40, 1e-4), grid(40, 1.0), shifted_laplacian(graded_grid<trimesh>(40, 3), 1e-8)}) {
    const Eigen::VectorXd x = random_vector(a.cols()), b = a * x;
    for (const double tolerance : {1e-2, 1e-4, 1e-7, 1e-10}) {
      multigrid solver({.tolerance = tolerance});
      solver.factorize(a);
      const double error = energy_norm(a, solver.solve(b) - x) / energy_norm(a, x);
      CHECK(error <= tolerance);
      CHECK(solver.error() <= tolerance);
      CHECK(solver.residual() <= tolerance);
    }
  }
}

TEST_CASE("multigrid: large entries of some rows do not hide the others") {
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
    multigrid solver;
    solver.factorize(a);
    CHECK(distance(solver.solve(b), expected) < 1e-9);
    CHECK(solver.iterations() < 30);
  }
}

TEST_CASE("multigrid: the error is small in the energy without penalties too, where a relative residual is not enough") {
  check_penalties(30, 10, [](double tolerance, int max_iterations) {
    return multigrid({.tolerance = tolerance, .max_iterations = max_iterations, .accept_missed_tolerance = true});
  });
}

TEST_CASE("multigrid: solves systems in any units of the unknowns") {
  const sparse a = grid(30, 0.01);
  const Eigen::VectorXd x = random_vector(900);
  std::mt19937 random(7);
  Eigen::VectorXd unit(900);
  for (double& u : unit) u = std::ldexp(1.0, static_cast<int>(random() % 41) - 20);
  const sparse scaled = unit.asDiagonal() * a * unit.asDiagonal();
  multigrid solver;
  solver.factorize(scaled);
  CHECK(distance(unit.cwiseProduct(solver.solve(unit.cwiseProduct(a * x))), x) < 1e-10);
  CHECK(solver.iterations() < 100);
}

TEST_CASE("multigrid: a missed tolerance is an error, or by option a flag") {
  const sparse a = grid(30, 0.01);
  const Eigen::VectorXd b = random_vector(900);
  multigrid few({.max_iterations = 5}), flagged({.max_iterations = 5, .accept_missed_tolerance = true});
  few.factorize(a);
  flagged.factorize(a);
  CHECK_THROWS_WITH_AS(few.solve(b), doctest::Contains("multigrid: not converged after 5 iterations: the error is estimated as "), solver_error);
  CHECK_FALSE(few.has_converged());
  flagged.solve(b);
  CHECK_FALSE(flagged.has_converged());
  CHECK(flagged.iterations() == 5);
  CHECK(flagged.error() == few.error());
  CHECK(flagged.error() > 1e-12);
  CHECK(flagged.error() < 1);
  flagged.solve(Eigen::VectorXd::Zero(900));
  CHECK(flagged.has_converged());
  CHECK(flagged.iterations() == 0);
}

TEST_CASE("multigrid: consistent singular systems are solved, others fail early") {
  multigrid solver;
  for (const int n : {8, 60, 100}) {
    const sparse a = grid(n, 0);
    solver.factorize(a);
    Eigen::VectorXd b = random_vector(n * n);
    b.array() -= b.mean();
    CHECK(distance(a * solver.solve(b), b) < 1e-9);
    CHECK(solver.iterations() < 30);
    b[3] += 2;
    CHECK_THROWS_WITH_AS(solver.solve(b), doctest::Contains("not converged"), solver_error);
    CHECK(solver.iterations() < 300);
  }
  std::vector<Eigen::Triplet<double>> entries;  // two components, each with constants as kernel
  const sparse one = grid(40, 0);
  for (int c = 0; c < 2; ++c)
    for (int k = 0; k < 1600; ++k)
      for (sparse::InnerIterator it(one, k); it; ++it) entries.emplace_back(1600 * c + static_cast<int>(it.row()), 1600 * c + k, it.value());
  const sparse two = from(3200, 3200, entries);
  Eigen::VectorXd b = random_vector(3200);
  for (const int first : {0, 1600}) b.segment(first, 1600).array() -= b.segment(first, 1600).mean();
  solver.factorize(two);
  CHECK(distance(two * solver.solve(b), b) < 1e-9);
  const sparse twice = from(2, 2, {{0, 0, 1.0}, {1, 0, 1.0}, {0, 1, 1.0}, {1, 1, 1.0}});
  solver.factorize(twice);
  CHECK_THROWS_AS(solver.solve(Eigen::Vector2d(1, 3)), solver_error);
}

TEST_CASE("multigrid: indefinite matrices are errors, or solved") {
  multigrid solver;
  CHECK_THROWS_WITH_AS(solver.factorize(from(2, 2, {{0, 0, 1.0}, {1, 1, -1.0}})),
                       doctest::Contains("multigrid: the matrix is not positive definite: the diagonal entry of row 1 is -1"), solver_error);
  for (const double more : {-0.3, -1.0, -1.9}) {
    const sparse a = grid(40, more);
    solver.factorize(a);
    CHECK_THROWS_WITH_AS(solver.solve(random_vector(1600)), doctest::Contains("not converged"), solver_error);
  }
  sparse huge = grid(40);  // so large that products overflow
  huge.coeffRef(41, 1) = huge.coeffRef(1, 41) = -1e300;
  solver.factorize(huge);
  CHECK_THROWS_AS(solver.solve(random_vector(1600)), solver_error);
  solver.factorize(grid(40));
  CHECK_NOTHROW(solver.solve(random_vector(1600)));
}

TEST_CASE("multigrid: takes few iterations in any order of rows") {
  std::vector<int> place(2500);
  for (std::size_t i = 0; i < place.size(); ++i) place[i] = static_cast<int>(i);
  std::shuffle(place.begin(), place.end(), std::mt19937(2));
  const sparse ordered = grid(50, 1e-3);
  std::vector<Eigen::Triplet<double>> entries;
  for (int c = 0; c < 2500; ++c)
    for (sparse::InnerIterator it(ordered, c); it; ++it)
      entries.emplace_back(place[static_cast<std::size_t>(it.row())], place[static_cast<std::size_t>(c)], it.value());
  multigrid solver;
  for (const sparse& a : {ordered, from(2500, 2500, entries)}) {
    solver.factorize(a);
    CHECK(solver.has_pattern_of(a));
    solver.solve(random_vector(2500));
    CHECK(solver.iterations() < 25);
  }
}

TEST_CASE("multigrid: results do not depend on the number of threads") {
  const sparse a = shifted_laplacian(testing::grid<tetmesh>(12), 1e-5);
  const Eigen::VectorXd b = random_vector(a.cols());
  std::vector<Eigen::VectorXd> x;
  for (const int threads : {1, 2, 5}) {
    const testing::with_num_threads set(threads);
    multigrid solver;
    solver.factorize(a);
    x.push_back(solver.solve(b));
  }
  CHECK((x[0] == x[1] && x[0] == x[2]));
}

TEST_CASE("multigrid: solves one-shot and prepared problems") {
  const trimesh m = testing::grid<trimesh>(50);
  const vert_id a{0}, b{2600};
  const auto expected = harmonic_map(m, {{a, 0.0}, {b, 1.0}}, {}, ldlt{});
  multigrid solver;
  const auto u = harmonic_map(m, {{a, 0.0}, {b, 1.0}}, {}, solver);
  const auto w = harmonic_map(m, {{a, 0.0}, {b, 1.0}}, {}, multigrid{{.tolerance = 1e-10}});
  CHECK(testing::largest_difference(u, expected) < 1e-10);
  CHECK(testing::largest_difference(w, expected) < 1e-7);
  CHECK(solver.levels() >= 3);
  CHECK(solver.iterations() < 25);
  const testing::by_number f;
  const auto solution = poisson(m, f, {.values = {{a, 0.0}, {b, 1.0}}}, ldlt{});
  double largest = 0;
  for (const auto v : verts(m)) largest = std::max(largest, std::abs(solution[v]));
  const auto prepared = prepare_poisson(m, {a, b}, {}, multigrid{});
  for (int again = 0; again < 2; ++again) CHECK(testing::largest_difference(prepared.solve(f, {.values = {{a, 0.0}, {b, 1.0}}}), solution) < 1e-9 * largest);
}

TEST_CASE("multigrid: similar solvers and copies work") {
  multigrid one({.tolerance = 1e-4, .max_iterations = 70});
  const multigrid similar(one.options());
  CHECK(similar.options().tolerance == 1e-4);
  CHECK(similar.options().max_iterations == 70);
  one.factorize(grid(30));
  const multigrid copy = one;
  const Eigen::VectorXd b = random_vector(900), x = one.solve(b);
  one.factorize(grid(4));
  CHECK(copy.solve(b) == x);
}

TEST_CASE("multigrid: rounding errors of a long row do not prevent convergence") {
  multigrid solver;
  check_wheel(solver, 6000);
}

TEST_CASE("multigrid: options out of range throw") {
  for (const double tolerance : {0.0, 1.0, -1.0, std::nan("")}) CHECK_THROWS_AS(multigrid({.tolerance = tolerance}), invalid_argument);
  CHECK_THROWS_AS(multigrid({.max_iterations = -1}), invalid_argument);
}
