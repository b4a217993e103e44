// The preconditioner of an iteration of PETSc: its options, and its computation.
#pragma once

#include <concino/adapters/detail/petsc/petsc_calls.hpp>
#include <concino/adapters/petsc_options.hpp>
#include <concino/core/error.hpp>
#include <concino/core/message.hpp>

#include <petscksp.h>

namespace concino::detail {

/// The options of a solver, then those of the database.
inline PetscErrorCode set_options(KSP krylov, Mat matrix, const petsc_options& options) {
  const bool is_symmetric = options.system == petsc_system::symmetric_definite;
  PC preconditioner = nullptr;
  PetscCall(KSPSetOptionsPrefix(krylov, options.prefix.c_str()));
  PetscCall(KSPSetOperators(krylov, matrix, matrix));
  PetscCall(KSPSetType(krylov, is_symmetric ? KSPCG : KSPGMRES));
  if (!is_symmetric) PetscCall(KSPSetPCSide(krylov, PC_RIGHT));
  PetscCall(KSPSetNormType(krylov, KSP_NORM_UNPRECONDITIONED));
  PetscCall(KSPSetTolerances(krylov, options.tolerance, 0, PETSC_DEFAULT,
                             options.max_iterations > 0 ? options.max_iterations : 10'000));
  PetscCall(KSPGetPC(krylov, &preconditioner));
  switch (options.preconditioner) {
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
  return KSPSetFromOptions(krylov);
}

/// The same on all processes of the communicator, each of which knows only its own.
inline PCFailedReason failure_of_preconditioner(const petsc_errors& errors, KSP krylov, MPI_Comm communicator) {
  PC preconditioner = nullptr;
  PCFailedReason failed = PC_NOERROR;
  errors.check(KSPGetPC(krylov, &preconditioner), "computing the preconditioner");
  errors.check(PCGetFailedReason(preconditioner, &failed), "computing the preconditioner");
  int code = static_cast<int>(failed);
  (MPI_Allreduce)(MPI_IN_PLACE, &code, 1, MPI_INT, MPI_MAX, communicator);
  return static_cast<PCFailedReason>(code);
}

/// Prepares another factorisation by MUMPS, which may take this much more memory than MUMPS estimates.
inline PetscErrorCode allow_memory(KSP krylov, Mat matrix, int percent) {
  PC preconditioner = nullptr;
  Mat factor = nullptr;
  PetscCall(KSPGetPC(krylov, &preconditioner));
  PetscCall(PCReset(preconditioner));
  PetscCall(KSPSetOperators(krylov, matrix, matrix));
  PetscCall(PCFactorSetUpMatSolverType(preconditioner));
  PetscCall(PCFactorGetMatrix(preconditioner, &factor));
  return MatMumpsSetIcntl(factor, 14, percent);
}

/// MUMPS' estimate, plus 20 percent, is too low for some matrices that several processes share.
/// Errors: solver_error.
inline void compute_preconditioner(const petsc_errors& errors, KSP krylov, Mat matrix, const petsc_options& options) {
  PCFailedReason failed = PC_NOERROR;
  for (int percent = 40; percent < 1000; percent *= 2) {
    errors.check(KSPSetUp(krylov), "computing the preconditioner");
    errors.check(KSPSetUpOnBlocks(krylov), "computing the preconditioner");
    failed = failure_of_preconditioner(errors, krylov, options.communicator);
    if (failed != PC_FACTOR_OUTMEMORY) break;
    errors.check(allow_memory(krylov, matrix, percent), "computing the preconditioner");
  }
  if (failed == PC_FACTOR_OUTMEMORY) throw solver_error("petsc: the factorisation ran out of memory");
  if (failed != PC_NOERROR)
    core::throw_joined<solver_error>({"petsc: the preconditioner cannot be computed: the matrix is singular, ",
                                      options.system == petsc_system::general ? "" : "not positive definite, ",
                                      "or badly conditioned"});
}

}  // namespace concino::detail
