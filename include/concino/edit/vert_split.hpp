// Splits a vert of triangles or tets into two that are joined by an edge: the inverse of edge_collapse.
#pragma once

#include <concino/edit/detail/propose.hpp>
#include <concino/edit/detail/link_condition.hpp>

#include <concino/concepts/end_verts.hpp>
#include <concino/concepts/facets.hpp>

#include <optional>
#include <span>
#include <vector>

namespace concino {

template<class M>
struct vert_split_options {
  std::vector<invariant> keep = {};            // see edit_options
  std::optional<vec3> kept_point = {};         // where the old vert moves; none: it stays
  std::span<const facet_t<M>> opened = {};     // further facets at the vert that open, which only moved polys have, or
                                               // only others
};

/// What vert_split needs to undo the collapse of an edge.
template<class M>
struct vert_split_input {
  std::vector<poly_t<M>> moved;
  std::vector<facet_t<M>> opened;
};

namespace detail {

inline constexpr permission not_polys_at_vert{
    refusal::wrong_set, "the moved polys must be at the vert, each once, and the opened facets must be at it too"};
inline constexpr permission nothing_opens{refusal::wrong_set,
                                          "no facet opens: none at the vert is between a moved poly and another one"};
inline constexpr permission split_breaks_link_condition{
    refusal::link_condition, "the link condition does not hold for the new edge: parts of the mesh would come apart"};

/// A facet at the split vert without this vert, and the moved poly at it.
template<std::size_t N>
struct opened_facet {
  local_simplex<N> verts;
  unsigned poly, opposite;  // the poly, and its vert that is not in the facet
  friend bool operator<(const opened_facet& a, const opened_facet& b) { return a.verts < b.verts; }
};

/// The facets at v of the polys first, ..., last - 1, sorted.
template<class M, std::size_t N>
void list_facets_at(const cavity_builder<M>& c, unsigned v, unsigned first, unsigned last,
                    core::small_array<opened_facet<N>, 64>& all) {
  for (unsigned k = first; k < last; ++k)
    for (unsigned i = 0; i < c.size; ++i) {
      const unsigned x = c.corners(k)[i];
      if (x == v) continue;
      simplex_list<N> one;
      add_link_simplex<N>(one, c.corners(k), c.size, v, x);
      all.push_back({one[0], k, x});
    }
  std::sort(all.begin(), all.end());
}

/// Old polys are the moved ones, neighbours the others at v.
template<class M>
permission find_polys_at(const M& m, const vert_t<M>& v, std::span<const poly_t<M>> moved,
                         std::span<const facet_t<M>> opened, cavity_builder<M>& c) {
  core::local_numbers numbers;
  for (const poly_t<M>& p : moved) {
    if (numbers.find(index_of(m, p)) != numbers.none) return not_polys_at_vert;
    numbers.add(index_of(m, p));
    if (!c.add_old(p)) return not_simplices;
  }
  const unsigned a = c.vert(v);
  for (unsigned k = 0; k < c.num_old(); ++k)
    if (!c.has(k, a)) return not_polys_at_vert;
  for (const facet_t<M>& f : opened)
    for (const vert_t<M> x : adj_facet2v(m, f)) c.vert(x);
  c.end_verts_of_cavity();
  for (const poly_t<M> p : adj_v2p(m, v))
    if (numbers.find(index_of(m, p)) == numbers.none && !c.add_neighbour(p)) return not_simplices;
  return {};
}

/// Collects the facets that open, each once: those between moved polys and others, and `opened`. Returns false if one
/// of these is not at v.
template<class M, std::size_t N>
bool find_opened_facets(const M& m, unsigned v, std::span<const facet_t<M>> opened, cavity_builder<M>& c,
                        core::small_array<opened_facet<N>, 64>& all) {
  core::small_array<opened_facet<N>, 64> of_moved, of_others;
  list_facets_at(c, v, 0, c.num_old(), of_moved);
  list_facets_at(c, v, c.num_old(), c.num_polys(), of_others);
  for (const opened_facet<N>& f : of_moved)
    if (std::binary_search(of_others.begin(), of_others.end(), f)) all.push_back(f);
  for (const facet_t<M>& x : opened) {
    unsigned corners[N + 1], n = 0;
    bool has_v = false;
    for (const vert_t<M> y : adj_facet2v(m, x)) {
      if (n > N) return false;
      corners[n] = c.vert(y);
      has_v |= corners[n++] == v;
    }
    if (!has_v || n != N + 1) return false;
    simplex_list<N> one;
    add_link_simplex<N>(one, corners, n, v, v);
    const opened_facet<N> wanted{one[0], 0, 0};
    const opened_facet<N>* f = std::lower_bound(of_moved.begin(), of_moved.end(), wanted);
    if (f == of_moved.end() || wanted < *f) {
      f = std::lower_bound(of_others.begin(), of_others.end(), wanted);
      if (f == of_others.end() || wanted < *f) return false;
    }
    all.push_back(*f);
  }
  std::sort(all.begin(), all.end());
  all.resize(static_cast<std::size_t>(
                 std::unique(all.begin(), all.end(), [](const auto& f, const auto& g) { return f.verts == g.verts; }) -
                 all.begin()),
             {});
  return true;
}

/// A new poly is made of each facet that opens and the new vert.
template<class M>
permission vert_split_cavity(const M& m, const vert_t<M>& v, std::span<const poly_t<M>> moved, const vec3& x,
                             const vert_split_options<M>& options, cavity_builder<M>& c) {
  constexpr unsigned n = cavity_builder<M>::size - 1, added = cavity_builder<M>::added;
  if (const permission p = find_polys_at(m, v, moved, options.opened, c); !p) return p;
  const unsigned a = c.vert(v), b = c.num_verts();  // b: the number of the new vert in the links
  core::small_array<opened_facet<n - 1>, 64> all;
  if (!find_opened_facets(m, a, options.opened, c, all)) return not_polys_at_vert;
  if (all.empty()) return nothing_opens;
  simplex_list<n> link_a, link_b;
  simplex_list<n - 1> link_ab;
  for (unsigned k = 0; k < c.num_polys(); ++k)
    add_link_simplex<n>(k < c.num_old() ? link_b : link_a, c.corners(k), c.size, a, a);
  for (unsigned k = 0; k < c.num_old(); ++k) c.add_new(k, a, added);
  for (const opened_facet<n - 1>& f : all) {
    // the new poly is the mirror image of a poly at the facet, whose opposite vert becomes the end of the new edge that
    // this poly lacks
    const bool is_moved = f.poly < c.num_old();
    unsigned corners[n + 1], of_facet[n];
    for (unsigned i = 0; i <= n; ++i) {
      const unsigned y = c.corners(f.poly)[i];
      corners[i] = y == f.opposite ? (is_moved ? a : added) : y == a && is_moved ? added : y;
    }
    std::swap(corners[0], corners[1]);
    c.add_new(corners, f.poly);
    std::copy_n(f.verts.begin(), n - 1, of_facet);
    of_facet[n - 1] = b, add_link_simplex<n>(link_a, of_facet, n, a, a);
    of_facet[n - 1] = a, add_link_simplex<n>(link_b, of_facet, n, b, b);
    link_ab.push_back(f.verts);
  }
  c.keep(c.num_old());
  c.add_point(x, {a, a, 0});
  if (options.kept_point) c.move(a, *options.kept_point);
  return can_collapse<n>(link_a, link_b, link_ab, b + 1) ? permission{} : split_breaks_link_condition;
}

template<class M>
void check_vert_split(const M& m, const vert_t<M>& v, std::span<const poly_t<M>> moved, const vec3& x,
                      const vert_split_options<M>& options, const char* edit) {
  check_element(m, v, edit, "vert");
  for (const poly_t<M>& p : moved) check_element(m, p, edit, "poly");
  for (const facet_t<M>& f : options.opened) check_element(m, f, edit, dimension_v<M> == 2 ? "edge" : "face");
  check_point(x, edit);
  if (options.kept_point) check_point(*options.kept_point, edit);
}

}  // namespace detail

/// What undoes the collapse of e: after `auto undo = inverse_of_collapse(m, e); auto c = edge_collapse(m, e);`,
/// `vert_split(m, c.vert, undo.moved, x, {.opened = undo.opened})` restores the connectivity, where x was the point of
/// the second end.
/// Needs:  EditableMesh M, an edge of m.
/// Result: the polys at the second end that the first end lacks, and the facets of polys at e that lack the second end.
/// Cost:   the polys at the second end.
/// Errors: invalid_mesh if e is not an edge of m.
template<EditableMesh M>
vert_split_input<M> inverse_of_collapse(const M& m, edge_t<M> e) {
  detail::check_element(m, e, "inverse_of_collapse", "edge");
  vert_split_input<M> undo;
  const auto ends = end_verts(m, e);
  const auto is_among = [](const auto& range, const vert_t<M>& v) {
    for (const vert_t<M> x : range)
      if (x == v) return true;
    return false;
  };
  for (const poly_t<M> p : adj_v2p(m, ends.second))
    if (!is_among(adj_p2v(m, p), ends.first)) undo.moved.push_back(p);
  for (const poly_t<M> p : adj_e2p(m, e))
    for (const facet_t<M> f : adj_p2facet(m, p))
      if (!is_among(adj_facet2v(m, f), ends.second)) undo.opened.push_back(f);
  return undo;
}

/// Whether v can be split so that these polys go to the new vert: a facet opens, and collapsing the new edge would be
/// allowed. The invariants hold.
/// Needs:  EditableMesh M, polys of m.
/// Result: true, or the reason: the polys or facets are not at v, a poly at v is no simplex, no facet opens, or the
///         topology would change.
/// Cost:   the polys at v, and sorting these.
/// Errors: as vert_split.
template<EditableMesh M>
permission can_vert_split(const M& m, vert_t<M> v, std::span<const std::type_identity_t<poly_t<M>>> moved,
                          const vec3& x, const vert_split_options<M>& options = {}) {
  detail::check_vert_split<M>(m, v, moved, x, options, "can_vert_split");
  detail::cavity_builder<M> c(m);
  if (const permission p = detail::vert_split_cavity<M>(m, v, moved, x, options, c); !p) return p;
  if (const permission p = detail::is_representable(m, c); !p) return p;
  return detail::ask(options.keep, m, c);
}

/// Splits v: the moved polys get a new vert at x in its place. Each facet at v between a moved poly and another one
/// opens into a new poly, whose verts are those of the facet and the new vert. In a surface these are the two edges at
/// which the moved polys of a closed fan begin and end. Facets that have no poly on one side, as at the boundary, open
/// if options.opened lists them.
/// Needs:  EditableMesh M; a finite x.
/// Result: the new vert, or the reason why not. All descriptors of verts and polys remain valid, and those of other
///         elements that some poly not moved has.
/// Cost:   that of can_vert_split, and the elements at the verts of the moved polys, but O(mesh) the first time.
/// Errors: invalid_mesh if v is not a vert, or one of the polys or facets not a poly or facet of m; invalid_argument if
///         a point is not finite. The mesh is unchanged then, also if memory runs out.
/// Source: Hoppe 1996, "Progressive meshes".
template<EditableMesh M>
vert_result<M> vert_split(M& m, vert_t<M> v, std::span<const std::type_identity_t<poly_t<M>>> moved, const vec3& x,
                          const vert_split_options<M>& options = {}) {
  detail::check_vert_split<M>(m, v, moved, x, options, "vert_split");
  detail::cavity_builder<M> c(m);
  if (const permission p = detail::vert_split_cavity<M>(m, v, moved, x, options, c); !p) return {p};
  if (const permission p = detail::is_representable(m, c); !p) return {p};
  if (const permission p = detail::ask(options.keep, m, c); !p) return {p};
  c.apply(m);
  return {{}, c.new_vert()};
}

}  // namespace concino
