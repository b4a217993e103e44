// Counts independent loops by Euler's formula.
#pragma once

#include <concino/core/error.hpp>
#include <concino/fields/detail/topology/first_betti_number.hpp>

namespace concino::detail {

[[noreturn, gnu::noinline, gnu::cold]] CONCINO_INLINE void throw_loops_not_counted(const char* caller, const char* kind,
                                                                                   std::size_t facet,
                                                                                   const char* what) {
  core::throw_joined<unsupported>({caller, ": ", kind, " ", facet, " has ", what,
                                   ", so it is not known whether the mesh has loops; reeb_graph allows it"});
}

}  // namespace concino::detail
