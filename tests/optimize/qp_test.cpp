#include <concino/optimize/qp.hpp>

#include <doctest/doctest.h>

#include <Eigen/Dense>

#include <random>

using namespace concino;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
using sparse = Eigen::SparseMatrix<double>;
using Eigen::MatrixXd;
using Eigen::VectorXd;

sparse make(const MatrixXd& a) { return a.sparseView(); }

struct program {
  sparse h, a;
  VectorXd g, low, high, solution;
};

/// A program constructed from its solution: multipliers are non-zero at active bounds only, and the gradient balances them.
program with_known_solution(unsigned seed) {
  std::mt19937 random(seed);
  const auto number = [&] { return static_cast<double>(random()) / 2147483648.0 - 1; };
  const Eigen::Index n = 2 + static_cast<Eigen::Index>(random() % 12), m = static_cast<Eigen::Index>(random() % 15);
  const auto matrix = [&](Eigen::Index rows, Eigen::Index columns) {
    MatrixXd x(rows, columns);
    for (Eigen::Index i = 0; i < rows; ++i)
      for (Eigen::Index j = 0; j < columns; ++j) x(i, j) = random() % 3 ? number() : 0;
    return x;
  };
  const MatrixXd root = matrix(n, n), a = matrix(m, n);
  const MatrixXd h = root * root.transpose() + 0.05 * MatrixXd::Identity(n, n);
  program p{make(h), make(a), VectorXd(n), VectorXd(m), VectorXd(m), VectorXd(n)};
  for (Eigen::Index i = 0; i < n; ++i) p.solution[i] = 3 * number();
  const VectorXd ax = a * p.solution;
  VectorXd y = VectorXd::Zero(m);
  for (Eigen::Index i = 0; i < m; ++i) {
    const double slack = 0.1 + std::abs(number());
    p.low[i] = ax[i] - slack;
    p.high[i] = ax[i] + slack;
    switch (random() % 6) {
      case 0: p.low[i] = ax[i]; y[i] = -0.1 - std::abs(number()); break;
      case 1: p.high[i] = ax[i]; y[i] = 0.1 + std::abs(number()); break;
      case 2: p.low[i] = p.high[i] = ax[i]; y[i] = number(); break;
      case 3: p.low[i] = -inf; break;
      case 4: p.low[i] = -inf; p.high[i] = inf; break;
      default: break;
    }
  }
  p.g = -(h * p.solution + a.transpose() * y);
  return p;
}

double violation(const program& p, const qp_result& r) {
  const VectorXd ax = p.a * r.x;
  double most = (p.h * r.x + p.g + p.a.transpose() * r.multipliers).cwiseAbs().maxCoeff();
  for (Eigen::Index i = 0; i < ax.size(); ++i) {
    most = std::max({most, p.low[i] - ax[i], ax[i] - p.high[i]});
    if (r.multipliers[i] < 0) most = std::max(most, std::min(-r.multipliers[i], ax[i] - p.low[i]));
    if (r.multipliers[i] > 0) most = std::max(most, std::min(r.multipliers[i], p.high[i] - ax[i]));
  }
  return most;
}

}  // namespace

TEST_CASE("solve_qp: solves 200 programs, to rounding errors with polish, else to the tolerance") {
  for (unsigned seed = 0; seed < 200; ++seed) {
    CAPTURE(seed);
    const program p = with_known_solution(seed);
    const auto r = solve_qp(p.h, p.g, p.a, p.low, p.high);
    REQUIRE(r.status == qp_status::solved);
    CHECK(r.residual <= 1e-9);
    CHECK(violation(p, r) <= 1e-9);
    CHECK((r.x - p.solution).cwiseAbs().maxCoeff() <= 1e-6);
    const auto plain = solve_qp(p.h, p.g, p.a, p.low, p.high, {.polish = false});
    REQUIRE(plain.status == qp_status::solved);
    CHECK(plain.residual <= 1e-5 * (1 + p.g.cwiseAbs().maxCoeff()));
  }
}

TEST_CASE("solve_qp: a warm start needs fewer iterations") {
  int cold = 0, warm = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    program p = with_known_solution(seed);
    const auto first = solve_qp(p.h, p.g, p.a, p.low, p.high);
    p.g *= 1.0001;
    cold += solve_qp(p.h, p.g, p.a, p.low, p.high).iterations;
    warm += solve_qp(p.h, p.g, p.a, p.low, p.high, {.x = first.x, .multipliers = first.multipliers}).iterations;
  }
  CHECK(warm < cold);
}

TEST_CASE("solve_qp: infeasible programs are recognised, with a certificate") {
  std::mt19937 random(3);
  for (unsigned seed = 0; seed < 40; ++seed) {
    CAPTURE(seed);
    program p = with_known_solution(seed);
    if (p.a.rows() < 2) continue;
    MatrixXd a = p.a;
    a.row(0).setOnes();
    a.row(1) = a.row(0);
    p.low[0] = 1;
    p.high[0] = inf;
    p.low[1] = -inf;
    p.high[1] = 0.5;
    const auto r = solve_qp(p.h, p.g, make(a), p.low, p.high);
    CHECK(r.status == qp_status::infeasible);
    REQUIRE(r.certificate.size() == a.rows());
    CHECK((a.transpose() * r.certificate).cwiseAbs().maxCoeff() < 1e-4);
    double support = 0;
    for (Eigen::Index i = 0; i < a.rows(); ++i)
      if (std::abs(r.certificate[i]) > 1e-4) support += r.certificate[i] * (r.certificate[i] > 0 ? p.high[i] : p.low[i]);
    CHECK(support < 0);
  }
}

TEST_CASE("solve_qp: unbounded programs are recognised, with the direction") {
  MatrixXd h = MatrixXd::Zero(3, 3);
  h(0, 0) = 2;
  MatrixXd a(2, 3);
  a << 0, 1, 1, 1, 0, 0;
  const VectorXd g = VectorXd::Constant(3, 1.0), low = VectorXd::Constant(2, -inf), high = VectorXd::Constant(2, 4.0);
  const auto r = solve_qp(make(h), g, make(a), low, high);
  CHECK(r.status == qp_status::unbounded);
  REQUIRE(r.certificate.size() == 3);
  CHECK(g.dot(r.certificate) < 0);
  CHECK((h * r.certificate).norm() < 1e-4);
  CHECK((a * r.certificate).maxCoeff() < 1e-4);
}

TEST_CASE("solve_qp: equality constraints only, or none, take one linear system") {
  MatrixXd h(2, 2), a(1, 2);
  h << 2, 0, 0, 4;
  a << 1, 1;
  const VectorXd g = VectorXd::Zero(2), one = VectorXd::Ones(1);
  const auto r = solve_qp(make(h), g, make(a), one, one);
  CHECK(r.status == qp_status::solved);
  CHECK(r.iterations == 0);
  CHECK(r.x[0] == doctest::Approx(2.0 / 3).epsilon(1e-12));
  CHECK(r.multipliers[0] == doctest::Approx(-4.0 / 3).epsilon(1e-12));
  const auto free = solve_qp(make(h), VectorXd::Constant(2, -2.0), sparse(0, 2), VectorXd(0), VectorXd(0));
  CHECK(free.status == qp_status::solved);
  CHECK(free.x[0] == doctest::Approx(1));
  CHECK(free.x[1] == doctest::Approx(0.5));
  CHECK(solve_qp(sparse(0, 0), VectorXd(0), sparse(0, 0), VectorXd(0), VectorXd(0)).status == qp_status::solved);
  // contradicting equations
  MatrixXd twice(2, 2);
  twice << 1, 1, 1, 1;
  VectorXd different(2);
  different << 1, 2;
  CHECK(solve_qp(make(h), g, make(twice), different, different).status == qp_status::infeasible);
}

TEST_CASE("solve_qp: finds the point of a box nearest to another") {
  const Eigen::Index n = 40;
  sparse one(n, n);
  one.setIdentity();
  VectorXd target(n);
  for (Eigen::Index i = 0; i < n; ++i) target[i] = std::sin(1.0 + static_cast<double>(i)) * 2;
  const auto r = solve_qp(one, -target, one, VectorXd::Constant(n, -1.0), VectorXd::Constant(n, 0.5));
  REQUIRE(r.status == qp_status::solved);
  for (Eigen::Index i = 0; i < n; ++i) CHECK(r.x[i] == doctest::Approx(std::clamp(target[i], -1.0, 0.5)).epsilon(1e-9));
}

TEST_CASE("solve_qp: throws if the input is invalid") {
  MatrixXd h = MatrixXd::Identity(2, 2);
  const sparse a(0, 2);
  const VectorXd none(0), g = VectorXd::Zero(2);
  CHECK_THROWS_AS(solve_qp(make(h), VectorXd::Zero(3), a, none, none), invalid_argument);
  CHECK_THROWS_AS(solve_qp(make(h), g, sparse(0, 3), none, none), invalid_argument);
  CHECK_THROWS_AS(solve_qp(make(h), g, sparse(1, 2), none, none), invalid_argument);
  CHECK_THROWS_AS(solve_qp(make(h), VectorXd::Constant(2, NAN), a, none, none), invalid_argument);
  CHECK_THROWS_WITH_AS(solve_qp(make(h), g, sparse(1, 2), VectorXd::Ones(1), VectorXd::Zero(1)), doctest::Contains("row 0 has the lower bound 1 and the upper bound 0"), invalid_argument);
  CHECK_THROWS_AS(solve_qp(make(h), g, sparse(1, 2), VectorXd::Constant(1, NAN), VectorXd::Zero(1)), invalid_argument);
  h(0, 1) = 1;
  CHECK_THROWS_WITH_AS(solve_qp(make(h), g, a, none, none), doctest::Contains("symmetric"), invalid_argument);
  h(0, 1) = 0;
  h(1, 1) = -1;
  CHECK_THROWS_WITH_AS(solve_qp(make(h), g, a, none, none), doctest::Contains("not positive semidefinite"), solver_error);
  h(1, 1) = 1;
  CHECK_THROWS_AS(solve_qp(make(h), g, a, none, none, {.tolerance = 0}), invalid_argument);
  CHECK_THROWS_AS(solve_qp(make(h), g, a, none, none, {.x = VectorXd::Zero(3)}), invalid_argument);
  const sparse box = make(h);
  CHECK_THROWS_AS(solve_qp(box, VectorXd::Constant(2, 5.0), box, VectorXd::Constant(2, -1.0), VectorXd::Ones(2), {.progress = [](double, const char*) { return false; }}), cancelled);
}

TEST_CASE("solve_qp: the error names the invalid size, number or option") {
  const auto refused = [](const MatrixXd& h, const VectorXd& g, const MatrixXd& a, const VectorXd& low, const VectorXd& high, const char* why,
                          const qp_options& options = {}) {
    CHECK_THROWS_WITH_AS(solve_qp(make(h), g, make(a), low, high, options), doctest::Contains(why), invalid_argument);
  };
  const MatrixXd h = MatrixXd::Identity(2, 2), a = MatrixXd::Ones(2, 2);
  const VectorXd two = VectorXd::Ones(2), three = VectorXd::Ones(3);
  refused(MatrixXd::Ones(2, 3), three, MatrixXd::Ones(2, 3), two, two, "H must have as many rows and columns");
  refused(h, three, MatrixXd::Ones(2, 3), two, two, "H must have as many rows and columns");
  refused(h, two, a, three, two, "A must have as many rows");
  refused(h, two, a, two, three, "A must have as many rows");
  for (const double bad : {static_cast<double>(NAN), inf})
    for (Eigen::Index i = 0; i < 2; ++i)
      for (Eigen::Index j = 0; j < 2; ++j) {
        MatrixXd wrong = MatrixXd::Ones(2, 2);
        wrong(i, j) = bad;
        refused(wrong, two, a, two, two, "H, A and g must be finite");
        refused(h, two, wrong, two, two, "H, A and g must be finite");
      }
  for (Eigen::Index i = 0; i < 2; ++i)
    for (const double end : {-inf, inf}) {
      VectorXd low = -two, high = two;
      low[i] = high[i] = end;
      refused(h, two, a, low, high, i == 0 ? "row 0 has the lower bound" : "row 1 has the lower bound");
    }
  refused(h, two, a, two, two, "tolerance", {.tolerance = 0.9e-12});
  refused(h, two, a, two, two, "tolerance", {.tolerance = 1.5});
  refused(h, two, a, two, two, "tolerance", {.tolerance = NAN});
  refused(h, two, a, two, two, "max_iterations", {.max_iterations = 0});
  refused(h, two, a, two, two, "the initial x", {.x = three});
  refused(h, two, a, two, two, "the initial x", {.x = two * inf});
  refused(h, two, a, two, two, "the initial multipliers", {.multipliers = three});
  refused(h, two, a, two, two, "the initial multipliers", {.multipliers = two * NAN});
  for (const qp_options& options : {qp_options{.tolerance = 1e-12}, qp_options{.tolerance = 1}, qp_options{.max_iterations = 1}})
    CHECK_NOTHROW(solve_qp(make(h), two, make(a), -two, two, options));
}

TEST_CASE("solve_qp: H may be 0, and unsymmetric by rounding errors") {
  const sparse box = make(MatrixXd::Identity(2, 2));
  const auto linear = solve_qp(sparse(2, 2), Eigen::Vector2d(1, -1), box, VectorXd::Constant(2, -3.0), VectorXd::Constant(2, 4.0));
  REQUIRE(linear.status == qp_status::solved);
  CHECK((linear.x - Eigen::Vector2d(-3, 4)).norm() < 1e-6);
  MatrixXd h(2, 2);
  h << 2e20, 1e20, 1e20 * (1 + 1e-14), 2e20;
  CHECK_NOTHROW(solve_qp(make(h), Eigen::Vector2d(1e20, 0), sparse(0, 2), VectorXd(0), VectorXd(0)));
}
