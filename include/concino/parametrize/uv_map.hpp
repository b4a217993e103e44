// Maps of the verts of a surface to the plane.
#pragma once

#include <concino/mesh/element_map.hpp>

#include <array>

namespace concino {

/// A point of the plane; "texture" coordinates of verts and corners have this type.
using uv_point = std::array<double, 2>;

/// A map of the verts of a surface to the plane: a texture_coordinates of pictures, and the property "texture" of
/// files.
template<class M> using uv_map = vert_map<M, uv_point>;

}  // namespace concino
