// Grids of which each process makes a block, compared with those that the first process makes and divides.
#include <concino/adapters/distributed_generate.hpp>

#include <concino/generate/grid.hpp>

#include <support/distributed.hpp>
#include <support/distributed_comparison.hpp>
#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

using namespace concino;
using namespace concino::testing;
using namespace distributed_tests;

TEST_CASE_TEMPLATE("make_distributed_grid: the same as make_grid, divided", M, CONCINO_ALL_KINDS) {
  // thin, with fewer cells than processes, and with odd and even numbers of rows
  for (const std::array<std::size_t, 3>& cells : std::vector<std::array<std::size_t, 3>>{{1, 1, 1}, {5, 4, 3}, {2, 7, 4}, {1, 1, 9}}) {
    CAPTURE(cells[0]);
    const grid_options options{.cells = cells, .min = {0.1, -1, 3}, .max = {0.7, 5, 11}};
    check_same(make_distributed_grid<M>(MPI_COMM_WORLD, options), make_grid<M>(options));
  }
}

TEST_CASE_TEMPLATE("make_distributed_grid: blocks are nearly equal", M, CONCINO_ALL_KINDS) {
  const auto n = static_cast<std::size_t>(number_of_processes());
  const auto d = make_distributed_grid<M>(MPI_COMM_WORLD, {.cells = {56, 12, 10}});
  std::size_t own = 0;
  for (const auto p : polys(d)) own += !d.is_ghost(p);
  const double average = static_cast<double>(d.num_global_polys()) / static_cast<double>(n);
  // all numbers of processes divide 56; hexagons of odd rows have halves at their ends
  CHECK(static_cast<double>(own) >= 0.9 * average);
  CHECK(static_cast<double>(own) <= 1.1 * average);
}

TEST_CASE("make_distributed_grid: divides the longest axis first") {
  using concino::detail::grid_division;
  const auto block = [](std::array<std::size_t, 3> cells, std::size_t axes, std::size_t n, std::size_t i) {
    const auto b = grid_division(cells, axes, n).block(i);
    return std::array{b.size(0), b.size(1), b.size(2)};
  };
  using size = std::array<std::size_t, 3>;
  CHECK(block({8, 8, 8}, 3, 8, 7) == size{4, 4, 4});
  CHECK(block({100, 10, 10}, 3, 8, 0) == size{12, 10, 10});
  CHECK(block({100, 10, 10}, 3, 8, 7) == size{13, 10, 10});
  CHECK(block({6, 6, 100}, 2, 6, 0) == size{2, 3, 100});  // a surface has no z
  CHECK(block({10, 4, 4}, 3, 7, 3) == size{1, 4, 4});
  CHECK(block({1, 1, 1}, 3, 2, 0) == size{0, 1, 1});
}

TEST_CASE("make_distributed_grid: errors are those of make_grid, on all processes") {
  CHECK_THROWS_AS(make_distributed_grid<quadmesh>(MPI_COMM_WORLD, {.cells = {0, 1, 1}}), invalid_argument);
  CHECK_THROWS_AS(make_distributed_grid<polygonmesh>(MPI_COMM_WORLD, {.max = {0, 1, 1}}), invalid_argument);
  CHECK_THROWS_AS(make_distributed_grid<hexmesh>(MPI_COMM_WORLD, {.min = {std::numeric_limits<double>::quiet_NaN(), 0, 0}}), invalid_argument);
  CHECK_THROWS_AS(make_distributed_grid<tetmesh>(MPI_COMM_WORLD, {.cells = {4000, 4000, 4000}}), invalid_argument);
}
