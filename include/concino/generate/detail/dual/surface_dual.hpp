// The dual mesh of a surface: a polygon for each vert.
#pragma once

#include <concino/generate/detail/dual/boundary_creases.hpp>
#include <concino/generate/detail/dual/dual_parts.hpp>
#include <concino/generate/detail/dual/unused_dual_verts.hpp>
#include <concino/mesh/arrays.hpp>

namespace concino::detail {

/// The arrays of the dual mesh of a surface, and the maps unless null. The centres of dual_parts are verts. If cells
/// are not clipped, some points may belong to no polygon.
template<SurfaceMesh M, class Creases>
  requires Embedded<M> surface_arrays surface_dual(const M& m, const boundary_creases<M, Creases>& creases,
                                                   dual_points where, dual_maps* maps) {
    dual_parts<M> parts(m, creases.has_boundary_cells(), where);
    std::vector<std::uint32_t> cell_of, own_of;
    if (maps) cell_of.assign(vert_index_bound(m), parts.none), own_of = cell_of;
    surface_arrays a;
    a.verts.reserve(parts.num_corners());
    a.offsets.reserve(num_verts(m) + 1);
    a.offsets.push_back(0);
    for (const vert_t<M> v : verts(m)) {
      const std::size_t i = index_of(m, v);
      if (!parts.has_polys(i)) continue;
      std::uint32_t own = parts.none;
      if (parts.is_border_centre(i)) {
        if (!creases.has_boundary_cells()) continue;
        if (creases(v)) own = parts.add_vert(to_vec3(point(m, v)));
      }
      if (maps) cell_of[i] = static_cast<std::uint32_t>(a.offsets.size() - 1), own_of[i] = own;
      parts.add_loop(i, own, a.verts);
      a.offsets.push_back(static_cast<std::uint32_t>(a.verts.size()));
    }
    a.points = std::move(parts.points);
    if (maps)
      *maps = {ids<poly_id>(cell_of), {}, ids<vert_id>(parts.vert_of_poly()), {}, ids<vert_id>(parts.vert_of_facet()),
               ids<vert_id>(own_of)};
    return a;
  }

}  // namespace concino::detail
