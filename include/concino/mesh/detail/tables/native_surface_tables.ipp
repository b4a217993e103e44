// The tables of the native surfaces; see surface_tables.hpp.
#pragma once

#include <concino/mesh/surface_tables.hpp>

#ifdef CONCINO_COMPILED
namespace concino {

CONCINO_SURFACE_TABLES(, 0);
CONCINO_SURFACE_TABLES(, 3);
CONCINO_SURFACE_TABLES(, 4);
CONCINO_TRIANGLE_EDITS();

}  // namespace concino
#endif
