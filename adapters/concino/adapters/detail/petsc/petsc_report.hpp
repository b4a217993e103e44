// How a solve of PETSc has ended.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/number_text.hpp>

#include <petscksp.h>

namespace concino::detail {

struct petsc_report {
  int iterations = 0;
  double residual = 0;
  bool has_converged = true;
  KSPConvergedReason reason = KSP_CONVERGED_RTOL;

  const char* explanation() const {
    switch (reason) {
      case KSP_DIVERGED_ITS:
        return "allow more iterations or a larger tolerance, or choose another preconditioner";
      case KSP_DIVERGED_INDEFINITE_MAT:
        return "the matrix is not positive definite: use petsc_system::general";
      case KSP_DIVERGED_INDEFINITE_PC:
        return "the preconditioner is not positive definite: the matrix is indefinite or singular";
      case KSP_DIVERGED_DTOL:
        return "the iteration diverges: choose another preconditioner";
      case KSP_DIVERGED_NANORINF:
        return "numbers overflow: the matrix is singular, or badly conditioned";
      case KSP_DIVERGED_PC_FAILED:
        return "the preconditioner cannot be computed: the matrix is singular";
      case KSP_DIVERGED_BREAKDOWN:
      case KSP_DIVERGED_BREAKDOWN_BICG:
        return "the iteration breaks down: choose another one by -ksp_type";
      default:
        return "the matrix is singular or badly conditioned: set accept_missed_tolerance to get what is reached";
    }
  }

  /// Errors: solver_error if the tolerance is missed.
  void check(double tolerance) const {
    if (has_converged) return;
    core::throw_joined<solver_error>({"petsc: not converged after ", iterations, " iterations: the residual is ",
                                      core::number_text(residual), ", the tolerance ", core::number_text(tolerance),
                                      "; ", explanation()});
  }
};

}  // namespace concino::detail
