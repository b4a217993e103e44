// The names of the six kinds of mesh.
#pragma once

#include <concino/mesh.hpp>

namespace program {

inline const char* name_of(const concino::trimesh&) { return "trimesh"; }
inline const char* name_of(const concino::quadmesh&) { return "quadmesh"; }
inline const char* name_of(const concino::polygonmesh&) { return "polygonmesh"; }
inline const char* name_of(const concino::tetmesh&) { return "tetmesh"; }
inline const char* name_of(const concino::hexmesh&) { return "hexmesh"; }
inline const char* name_of(const concino::polyhedralmesh&) { return "polyhedralmesh"; }

}  // namespace program
