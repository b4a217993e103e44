// Refusals of decompositions of forms; see form_problem.hpp.
#pragma once

#include <concino/core/error.hpp>
#include <concino/fields/detail/problems/form_problem.hpp>

namespace concino::detail {

[[noreturn, gnu::noinline, gnu::cold]] CONCINO_INLINE void throw_edge_value_not_finite(const char* caller,
                                                                                       std::size_t edge) {
  core::throw_joined<invalid_argument>({caller, ": the value at edge ", edge, " is not finite; replace it"});
}

}  // namespace concino::detail
