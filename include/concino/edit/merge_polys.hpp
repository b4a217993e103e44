// Merges polys into one across what they share, as edits: descriptors of all that is not touched stay valid.
#pragma once

#include <concino/concepts/facets.hpp>
#include <concino/concepts/maps.hpp>
#include <concino/edit/detail/operator_checks.hpp>
#include <concino/edit/detail/polys/poly_merger.hpp>

#include <algorithm>
#include <concepts>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino {

/// What merge_polys has made of two polys, which is valid only if it was allowed.
template<class M> struct poly_result : permission { poly_t<M> poly{}; };

/// What merge_polys has made of the polys of each label, in ascending order of labels; valid only if it was allowed.
template<class M>
struct merged_polys_result : permission {
  std::vector<poly_t<M>> polys;
  long long label = 0;  // if it is refused by what the polys are: the first label whose polys cannot be merged
};

namespace detail {

inline constexpr permission no_two_polys{refusal::wrong_number, "the edge or face does not have exactly two polys"};

template<class M>
permission merge_cavity_at(const M& m, const facet_t<M>& f, general_cavity<M>& c) {
  unsigned n = 0;
  for (const poly_t<M> p : adj_facet2p(m, f)) {
    if (++n > 2) return no_two_polys;
    c.add_old(p);
  }
  return c.num_old() == 2 ? poly_merger<M>(c, 0, 2)() : no_two_polys;
}

/// Merges the polys of each label. Returns the first refusal, and sets r.label.
template<class M, class L>
permission merge_cavity_by_labels(const M& m, const L& labels, general_cavity<M>& c, merged_polys_result<M>& r) {
  std::vector<poly_t<M>> all;
  std::vector<std::pair<long long, std::size_t>> order;
  for (const poly_t<M> p : polys(m)) {
    order.emplace_back(static_cast<long long>(labels[p]), all.size());
    all.push_back(p);
  }
  std::sort(order.begin(), order.end());
  for (std::size_t i = 0, j = 0; i < order.size(); i = j) {
    while (j < order.size() && order[j].first == order[i].first) ++j;
    r.polys.push_back(all[order[i].second]);
    if (j - i == 1) continue;
    const unsigned first = c.num_old();
    for (std::size_t k = i; k < j; ++k) c.add_old(all[order[k].second]);
    if (const permission p = poly_merger<M>(c, first, c.num_old())(); !p) return r.label = order[i].first, p;
  }
  return {};
}

template<class M>
void check_facet(const M& m, const facet_t<M>& f, const char* edit) {
  check_element(m, f, edit, dimension_v<M> == 2 ? "edge" : "face");
}

}  // namespace detail

/// Whether the two polys at f can be merged. What they share is one chain of edges or one disk of faces, not a whole
/// boundary, with no third poly inside; they are oriented consistently; no poly has the same verts; and the invariants
/// hold.
/// Needs:  EditableGeneralMesh M, an edge of a surface or a face of a volume.      Result: true, or the reason.
/// Cost:   sorting the edges of the two polys, and the elements at some of their verts.      Errors: as merge_polys.
template<EditableGeneralMesh M>
permission can_merge_polys(const M& m, facet_t<M> f, const edit_options& options = {}) {
  detail::check_facet(m, f, "can_merge_polys");
  detail::general_cavity<M> c(m);
  if (const permission p = detail::merge_cavity_at(m, f, c); !p) return p;
  return detail::allow_general(options.keep, c);
}

/// Merges the two polys at f across all that they share. It is the inverse of poly_cut.
/// Needs:  EditableGeneralMesh M.
/// Result: the poly, which has the descriptor of the first one at f, or the reason why not. Its values are those of
///         both, by the rules of properties. Other descriptors remain valid, apart from those of the other poly and of
///         what is inside. All verts and faces on the boundary stay.
/// Cost:   that of can_merge_polys, and the elements at the verts of the polys, but O(mesh) the first time.
/// Errors: invalid_mesh if f is not an element of m, and what an invariant throws. The mesh is unchanged then, also if
///         memory runs out.
template<EditableGeneralMesh M>
poly_result<M> merge_polys(M& m, facet_t<M> f, const edit_options& options = {}) {
  detail::check_facet(m, f, "merge_polys");
  detail::general_cavity<M> c(m);
  if (const permission p = detail::merge_cavity_at(m, f, c); !p) return {p};
  if (const permission p = detail::allow_general(options.keep, c); !p) return {p};
  typename detail::general_cavity<M>::prepared x;
  c.apply(m, x);
  return {{}, x.polys.front()};
}

namespace requirement {

template<class L, class M>
concept has_integer_at_polys = ReadableMap<L, poly_t<M>> && requires(const L& labels, const poly_t<M>& p) {
  { labels[p] } -> std::convertible_to<long long>;
  requires std::integral<std::remove_cvref_t<decltype(labels[p])>>;
};

}  // namespace requirement

/// Merges all polys of one label into one, for each label. agglomerate of <concino/generate.hpp> makes a new mesh of
/// the result instead, also of meshes whose polys have a fixed number of verts.
/// Needs:  EditableGeneralMesh M; labels[p] is an integer. The polys of each label form a disk or a ball, with nothing
///         else inside, and are oriented consistently; random_labels makes such labels.
/// Result: the polys, or the reason why nothing is merged. The poly of a label has the descriptor of its first one in
///         the order of polys(m). Other descriptors remain valid, apart from those of what is inside.
/// Cost:   O(P log P) for P polys, and sorting the elements of those that are merged.
/// Errors: what an invariant throws. The mesh is unchanged then, also if memory runs out.
template<EditableGeneralMesh M, class L>
  requires requirement::has_integer_at_polys<L, M>
merged_polys_result<M> merge_polys(M& m, const L& labels, const edit_options& options = {}) {
  detail::general_cavity<M> c(m);
  merged_polys_result<M> r;
  static_cast<permission&>(r) = detail::merge_cavity_by_labels(m, labels, c, r);
  if (r) static_cast<permission&>(r) = detail::allow_general(options.keep, c);
  if (!r || c.num_old() == 0) return r;
  typename detail::general_cavity<M>::prepared x;
  c.apply(m, x);
  return r;
}

// What to write instead of calls that cannot compile.
template<EditableMesh M, class... T>
  requires(arity_v<M> > 0)
void merge_polys(const M&, const T&...) = delete;  // fixed number of verts: make m a polygonmesh or polyhedralmesh

}  // namespace concino
