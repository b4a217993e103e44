// Elimination orders, by Eigen; see ordered.hpp.
#pragma once

#include <concino/core/error.hpp>
#include <concino/solve/detail/direct/ordered.hpp>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

#include <cstddef>
#include <utility>
#include <vector>

namespace concino::detail {

using eigen_permutation = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>;

CONCINO_INLINE eigen_permutation permutation_of(const std::vector<int>& indices) {
  eigen_permutation p(static_cast<Eigen::Index>(indices.size()));
  for (std::size_t i = 0; i < indices.size(); ++i) p.indices()[static_cast<Eigen::Index>(i)] = indices[i];
  return p;
}

CONCINO_INLINE bool is_permutation(const std::vector<int>& order, std::size_t size) {
  if (order.size() != size) return false;
  std::vector<bool> seen(size);
  for (const int i : order) {
    if (i < 0 || static_cast<std::size_t>(i) >= size || seen[static_cast<std::size_t>(i)]) return false;
    seen[static_cast<std::size_t>(i)] = true;
  }
  return true;
}

CONCINO_INLINE void elimination_order::keep(std::vector<int> row_at) {
  std::vector<int> new_position(row_at.size());
  for (std::size_t i = 0; i < row_at.size(); ++i)
    new_position[static_cast<std::size_t>(row_at[i])] = static_cast<int>(i);
  row.swap(row_at);
  position.swap(new_position);
}

CONCINO_INLINE void elimination_order::find(const Eigen::SparseMatrix<double>& a, elimination_ordering ordering) {
  std::vector<int> row_at;
  if (ordering) {
    row_at = ordering(a);
    if (!is_permutation(row_at, static_cast<std::size_t>(a.cols())))
      throw invalid_argument("the elimination ordering of a solver returned no permutation of its rows");
  } else {
    eigen_permutation order;
    Eigen::AMDOrdering<int>()(a, order);
    row_at.assign(order.indices().data(), order.indices().data() + a.cols());
  }
  keep(std::move(row_at));
}

CONCINO_INLINE Eigen::SparseMatrix<double> elimination_order::operator()(const Eigen::SparseMatrix<double>& a) const {
  Eigen::SparseMatrix<double> r(a.rows(), a.cols());
  r.selfadjointView<Eigen::Upper>() = a.selfadjointView<Eigen::Lower>().twistedBy(permutation_of(position));
  return r;
}

CONCINO_INLINE Eigen::SparseMatrix<double> elimination_order::lower(const Eigen::SparseMatrix<double>& a) const {
  const Eigen::SparseMatrix<double> upper = (*this)(a);
  Eigen::SparseMatrix<double> r;
  r = upper.transpose();  // which sorts
  return r;
}

}  // namespace concino::detail
