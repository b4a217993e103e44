// native_mesh_of: the native mesh for the polys of another mesh.
#pragma once

#include <concino/mesh/hexmesh.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/polyhedralmesh.hpp>
#include <concino/mesh/quadmesh.hpp>
#include <concino/mesh/tetmesh.hpp>
#include <concino/mesh/trimesh.hpp>

#include <type_traits>

namespace concino::core {

/// The native mesh of this dimension for polys of this arity, 0 for any.
template<int dimension, int arity>
struct native_mesh_of {
  using type = std::conditional_t<dimension == 2, polygonmesh, polyhedralmesh>;
};
template<>
struct native_mesh_of<2, 3> {
  using type = trimesh;
};
template<>
struct native_mesh_of<2, 4> {
  using type = quadmesh;
};
template<>
struct native_mesh_of<3, 4> {
  using type = tetmesh;
};
template<>
struct native_mesh_of<3, 8> {
  using type = hexmesh;
};

}  // namespace concino::core
