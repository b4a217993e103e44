// Refusals of the Hodge decomposition; see hodge_problem.hpp.
#pragma once

#include <concino/core/error.hpp>
#include <concino/fields/detail/problems/hodge_problem.hpp>

namespace concino::detail {

[[noreturn, gnu::noinline, gnu::cold]] CONCINO_INLINE void throw_no_simplex(const char* caller, bool in_volume,
                                                                            std::size_t poly, std::size_t verts) {
  core::throw_joined<unsupported>({caller, ": poly ", poly, " has ", verts, " verts; all polys must be ",
                                   in_volume ? "tets: call to_tets" : "triangles: call to_triangles"});
}

[[noreturn, gnu::noinline, gnu::cold]] CONCINO_INLINE void throw_vector_not_finite(const char* caller,
                                                                                   std::size_t poly) {
  core::throw_joined<invalid_argument>({caller, ": the vector at poly ", poly, " is not finite; replace it"});
}

}  // namespace concino::detail
