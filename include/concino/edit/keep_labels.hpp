// An invariant that keeps regions of polys with equal labels, such as materials, apart and their common boundaries in
// place.
#pragma once

#include <concino/edit/support/typed_edit.hpp>

namespace concino {

namespace detail {

template<class M, class Cavity, class F>
class label_checker {
  const M& m_;
  const Cavity& c_;
  const F& label_;

  bool are_equal(unsigned k, unsigned j) const { return label_(c_.poly(k)) == label_(c_.poly(j)); }
  bool has_label_of(unsigned k, unsigned v, unsigned w) const {  // whether a poly with v and w has the label of poly k
    for (unsigned j = 0; j < c_.num_polys(); ++j)
      if (c_.has(j, v) && c_.has(j, w) && are_equal(k, j)) return true;
    return false;
  }
  bool labels_are_among(unsigned a, unsigned b) const {  // whether each label at a is one at b
    for (unsigned k = 0; k < c_.num_polys(); ++k)
      if (c_.has(k, a) && !has_label_of(k, b, b)) return false;
    return true;
  }

 public:
  label_checker(const M& m, const Cavity& c, const F& label) : m_(m), c_(c), label_(label) {}

  bool collapse_keeps_labels() const {
    const unsigned a = c_.kept_vert(), b = c_.removed_vert();
    for (unsigned k = 0; k < c_.num_polys(); ++k)
      if (c_.has(k, a) && has_label_of(k, b, b) && !has_label_of(k, a, b)) return false;
    const vec3 x = to_vec3(point(m_, c_.vert_at(a))), y = to_vec3(point(m_, c_.vert_at(b))),
               now = c_.moved_vert() == a ? c_.moved_to() : x;
    return (now == x || labels_are_among(a, b)) && (now == y || labels_are_among(b, a));
  }
  bool new_polys_have_one_label() const {
    for (const poly_origin& x : c_.origins())
      for (unsigned k = x.first + 1; k < x.first + x.count; ++k)
        if (!are_equal(x.first, k)) return false;
    return true;
  }
};

}  // namespace detail

/// Refuses edits of m that change the regions of polys with equal labels. Those are flips and merges of polys with
/// different labels, collapses that join two places of the boundary of a region, and collapses that move a vert of the
/// boundary between regions, except along it.
/// Needs:  EditableMesh M; a map of polys, or a function of polys, to anything with ==. One that is large or owns
///         memory must be an lvalue that outlives the invariant. New polys take the labels of those that they come from
///         if the property is carried so.
/// Result: an invariant for `keep`.
/// Cost:   at each edit, at most the square of the number of its polys.
/// Errors: an edit throws invalid_argument if its mesh is not m; the mesh is unchanged then.
template<EditableMesh M, class F>
  requires(core::caller_map<std::remove_cvref_t<F>>::template can_hold<F>)
invariant keep_labels(const M& m, F&& labels) {
  return [&m, map = core::caller_map<std::remove_cvref_t<F>>(labels)](const proposed_edit& e) -> permission {
    return core::with_cavity_of_edit(e, m, "keep_labels", [&]<class Cavity>(const Cavity& c) -> permission {
      const detail::label_checker<M, Cavity, std::remove_cvref_t<decltype(map)>> checker(m, c, map);
      if (!checker.new_polys_have_one_label())
        return {refusal::invariant, "keep_labels: polys of different labels would be mixed"};
      if (c.removed_vert() != c.none && !checker.collapse_keeps_labels())
        return {refusal::invariant, "keep_labels: the boundary between labels would change"};
      return {};
    });
  };
}

}  // namespace concino
