// Meshes of a box: make_box<M>() returns its surface, or the solid box if M is a volume.
#pragma once

#include <concino/generate/detail/shapes/box_surface.hpp>
#include <concino/generate/grid.hpp>

namespace concino {

/// The closed surface of a box, oriented outward. If M is a volume: the solid box, as make_grid.
/// Needs:  as make_grid.
/// Result: a grid of quads on each of the six rectangles, cells[0] x cells[1] on those perpendicular to z, and so on.
///         If M has triangles, each quad is split into two.
/// Cost:   O(cells) time and memory.
/// Errors: as make_grid.
template<requirement::can_be_generated M>
M make_box(const grid_options& options = {}) {
  if constexpr (dimension_v<M> == 3) {  // a volume is a solid box, a surface its six rectangles
    return make_grid<M>(options);
  } else {
    detail::check_grid("make_box", options, 3);
    const auto [nx, ny, nz] = options.cells;
    const double i = static_cast<double>(nx), j = static_cast<double>(ny), k = static_cast<double>(nz),
                 quads = 2 * (i * j + j * k + k * i);
    detail::check_element_counts<M>("make_box", "cells", quads + 2, quads);
    const detail::spaced x("make_box", "x", options.min.x, options.max.x, nx),
        y("make_box", "y", options.min.y, options.max.y, ny), z("make_box", "z", options.min.z, options.max.z, nz);
    const detail::box_surface quad_surface(options.cells);
    surface_arrays a{{}, {}, {}, 4};
    a.points.reserve(quad_surface.num_verts());
    a.verts.reserve(4 * quad_surface.num_quads());
    quad_surface.for_each_vert([&](const detail::grid_corner& at) {
      a.points.push_back({x[at[0]], y[at[1]], z[at[2]]});
    });
    quad_surface.for_each_quad([&](const std::array<detail::grid_corner, 4>& quad) {
      for (const detail::grid_corner& at : quad) a.verts.push_back(vert_id{quad_surface.number(at)});
    });
    return detail::construct_from_quads<M>(std::move(a));
  }
}

// What to write instead of calls that cannot compile.
template<class M, class R = mistake::remedy<mistake::include_adapter>>
  requires(!requirement::is_adapted<M>)
M make_box(...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter

}  // namespace concino
