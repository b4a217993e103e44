// Refusals; see resample.hpp.
#pragma once

#include <concino/core/error.hpp>
#include <concino/fields/resample.hpp>

namespace concino::detail {

[[noreturn, gnu::noinline, gnu::cold]] CONCINO_INLINE void throw_nothing_to_resample() {
  throw invalid_argument(
      "resample: one of the meshes has no polys, so there are no values to take or no polys to give them to");
}

[[noreturn, gnu::noinline, gnu::cold]] CONCINO_INLINE void throw_target_without_measure(std::size_t poly) {
  core::throw_joined<invalid_mesh>(
      {"resample: poly ", poly,
       " of the new mesh has no area or volume, but would get a part of the integral; remove it"});
}

}  // namespace concino::detail
