#include <concino/solve/detail/sparse_factor.hpp>

#include <concino/solve/detail/ordered.hpp>

#include <doctest/doctest.h>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>

#include <limits>

#include <support/systems.hpp>

using namespace concino;
using namespace systems;

namespace {

void check_same(const sparse& a, const sparse& b) {
  REQUIRE(a.cols() == b.cols());
  REQUIRE(a.nonZeros() == b.nonZeros());
  for (Eigen::Index i = 0; i <= a.cols(); ++i) CHECK(a.outerIndexPtr()[i] == b.outerIndexPtr()[i]);
  for (Eigen::Index k = 0; k < a.nonZeros(); ++k) {
    CHECK(a.innerIndexPtr()[k] == b.innerIndexPtr()[k]);
    CHECK(a.valuePtr()[k] == b.valuePtr()[k]);
  }
}

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

TEST_CASE("sparse_factor: equals Eigen's SimplicialLDLT in the same order to the last bit") {
  for (const int n : {1, 2, 7, 20}) {
    detail::elimination_order order;
    order.find(grid(n));
    detail::sparse_factor factor;
    for (const double more : {0.5, 0.5, 2.0, -0.7}) {
      const sparse upper = order(grid(n, more));
      const Eigen::SimplicialLDLT<sparse, Eigen::Upper, Eigen::NaturalOrdering<int>> expected(upper);
      REQUIRE(factor.analyse(upper, std::numeric_limits<std::int64_t>::max()));
      factor.factorize(upper);
      check_same(factor.lower(), expected.matrixL().nestedExpression());
      REQUIRE(static_cast<Eigen::Index>(factor.pivots().size()) == upper.cols());
      const Eigen::VectorXd d = expected.vectorD();
      for (Eigen::Index i = 0; i < d.size(); ++i) CHECK(factor.pivots()[static_cast<std::size_t>(i)] == d[i]);
    }
  }
}

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
