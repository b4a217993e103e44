#include <concino/solve/detail/multigrid/cancelling_rows.hpp>

#include <support/systems.hpp>

#include <cmath>
#include <cstddef>
#include <vector>

using namespace systems;
using concino::detail::cancelling_rows;
using concino::detail::prolongation;

namespace {

/// Squared second differences in a row of n numbers, a bent beam: rows 1 -4 6 -4 1.
sparse beam(int n) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int k = 1; k + 1 < n; ++k)
    for (int i = -1; i <= 1; ++i)
      for (int j = -1; j <= i; ++j) entries.emplace_back(k + i, k + j, (i == 0 ? -2.0 : 1.0) * (j == 0 ? -2.0 : 1.0));
  return from(n, n, entries);
}

/// Threes in a row are one aggregate each.
prolongation threes(int n) {
  prolongation p;
  p.columns = n / 3;
  for (int i = 0; i <= n; ++i) p.begin.push_back(i);
  for (int i = 0; i < n; ++i) p.column.push_back(i / 3);
  p.weight.assign(static_cast<std::size_t>(n), 1);
  return p;
}

}  // namespace

TEST_CASE("cancelling_rows: rows of a beam are found, those of a Laplacian are not") {
  const sparse bent = beam(30), even = grid(6).triangularView<Eigen::Lower>();
  const cancelling_rows some(bent), none(even);
  for (std::size_t i = 0; i < 30; ++i) CHECK(some.contains(i));
  for (std::size_t i = 0; i < 36; ++i) CHECK_FALSE(none.contains(i));
  CHECK_FALSE(cancelling_rows::pay_for(beam(30)));  // few entries in a row
}

TEST_CASE("cancelling_rows: constants are interpolated exactly, and values in proportion to the number nearly") {
  const int n = 90;
  const sparse a = beam(n);
  const prolongation p = cancelling_rows(a).smooth(threes(n), 100000);
  REQUIRE(p.columns == 30);
  for (int i = 9; i < n - 9; ++i) {
    double sum = 0, line = 0;
    for (auto k = static_cast<std::size_t>(p.begin[static_cast<std::size_t>(i)]); k < static_cast<std::size_t>(p.begin[static_cast<std::size_t>(i) + 1]); ++k) {
      sum += static_cast<double>(p.weight[k]);
      line += static_cast<double>(p.weight[k]) * (3 * p.column[k] + 1);
    }
    CHECK(sum == 1);
    CHECK(std::abs(line - i) < 0.3);  // 1 without smoothing
  }
}

TEST_CASE("cancelling_rows: too many entries yield an empty result, other rows stay as they are") {
  const sparse bent = beam(90), even = grid(6).triangularView<Eigen::Lower>();
  CHECK(cancelling_rows(bent).smooth(threes(90), 100).columns == 0);
  const prolongation before = threes(36), after = cancelling_rows(even).smooth(before, 1000);
  CHECK(after.column == before.column);
  CHECK(after.weight == before.weight);
}
