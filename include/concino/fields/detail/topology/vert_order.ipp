// Orders of verts by values; see vert_order.hpp.
#pragma once

#include <concino/core/error.hpp>
#include <concino/fields/detail/topology/vert_order.hpp>

namespace concino::detail {

[[noreturn, gnu::noinline, gnu::cold]] CONCINO_INLINE void throw_value_not_finite(const char* caller,
                                                                                  std::size_t vert) {
  core::throw_joined<invalid_argument>({caller, ": the value at vert ", vert, " is not finite; replace it"});
}

}  // namespace concino::detail
