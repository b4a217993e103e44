#include <concino/solve/detail/multigrid/coarse_matrix.hpp>

#include <support/systems.hpp>

#include <cstddef>
#include <vector>

using namespace systems;
using concino::detail::aggregates;
using concino::detail::coarse_matrix;
using concino::detail::prolongation;

namespace {

sparse as_matrix(const prolongation& p) {
  std::vector<Eigen::Triplet<double>> entries;
  const auto rows = static_cast<int>(p.begin.size()) - 1;
  for (int i = 0; i < rows; ++i)
    for (int k = p.begin[static_cast<std::size_t>(i)]; k < p.begin[static_cast<std::size_t>(i) + 1]; ++k)
      entries.emplace_back(i, p.column[static_cast<std::size_t>(k)], static_cast<double>(p.weight[static_cast<std::size_t>(k)]));
  return from(rows, p.columns, entries);
}

}  // namespace

TEST_CASE("coarse_matrix: is the lower triangle of the product with the interpolation on both sides, with sorted columns") {
  for (const int n : {5, 20}) {
    const sparse a = grid(n, 1e-2), lower = a.triangularView<Eigen::Lower>();
    const aggregates groups(lower);
    for (const prolongation& p : {groups.piecewise_constant(), groups.smoothed(100000)}) {
      bool has_kernel = false;
      const sparse coarse = coarse_matrix(lower, p, has_kernel), q = as_matrix(p), product = q.transpose() * a * q;
      const sparse expected = product.triangularView<Eigen::Lower>();
      CHECK((coarse - expected).norm() < 1e-14 * expected.norm());
      CHECK_FALSE(has_kernel);
      for (int c = 0; c < coarse.cols(); ++c) {
        CHECK(coarse.innerIndexPtr()[coarse.outerIndexPtr()[c]] == c);
        for (int k = coarse.outerIndexPtr()[c] + 1; k < coarse.outerIndexPtr()[c + 1]; ++k)
          CHECK(coarse.innerIndexPtr()[k - 1] < coarse.innerIndexPtr()[k]);
      }
    }
  }
}

TEST_CASE("coarse_matrix: a kernel vector is found, and its diagonal entry is positive") {
  const sparse a = grid(4, 0), lower = a.triangularView<Eigen::Lower>();
  prolongation constant;
  constant.columns = 1;
  for (int i = 0; i <= 16; ++i) constant.begin.push_back(i);
  constant.column.assign(16, 0);
  constant.weight.assign(16, 1);
  bool has_kernel = false;
  const sparse coarse = coarse_matrix(lower, constant, has_kernel);
  CHECK(has_kernel);
  CHECK(coarse.coeff(0, 0) > 0);
}
