#include <concino/solve/detail/sorted_columns.hpp>

#include <support/systems.hpp>

#include <random>
#include <vector>

using namespace systems;

namespace {

/// A square matrix with its columns in any order, some entries twice, and a column of `longest` entries. sum: the same matrix by Eigen.
sparse unsorted(int n, int longest, sparse& sum) {
  std::mt19937 random(5);
  std::vector<Eigen::Triplet<double>> entries;
  sparse a(n, n);
  a.resizeNonZeros(3 * (n - 1) + longest);
  int size = 0;
  for (int c = 0; c < n; ++c) {
    for (int k = 0; k < (c == 1 ? longest : 3); ++k) {
      const int row = static_cast<int>(random() % static_cast<unsigned>(n));
      a.innerIndexPtr()[size] = row;
      a.valuePtr()[size++] = 1 + c + k;
      entries.emplace_back(row, c, 1 + c + k);
    }
    a.outerIndexPtr()[c + 1] = size;
  }
  sum = from(n, n, entries);
  return a;
}

}  // namespace

TEST_CASE("sorted_columns: sorting and adding up yields the matrix of the same entries, with short and long columns") {
  for (const int longest : {3, 40, 3000}) {
    sparse expected, a = unsorted(100, longest, expected);
    concino::detail::sort_columns(a);
    for (int c = 0; c < 100; ++c)
      for (int k = a.outerIndexPtr()[c] + 1; k < a.outerIndexPtr()[c + 1]; ++k) CHECK(a.innerIndexPtr()[k - 1] <= a.innerIndexPtr()[k]);
    concino::detail::add_up_equal_rows(a);
    CHECK(a.nonZeros() == expected.nonZeros());
    CHECK((a - expected).norm() == 0);
  }
}

TEST_CASE("sorted_columns: the transpose of a matrix with any columns is sorted") {
  sparse expected, a = unsorted(50, 20, expected);
  concino::detail::add_up_equal_rows(a);  // equal rows that are neighbours only
  const sparse t = concino::detail::sorted_transpose(a);
  for (int c = 0; c < 50; ++c)
    for (int k = t.outerIndexPtr()[c] + 1; k < t.outerIndexPtr()[c + 1]; ++k) CHECK(t.innerIndexPtr()[k - 1] <= t.innerIndexPtr()[k]);
  sparse sum = t;
  concino::detail::add_up_equal_rows(sum);
  CHECK((sum - sparse(expected.transpose())).norm() == 0);
}
