// Bodies of united_properties.hpp: the properties of a mesh that was made of two.
#pragma once

#include <concino/generate/detail/unite/united_properties.hpp>

namespace concino::detail {

CONCINO_INLINE void add_united_properties(const property_set& second, const correspondence& from_first,
                                          const correspondence& from_second, property_set& to) {
  const element_origins the_mesh(std::vector<std::uint32_t>{0u});
  const auto of_kind = [&](const correspondence& c, element_kind kind) -> const element_origins& {
    const element_origins* const all[] = {&c.verts, &c.edges, &c.faces, &c.polys, &the_mesh, &c.corners};
    return *all[static_cast<unsigned>(kind)];
  };
  for (std::size_t i = 0; i < second.size(); ++i) {
    const property_info info = second.info(i);
    const column& values = *second.values(i);
    const element_origins& from = of_kind(from_second, info.kind);
    column taken(values, from);
    const bool is_new = !to.find(info.kind, info.name, values.operations());
    const auto united = to.get(info.kind, info.name, values.operations(), from.size());
    if (is_new) {
      united->set_rule(values.rule());
      united->swap_values(taken);
      continue;
    }
    const element_origins& before = of_kind(from_first, info.kind);
    for (std::size_t k = 0; k < from.size(); ++k)
      if (before[k].empty() && !from[k].empty()) united->take(k, taken, k);
  }
}

}  // namespace concino::detail
