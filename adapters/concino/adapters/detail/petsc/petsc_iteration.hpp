// A linear system whose rows are distributed over processes, and PETSc's iteration for it.
#pragma once

#include <concino/adapters/detail/mpi/mpi_agreement.hpp>
#include <concino/adapters/detail/petsc/petsc_calls.hpp>
#include <concino/adapters/detail/petsc/petsc_default_options.hpp>
#include <concino/adapters/detail/petsc/petsc_preconditioner.hpp>
#include <concino/adapters/detail/petsc/petsc_report.hpp>
#include <concino/adapters/detail/petsc/petsc_rows.hpp>
#include <concino/adapters/detail/petsc/petsc_unused_options.hpp>
#include <concino/adapters/petsc_options.hpp>
#include <concino/core/number_text.hpp>
#include <concino/core/system_checks.hpp>

#include <petscksp.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace concino::detail {

/// Factorises and solves. Every function is collective. The matrix and the right-hand side are scaled by powers of two,
/// so that PETSc's absolute tolerances mean the same in all units.
class petsc_iteration {
  petsc_options options_;
  double scale_ = 1, tolerance_ = 0;
  petsc_matrix matrix_;
  petsc_krylov krylov_;
  petsc_vector solution_, right_, rest_;
  std::vector<std::string> unused_;

 public:
  explicit petsc_iteration(const petsc_options& options) : options_(options) {
    check_petsc_is_running();
    if (!(options.tolerance > 0 && options.tolerance < 1))
      core::throw_joined<invalid_argument>(
          {"petsc: tolerance is ", core::number_text(options.tolerance), "; it must be in (0, 1)"});
    if (options.max_iterations < 0) throw invalid_argument("petsc: max_iterations is negative");
    const std::string& p = options.prefix;
    if (!p.empty() && (p.front() == '-' || p.back() != '_'))
      core::throw_joined<invalid_argument>({"petsc: prefix is \"", p, "\"; it must begin without - and end in _"});
  }

  const petsc_options& options() const { return options_; }
  const std::vector<std::string>& unused_options() const { return unused_; }

  /// rows: those of this process, numbered on from those of the processes before it.
  void factorize(const petsc_rows& rows) {
    const petsc_errors errors;
    double largest = 0;
    for (const double value : rows.values) largest = std::max(largest, std::abs(value));
    (MPI_Allreduce)(MPI_IN_PLACE, &largest, 1, MPI_DOUBLE, MPI_MAX, options_.communicator);
    scale_ = core::power_of_two_to_scale(largest);
    std::vector<double> values = rows.values;
    for (double& value : values) value *= scale_;
    errors.check(MatCreate(options_.communicator, matrix_.address()), "creating the matrix");
    errors.check(MatSetSizes(matrix_, rows.size(), rows.size(), PETSC_DETERMINE, PETSC_DETERMINE),
                 "creating the matrix");
    errors.check(MatSetType(matrix_, MATAIJ), "creating the matrix");
    // each does nothing for matrices of the other type
    errors.check(MatSeqAIJSetPreallocationCSR(matrix_, rows.starts.data(), rows.columns.data(), values.data()),
                 "filling the matrix");
    errors.check(MatMPIAIJSetPreallocationCSR(matrix_, rows.starts.data(), rows.columns.data(), values.data()),
                 "filling the matrix");
    prepare(errors, rows.first, rows.size());
  }
  /// matrix: square, on all processes of the communicator.
  void factorize(petsc_matrix matrix) {
    const petsc_errors errors;
    PetscReal largest = 0;
    PetscInt first = 0, end = 0;
    errors.check(MatNorm(matrix, NORM_INFINITY, &largest), "scaling the matrix");
    errors.check(MatGetOwnershipRange(matrix, &first, &end), "scaling the matrix");
    scale_ = core::power_of_two_to_scale(largest);
    errors.check(MatScale(matrix, scale_), "scaling the matrix");
    matrix_ = std::move(matrix);
    prepare(errors, first, end - first);
  }

  /// b: the entries of this process. Returns those of the solution, and says how it was reached.
  std::vector<double> solve(const double* b, petsc_report& r) const {
    const petsc_errors errors;
    r = {};
    PetscInt size = 0;
    errors.check(VecGetLocalSize(right_, &size), "solving");
    double largest = 0;
    for (PetscInt i = 0; i < size; ++i) largest = std::max(largest, std::abs(b[i]));
    (MPI_Allreduce)(MPI_IN_PLACE, &largest, 1, MPI_DOUBLE, MPI_MAX, options_.communicator);
    std::vector<double> x(static_cast<std::size_t>(size));
    if (!(largest > 0)) return x;
    const double b_scale = core::power_of_two_to_scale(largest);
    PetscScalar* values = nullptr;
    errors.check(VecGetArrayWrite(right_, &values), "solving");
    for (PetscInt i = 0; i < size; ++i) values[i] = b[i] * b_scale;
    errors.check(VecRestoreArrayWrite(right_, &values), "solving");
    iterate(errors, r);
    const PetscScalar* result = nullptr;
    errors.check(VecGetArrayRead(solution_, &result), "solving");
    for (PetscInt i = 0; i < size; ++i) x[static_cast<std::size_t>(i)] = result[i] * scale_ / b_scale;
    errors.check(VecRestoreArrayRead(solution_, &result), "solving");
    return x;
  }

  /// The tolerance, which the database of options may override.
  double tolerance() const { return tolerance_; }
  /// Whether the preconditioner is a factor of the whole matrix, by the options or the database.
  bool is_factorised() const {
    const petsc_errors errors;
    PC preconditioner = nullptr;
    PetscBool is_cholesky = PETSC_FALSE, is_lu = PETSC_FALSE;
    errors.check(KSPGetPC(krylov_, &preconditioner), "reading the options");
    errors.check(PetscObjectTypeCompare(reinterpret_cast<PetscObject>(preconditioner), PCCHOLESKY, &is_cholesky),
                 "reading the options");
    errors.check(PetscObjectTypeCompare(reinterpret_cast<PetscObject>(preconditioner), PCLU, &is_lu),
                 "reading the options");
    return is_cholesky || is_lu;
  }

 private:
  void prepare(const petsc_errors& errors, PetscInt first, PetscInt size) {
    if (options_.system == petsc_system::symmetric_definite)
      errors.check(MatSetOption(matrix_, MAT_SPD, PETSC_TRUE), "filling the matrix");
    errors.check(MatCreateVecs(matrix_, solution_.address(), right_.address()), "creating vectors");
    errors.check(VecDuplicate(right_, rest_.address()), "creating vectors");
    set_near_null_space(errors, first, size);
    krylov_.reset();
    errors.check(KSPCreate(options_.communicator, krylov_.address()), "creating the solver");
    {
      const petsc_default_options defaults(options_.prefix);
      errors.check(set_options(krylov_, matrix_, options_), "setting its options");
      compute_preconditioner(errors, krylov_, matrix_, options_);
    }
    PetscReal tolerance = 0;
    errors.check(KSPGetTolerances(krylov_, &tolerance, nullptr, nullptr, nullptr), "setting its options");
    tolerance_ = tolerance;
    unused_ = find_unused_options(errors, options_.prefix);
    if (!options_.accept_unused_options) check_unused_options(unused_);
  }

  /// PETSc wants orthonormal vectors.
  void set_near_null_space(const petsc_errors& errors, PetscInt first, PetscInt size) {
    const std::vector<Eigen::VectorXd>& given = options_.near_null_space;
    if (given.empty()) return;
    std::vector<petsc_vector> owners(given.size());
    std::vector<Vec> vectors;
    for (std::size_t k = 0; k < given.size(); ++k) {
      errors.check(VecDuplicate(solution_, owners[k].address()), "the near-null space");
      PetscScalar* values = nullptr;
      errors.check(VecGetArrayWrite(owners[k], &values), "the near-null space");
      for (PetscInt i = 0; i < size; ++i) values[i] = given[k][static_cast<Eigen::Index>(first + i)];
      errors.check(VecRestoreArrayWrite(owners[k], &values), "the near-null space");
      PetscReal before = 0, after = 0;
      errors.check(VecNorm(owners[k], NORM_2, &before), "the near-null space");
      for (int twice = 0; twice < 2; ++twice)
        for (const Vec other : vectors) {
          PetscScalar product = 0;
          errors.check(VecDot(owners[k], other, &product), "the near-null space");
          errors.check(VecAXPY(owners[k], -product, other), "the near-null space");
        }
      errors.check(VecNormalize(owners[k], &after), "the near-null space");
      if (!(after > 1e-10 * before))
        core::throw_joined<invalid_argument>(
            {"petsc: vector ", k, " of near_null_space is not finite, 0, or depends on those before it"});
      vectors.push_back(owners[k]);
    }
    petsc_null_space space;
    errors.check(MatNullSpaceCreate(options_.communicator, PETSC_FALSE, static_cast<PetscInt>(vectors.size()),
                                    vectors.data(), space.address()),
                 "the near-null space");
    errors.check(MatSetNearNullSpace(matrix_, space), "the near-null space");
  }

  /// Continues from the solution so far while that halves the residual: the iteration only estimates it.
  void iterate(const petsc_errors& errors, petsc_report& r) const {
    PetscReal of_right = 0;
    errors.check(VecNorm(right_, NORM_2, &of_right), "solving");
    r.has_converged = false;
    for (double before = 2;; before = r.residual) {
      PetscInt iterations = 0;
      errors.check(KSPSetInitialGuessNonzero(krylov_, before < 2 ? PETSC_TRUE : PETSC_FALSE), "solving");
      errors.check(KSPSolve(krylov_, right_, solution_), "solving");
      errors.check(KSPGetConvergedReason(krylov_, &r.reason), "solving");
      errors.check(KSPGetIterationNumber(krylov_, &iterations), "solving");
      r.iterations += static_cast<int>(iterations);
      errors.check(MatResidual(matrix_, right_, solution_, rest_), "solving");
      PetscReal of_rest = 0;
      errors.check(VecNorm(rest_, NORM_2, &of_rest), "solving");
      r.residual = of_rest / of_right;
      r.has_converged = r.residual <= tolerance_;
      if (r.has_converged || r.reason < 0 || !(r.residual < before / 2)) break;
    }
    if (!r.has_converged && r.residual <= 1e-6) r.has_converged = is_rounding_error();
  }

  /// Whether the residual is of the size of rounding errors: |b - A x| <= 1e-14 |A| |x|, norms of largest values.
  bool is_rounding_error() const {
    const petsc_errors errors;
    PetscReal of_rest = 0, of_solution = 0, of_matrix = 0;
    errors.check(VecNorm(rest_, NORM_INFINITY, &of_rest), "solving");
    errors.check(VecNorm(solution_, NORM_INFINITY, &of_solution), "solving");
    errors.check(MatNorm(matrix_, NORM_INFINITY, &of_matrix), "solving");
    return of_rest <= 1e-14 * of_matrix * of_solution;
  }
};

}  // namespace concino::detail
