// Repairs a surface, as lists.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/mesh/arrays.hpp>
#include <concino/repair/detail/repaired_arrays.hpp>
#include <concino/repair/repair_options.hpp>

#include <cstdint>

namespace concino::detail {

/// Polys of any size for arity 0.
repaired_arrays<surface_arrays> repair_surface(surface_arrays a, std::uint32_t arity, const repair_options& options,
                                               repair_log& log);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/repair/detail/repair_surface.ipp>
#endif
