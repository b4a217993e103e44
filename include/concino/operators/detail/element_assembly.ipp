// Compressed columns of matrices over polys; see element_assembly.hpp.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/product.hpp>
#include <concino/operators/detail/element_assembly.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace concino::detail {

CONCINO_INLINE pattern_builder::pattern_builder(std::size_t size) {
  if (size >= static_cast<std::size_t>(std::numeric_limits<int>::max()))
    throw unsupported("assembly: the matrix would have more rows than its 32-bit indices can count");
  seen_in_.assign(size, -1);
  rows_.reserve(4 * size);
  begin_.assign(size, 0);
  end_.assign(size, 0);
}

CONCINO_INLINE void pattern_builder::begin_column(std::size_t i) {
  column_ = static_cast<int>(i);
  begin_[i] = rows_.size();
  rows_.push_back(column_);
}

CONCINO_INLINE void pattern_builder::add_new(int row) {
  seen_in_[static_cast<std::size_t>(row)] = column_;
  rows_.push_back(row);
}

CONCINO_INLINE void pattern_builder::end_column() {
  const auto i = static_cast<std::size_t>(column_);
  std::sort(rows_.data() + begin_[i], rows_.data() + rows_.size());
  end_[i] = rows_.size();
}

CONCINO_INLINE void pattern_builder::finish(Eigen::SparseMatrix<double>& a) const {
  const std::size_t size = seen_in_.size();
  if (rows_.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    throw unsupported("assembly: the matrix would have more entries than its 32-bit indices can count");
  a.resize(static_cast<Eigen::Index>(size), static_cast<Eigen::Index>(size));
  a.resizeNonZeros(static_cast<Eigen::Index>(rows_.size()));
  int at = 0;
  for (std::size_t i = 0; i < size; ++i) {  // verts may come in any order
    std::copy(rows_.begin() + static_cast<std::ptrdiff_t>(begin_[i]),
              rows_.begin() + static_cast<std::ptrdiff_t>(end_[i]), a.innerIndexPtr() + at);
    at += static_cast<int>(end_[i] - begin_[i]);
    a.outerIndexPtr()[i + 1] = at;
  }
  std::fill_n(a.valuePtr(), at, 0.0);
}

CONCINO_INLINE void add_local(const std::vector<int>& index, const double* entries, Eigen::SparseMatrix<double>& a) {
  const int *const begin = a.outerIndexPtr(), *const rows = a.innerIndexPtr();
  for (std::size_t i = 0; i < index.size(); ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      const int row = std::max(index[i], index[j]), column = std::min(index[i], index[j]);
      const int* const at = std::lower_bound(rows + begin[column], rows + begin[column + 1], row);
      a.valuePtr()[at - rows] += *entries++;
    }
}

CONCINO_INLINE Eigen::SparseMatrix<double> with_constants_in_kernel(const Eigen::SparseMatrix<double>& lower,
                                                                    double sign) {
  Eigen::SparseMatrix<double> a = with_both_triangles(lower);
  for (int c = 0; c < a.cols(); ++c) {
    double sum = 0;
    int diagonal = -1;
    for (int k = a.outerIndexPtr()[c]; k < a.outerIndexPtr()[c + 1]; ++k) {
      if (a.innerIndexPtr()[k] == c) diagonal = k;
      else sum += a.valuePtr()[k] *= sign;
    }
    if (diagonal >= 0) a.valuePtr()[diagonal] = 0 - sum;
  }
  return a;
}

}  // namespace concino::detail
