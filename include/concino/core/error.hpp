// Exceptions for wrong input by the caller. Every message says what is wrong, where, and what to do.
#pragma once

#include <concino/core/message.hpp>

#include <cstddef>
#include <stdexcept>
#include <string>

namespace concino {

/// Base class of all exceptions that concino throws.
struct error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The mesh, or an element passed with it, does not meet a requirement.
struct invalid_mesh : error {
  using error::error;
};

/// An option or argument is out of its range.
struct invalid_argument : error {
  using error::error;
};

/// A system of equations has no solution, or none that can be computed.
struct solver_error : error {
  using error::error;
};

/// The format, the kind of mesh or this build does not support the request.
struct unsupported : error {
  using error::error;
};

/// A file cannot be opened, read or written.
struct io_error : error {
  using error::error;
};

/// The progress callback asked to stop.
struct cancelled : error {
  using error::error;
};

/// A file does not follow its format. Lines count from 1.
struct parse_error : error {
  parse_error(std::string file_, std::size_t line_, std::string expected_, std::string found_);

  std::string file;
  std::size_t line;
  std::string expected;
  std::string found;
};

#ifdef CONCINO_COMPILED
namespace core {
extern template void throw_joined<invalid_mesh>(message);
extern template void throw_joined<invalid_argument>(message);
extern template void throw_joined<solver_error>(message);
extern template void throw_joined<unsupported>(message);
extern template void throw_joined<io_error>(message);
extern template void throw_joined<cancelled>(message);
}  // namespace core
#endif

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/core/detail/error.ipp>
#endif
