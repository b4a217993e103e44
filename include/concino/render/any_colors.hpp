// Colours and texture coordinates of any map on a mesh, for options that hold one.
//
// Needs:  AnyMesh M; a map that gives rgb or rgba at each vert, poly, face or corner (colours), or two numbers at each
//         vert or corner (texture coordinates). If this holds for several kinds, they are taken in this order. rgba is
//         taken as sRGB, as in files, without its opacity. Of two and more numbers the first two are taken. A map that
//         is an lvalue must outlive the option; a temporary map is stored in it.
// Result: an implicit conversion from such a map. By default there is no map.
// Cost:   one allocation for a stored map; each value is read once when the mesh is drawn, those of verts, polys and
//         faces in parallel.
// Errors: when the mesh is drawn: invalid_argument if it is a map of another mesh, was made before elements were added,
//         or is the handle of a property that the mesh does not have.
#pragma once

#include <concino/render/detail/colors/drawn_map.hpp>

namespace concino {

/// Colours on a mesh of type M, such as make_poly_map<rgb>(m) or find_vert_property<rgba>(m, "color").
template<AnyMesh M>
using any_colors = detail::drawn_map<M, rgb>;

/// Texture coordinates on a mesh of type M, such as find_corner_property<std::array<double, 2>>(m, "texture") of an OBJ
/// file.
template<AnyMesh M>
using any_texture_coordinates = detail::drawn_map<M, detail::drawn_point>;

}  // namespace concino
