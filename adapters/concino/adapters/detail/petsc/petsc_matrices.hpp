// Matrices whose rows are distributed over processes: sums of entries, products and parts.
#pragma once

#include <concino/adapters/detail/petsc/petsc_calls.hpp>
#include <concino/adapters/detail/petsc/petsc_rows.hpp>

#include <petscmat.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace concino::detail {

using petsc_index_set = petsc_object<IS, ISDestroy>;

/// The square matrix of the entries of all processes. The lists of entries are used up. Collective, as all below.
inline petsc_matrix matrix_of(MPI_Comm communicator, petsc_entries& entries) {
  const petsc_errors errors;
  petsc_matrix a;
  errors.check(MatCreate(communicator, a.address()), "creating the matrix");
  errors.check(MatSetSizes(a, entries.size, entries.size, PETSC_DETERMINE, PETSC_DETERMINE), "creating the matrix");
  errors.check(MatSetType(a, MATAIJ), "creating the matrix");
  errors.check(MatSetPreallocationCOO(a, static_cast<PetscCount>(entries.values.size()), entries.rows.data(),
                                      entries.columns.data()),
               "filling the matrix");
  errors.check(MatSetValuesCOO(a, entries.values.data(), INSERT_VALUES), "filling the matrix");
  return a;
}

inline void copy_to(const petsc_errors& errors, const std::vector<double>& values, Vec vector) {
  PetscScalar* to = nullptr;
  errors.check(VecGetArrayWrite(vector, &to), "filling a vector");
  std::copy(values.begin(), values.end(), to);
  errors.check(VecRestoreArrayWrite(vector, &to), "filling a vector");
}

/// The rows and columns of these numbers, of which each process gives those of its own rows that it keeps, increasing.
inline petsc_matrix submatrix(MPI_Comm communicator, Mat a, const std::vector<PetscInt>& own) {
  const petsc_errors errors;
  petsc_index_set kept;
  petsc_matrix r;
  errors.check(ISCreateGeneral(communicator, static_cast<PetscInt>(own.size()), own.data(), PETSC_COPY_VALUES,
                               kept.address()),
               "selecting rows");
  errors.check(MatCreateSubMatrix(a, kept, kept, MAT_INITIAL_MATRIX, r.address()), "selecting rows");
  return r;
}

/// The product a x; x and the result: the entries of this process.
inline std::vector<double> product(Mat a, const std::vector<double>& x) {
  const petsc_errors errors;
  petsc_vector right, left;
  errors.check(MatCreateVecs(a, right.address(), left.address()), "creating vectors");
  copy_to(errors, x, right);
  errors.check(MatMult(a, right, left), "multiplying");
  std::vector<double> r(x.size());
  const PetscScalar* values = nullptr;
  errors.check(VecGetArrayRead(left, &values), "multiplying");
  std::copy(values, values + r.size(), r.begin());
  errors.check(VecRestoreArrayRead(left, &values), "multiplying");
  return r;
}

/// a (d a)^(n-1), where the diagonal matrix d has these entries in the rows of this process; n is 1 or more.
inline petsc_matrix power(petsc_matrix a, const std::vector<double>& d, int n) {
  const petsc_errors errors;
  if (n == 1) return a;
  petsc_vector scales;
  petsc_matrix scaled;
  errors.check(MatCreateVecs(a, nullptr, scales.address()), "creating vectors");
  copy_to(errors, d, scales);
  errors.check(MatDuplicate(a, MAT_COPY_VALUES, scaled.address()), "copying the matrix");
  errors.check(MatDiagonalScale(scaled, scales, nullptr), "scaling the matrix");
  for (; n > 1; --n) {
    petsc_matrix next;
    errors.check(MatMatMult(a, scaled, MAT_INITIAL_MATRIX, PETSC_DEFAULT, next.address()), "multiplying matrices");
    a = std::move(next);
  }
  return a;
}

}  // namespace concino::detail
