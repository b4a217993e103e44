// Collapses a chord of quads or a sheet of hexes: the two ends of each of its edges become one vert, and its polys
// vanish.
#pragma once

#include <concino/layout/chords.hpp>
#include <concino/layout/detail/apply_cell_edit.hpp>
#include <concino/layout/detail/cell_collapse.hpp>
#include <concino/layout/sheets.hpp>

#include <vector>

namespace concino {

struct collapse_sheet_options {
  std::vector<invariant> keep = {};  // see edit_options; asked about the polys that change
};

/// What collapse_chord returns: a permission, and the edges to which the chord has become, for insert_chord. There are
/// none if the chord crosses or touches itself.
template<class M>
struct collapsed_chord : permission {
  std::vector<edge_t<M>> edges;
};

/// What collapse_sheet returns: a permission, and the faces to which the sheet has become, for insert_sheet. There are
/// none if the sheet crosses or touches itself.
template<class M>
struct collapsed_sheet : permission {
  std::vector<face_t<M>> faces;
};

namespace detail {

inline constexpr permission not_a_chord{refusal::wrong_set,
                                        "these are not the edges of one chord or sheet of the mesh"};

/// The collapse of the cells along some edges, which are a whole chord or sheet.
template<class M>
struct planned_collapse {
  const std::vector<edge_t<M>>& edges;
  cell_patch<M> patch;
  cell_edit e;

  planned_collapse(const M& m, const std::vector<edge_t<M>>& all, const char* caller)
      : edges(all), patch(
                        m, all, [&](const edge_t<M>& x) { return adj_e2v(m, x); }, caller),
        e(patch.t) {
    std::vector<unsigned char> is_marked(patch.t.num_edges);
    for (const edge_t<M>& x : all)
      if (const std::uint32_t n = patch.number(m, x); n != patch.t.none) is_marked[n] = 1;
    const boundary_flags boundary(patch.t);
    e = collapsed(patch.t, boundary, patch.points, collapse_along(patch.t, boundary, is_marked));
    if (patch.polys.empty()) e.allowed = not_a_chord;
  }
  bool has_touching_edges(const M& m) const {
    core::local_numbers verts;
    for (const edge_t<M>& x : edges)
      for (const vert_t<M> v : adj_e2v(m, x)) verts.add(index_of(m, v));
    return verts.size() < 2 * edges.size();
  }
};

template<class M>
permission can_collapse(const M& m, const std::vector<edge_t<M>>& along, const collapse_sheet_options& options,
                        const char* caller) {
  const planned_collapse<M> plan(m, along, caller);
  return plan.e.allowed ? cell_replacement<M>(m, plan.patch, plan.e).ask(m, plan, options.keep) : plan.e.allowed;
}

template<class M>
permission collapse(M& m, const std::vector<edge_t<M>>& along, const collapse_sheet_options& options,
                    std::vector<facet_t<M>>& becomes, const char* caller) {
  const planned_collapse<M> plan(m, along, caller);
  if (!plan.e.allowed) return plan.e.allowed;
  cell_replacement<M> replacement(m, plan.patch, plan.e);
  if (const permission p = replacement.ask(m, plan, options.keep); !p) return p;
  const bool has_inverse = !plan.has_touching_edges(m);
  if (has_inverse) becomes.reserve(plan.e.facets.size());
  replacement.apply(m);
  const unsigned n = plan.patch.t.num_poly_facets();
  for (std::size_t i = 0; has_inverse && i < plan.e.facets.size(); ++i)
    becomes.push_back(facet_at(m, plan.patch.polys[plan.e.facets[i] / n], plan.e.facets[i] % n, caller));
  return {};
}

/// Whether two lists have the same elements.
template<class M, class X>
bool are_same_set(const M& m, const std::vector<X>& a, const std::vector<X>& b) {
  core::local_numbers numbers;
  for (const X& x : a) numbers.add(index_of(m, x));
  if (numbers.size() != a.size() || a.size() != b.size()) return false;
  for (const X& x : b)
    if (numbers.find(index_of(m, x)) == numbers.none) return false;
  return true;
}

/// Errors: invalid_mesh if one of its edges is not an edge of m.
template<class M>
permission check_chord(const M& m, const chord<M>& c, const char* caller) {
  for (const edge_t<M>& e : c.facets) check_member(m, e, caller, "edge");
  if (c.facets.empty() || !are_same_set(m, c.facets, chord_through(m, c.facets[0], caller).facets)) return not_a_chord;
  return {};
}
template<class M>
permission check_sheet(const M& m, const sheet<M>& s, const char* caller) {
  for (const edge_t<M>& e : s.edges) check_member(m, e, caller, "edge");
  if (s.edges.empty() || !are_same_set(m, s.edges, sheet_through(m, s.edges[0], caller).edges)) return not_a_chord;
  return {};
}

}  // namespace detail

/// Whether a chord of quads can be collapsed.
/// Needs:  an EditableSurfaceMesh whose polys are quads, with points; a chord of it.
/// Result: true, or the reason: the topology would change, as where the chord connects two boundaries, two edges or
///         quads would have the same verts, or an invariant does not hold.
/// Cost:   the polys at the verts of the chord, and sorting these.
/// Errors: as collapse_chord.
template<EditableSurfaceMesh M>
  requires requirement::may_be_quads<M> permission can_collapse_chord(const M& m, const chord<M>& c,
                                                                      const collapse_sheet_options& options = {}) {
    if (const permission p = detail::check_chord(m, c, "can_collapse_chord"); !p) return p;
    return detail::can_collapse(m, c.facets, options, "can_collapse_chord");
  }

/// Collapses a chord of quads: the ends of each of its edges become one vert, and its quads vanish.
/// Needs:  as can_collapse_chord.
/// Result: the edges to which the chord has become, or the reason why not. Of the verts that become one, the one at a
///         corner of the boundary stays, else the one on the boundary. Several of the same rank are replaced by a new
///         vert at their mean, with the means of their values. Other verts and quads keep their descriptors.
/// Cost:   that of can_collapse_chord, but O(mesh) the first time.
/// Errors: invalid_mesh if an edge of the chord is not one of m, or a poly there is not a quad. The mesh is unchanged
///         then, also if memory runs out.
/// Source: Borden, Benzley, Shepherd 2002, "Hexahedral sheet extraction"; paper section 4.
template<EditableSurfaceMesh M>
  requires requirement::may_be_quads<M> collapsed_chord<M> collapse_chord(M& m, const chord<M>& c,
                                                                          const collapse_sheet_options& options = {}) {
    collapsed_chord<M> r{detail::check_chord(m, c, "collapse_chord"), {}};
    if (r) static_cast<permission&>(r) = detail::collapse(m, c.facets, options, r.edges, "collapse_chord");
    return r;
  }

/// Whether a sheet of hexes can be collapsed.
/// Needs:  an EditableVolumeMesh of hexes, with points; a sheet of it.
/// Result: as can_collapse_chord.      Cost: the polys at the verts of the sheet, and sorting these.
/// Errors: as collapse_sheet.
template<EditableVolumeMesh M>
  requires HexMesh<M> permission can_collapse_sheet(const M& m, const sheet<M>& s,
                                                    const collapse_sheet_options& options = {}) {
    if (const permission p = detail::check_sheet(m, s, "can_collapse_sheet"); !p) return p;
    return detail::can_collapse(m, s.edges, options, "can_collapse_sheet");
  }

/// Collapses a sheet of hexes, as collapse_chord does with quads.
/// Needs:  as can_collapse_sheet.
/// Result: the faces to which the sheet has become, or the reason why not; verts as collapse_chord.
/// Cost:   that of can_collapse_sheet, but O(mesh) the first time.
/// Errors: invalid_mesh if an edge of the sheet is not one of m. The mesh is unchanged then, also if memory runs out.
/// Source: as collapse_chord.
template<EditableVolumeMesh M>
  requires HexMesh<M> collapsed_sheet<M> collapse_sheet(M& m, const sheet<M>& s,
                                                        const collapse_sheet_options& options = {}) {
    collapsed_sheet<M> r{detail::check_sheet(m, s, "collapse_sheet"), {}};
    if (r) static_cast<permission&>(r) = detail::collapse(m, s.edges, options, r.faces, "collapse_sheet");
    return r;
  }

}  // namespace concino
