// Collective errors: what one process finds wrong ends the call on all processes of a communicator, with its type and
// message.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/system_checks.hpp>

#include <mpi.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <string>

namespace concino::detail {

/// The types of errors as numbers, for other processes.
enum class error_kind {
  other, invalid_mesh, invalid_argument, solver_error, singular_row, unsupported, io_error, cancelled, parse_error
};

/// What another process needs to throw the same error.
struct error_record {
  error_kind kind = error_kind::other;
  std::uint64_t place = 0;                // the line of a parse_error, the row of a singular_row
  std::array<std::string, 3> texts = {};  // the message; of a parse_error its file, what is expected, and what is found

  explicit error_record(const std::exception& e) : texts{e.what()} {
    if (dynamic_cast<const invalid_mesh*>(&e)) kind = error_kind::invalid_mesh;
    if (dynamic_cast<const invalid_argument*>(&e)) kind = error_kind::invalid_argument;
    if (dynamic_cast<const solver_error*>(&e)) kind = error_kind::solver_error;
    if (dynamic_cast<const unsupported*>(&e)) kind = error_kind::unsupported;
    if (dynamic_cast<const io_error*>(&e)) kind = error_kind::io_error;
    if (dynamic_cast<const cancelled*>(&e)) kind = error_kind::cancelled;
    if (const auto* const singular = dynamic_cast<const core::singular_row*>(&e)) {
      kind = error_kind::singular_row;
      place = static_cast<std::uint64_t>(singular->row);
    }
    if (const auto* const parse = dynamic_cast<const parse_error*>(&e)) {
      kind = error_kind::parse_error;
      place = parse->line;
      texts = {parse->file, parse->expected, parse->found};
    }
  }
  error_record() = default;

  [[noreturn, gnu::cold]] void raise() const {
    switch (kind) {
      case error_kind::invalid_mesh:
        throw invalid_mesh(texts[0]);
      case error_kind::invalid_argument:
        throw invalid_argument(texts[0]);
      case error_kind::solver_error:
        throw solver_error(texts[0]);
      case error_kind::singular_row:
        throw core::singular_row(texts[0], static_cast<Eigen::Index>(place));
      case error_kind::unsupported:
        throw unsupported(texts[0]);
      case error_kind::io_error:
        throw io_error(texts[0]);
      case error_kind::cancelled:
        throw cancelled(texts[0]);
      case error_kind::parse_error:
        throw parse_error(texts[0], static_cast<std::size_t>(place), texts[1], texts[2]);
      case error_kind::other:
        break;
    }
    throw error(texts[0]);
  }
};

/// Copies the record of one process to all others. Collective.
inline void broadcast_error(error_record& r, int from, MPI_Comm communicator) {
  std::uint64_t numbers[] = {static_cast<std::uint64_t>(r.kind), r.place, r.texts[0].size(), r.texts[1].size(),
                             r.texts[2].size()};
  (MPI_Bcast)(numbers, 5, MPI_UINT64_T, from, communicator);
  r.kind = static_cast<error_kind>(numbers[0]);
  r.place = numbers[1];
  for (std::size_t k = 0; k < r.texts.size(); ++k) {
    r.texts[k].resize(static_cast<std::size_t>(numbers[2 + k]));
    (MPI_Bcast)(r.texts[k].data(), static_cast<int>(numbers[2 + k]), MPI_CHAR, from, communicator);
  }
}

/// Calls f(), which does not communicate, on every process of the communicator. If it throws on some, the error of the
/// first of these is thrown on all: errors of this library with their type, others as `error`. Collective. Names of MPI
/// are in parentheses, because PETSc has macros of these names, which count calls.
template<class F>
void on_all(MPI_Comm communicator, F f) {
  int size = 1, rank = 0;
  (MPI_Comm_size)(communicator, &size);
  (MPI_Comm_rank)(communicator, &rank);
  if (size == 1) return f();
  std::exception_ptr error;
  error_record record;
  try {
    f();
  } catch (const std::exception& e) {
    error = std::current_exception();
    record = error_record(e);
  }
  int first = error ? rank : size;
  (MPI_Allreduce)(MPI_IN_PLACE, &first, 1, MPI_INT, MPI_MIN, communicator);
  if (first == size) return;
  broadcast_error(record, first, communicator);
  if (rank == first) std::rethrow_exception(error);
  record.raise();
}

}  // namespace concino::detail
