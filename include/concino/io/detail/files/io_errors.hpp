// Throws io_error with the reason that the system reports.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/message.hpp>

#include <cstring>
#include <string>

namespace concino::detail {

[[noreturn, gnu::noinline, gnu::cold]] inline void throw_io_error(const std::string& path, const char* what,
                                                                  int error_number) {
  core::throw_joined<io_error>({path, ": ", what, ": ", std::strerror(error_number)});
}

[[noreturn, gnu::noinline, gnu::cold]] inline void throw_size_changed(const std::string& path, bool grew) {
  core::throw_joined<io_error>(
      {path, grew ? ": grew" : ": shrank", " while it was read; load it again once it is complete"});
}

}  // namespace concino::detail
