// Repairs a volume of general polyhedra, as lists of faces and of verts.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/mesh/arrays.hpp>
#include <concino/repair/detail/repaired_arrays.hpp>
#include <concino/repair/repair_options.hpp>

namespace concino::detail {

repaired_arrays<polyhedra_arrays> repair_polyhedra(polyhedra_arrays a, const repair_options& options, repair_log& log);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/repair/detail/repair_polyhedra.ipp>
#endif
