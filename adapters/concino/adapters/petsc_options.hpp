// The options of petsc.
// Needs: MPI (Debian: petsc-dev).
#pragma once

#include <Eigen/Core>

#include <mpi.h>

#include <string>
#include <vector>

namespace concino {

/// The systems that petsc solves.
enum class petsc_system {
  symmetric_definite,  // by conjugate gradients; the matrix is symmetric and positive definite
  general              // by GMRES; the matrix is square
};

/// The preconditioners that petsc chooses among. PETSc's database of options knows more, by -pc_type.
enum class petsc_preconditioner {
  gamg,       // PETSc's algebraic multigrid, by smoothed aggregation
  boomeramg,  // hypre's algebraic multigrid
  mumps       // a factorisation by MUMPS, on all processes together
};

struct petsc_options {
  std::string prefix = "";  // of this solver's options in PETSc's database: with "poisson_", -poisson_pc_type hypre
                            // overrides the preconditioner; empty, or ends in _
  concino::petsc_system system = concino::petsc_system::symmetric_definite;            // what is solved, and how
  concino::petsc_preconditioner preconditioner = concino::petsc_preconditioner::gamg;  // unless the database says more
  double tolerance = 1e-12;                           // of |b - A x| / |b|, Euclidean norms; in (0, 1)
  int max_iterations = 0;                             // 0: 10,000
  std::vector<Eigen::VectorXd> near_null_space = {};  // vectors that the matrix nearly maps to 0, for gamg; linearly
                                                      // independent; none: the constants
  MPI_Comm communicator = MPI_COMM_SELF;              // the processes that solve together
  bool accept_missed_tolerance = false;  // true: solve returns the best result so far; has_converged() says whether it
                                         // meets the tolerance
  bool accept_unused_options = false;    // true: options of the database with this prefix that are misspelt, or have
                                         // no effect, are no error; unused_options() lists them
};

}  // namespace concino
