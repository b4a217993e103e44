// replace_polys: many polys replaced by others at once, with the values of named properties. Larger edits are made of
// it, such as cutting along a curve.
#pragma once

#include <concino/concepts/editable.hpp>
#include <concino/edit/detail/replaced_origins.hpp>
#include <concino/edit/detail/representable.hpp>

#include <span>
#include <type_traits>

namespace concino {

namespace detail {

template<class M>
void save_verts(const M& m, std::span<const vert_t<M>> changed, const auto& save) {
  for (const vert_t<M>& v : changed) save(element_kind::vert, index_of(m, v));
}

}  // namespace detail

/// Replaces polys as rewire does, and carries the values of named properties over.
/// Needs:  EditableMesh M; a cavity with the laws of rewire; from.verts: the verts of which each new vert was made, in
///         the order of c.points; from.polys: the old poly of which each new one was made. finish() changes values of
///         properties at the verts `changed` and at new ones; it cannot fail. replaced: removed verts with those that
///         take their places, by their numbers in the cavity, each once.
/// Result: none; `made` has the new elements. Edges and faces that old polys have too keep their values. A new one has
///         those of the old ones that become it where verts are replaced. Else it has those of an old one that has all
///         verts of which its own were made, else default ones. Corners have those of the old poly. In an open
///         transaction all of it can be undone.
/// Cost:   the elements at the verts of the cavity, but O(mesh) the first time, and sorting these.
/// Errors: those of rewire. The mesh is unchanged then, also if memory runs out.
template<EditableMesh M, class Finish>
void replace_polys(M& m, const cavity<M>& c, const cavity_result<M>& made, const correspondence& from,
                   std::span<const std::type_identity_t<vert_t<M>>> changed, const Finish& finish,
                   std::span<const replaced_vert> replaced = {}) {
  const auto rewire_all = [&] {
    if (c.polys.size() > 0) rewire(m, c, made);
  };
  if constexpr (detail::carries_values<M>)
    if (traits<M>::properties(m).size() > 0) {
      const auto first_new = static_cast<unsigned>(c.verts.size());
      const std::size_t num_new = (c.poly_ends.size() > 0 ? c.poly_ends : c.ends).size();
      detail::edit_values<M> values(m, {c.verts.begin(), c.verts.size()}, first_new, c.points.size());
      detail::replaced_origins<M>(m, c, from, replaced, values).add(traits<M>::properties(m));
      values.find(traits<M>::properties(m));
      detail::replace_saved(
          m,
          [&](const auto& save) {
            values.for_each_replaced(save);
            detail::save_verts<M>(m, changed, save);
          },
          rewire_all);
      values.write(m, made.verts, {made.polys, num_new});
      finish();
      return;
    }
  detail::replace_saved(m, [&](const auto& save) { detail::save_verts<M>(m, changed, save); }, rewire_all);
  finish();
}

/// Why the library of m cannot represent what a replacement leads to.
/// Needs:  EditableMesh M, a cavity.      Result: a permission with the reason, or without one.      Cost: the cavity. 
///             Errors: none.
template<EditableMesh M>
permission can_replace_polys(const M& m, const cavity<M>& c) {
  return detail::is_representable(m, c);
}

}  // namespace concino
