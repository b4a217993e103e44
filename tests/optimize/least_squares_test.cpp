#include <concino/optimize/least_squares.hpp>

#include <concino/solve/conjugate_gradients.hpp>
#include <concino/solve/ldlt.hpp>
#include <concino/solve/qr.hpp>

#include <support/systems.hpp>

#include <cmath>
#include <utility>
#include <vector>

using namespace concino;
using namespace systems;

namespace {

/// The differences along a path of n values, and its first value.
sparse differences(int n) {
  std::vector<Eigen::Triplet<double>> entries{{0, 0, 1.0}};
  for (int i = 1; i < n; ++i) {
    entries.emplace_back(i, i - 1, -1.0);
    entries.emplace_back(i, i, 1.0);
  }
  return from(n, n, entries);
}

/// n independent equations in m unknowns.
sparse tall(int n, int m) {
  std::mt19937 random(9);
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < n; ++i) {
    entries.emplace_back(i, i % m, 3.0);
    entries.emplace_back(i, static_cast<int>(random() % static_cast<unsigned long>(m)), static_cast<double>(random() % 1000) / 1000);
  }
  return from(n, m, entries);
}

}  // namespace

TEST_CASE("least_squares: fits a line to points") {
  const sparse a = from(4, 2, {{0, 0, 1.0}, {1, 0, 1.0}, {2, 0, 1.0}, {3, 0, 1.0}, {1, 1, 1.0}, {2, 1, 2.0}, {3, 1, 3.0}});
  const Eigen::VectorXd b = Eigen::Vector4d(1, 3, 4, 4);
  const auto fit = least_squares(a, b);
  CHECK(fit.x[0] == doctest::Approx(1.5));
  CHECK(fit.x[1] == doctest::Approx(1));
  CHECK(fit.residual == doctest::Approx(1));
  const auto through = least_squares(a, b, {{0, 1.0}});
  CHECK(through.x[0] == 1.0);
  CHECK(through.x[1] == doctest::Approx(17.0 / 14));
  const auto weighted = weighted_least_squares(a, Eigen::Vector4d(1, 1, 0, 0), b);
  CHECK(weighted.x[0] == doctest::Approx(1));
  CHECK(weighted.x[1] == doctest::Approx(2));
  CHECK(weighted.residual < 1e-14);
  CHECK(weighted_least_squares(a, Eigen::Vector4d(1, 1, 1e20, 1e20), b).x[1] == doctest::Approx(0).epsilon(1e-8));
}

TEST_CASE("least_squares: the residual is minimal, with and without conditions, by any solver") {
  const sparse a = tall(300, 80);
  const Eigen::VectorXd b = random_vector(300);
  const std::vector<std::pair<int, double>> given{{3, 0.1}, {79, -2.5}, {3, 0.1}};
  const Eigen::VectorXd w = random_vector(300, 8).cwiseAbs();
  const auto check = [&](const Eigen::VectorXd& x, const Eigen::VectorXd& weight, bool fixed) {
    const Eigen::VectorXd gradient = a.transpose() * weight.cwiseProduct(b - a * x);
    for (int i = 0; i < 80; ++i)
      if (!fixed || (i != 3 && i != 79)) CHECK(std::abs(gradient[i]) < 1e-10);
    if (fixed) CHECK((x[3] == 0.1 && x[79] == -2.5));
  };
  const Eigen::VectorXd one = Eigen::VectorXd::Ones(300);
  check(least_squares(a, b).x, one, false);
  check(least_squares(a, b, given).x, one, true);
  check(weighted_least_squares(a, w, b).x, w, false);
  check(weighted_least_squares(a, w, b, given).x, w, true);
  check(least_squares(a, b, given, qr{}).x, one, true);
  check(least_squares(a, b, given, conjugate_gradients{}).x, one, true);
  ldlt mine;
  CHECK(least_squares(a, b, given, mine).x == least_squares(a, b, given).x);
}

TEST_CASE("least_squares: nearly dependent columns are as accurate as with qr, by any solver") {
  const int rows = 60;
  bool some_by_qr = false, some_without = false;
  for (int degree = 2; degree <= 12; ++degree) {  // polynomials through points, with condition numbers up to 10^9
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < rows; ++i)
      for (int k = 0; k <= degree; ++k) entries.emplace_back(i, k, std::pow(i / (rows - 1.0), k));
    const sparse a = from(rows, degree + 1, entries);
    const Eigen::VectorXd x = random_vector(degree + 1), b = a * x;
    for (const double away : {0.0, 1e-6}) {  // the distance of the right-hand side from the range of A
      const Eigen::VectorXd near = b + away * random_vector(rows, 5);
      const Eigen::VectorXd expected = least_squares(a, near, {}, qr{}).x;
      const double allowed = 50 * distance(least_squares(a, b, {}, qr{}).x, x) + 1e-12;
      const auto by_default = least_squares(a, near), by_iteration = least_squares(a, near, {}, conjugate_gradients{});
      CHECK(distance(by_default.x, expected) < allowed);
      CHECK(distance(by_iteration.x, expected) < allowed);
      (by_default.used_qr ? some_by_qr : some_without) = true;
    }
  }
  CHECK((some_by_qr && some_without));
  CHECK(least_squares(differences(9), Eigen::VectorXd::Ones(9), {}, qr{}).used_qr);
  CHECK_FALSE(least_squares(tall(300, 80), random_vector(300)).used_qr);
}

TEST_CASE("least_squares: solves consistent systems, and accepts conditions on all unknowns") {
  const sparse a = differences(200);
  const Eigen::VectorXd x = random_vector(200);
  CHECK(distance(least_squares(a, a * x).x, x) < 1e-9);
  std::vector<std::pair<Eigen::Index, double>> all;
  for (Eigen::Index i = 0; i < 200; ++i) all.emplace_back(i, x[i]);
  const auto r = least_squares(a, Eigen::VectorXd::Zero(200), all);
  CHECK(r.x == x);
  CHECK(r.residual == doctest::Approx((a * x).norm()));
  CHECK(least_squares(sparse(0, 0), Eigen::VectorXd(0)).x.size() == 0);
  CHECK(least_squares(sparse(3, 0), Eigen::Vector3d(0, 3, 4)).residual == 5);
}

TEST_CASE("least_squares: a condition determines what A does not; without it A is an error") {
  const sparse a = differences(50).bottomRows(49);
  const Eigen::VectorXd b = Eigen::VectorXd::Ones(49);
  const auto r = least_squares(a, b, {{10, 5.0}});
  for (int i = 0; i < 50; ++i) CHECK(r.x[i] == doctest::Approx(i - 5));
  CHECK_THROWS_AS(least_squares(a, b), solver_error);
  CHECK_THROWS_AS(least_squares(a, b, std::vector<std::pair<int, double>>{}, qr{}), solver_error);
  CHECK_THROWS_AS(least_squares(sparse(3, 2), Eigen::Vector3d(1, 1, 1)), solver_error);
}

TEST_CASE("least_squares: the error names the invalid argument") {
  sparse a = differences(4);
  const Eigen::VectorXd b = Eigen::VectorXd::Ones(4);
  CHECK_THROWS_WITH_AS(least_squares(a, Eigen::VectorXd::Ones(3)), doctest::Contains("3 entries, the matrix 4 rows"), solver_error);
  CHECK_THROWS_WITH_AS(least_squares(a, b * std::nan("")), doctest::Contains("entry 0 of the right-hand side is not finite"), solver_error);
  CHECK_THROWS_WITH_AS(least_squares(a, b, {{4, 1.0}}), doctest::Contains("unknown 4, but there are 4"), invalid_argument);
  CHECK_THROWS_WITH_AS(least_squares(a, b, {{-1, 1.0}}), doctest::Contains("unknown -1"), invalid_argument);
  CHECK_THROWS_WITH_AS(least_squares(a, b, {{1, 1.0}, {1, 2.0}}), doctest::Contains("unknown 1 is given two values, 1 and 2"), invalid_argument);
  CHECK_THROWS_WITH_AS(least_squares(a, b, {{1, HUGE_VAL}}), doctest::Contains("not finite"), invalid_argument);
  CHECK_THROWS_WITH_AS(weighted_least_squares(a, Eigen::Vector3d(1, 1, 1), b), doctest::Contains("3 weights, but 4 rows"), invalid_argument);
  CHECK_THROWS_WITH_AS(weighted_least_squares(a, Eigen::Vector4d(1, -1, 1, 1), b), doctest::Contains("weight of row 1 is -1"), invalid_argument);
  CHECK_THROWS_WITH_AS(weighted_least_squares(a, Eigen::Vector4d(1, 1, 1, std::nan("")), b), doctest::Contains("row 3"), invalid_argument);
  a.coeffRef(2, 1) = std::nan("");
  CHECK_THROWS_WITH_AS(least_squares(a, b), doctest::Contains("not finite, in row 2, column 1"), solver_error);
}
