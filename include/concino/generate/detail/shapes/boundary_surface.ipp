// Bodies of boundary_surface.hpp: the boundary of a volume as a surface mesh of its own.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/generate/boundary_surface.hpp>

namespace concino::detail {

CONCINO_INLINE void transfer_to_boundary(const property_set& source, const correspondence& c, property_set& to) {
  const element_origins the_mesh(std::vector<std::uint32_t>{0u});
  for (std::size_t i = 0; i < source.size(); ++i) {
    const property_info info = source.info(i);
    if (info.kind == element_kind::poly || info.kind == element_kind::corner) continue;
    const bool is_face = info.kind == element_kind::face;
    const element_origins& origins = is_face                           ? c.polys
                                     : info.kind == element_kind::vert ? c.verts
                                     : info.kind == element_kind::edge ? c.edges
                                                                       : the_mesh;
    const column& values = *source.values(i);
    column taken(values, origins);
    const auto column_there =
        to.get(is_face ? element_kind::poly : info.kind, info.name, values.operations(), origins.size());
    column_there->set_rule(values.rule());
    column_there->swap_values(taken);
  }
}

}  // namespace concino::detail
