// file_of<M>: the file in this folder that holds a mesh of type M.
#pragma once

#include <concino/mesh.hpp>

template<class M> constexpr const char* file_of = "";
template<> constexpr const char* file_of<concino::trimesh> = "triangles.obj";
template<> constexpr const char* file_of<concino::quadmesh> = "quads.obj";
template<> constexpr const char* file_of<concino::polygonmesh> = "polygons.obj";
template<> constexpr const char* file_of<concino::tetmesh> = "tets.mesh";
template<> constexpr const char* file_of<concino::hexmesh> = "hexes.mesh";
template<> constexpr const char* file_of<concino::polyhedralmesh> = "polyhedra.hedra";
