#include <concino/optimize/constrained.hpp>

#include <concino/solve/ldlt.hpp>
#include <concino/solve/lu.hpp>

#include <support/systems.hpp>

#include <Eigen/Dense>

using namespace concino;
using namespace systems;

namespace {

/// A solver whose solutions have a relative error of 1/1000.
struct rough_solver : lu {
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const { return 1.001 * lu::solve(b); }
};

}  // namespace

TEST_CASE("solve_with_constraints: finds the point of a plane nearest to the origin") {
  const auto r = solve_with_constraints(from(3, 3, {{0, 0, 1.0}, {1, 1, 1.0}, {2, 2, 1.0}}), Eigen::Vector3d::Zero(),
                                        from(1, 3, {{0, 0, 1.0}, {0, 1, 2.0}, {0, 2, 2.0}}), Eigen::VectorXd::Constant(1, 9.0));
  CHECK(distance(r.x, Eigen::Vector3d(1, 2, 2)) < 1e-14);
  CHECK(r.multipliers[0] == doctest::Approx(-1));
  CHECK(r.redundant == 0);
}

TEST_CASE("solve_with_constraints: the optimality conditions hold, by both solvers, at any size") {
  for (const int n : {2, 5, 30}) {
    const sparse k = grid(n);
    std::mt19937 random(4);
    std::vector<Eigen::Triplet<double>> entries;
    const int rows = n;
    for (int i = 0; i < rows; ++i) {
      entries.emplace_back(i, i, 1.0);
      entries.emplace_back(i, static_cast<int>(random() % static_cast<unsigned long>(n * n)), 0.3);
    }
    const sparse c = from(rows, n * n, entries);
    const Eigen::VectorXd b = random_vector(n * n), d = random_vector(rows, 5);
    const auto r = solve_with_constraints(k, b, c, d);
    CHECK(distance(c * r.x, d) < 1e-12);
    CHECK(distance(k * r.x + c.transpose() * r.multipliers, b) < 1e-12);
    CHECK(distance(solve_with_constraints(k, b, c, d, ldlt{}).x, r.x) < 1e-11);
  }
}

TEST_CASE("solve_with_constraints: accepts no constraints, and as many as unknowns") {
  const sparse k = grid(4);
  const Eigen::VectorXd x = random_vector(16);
  CHECK(distance(solve_with_constraints(k, k * x, sparse(0, 16), Eigen::VectorXd(0)).x, x) < 1e-12);
  sparse identity(16, 16);
  identity.setIdentity();
  CHECK(distance(solve_with_constraints(k, Eigen::VectorXd::Zero(16), identity, x).x, x) < 1e-14);
}

TEST_CASE("solve_with_constraints: a mean constraint determines a singular K; without it K is an error") {
  const sparse k = grid(10, 0);
  Eigen::VectorXd b = random_vector(100);
  b.array() -= b.mean();
  const sparse mean = Eigen::MatrixXd::Ones(1, 100).sparseView();
  const auto r = solve_with_constraints(k, b, mean, Eigen::VectorXd::Constant(1, 50.0));
  CHECK(r.x.sum() == doctest::Approx(50));
  CHECK(distance(k * r.x, b) < 1e-11);
  CHECK_THROWS_WITH_AS(solve_with_constraints(k, b, sparse(0, 100), Eigen::VectorXd(0)),
                       doctest::Contains("K and 0 constraints do not determine the"), solver_error);
}

TEST_CASE("solve_with_constraints: redundant constraints are counted; the error names contradicting ones") {
  const sparse k = grid(3);
  const Eigen::VectorXd b = random_vector(9);
  // row 2 = row 0 + 2 row 1, row 3 = 3 row 0, row 4 is empty, row 5 is independent
  const sparse c = from(6, 9, {{0, 0, 0.1}, {0, 4, 0.7}, {1, 4, 1.0}, {1, 8, 0.3}, {2, 0, 0.1}, {2, 4, 2.7}, {2, 8, 0.6},
                            {3, 0, 0.1 * 3}, {3, 4, 0.7 * 3}, {5, 2, 1e-20}});
  Eigen::VectorXd d(6);
  d << 0.3, 0.2, 0.7, 0.9, 0, 4e-20;
  const auto r = solve_with_constraints(k, b, c, d);
  CHECK(r.redundant == 3);
  CHECK(distance(c * r.x, d) < 1e-14);
  CHECK(r.x[2] == doctest::Approx(4));
  CHECK(distance(k * r.x + c.transpose() * r.multipliers, b) < 1e-12);
  CHECK((r.multipliers[2] == 0 && r.multipliers[3] == 0 && r.multipliers[4] == 0));
  for (const int row : {2, 3, 4}) {
    Eigen::VectorXd wrong = d;
    wrong[row] += 1e-3;
    const std::string name = "constraint " + std::to_string(row) + " contradicts";
    CHECK_THROWS_WITH_AS(solve_with_constraints(k, b, c, wrong), doctest::Contains(name.c_str()), solver_error);
  }
}

TEST_CASE("solve_with_constraints: nearly dependent constraints are kept, in any units") {
  sparse k(2, 2);
  k.setIdentity();
  for (const double little : {1e-6, 1e-9, 1e-11, 3e-12, 1e-13})
    for (const double unit : {1e-30, 1.0, 1e40}) {
      const sparse c = from(2, 2, {{0, 0, 1.0}, {0, 1, 1.0}, {1, 0, unit}, {1, 1, unit * (1 + little)}});
      const Eigen::Vector2d x(-3, 1000);
      const auto r = solve_with_constraints(k, Eigen::Vector2d::Zero(), c, c * x);
      CHECK(r.redundant == 0);
      CHECK(distance(r.x, x) < 1e-12 / little);
      const Eigen::Vector2d terms = c.transpose().cwiseAbs() * r.multipliers.cwiseAbs();
      CHECK(distance(r.x, -(c.transpose() * r.multipliers)) < 1e-14 * terms.maxCoeff());
    }
  for (const double unit : {1e-30, 1.0, 1e40}) {  // dependent constraints are found, also after a row that is nearly eliminated
    const sparse c = from(4, 3, {{0, 0, 1.0}, {0, 1, 1.0}, {1, 0, 1.0}, {1, 1, 1 + 1e-7}, {1, 2, 1e-7}, {2, 0, 0.3 * unit}, {2, 1, (0.3 + 0.3e-7) * unit},
                              {2, 2, 0.3e-7 * unit}, {3, 0, 0.7 * unit}, {3, 1, 0.7 * unit}});
    sparse k3(3, 3);
    k3.setIdentity();
    CHECK(solve_with_constraints(k3, Eigen::Vector3d::Zero(), c, c * Eigen::Vector3d(1, 2, 3)).redundant == 2);
  }
}

TEST_CASE("solve_with_constraints: redundancy agrees with a dense rank") {
  std::mt19937 random(6);
  for (int round = 0; round < 40; ++round) {
    const int rank = 1 + static_cast<int>(random() % 8);
    Eigen::MatrixXd base(rank, 12), mix(14, rank);
    for (double& x : base.reshaped()) x = random() % 3 ? 0.0 : static_cast<double>(random() % 1000) / 100 - 5;
    for (double& x : mix.reshaped()) x = static_cast<double>(random() % 5) - 2;
    const Eigen::MatrixXd c = mix * base;
    const Eigen::VectorXd x = random_vector(12);
    sparse k(12, 12);
    k.setIdentity();
    const auto r = solve_with_constraints(k, Eigen::VectorXd::Zero(12), c.sparseView(), c * x);
    CHECK(r.redundant == static_cast<std::size_t>(14 - c.fullPivLu().rank()));
    CHECK(distance(c * r.x, c * x) < 1e-9);
  }
}

TEST_CASE("solve_with_constraints: the error names the invalid argument") {
  const sparse k = grid(2), c = from(1, 4, {{0, 0, 1.0}});
  const Eigen::VectorXd b = Eigen::VectorXd::Ones(4), d = Eigen::VectorXd::Ones(1);
  CHECK_THROWS_WITH_AS(solve_with_constraints(sparse(2, 3), b, c, d), doctest::Contains("it must be square"), solver_error);
  CHECK_THROWS_WITH_AS(solve_with_constraints(k, d, c, d), doctest::Contains("1 entries, the matrix 4 rows"), solver_error);
  CHECK_THROWS_WITH_AS(solve_with_constraints(k, b, sparse(1, 3), d), doctest::Contains("on 3 unknowns, but there are 4"), solver_error);
  CHECK_THROWS_WITH_AS(solve_with_constraints(k, b, c, b), doctest::Contains("4 entries, the matrix 1 rows"), solver_error);
  CHECK_THROWS_WITH_AS(solve_with_constraints(k, b, c * std::nan(""), d), doctest::Contains("not finite"), solver_error);
  CHECK_THROWS_WITH_AS(solve_with_constraints(k, b, c, d * HUGE_VAL), doctest::Contains("not finite"), solver_error);
}

TEST_CASE("solve_with_constraints: the error of the solver is corrected once") {
  const sparse k = grid(4), c = from(1, 16, {{0, 2, 1.0}, {0, 7, 1.0}});
  const Eigen::VectorXd b = random_vector(16), d = Eigen::VectorXd::Constant(1, 0.5);
  CHECK(distance(solve_with_constraints(k, b, c, d, rough_solver{}).x, solve_with_constraints(k, b, c, d).x) < 1e-5);
}
