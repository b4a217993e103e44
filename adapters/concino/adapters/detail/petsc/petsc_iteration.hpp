// A linear system whose rows are distributed over processes, and PETSc's iteration for it.
#pragma once

#include <concino/adapters/detail/mpi/mpi_agreement.hpp>
#include <concino/adapters/detail/petsc/petsc_calls.hpp>
#include <concino/adapters/detail/petsc/petsc_default_options.hpp>
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
    factorize_scaled(rows.values, rows.first, rows.size(), [&](const petsc_errors& errors, const double* values) {
      errors.check(MatSetType(matrix_, MATAIJ), "creating the matrix");
      // each does nothing for matrices of the other type
      errors.check(MatSeqAIJSetPreallocationCSR(matrix_, rows.starts.data(), rows.columns.data(), values),
                   "filling the matrix");
      errors.check(MatMPIAIJSetPreallocationCSR(matrix_, rows.starts.data(), rows.columns.data(), values),
                   "filling the matrix");
    });
  }
  /// entries: of any rows, which PETSc sums over all processes. Its lists are used up.
  void factorize(petsc_entries& entries) {
    factorize_scaled(entries.values, entries.first, entries.size,
                     [&](const petsc_errors& errors, const double* values) {
                       errors.check(MatSetType(matrix_, MATAIJ), "creating the matrix");
                       errors.check(MatSetPreallocationCOO(matrix_, static_cast<PetscCount>(entries.values.size()),
                                                           entries.rows.data(), entries.columns.data()),
                                    "filling the matrix");
                       errors.check(MatSetValuesCOO(matrix_, values, INSERT_VALUES), "filling the matrix");
                     });
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

 private:
  template<class Fill>
  void factorize_scaled(std::vector<double> values, PetscInt first, PetscInt size, const Fill& fill) {
    const petsc_errors errors;
    double largest = 0;
    for (const double value : values) largest = std::max(largest, std::abs(value));
    (MPI_Allreduce)(MPI_IN_PLACE, &largest, 1, MPI_DOUBLE, MPI_MAX, options_.communicator);
    scale_ = core::power_of_two_to_scale(largest);
    for (double& value : values) value *= scale_;
    errors.check(MatCreate(options_.communicator, matrix_.address()), "creating the matrix");
    errors.check(MatSetSizes(matrix_, size, size, PETSC_DETERMINE, PETSC_DETERMINE), "creating the matrix");
    fill(errors, values.data());
    if (options_.system == petsc_system::symmetric_definite)
      errors.check(MatSetOption(matrix_, MAT_SPD, PETSC_TRUE), "filling the matrix");
    errors.check(MatCreateVecs(matrix_, solution_.address(), right_.address()), "creating vectors");
    errors.check(VecDuplicate(right_, rest_.address()), "creating vectors");
    set_near_null_space(errors, first, size);
    krylov_.reset();
    errors.check(KSPCreate(options_.communicator, krylov_.address()), "creating the solver");
    {
      const petsc_default_options defaults(options_.prefix);
      errors.check(choose(), "setting its options");
      errors.check(KSPSetUp(krylov_), "computing the preconditioner");
      errors.check(KSPSetUpOnBlocks(krylov_), "computing the preconditioner");
    }
    check_preconditioner(errors);
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

  /// The options of this solver, then those of the database.
  PetscErrorCode choose() {
    const bool is_symmetric = options_.system == petsc_system::symmetric_definite;
    PC preconditioner = nullptr;
    PetscCall(KSPSetOptionsPrefix(krylov_, options_.prefix.c_str()));
    PetscCall(KSPSetOperators(krylov_, matrix_, matrix_));
    PetscCall(KSPSetType(krylov_, is_symmetric ? KSPCG : KSPGMRES));
    if (!is_symmetric) PetscCall(KSPSetPCSide(krylov_, PC_RIGHT));
    PetscCall(KSPSetNormType(krylov_, KSP_NORM_UNPRECONDITIONED));
    PetscCall(KSPSetTolerances(krylov_, options_.tolerance, 0, PETSC_DEFAULT,
                               options_.max_iterations > 0 ? options_.max_iterations : 10'000));
    PetscCall(KSPGetPC(krylov_, &preconditioner));
    switch (options_.preconditioner) {
      case petsc_preconditioner::gamg:
        PetscCall(PCSetType(preconditioner, PCGAMG));
        break;
      case petsc_preconditioner::boomeramg:
        PetscCall(PCSetType(preconditioner, PCHYPRE));
        PetscCall(PCHYPRESetType(preconditioner, "boomeramg"));
        break;
      case petsc_preconditioner::mumps:
        PetscCall(PCSetType(preconditioner, is_symmetric ? PCCHOLESKY : PCLU));
        PetscCall(PCFactorSetMatSolverType(preconditioner, MATSOLVERMUMPS));
        break;
    }
    PetscCall(KSPSetFromOptions(krylov_));
    PetscReal tolerance = 0;
    PetscCall(KSPGetTolerances(krylov_, &tolerance, nullptr, nullptr, nullptr));
    tolerance_ = tolerance;
    return 0;
  }

  void check_preconditioner(const petsc_errors& errors) const {
    PC preconditioner = nullptr;
    PCFailedReason failed = PC_NOERROR;
    errors.check(KSPGetPC(krylov_, &preconditioner), "computing the preconditioner");
    errors.check(PCGetFailedReason(preconditioner, &failed), "computing the preconditioner");
    int code = static_cast<int>(failed);  // each process knows only its own
    (MPI_Allreduce)(MPI_IN_PLACE, &code, 1, MPI_INT, MPI_MAX, options_.communicator);
    if (code == PC_FACTOR_OUTMEMORY) throw solver_error("petsc: the factorisation ran out of memory");
    if (code != PC_NOERROR)
      core::throw_joined<solver_error>({"petsc: the preconditioner cannot be computed: the matrix is singular, ",
                                        options_.system == petsc_system::general ? "" : "not positive definite, ",
                                        "or badly conditioned"});
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
