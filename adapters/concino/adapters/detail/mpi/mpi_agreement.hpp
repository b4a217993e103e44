// Collective errors: what one process finds wrong ends the call on all processes of a communicator, with its message.
#pragma once

#include <concino/core/error.hpp>

#include <mpi.h>

#include <cstddef>
#include <exception>
#include <string>

namespace concino::detail {

/// The types of errors as numbers, for other processes.
enum class error_kind { other, invalid_mesh, invalid_argument, solver_error, unsupported, io_error, cancelled };

inline error_kind kind_of(const std::exception& e) {
  if (dynamic_cast<const invalid_mesh*>(&e)) return error_kind::invalid_mesh;
  if (dynamic_cast<const invalid_argument*>(&e)) return error_kind::invalid_argument;
  if (dynamic_cast<const solver_error*>(&e)) return error_kind::solver_error;
  if (dynamic_cast<const unsupported*>(&e)) return error_kind::unsupported;
  if (dynamic_cast<const io_error*>(&e)) return error_kind::io_error;
  if (dynamic_cast<const cancelled*>(&e)) return error_kind::cancelled;
  return error_kind::other;
}

[[noreturn, gnu::cold]] inline void throw_of_kind(error_kind kind, const std::string& what) {
  switch (kind) {
    case error_kind::invalid_mesh:
      throw invalid_mesh(what);
    case error_kind::invalid_argument:
      throw invalid_argument(what);
    case error_kind::solver_error:
      throw solver_error(what);
    case error_kind::unsupported:
      throw unsupported(what);
    case error_kind::io_error:
      throw io_error(what);
    case error_kind::cancelled:
      throw cancelled(what);
    case error_kind::other:
      break;
  }
  throw error(what);
}

/// Calls f(), which does not communicate, on every process of the communicator. If it throws on some, the error of the
/// first of these is thrown on all. Collective. Names of MPI are in parentheses, because PETSc has macros of these
/// names, which count calls.
template<class F>
void on_all(MPI_Comm communicator, F f) {
  int size = 1, rank = 0;
  (MPI_Comm_size)(communicator, &size);
  (MPI_Comm_rank)(communicator, &rank);
  if (size == 1) return f();
  std::exception_ptr error;
  std::string what;
  int kind = static_cast<int>(error_kind::other);
  try {
    f();
  } catch (const std::exception& e) {
    error = std::current_exception();
    what = e.what();
    kind = static_cast<int>(kind_of(e));
  }
  int first = error ? rank : size;
  (MPI_Allreduce)(MPI_IN_PLACE, &first, 1, MPI_INT, MPI_MIN, communicator);
  if (first == size) return;
  int message[] = {kind, static_cast<int>(what.size())};
  (MPI_Bcast)(message, 2, MPI_INT, first, communicator);
  what.resize(static_cast<std::size_t>(message[1]));
  (MPI_Bcast)(what.data(), message[1], MPI_CHAR, first, communicator);
  if (rank == first) std::rethrow_exception(error);
  throw_of_kind(static_cast<error_kind>(message[0]), what);
}

}  // namespace concino::detail
