#include <concino/solve/detail/iterative/penalty_rows.hpp>

#include <support/systems.hpp>

#include <doctest/doctest.h>


using namespace systems;
using concino::detail::penalty_rows;

namespace {

/// The lower triangle of a grid of 20 x 20 verts whose first rows have penalties.
sparse with_penalties(int number, double penalty) {
  sparse a = grid(20, 0);
  for (int i = 0; i < number; ++i) a.coeffRef(i, i) += penalty;
  return a.triangularView<Eigen::Lower>();
}

}  // namespace

TEST_CASE("penalty_rows: the energy is that without penalties, however large they are") {
  const Eigen::VectorXd x = random_vector(400), y = random_vector(400, 8);
  const double expected = x.dot(grid(20, 0) * x);
  for (const double penalty : {1e3, 1e9, 1e15}) {
    const sparse a = with_penalties(30, penalty);
    const penalty_rows rows(a);
    CHECK(rows.any());
    CHECK(rows.energy_of_rest(x) == doctest::Approx(expected));
    CHECK(rows.product_of_rest(x, y) == doctest::Approx(x.tail(370).dot(y.tail(370))));
  }
}

TEST_CASE("penalty_rows: rows without entries off the diagonal have no energy; where all rows are alike, none is a penalty") {
  for (const double penalty : {0.0, 1.0, 15.0}) {
    const sparse a = with_penalties(400, penalty);
    CHECK(!penalty_rows(a).any());
  }
  for (const double more : {100.0, 1e6}) {
    const sparse a = with_penalties(400, more);
    CHECK(!penalty_rows(a).any());
  }
  const sparse mixed = from(3, 3, {{0, 0, 5.0}, {1, 1, 2.0}, {2, 1, -1.0}, {2, 2, 2.0}});
  const penalty_rows rows(mixed);
  CHECK(rows.any());
  CHECK(rows.energy_of_rest(Eigen::Vector3d(7, 1, 2)) == doctest::Approx(2 + 8 - 4));
  CHECK(penalty_rows(sparse(0, 0)).any() == false);
}

TEST_CASE("penalty_rows: energy that is only rounding errors is not taken for 0") {
  const sparse a = with_penalties(1, 1e6);
  const penalty_rows rows(a);
  const double constant = rows.energy_of_rest(Eigen::VectorXd::Constant(400, 3));
  CHECK(constant > 0);
  CHECK(constant < 1e-6);
  CHECK(rows.energy_of_rest(Eigen::VectorXd::Zero(400)) == 0);
}
