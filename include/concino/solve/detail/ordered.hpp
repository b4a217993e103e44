// A symmetric matrix in an order of elimination that keeps its factor small, and how large that factor is.
#pragma once

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// Orders by approximate minimum degree (Amestoy, Davis, Duff 1996) and keeps the order for further matrices of that pattern.
struct elimination_order {
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> place;  // of each row
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> row;    // at each place

  /// Only the lower triangle of a is read.
  void find(const Eigen::SparseMatrix<double>& a) {
    Eigen::SparseMatrix<double> whole;
    whole = a.selfadjointView<Eigen::Lower>();
    Eigen::AMDOrdering<int> order;
    order(whole, row);
    place = row.inverse();
  }

  /// The upper triangle of the reordered matrix.
  Eigen::SparseMatrix<double> operator()(const Eigen::SparseMatrix<double>& a) const {
    Eigen::SparseMatrix<double> upper(a.rows(), a.cols());
    upper.selfadjointView<Eigen::Upper>() = a.selfadjointView<Eigen::Lower>().twistedBy(place);
    return upper;
  }
};

/// Entries below the diagonal of the factor of a symmetric matrix given by its upper triangle, in its own order; counting ends beyond `most`.
/// Cost:   as many steps as it counts, a small part of a factorisation.
/// Source: Davis, Algorithm 849, 2005.
inline std::int64_t factor_entries(const Eigen::SparseMatrix<double>& upper, std::int64_t most) {
  const auto n = static_cast<std::size_t>(upper.cols());
  std::vector<int> parent(n, -1), seen(n, -1);
  std::int64_t entries = 0;
  for (int c = 0; c < upper.cols() && entries <= most; ++c) {
    seen[static_cast<std::size_t>(c)] = c;
    for (int k = upper.outerIndexPtr()[c]; k < upper.outerIndexPtr()[c + 1]; ++k)
      for (int i = upper.innerIndexPtr()[k]; seen[static_cast<std::size_t>(i)] != c; i = parent[static_cast<std::size_t>(i)]) {
        if (parent[static_cast<std::size_t>(i)] < 0) parent[static_cast<std::size_t>(i)] = c;
        seen[static_cast<std::size_t>(i)] = c;
        ++entries;
      }
  }
  return entries;
}

}  // namespace concino::detail
