// The tables of tets and hexes; see cell_tables.hpp. All members are compiled here: the optimiser leaves no copy of one
// that only others call, but headers may call it.
#pragma once

#include <concino/mesh/cell_tables.hpp>

#ifdef CONCINO_COMPILED
#include <concino/mesh/detail/edits/cell_tables_rewire.ipp>
#include <concino/mesh/detail/tables/cell_tables_build.ipp>
#include <concino/mesh/detail/tables/cell_tables_compact.ipp>
#include <concino/mesh/detail/tables/cell_tables_edit.ipp>
#include <concino/mesh/detail/tables/cell_tables_fans.ipp>

namespace concino {

template class cell_tables<detail::tet_shape>;
template class cell_tables<detail::hex_shape>;

}  // namespace concino
#endif
