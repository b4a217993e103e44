#include <concino/core/product.hpp>

#include <doctest/doctest.h>

#include <Eigen/Dense>

#include <random>
#include <vector>

using namespace concino;

namespace {

Eigen::SparseMatrix<double> random_matrix(std::mt19937& random, int rows, int columns) {
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(rows, columns);
  for (int k = 0; k < rows * columns / 2; ++k)
    a(static_cast<int>(random() % static_cast<unsigned>(rows)), static_cast<int>(random() % static_cast<unsigned>(columns))) = 1.0 + static_cast<int>(random() % 9);
  return a.sparseView();
}

void check_sorted(const Eigen::SparseMatrix<double>& a) {
  REQUIRE(a.isCompressed());
  for (int c = 0; c < a.cols(); ++c)
    for (int k = a.outerIndexPtr()[c] + 1; k < a.outerIndexPtr()[c + 1]; ++k) REQUIRE(a.innerIndexPtr()[k - 1] < a.innerIndexPtr()[k]);
}

}  // namespace

TEST_CASE("with_both_triangles, scaled_product: agree with dense matrices, and rows are sorted") {
  std::mt19937 random(3);
  for (int round = 0; round < 100; ++round) {
    const int rows = 1 + static_cast<int>(random() % 6), between = 1 + static_cast<int>(random() % 6), columns = 1 + static_cast<int>(random() % 6);
    const auto a = random_matrix(random, rows, between), b = random_matrix(random, between, columns);
    std::vector<double> d;
    Eigen::VectorXd factors(between);
    for (int i = 0; i < between; ++i) d.push_back(factors[i] = static_cast<int>(random() % 5) - 2);
    const auto product = scaled_product(a, d, b);
    check_sorted(product);
    CHECK(Eigen::MatrixXd(product) == Eigen::MatrixXd(a) * factors.asDiagonal() * Eigen::MatrixXd(b));

    const auto square = random_matrix(random, rows, rows);
    const Eigen::SparseMatrix<double> lower = square.triangularView<Eigen::Lower>();
    const auto whole = with_both_triangles(lower);
    check_sorted(whole);
    CHECK(Eigen::MatrixXd(whole) == Eigen::MatrixXd(Eigen::MatrixXd(lower).selfadjointView<Eigen::Lower>()));
  }
}

TEST_CASE("with_both_triangles, scaled_product: handle empty matrices, cancellation and wrong sizes") {
  CHECK(with_both_triangles(Eigen::SparseMatrix<double>(0, 0)).cols() == 0);
  CHECK(scaled_product(Eigen::SparseMatrix<double>(2, 0), {}, Eigen::SparseMatrix<double>(0, 3)).cols() == 3);
  Eigen::SparseMatrix<double> row(1, 2), column(2, 1);
  row.insert(0, 0) = row.insert(0, 1) = column.insert(0, 0) = column.insert(1, 0) = 1;
  CHECK_THROWS_WITH_AS(scaled_product(row, {1, 1}, column), "scaled_product: a matrix is not compressed; call makeCompressed()", invalid_argument);
  row.makeCompressed();
  CHECK_THROWS_AS(scaled_product(row, {1, 1}, column), invalid_argument);
  column.makeCompressed();
  const auto cancelled = scaled_product(row, {1, -1}, column);
  CHECK(cancelled.nonZeros() == 1);
  CHECK(cancelled.coeff(0, 0) == 0);
  CHECK_THROWS_WITH_AS(scaled_product(row, {1}, column), "scaled_product: there are 2 columns of a, 1 factors and 2 rows of b; the numbers must be equal", invalid_argument);
  CHECK_THROWS_AS(scaled_product(row, {1, 1}, row), invalid_argument);
  CHECK_THROWS_WITH_AS(with_both_triangles(row), "with_both_triangles: the matrix is not square", invalid_argument);
  Eigen::SparseMatrix<double> loose(2, 2);
  loose.insert(0, 0) = 1;
  CHECK_THROWS_WITH_AS(with_both_triangles(loose), "with_both_triangles: a matrix is not compressed; call makeCompressed()", invalid_argument);
}
