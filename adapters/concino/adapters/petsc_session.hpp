// Starts PETSc and MPI, and ends them at the end of a scope. A program that uses concino::petsc has one in main.
// Needs: PETSc 3.18 with MPI (Debian: petsc-dev).
#pragma once

#include <concino/core/error.hpp>

#include <petscsys.h>

#include <cstddef>
#include <exception>

namespace concino {

/// PETSc and MPI, from here to the end of the scope. Options of the command line go to PETSc's database, such as
/// -pc_type hypre or, for solvers with a prefix, -poisson_pc_type hypre.
/// Needs:  at most one object at a time, constructed before any solver of PETSc and destroyed after all of them. Where
///         PETSc is running already, the object does nothing; where MPI is, it ends PETSc alone. MPI starts once in a
///         program.
/// Result: signals are handled as before: PETSc's own handler of them is removed.
/// Errors: solver_error if PETSc cannot start. If the scope is left by an exception, PETSc and MPI are not ended, since
///         ending waits for all processes: the process that does not catch it ends, and mpirun ends the others.
class petsc_session {
  bool is_owner_ = false;
  int exceptions_ = std::uncaught_exceptions();

 public:
  petsc_session(int& argc, char**& argv) {
    PetscBool is_running = PETSC_FALSE;
    if (PetscInitialized(&is_running) == 0 && is_running) return;
    if (PetscInitialize(&argc, &argv, nullptr, nullptr) != 0) throw solver_error("petsc: PETSc cannot start");
    is_owner_ = true;
    static_cast<void>(PetscPopSignalHandler());
  }
  /// Of MPI_COMM_WORLD.
  std::size_t num_processes() const {
    int size = 1;
    (MPI_Comm_size)(MPI_COMM_WORLD, &size);
    return static_cast<std::size_t>(size);
  }

  petsc_session(const petsc_session&) = delete;
  petsc_session& operator=(const petsc_session&) = delete;
  ~petsc_session() {
    if (is_owner_ && std::uncaught_exceptions() <= exceptions_) static_cast<void>(PetscFinalize());
  }
};

}  // namespace concino
