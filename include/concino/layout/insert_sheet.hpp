// Inserts a chord of quads along edges, or a sheet of hexes along faces. pillow: a layer around some polys.
#pragma once

#include <concino/core/number_text.hpp>
#include <concino/layout/detail/apply_cell_edit.hpp>
#include <concino/layout/detail/cell_insertion.hpp>

#include <initializer_list>
#include <span>
#include <vector>

namespace concino {

struct insert_sheet_options {
  double thickness = 1 / 3.0;  // in [0, 1): by which part of the polys on either side the new ones push these back;
                               // with 0 they have no thickness
  std::vector<invariant> keep = {};  // see edit_options; asked about the polys that change and the new ones
};
struct pillow_options {
  double thickness = 1 / 3.0;  // as that of insert_sheet_options
  bool at_boundary = true;     // whether the layer also covers facets of the polys at the boundary; else it ends there
  std::vector<invariant> keep = {};  // as that of insert_sheet_options
};

/// What an insertion returns: a permission, the new polys, in the order of the edges or faces, and an edge of them that
/// lies across the new chord or sheet.
template<class M>
struct inserted_sheet : permission {
  std::vector<poly_t<M>> polys;
  edge_t<M> edge{};
};

namespace detail {

template<class M>
struct planned_insertion {
  cell_patch<M> patch;
  cell_edit e;

  planned_insertion(const M& m, const std::vector<facet_t<M>>& along, double thickness, const char* caller)
      : patch(
            m, along, [&](const facet_t<M>& x) { return adj_facet2v(m, x); }, caller),
        e(patch.t) {
    std::vector<std::uint32_t> numbers;
    for (const facet_t<M>& x : along) {
      numbers.push_back(patch.facet_number(m, x));
      if (numbers.back() == patch.t.none) {
        e.allowed = facet_of_many;
        return;
      }
    }
    e = inserted(patch.t, boundary_flags(patch.t), patch.points, numbers, thickness);
  }
};

template<class M>
std::vector<facet_t<M>> checked_facets(const M& m, std::span<const facet_t<M>> all, double thickness,
                                       const char* caller) {
  if (!(thickness >= 0 && thickness < 1))
    core::throw_joined<invalid_argument>(
        {caller, ": options.thickness is ", core::number_text(thickness), "; it must be in [0, 1)"});
  for (const facet_t<M>& f : all) check_member(m, f, caller, dimension_v<M> == 2 ? "edge" : "face");
  return {all.begin(), all.end()};
}

/// The facets with one poly in the set.
template<class M>
std::vector<facet_t<M>> facets_around(const M& m, std::span<const poly_t<M>> some, bool at_boundary,
                                      const char* caller) {
  core::local_numbers inside;
  std::vector<facet_t<M>> around;
  for (const poly_t<M>& p : some) check_member(m, p, caller, "poly"), inside.add(index_of(m, p));
  core::local_numbers known;
  for (const poly_t<M>& p : some)
    for (const facet_t<M> f : adj_p2facet(m, p)) {
      const unsigned before = known.size();
      if (known.add(index_of(m, f)) < before) continue;
      std::size_t num_inside = 0, num_all = 0;
      for (const poly_t<M> q : adj_facet2p(m, f)) num_inside += inside.find(index_of(m, q)) != inside.none, ++num_all;
      if (num_inside == 1 && (at_boundary || num_all > 1)) around.push_back(f);
    }
  return around;
}

template<class M>
permission can_insert(const M& m, const std::vector<facet_t<M>>& along, double thickness,
                      const std::vector<invariant>& keep, const char* caller) {
  const planned_insertion<M> plan(m, along, thickness, caller);
  return plan.e.allowed ? cell_replacement<M>(m, plan.patch, plan.e).ask(m, plan, keep) : plan.e.allowed;
}

template<class M>
inserted_sheet<M> insert(M& m, const std::vector<facet_t<M>>& along, double thickness,
                         const std::vector<invariant>& keep, const char* caller) {
  const planned_insertion<M> plan(m, along, thickness, caller);
  if (!plan.e.allowed) return {plan.e.allowed, {}, edge_t<M>{}};
  cell_replacement<M> replacement(m, plan.patch, plan.e);
  if (const permission p = replacement.ask(m, plan, keep); !p) return {p, {}, edge_t<M>{}};
  inserted_sheet<M> r;
  r.polys.reserve(along.size());
  replacement.apply(m);
  r.polys.assign(replacement.new_polys.begin() + static_cast<std::ptrdiff_t>(replacement.num_kept()),
                 replacement.new_polys.end());
  r.edge = edge_at(m, r.polys[0], dimension_v<M> - 1, caller);
  return r;
}

}  // namespace detail

/// Whether a chord of quads can be inserted along edges.
/// Needs:  an EditableSurfaceMesh whose polys are quads, with points; edges of it.
/// Result: true, or the reason: the edges are not a closed curve or one from boundary to boundary, meet or touch
///         themselves, or an invariant does not hold. Edges at the boundary are allowed: outside of
///         the mesh is a side of them.
/// Cost:   the polys at the verts of the edges, and sorting these.
/// Errors: as insert_chord.
template<EditableSurfaceMesh M>
  requires requirement::may_be_quads<M> permission can_insert_chord(
      const M& m, std::span<const std::type_identity_t<edge_t<M>>> along, const insert_sheet_options& options = {}) {
    const auto all = detail::checked_facets<M>(m, along, options.thickness, "can_insert_chord");
    return detail::can_insert(m, all, options.thickness, options.keep, "can_insert_chord");
  }

/// Inserts a chord of quads along edges: the quads on their two sides get verts of their own, with a new quad between
/// for each edge. It is the inverse of collapse_chord of a chord that neither crosses nor touches itself.
/// Needs:  as can_insert_chord.
/// Result: the new quads, or the reason why not. Verts of the edges are replaced by two new ones, with their values;
///         one that is outside of the mesh, or at which nothing moves, stays. Values of new quads are those of a quad
///         beside them. Other verts, and all quads that were there, keep their descriptors.
/// Cost:   that of can_insert_chord, but O(mesh) the first time.
/// Errors: invalid_mesh if an edge is not one of m, or a poly there is not a quad; invalid_argument if the thickness is
///         not in [0, 1). The mesh is unchanged then, also if memory runs out.
/// Source: Mitchell, Tautges 1995, "Pillowing doublets"; Ledoux, Shepherd 2010, "Topological modifications of
///         hexahedral meshes via sheet operations".
template<EditableSurfaceMesh M>
  requires requirement::may_be_quads<M> inserted_sheet<M> insert_chord(
      M& m, std::span<const std::type_identity_t<edge_t<M>>> along, const insert_sheet_options& options = {}) {
    const auto all = detail::checked_facets<M>(m, along, options.thickness, "insert_chord");
    return detail::insert(m, all, options.thickness, options.keep, "insert_chord");
  }

/// Whether a sheet of hexes can be inserted along faces.
/// Needs:  an EditableVolumeMesh of hexes, with points; faces of it.
/// Result: true, or the reason: the faces are not a closed surface or one that ends at the boundary, meet or touch
///         themselves, or an invariant does not hold.
/// Cost:   the polys at the verts of the faces, and sorting these.
/// Errors: as insert_sheet.
template<EditableVolumeMesh M>
  requires HexMesh<M> permission can_insert_sheet(const M& m, std::span<const std::type_identity_t<face_t<M>>> along,
                                                  const insert_sheet_options& options = {}) {
    const auto all = detail::checked_facets<M>(m, along, options.thickness, "can_insert_sheet");
    return detail::can_insert(m, all, options.thickness, options.keep, "can_insert_sheet");
  }

/// Inserts a sheet of hexes along faces, as insert_chord does with quads along edges. It is the inverse of
/// collapse_sheet of a sheet that neither crosses nor touches itself.
/// Needs:  as can_insert_sheet.      Result: as insert_chord.
/// Cost:   that of can_insert_sheet, but O(mesh) the first time.
/// Errors: invalid_mesh if a face is not one of m; invalid_argument if the thickness is not in [0, 1). The mesh is
///         unchanged then, also if memory runs out.
/// Source: as insert_chord.
template<EditableVolumeMesh M>
  requires HexMesh<M> inserted_sheet<M> insert_sheet(M& m, std::span<const std::type_identity_t<face_t<M>>> along,
                                                     const insert_sheet_options& options = {}) {
    const auto all = detail::checked_facets<M>(m, along, options.thickness, "insert_sheet");
    return detail::insert(m, all, options.thickness, options.keep, "insert_sheet");
  }

/// Whether a layer of quads or hexes can be inserted around some of them.
/// Needs:  an EditableMesh of quads or hexes, with points; polys of it.
/// Result: true, or the reason, as can_insert_sheet for the facets around the polys.
/// Cost:   the polys at the verts of these facets, and sorting these.
/// Errors: as pillow.
template<EditableMesh M>
  requires requirement::may_be_quads_or_hexes<M> permission
  can_pillow(const M& m, std::span<const std::type_identity_t<poly_t<M>>> inside, const pillow_options& options = {}) {
    const auto around = detail::facets_around<M>(m, inside, options.at_boundary, "can_pillow");
    const auto all = detail::checked_facets<M>(m, around, options.thickness, "can_pillow");
    return detail::can_insert(m, all, options.thickness, options.keep, "can_pillow");
  }

/// Inserts a layer of quads or hexes around some of them.
/// Needs:  as can_pillow.
/// Result: the new polys, or the reason why not; elements as insert_chord.
/// Cost:   that of can_pillow, but O(mesh) the first time.
/// Errors: invalid_mesh if one of the polys is not one of m, or not a quad; invalid_argument if the thickness is not in
///         [0, 1). The mesh is unchanged then, also if memory runs out.
/// Source: Mitchell, Tautges 1995, as insert_chord.
template<EditableMesh M>
  requires requirement::may_be_quads_or_hexes<M> inserted_sheet<M> pillow(
      M& m, std::span<const std::type_identity_t<poly_t<M>>> inside, const pillow_options& options = {}) {
    const auto around = detail::facets_around<M>(m, inside, options.at_boundary, "pillow");
    const auto all = detail::checked_facets<M>(m, around, options.thickness, "pillow");
    return detail::insert(m, all, options.thickness, options.keep, "pillow");
  }

}  // namespace concino
