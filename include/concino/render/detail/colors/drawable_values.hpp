// Values and colours of drawables, read from arrays by the index of elements of their mesh.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/mesh/property_set.hpp>
#include <concino/render/drawable.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace concino::detail {

/// Errors: invalid_argument if an option of a mesh_look is out of its range. labels_at: `mesh` without labels.
void check_look(double opacity, double shine, double crease_angle, double edge_width, int isobands, int isolines,
                element_kind labels_at);

/// Marks polygons as laid bare. selected: by index in the mesh.
void expose(drawable& d, std::span<const unsigned char> selected);

/// Adds triangles and normals.
void finish_drawable(drawable& d, double crease_angle);

/// Reads the values of elements of a kind. edges: by corner, the index of the edge to the next corner, if they are
/// values of edges.
void take_values(drawable& d, element_kind at, std::span<const double> by_index, std::span<const std::uint32_t> edges,
                 const std::optional<value_scale>& scale);

/// Texture coordinates by corner, from those at verts (by point) or corners.
std::vector<std::array<float, 2>> texture_points_of_corners(const drawable& d, element_kind at,
                                                            std::vector<std::array<float, 2>> points);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/render/detail/colors/drawable_values.ipp>
#endif
