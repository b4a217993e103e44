#include <concino/solve/detail/direct/ordered.hpp>

#include <concino/solve/detail/direct/ordered_factors.hpp>

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <Eigen/OrderingMethods>

#include <algorithm>

#include <support/systems.hpp>

using namespace concino;
using namespace systems;

namespace {

/// Checks the order with the lower triangle, the upper one, and both.
void check_order(const sparse& a) {
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> expected;
  Eigen::AMDOrdering<int>()(a, expected);
  detail::elimination_order order;
  order.find(a);
  REQUIRE(static_cast<Eigen::Index>(order.row.size()) == a.cols());
  for (std::size_t i = 0; i < order.row.size(); ++i) {
    CHECK(order.row[i] == expected.indices()[static_cast<Eigen::Index>(i)]);
    CHECK(order.position[static_cast<std::size_t>(order.row[i])] == static_cast<int>(i));
  }
}

}  // namespace

TEST_CASE("elimination_order: equals Eigen's AMDOrdering, from any triangle") {
  for (const int n : {1, 2, 7, 20}) {
    const sparse a = grid(n), lower = a.triangularView<Eigen::Lower>(), upper = a.triangularView<Eigen::Upper>();
    check_order(a);
    check_order(lower);
    check_order(upper);
  }
  check_order(from(5, 5, {{0, 0, 1.0}, {3, 0, 1.0}, {0, 1, 1.0}, {4, 2, 1.0}, {2, 4, 1.0}, {1, 3, 1.0}, {4, 3, 1.0}}));
  check_order(from(3, 3, {}));
}

TEST_CASE("count_factor_entries: counts the entries of the factor below the diagonal, up to a limit") {
  for (const int n : {1, 2, 7, 20}) {
    const Eigen::SimplicialLDLT<sparse> factors(grid(n));
    detail::elimination_order order;
    order.find(grid(n));
    const auto all = factors.matrixL().nestedExpression().nonZeros();
    CHECK(detail::count_factor_entries(order(grid(n)), all) == all);
    if (all > 0) CHECK(detail::count_factor_entries(order(grid(n)), all - 1) == -1);
  }
}

TEST_CASE("elimination_order: reorders both triangles") {
  const sparse a = grid(7);
  detail::elimination_order order;
  order.find(a);
  const sparse lower = order.lower(a);
  const Eigen::MatrixXd upper(order(a));
  for (int i = 0; i < a.rows(); ++i)
    for (int j = 0; j < a.cols(); ++j) {
      const int p = order.position[static_cast<std::size_t>(i)], q = order.position[static_cast<std::size_t>(j)];
      CHECK(upper(std::min(p, q), std::max(p, q)) == a.coeff(i, j));
      CHECK(lower.coeff(std::max(p, q), std::min(p, q)) == a.coeff(i, j));
    }
  CHECK(lower.nonZeros() == (a.nonZeros() + a.rows()) / 2);
  for (int c = 0; c < lower.cols(); ++c) CHECK(lower.innerIndexPtr()[lower.outerIndexPtr()[c]] == c);
}
