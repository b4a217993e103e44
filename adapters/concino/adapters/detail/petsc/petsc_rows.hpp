// The rows of a sparse matrix that one process hands to PETSc.
#pragma once

#include <concino/core/number_text.hpp>
#include <concino/core/system_checks.hpp>

#include <Eigen/SparseCore>

#include <petscsys.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace concino::detail {

/// The entries of rows first, first + 1, ...; columns count in the whole matrix, and are sorted in each row.
struct petsc_rows {
  PetscInt first = 0;
  std::vector<PetscInt> starts = {0};
  std::vector<PetscInt> columns = {};
  std::vector<double> values = {};

  PetscInt size() const { return static_cast<PetscInt>(starts.size()) - 1; }
};

/// Entries anywhere in the matrix, of which this process has the rows first, first + 1, ..., first + size - 1. Those of
/// one place are summed.
struct petsc_entries {
  PetscInt first = 0, size = 0;
  std::vector<PetscInt> rows = {}, columns = {};
  std::vector<double> values = {};
};

/// Rows first to last - 1 of a compressed matrix.
inline petsc_rows rows_of(const Eigen::SparseMatrix<double>& a, int first, int last) {
  petsc_rows r;
  r.first = first;
  const int *starts = a.outerIndexPtr(), *rows = a.innerIndexPtr();
  std::vector<PetscInt> next(static_cast<std::size_t>(last - first) + 1);
  for (int k = 0; k < starts[a.outerSize()]; ++k)
    if (rows[k] >= first && rows[k] < last) ++next[static_cast<std::size_t>(rows[k] - first) + 1];
  for (std::size_t i = 1; i < next.size(); ++i) next[i] += next[i - 1];
  r.starts = next;
  r.columns.resize(static_cast<std::size_t>(next.back()));
  r.values.resize(r.columns.size());
  for (int c = 0; c < a.outerSize(); ++c)
    for (int k = starts[c]; k < starts[c + 1]; ++k) {
      if (rows[k] < first || rows[k] >= last) continue;
      const auto at = static_cast<std::size_t>(next[static_cast<std::size_t>(rows[k] - first)]++);
      r.columns[at] = c;
      r.values[at] = a.valuePtr()[k];
    }
  return r;
}

/// Errors: solver_error if one of these rows of a differs from the column of the same number by more than rounding, or
///         has no positive diagonal entry.
inline void check_symmetric_definite(const petsc_rows& r, const Eigen::SparseMatrix<double>& a) {
  const std::vector<double> diagonal = core::diagonal(a);
  for (PetscInt i = 0; i < r.size(); ++i) {
    const int row = static_cast<int>(r.first + i);
    if (const double d = diagonal[static_cast<std::size_t>(row)]; !(d > 0))
      throw core::singular_row(core::joined({"petsc: the matrix is not positive definite: the diagonal entry of row ",
                                             static_cast<std::size_t>(row), " is ", core::number_text(d)}),
                               row);
    const auto begin = static_cast<std::size_t>(r.starts[static_cast<std::size_t>(i)]),
               end = static_cast<std::size_t>(r.starts[static_cast<std::size_t>(i) + 1]);
    const int* column = a.innerIndexPtr() + a.outerIndexPtr()[row];
    const double* value = a.valuePtr() + a.outerIndexPtr()[row];
    double largest = 0;
    for (std::size_t k = begin; k < end; ++k) largest = std::max(largest, std::abs(r.values[k]));
    bool is_equal = static_cast<std::size_t>(a.outerIndexPtr()[row + 1] - a.outerIndexPtr()[row]) == end - begin;
    for (std::size_t k = begin; is_equal && k < end; ++k, ++column, ++value)
      is_equal = r.columns[k] == *column && std::abs(r.values[k] - *value) <= 1e-10 * largest;
    if (!is_equal)
      core::throw_joined<solver_error>({"petsc: the matrix is not symmetric: row and column ",
                                        static_cast<std::size_t>(row),
                                        " differ; pass both triangles, or set system to petsc_system::general"});
  }
}

/// Errors: solver_error if one of these rows is 0.
inline void check_no_row_is_zero(const petsc_rows& r) {
  for (std::size_t i = 0; i + 1 < r.starts.size(); ++i) {
    bool is_zero = true;
    for (PetscInt k = r.starts[i]; k < r.starts[i + 1]; ++k)
      is_zero = is_zero && r.values[static_cast<std::size_t>(k)] == 0;
    if (is_zero)
      core::throw_joined<solver_error>(
          {"petsc: the matrix is singular: row ", static_cast<std::size_t>(r.first) + i, " is 0"});
  }
}

}  // namespace concino::detail
