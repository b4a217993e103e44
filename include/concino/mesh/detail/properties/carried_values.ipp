// Values that follow an edit; see carried_values.hpp.
#pragma once

#include <concino/mesh/support/carried_values.hpp>

namespace concino {

CONCINO_INLINE carried_values::carried_values(const property_set& properties, const correspondence& origins,
                                              const correspondence& of_sums) {
  for (std::size_t i = 0; i < properties.size(); ++i) {
    const element_kind kind = properties.kind(i);
    if (kind == element_kind::mesh) continue;
    const std::shared_ptr<detail::column>& to = properties.values(i);
    const correspondence& all = to->rule() == property_rule::sum ? of_sums : origins;
    const element_origins* const of[] = {&all.verts, &all.edges, &all.faces, &all.polys, nullptr, &all.corners};
    const element_origins& from = *of[static_cast<unsigned>(kind)];
    if (from.size() > 0 && to->operations().moves_without_throwing)
      all_.push_back({kind, to, std::make_unique<detail::column>(*to, from)});
  }
}

CONCINO_INLINE void carried_values::write(element_kind kind, std::size_t number, std::size_t index) noexcept {
  for (values& x : all_)
    if (x.kind == kind) x.to->take(index, *x.found, number);
}

}  // namespace concino
