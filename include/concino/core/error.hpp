// What is thrown when the caller's input is at fault. Every message says what, where and what to do.
#pragma once

#include <concino/core/message.hpp>

#include <cstddef>
#include <stdexcept>
#include <string>

namespace concino {

/// Base of everything that concino throws.
struct error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The mesh, or an element handed in with it, does not meet a requirement.
struct invalid_mesh : error {
  using error::error;
};

/// An option or argument is out of its range.
struct invalid_argument : error {
  using error::error;
};

/// A system of equations has no or no reachable solution.
struct solver_error : error {
  using error::error;
};

/// The format, the kind of mesh or this build cannot do what was asked.
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
  parse_error(std::string file_, std::size_t line_, std::string expected_, std::string found_)
      : error(core::joined({file_, ":", line_, ": expected ", expected_, ", found ", found_})),
        file(std::move(file_)), line(line_), expected(std::move(expected_)), found(std::move(found_)) {}

  std::string file;
  std::size_t line;
  std::string expected;
  std::string found;
};

}  // namespace concino
