// Collapses an edge of polys with any number of verts.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/edit/detail/direct_edits.hpp>
#include <concino/edit/detail/polys/general_collapse.hpp>
#include <concino/edit/merge_verts.hpp>

#include <optional>
#include <vector>

namespace concino::detail {

inline constexpr permission breaks_link_condition{
    refusal::link_condition, "the link condition does not hold: parts of the mesh would touch or vanish"};

/// The ends of the edge, and where the one that remains lies.
template<class M>
struct collapse_of_polys {
  const M& m;
  const vert_t<M> kept, removed;
  const double t;                     // the remaining vert lies at (1 - t) kept + t removed,
  const std::optional<vec3>& point;   // unless a point is given
  relabelled_cavity<M> cavity{m};

  bool moves() const { return point || t > 0; }
  vec3 moved_to() const {
    return point ? *point : point_between(to_vec3(concino::point(m, kept)), to_vec3(concino::point(m, removed)), t);
  }

  /// Whether the collapse is allowed. Then `cavity` is ready to be applied.
  permission propose(const std::vector<invariant>& keep) {
    if (has_loose_face(m, kept) || has_loose_face(m, removed)) return face_without_polys;
    general_cavity<M> around(m);
    for (const poly_t<M> p : adj_v2p(m, removed)) around.add_old(p);
    for (const poly_t<M> p : adj_v2p(m, kept)) around.add_old(p);
    const unsigned a = around.vert(kept), b = around.vert(removed);
    if (!divided_links<M>(around, a, b).allow_collapse()) return breaks_link_condition;
    if (would_share_more(around, a, b)) return collapse_shares_more;
    if (has_equal_faces(around, a, b)) return general_same_verts;
    cavity.number(removed);
    cavity.end_removed();
    const unsigned label = cavity.number(kept);
    for (const poly_t<M> p : adj_v2p(m, removed)) cavity.set_label(cavity.add(p), 0, label);
    cavity.build();
    for (const unsigned k : cavity.degenerate())
      if (const unsigned i = around.find_poly(index_of(m, cavity.polys()[k]));
          !is_simplex(around, i) || !around.has(i, a) || !around.has(i, b))
        return too_few_faces;
    if (has_polys_on_same_verts(m, kept, cavity)) return polys_on_same_verts;
    cavity.prepare();
    if (const permission p = is_representable(m, cavity.lists()); !p) return p;
    return keep.empty() ? permission{} : ask(keep);
  }

  void apply(M& to) {
    const vec3 at = moved_to();
    const auto index = [&](const vert_t<M>& v) { return static_cast<std::uint32_t>(index_of(to, v)); };
    std::vector<relabelled_vert> changed(1);
    changed[0].label = cavity.num_removed();
    changed[0].from = {{index(kept), 1 - t}, {index(removed), t}};
    changed[0].of_sums = {{index(kept)}, {index(removed)}};
    apply_relabelling(to, cavity, changed, [&] {
      // while a transaction is open, moving the vert may fail, so it comes first
      const bool is_recorded = has_open_transaction(to);
      if (moves() && is_recorded) set_point(to, kept, at);
      cavity.apply(to);
      if (moves() && !is_recorded) set_point(to, kept, at);
    });
  }

 private:
  permission ask(const std::vector<invariant>& keep) const {
    general_cavity<M> c(m);
    for (const poly_t<M>& p : cavity.polys()) c.add_old(p);
    const concino::cavity<M> lists = cavity.lists();
    std::vector<unsigned> list;
    unsigned i = 0, corner = 0;
    for (std::size_t k = 0; k < cavity.survivors().size(); ++k) {
      const unsigned end = lists.poly_ends.size() > 0 ? lists.poly_ends[k] : static_cast<unsigned>(k) + 1;
      for (; i < end; ++i) {
        list.clear();
        for (; corner < lists.ends[i]; ++corner) list.push_back(c.vert(lists.verts[lists.corners[corner]]));
        c.add_list(list);
      }
      c.end_new(cavity.survivors()[k]);
    }
    const unsigned a = c.vert(kept);
    c.merge(a, c.vert(removed));
    if (moves()) c.move(a, moved_to());
    for (const poly_t<M> p : adj_v2p(m, kept))
      if (!cavity.has(p)) c.add_neighbour(p);
    return ask_general(keep, c);
  }
};

}  // namespace concino::detail
