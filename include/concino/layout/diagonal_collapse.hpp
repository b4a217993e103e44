// Collapses a quad along one of its diagonals: two opposite corners become one vert.
#pragma once

#include <concino/layout/collapse_sheet.hpp>

namespace concino {

namespace detail {

template<class M>
struct planned_diagonal {
  cell_patch<M> patch;
  cell_edit e;
  vert_t<M> kept{};  // if no vert is new

  planned_diagonal(const M& m, const poly_t<M>& p, const vert_t<M>& v, const char* caller)
      : patch(
            m, std::vector<poly_t<M>>{p}, [&](const poly_t<M>& x) { return adj_p2v(m, x); }, caller),
        e(patch.t) {
    const auto corners = corners_by_place(m, p, caller);
    unsigned place = 0;
    while (place < 4 && !(corners[place] == v)) ++place;
    if (place == 4)
      core::throw_joined<invalid_argument>(
          {caller, ": vert ", index_of(m, v), " is not a corner of poly ", index_of(m, p)});
    std::uint32_t number = 0;
    while (!(patch.polys[number] == p)) ++number;
    e = collapsed(patch.t, boundary_flags(patch.t), patch.points, collapse_diagonal(patch.t, number, place));
    const bool goes = !e.removed.empty() && patch.verts[e.removed[0]] == v;
    kept = goes ? corners[place ^ 3] : v;
  }
};

}  // namespace detail

/// Whether a quad can be collapsed along the diagonal from v.
/// Needs:  an EditableSurfaceMesh whose polys at p are quads, with points; a poly of it and a vert of the poly.
/// Result: true, or the reason: both ends of the diagonal are on the boundary, two edges or quads would have the same
///         verts, or an invariant does not hold.
/// Cost:   the polys at the verts of p, and sorting these.
/// Errors: as diagonal_collapse.
template<EditableSurfaceMesh M>
  requires requirement::may_be_quads<M> permission can_diagonal_collapse(const M& m, poly_t<M> p, vert_t<M> v,
                                                                         const collapse_sheet_options& options = {}) {
    detail::check_member(m, p, "can_diagonal_collapse", "poly");
    const detail::planned_diagonal<M> plan(m, p, v, "can_diagonal_collapse");
    if (!plan.e.allowed) return plan.e.allowed;
    return detail::cell_replacement<M>(m, plan.patch, plan.e).ask(m, plan, options.keep);
  }

/// Collapses a quad along a diagonal: v and the opposite corner become one vert, p vanishes, and of its edges each two
/// at one of the other corners become one.
/// Needs:  as can_diagonal_collapse.
/// Result: the vert, or the reason why not; its place and values are those of collapse_chord. Other verts and quads
///         keep their descriptors.
/// Cost:   that of can_diagonal_collapse, but O(mesh) the first time.
/// Errors: invalid_mesh if p is not a poly of m, or a poly at it is not a quad; invalid_argument if v is not a vert of
///         p. The mesh is unchanged then, also if memory runs out.
/// Source: Daniels, Silva, Shepherd, Cohen 2008, "Quadrilateral mesh simplification".
template<EditableSurfaceMesh M>
  requires requirement::may_be_quads<M> vert_result<M> diagonal_collapse(M& m, poly_t<M> p, vert_t<M> v,
                                                                         const collapse_sheet_options& options = {}) {
    detail::check_member(m, p, "diagonal_collapse", "poly");
    const detail::planned_diagonal<M> plan(m, p, v, "diagonal_collapse");
    if (!plan.e.allowed) return {plan.e.allowed, vert_t<M>{}};
    detail::cell_replacement<M> replacement(m, plan.patch, plan.e);
    if (const permission r = replacement.ask(m, plan, options.keep); !r) return {r, vert_t<M>{}};
    replacement.apply(m);
    return {{}, plan.e.points.empty() ? plan.kept : replacement.new_verts[0]};
  }

}  // namespace concino
