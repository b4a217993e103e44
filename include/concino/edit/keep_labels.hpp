// An invariant that keeps regions of polys with equal labels, such as materials, apart and their common boundaries in
// place.
#pragma once

#include <concino/edit/support/typed_edit.hpp>

#include <algorithm>

namespace concino {

namespace detail {

template<class M, class F>
class label_checker {
  const M& m_;
  const F& label_;

  bool has_vert(const poly_t<M>& p, const vert_t<M>& v) const {
    for (const vert_t<M> x : adj_p2v(m_, p))
      if (x == v) return true;
    return false;
  }
  bool are_equal(const poly_t<M>& p, const poly_t<M>& q) const { return label_(p) == label_(q); }
  bool has_label_of(const poly_t<M>& p, const vert_t<M>& v, const vert_t<M>& w) const {  // whether a poly with v and w
                                                                                         // has the label of p
    for (const poly_t<M> q : adj_v2p(m_, v))
      if (are_equal(p, q) && has_vert(q, w)) return true;
    return false;
  }
  bool labels_are_among(const vert_t<M>& a, const vert_t<M>& b) const {  // whether each label at a is one at b
    for (const poly_t<M> p : adj_v2p(m_, a))
      if (!has_label_of(p, b, b)) return false;
    return true;
  }
  bool has_one_label(const vert_t<M>& v) const {
    for (const poly_t<M> p : adj_v2p(m_, v))
      if (!are_equal(p, *adj_v2p(m_, v).begin())) return false;
    return true;
  }
  bool is_at(const vert_t<M>& v, const vec3& x) const { return to_vec3(point(m_, v)) == x; }
  /// Whether two verts may become one at x.
  bool may_become_one(const vert_t<M>& a, const vert_t<M>& b, const vec3& x) const {
    for (const poly_t<M> p : adj_v2p(m_, a))
      if (has_label_of(p, b, b) && !has_label_of(p, a, b)) return false;
    return (is_at(a, x) || labels_are_among(a, b)) && (is_at(b, x) || labels_are_among(b, a));
  }
  template<class Cavity>
  bool keeps_labels_at(const Cavity& c) const {
    const unsigned a = c.kept_vert(), b = c.removed_vert();
    if (b == c.none) return true;
    const vec3 x = c.moved_vert() == a ? c.moved_to() : to_vec3(point(m_, c.vert_at(a)));
    return may_become_one(c.vert_at(a), c.vert_at(b), x);
  }
  /// Verts with the same successor become one; what has a successor of its own is split, or moves.
  bool keeps_labels_at_replaced(const general_cavity<M>& c) const {
    auto all = c.replaced_verts();
    std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.by < b.by; });
    for (std::size_t first = 0, last = 0; first < all.size(); first = last) {
      const vec3 x = c.point_of(all[first].by);
      for (last = first; last < all.size() && all[last].by == all[first].by; ++last)
        for (std::size_t i = first; i < last; ++i)
          if (!may_become_one(c.vert_at(all[i].vert), c.vert_at(all[last].vert), x)) return false;
      const vert_t<M>& v = c.vert_at(all[first].vert);
      if (last == first + 1 && !is_at(v, x) && !has_one_label(v)) return false;
    }
    return true;
  }

 public:
  label_checker(const M& m, const F& label) : m_(m), label_(label) {}

  template<class Cavity>
  bool new_polys_have_one_label(const Cavity& c) const {
    for (const poly_origin& x : c.origins())
      for (unsigned k = x.first + 1; k < x.first + x.count; ++k)
        if (!are_equal(c.poly(x.first), c.poly(k))) return false;
    return true;
  }
  bool keeps_labels(const cavity_builder<M>& c) const { return keeps_labels_at(c); }
  bool keeps_labels(const general_cavity<M>& c) const { return keeps_labels_at(c) && keeps_labels_at_replaced(c); }
};

}  // namespace detail

/// Refuses edits of m that change the regions of polys with equal labels. Those are flips and merges of polys with
/// different labels, collapses that join two places of the boundary of a region, and collapses that move a vert of the
/// boundary between regions, except along it. Insertions of chords and sheets may move no such vert.
/// Needs:  EditableMesh M; a map of polys, or a function of polys, to anything with ==. One that is large or owns
///         memory must be an lvalue that outlives the invariant. New polys take the labels of those that they come from
///         if the property is carried so.
/// Result: an invariant for `keep`.
/// Cost:   at each edit, at most the square of the number of its polys; in edits of many verts, of those at each.
/// Errors: an edit throws invalid_argument if its mesh is not m; the mesh is unchanged then.
template<EditableMesh M, class F>
  requires(core::caller_map<std::remove_cvref_t<F>>::template can_hold<F>)
invariant keep_labels(const M& m, F&& labels) {
  return [&m, map = core::caller_map<std::remove_cvref_t<F>>(labels)](const proposed_edit& e) -> permission {
    return core::with_cavity_of_edit(e, m, "keep_labels", [&](const auto& c) -> permission {
      const detail::label_checker<M, std::remove_cvref_t<decltype(map)>> checker(m, map);
      if (!checker.new_polys_have_one_label(c))
        return {refusal::invariant, "keep_labels: polys of different labels would be mixed"};
      if (!checker.keeps_labels(c))
        return {refusal::invariant, "keep_labels: the boundary between labels would change"};
      return {};
    });
  };
}

}  // namespace concino
