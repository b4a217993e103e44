// The tables of polyhedra; see polyhedra_tables.hpp. All members are compiled here: the optimiser leaves no copy of one
// that only others call, but headers may call it.
#pragma once

#include <concino/mesh/polyhedra_tables.hpp>

#ifdef CONCINO_COMPILED
#include <concino/mesh/detail/edits/polyhedra_tables_rewire.ipp>
#include <concino/mesh/detail/tables/polyhedra_compact.ipp>
#include <concino/mesh/detail/tables/polyhedra_tables_build.ipp>
#include <concino/mesh/detail/tables/polyhedra_tables_edit.ipp>

namespace concino {

template class basic_polyhedra_tables<detail::jagged_array<vert_id, 0>>;

}  // namespace concino
#endif
