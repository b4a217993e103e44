// Construction of exceptions; see error.hpp.
#pragma once

#include <concino/core/error.hpp>

#include <utility>

namespace concino {

CONCINO_INLINE parse_error::parse_error(std::string file_, std::size_t line_, std::string expected_, std::string found_)
    : error(core::joined({file_, ":", line_, ": expected ", expected_, ", found ", found_})),
      file(std::move(file_)), line(line_), expected(std::move(expected_)), found(std::move(found_)) {}

#ifdef CONCINO_COMPILED
namespace core {
template void throw_joined<invalid_mesh>(message);
template void throw_joined<invalid_argument>(message);
template void throw_joined<solver_error>(message);
template void throw_joined<unsupported>(message);
template void throw_joined<io_error>(message);
template void throw_joined<cancelled>(message);
}  // namespace core
#endif

}  // namespace concino
