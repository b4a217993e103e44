#include <concino/adapters/metis.hpp>

#include <concino/solve/ldlt.hpp>
#include <concino/solve/llt.hpp>

#include <support/systems.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

using namespace concino;
using namespace systems;

namespace {

bool is_permutation(std::vector<int> order, std::size_t size) {
  std::sort(order.begin(), order.end());
  for (std::size_t i = 0; i < order.size(); ++i)
    if (order[i] != static_cast<int>(i)) return false;
  return order.size() == size;
}

}  // namespace

TEST_CASE("metis: orders matrices of any size, from either triangle") {
  CHECK(metis(sparse(0, 0)).empty());
  CHECK(metis(sparse(3, 3)) == std::vector<int>{0, 1, 2});
  CHECK(metis(from(3, 3, {{0, 0, 1.0}, {1, 1, 1.0}, {2, 2, 1.0}})) == std::vector<int>{0, 1, 2});
  for (const int n : {1, 2, 5, 40}) {
    const sparse a = grid(n), lower = a.triangularView<Eigen::Lower>(), upper = a.triangularView<Eigen::Upper>();
    const std::vector<int> order = metis(a);
    CHECK(is_permutation(order, static_cast<std::size_t>(n * n)));
    CHECK(is_permutation(metis(lower), order.size()));
    CHECK(is_permutation(metis(upper), order.size()));
    CHECK(metis(a) == order);
  }
  CHECK(is_permutation(metis(from(5, 5, {{3, 1, 1.0}, {4, 4, 1.0}})), 5));  // with isolated rows
}

TEST_CASE("metis: ldlt and llt factorise in its order") {
  ldlt by_metis({.ordering = metis});
  check_solver(by_metis, 40);
  llt also({.ordering = metis});
  check_solver(also, 40);
  ldlt automatic;
  automatic.factorize(grid(70));
  by_metis.factorize(grid(70));
  const Eigen::VectorXd b = random_vector(4900);
  CHECK(distance(by_metis.solve(b), automatic.solve(b)) < 1e-11);
}

TEST_CASE("metis: the factor of a large grid is smaller than by minimum degree") {
  const sparse a = grid(300);
  ldlt by_metis({.ordering = metis}), automatic;
  CHECK(by_metis.factorize_within(a, 2'600'000));
  CHECK_FALSE(automatic.factorize_within(a, 2'600'000));
}
