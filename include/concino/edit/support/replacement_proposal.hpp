// Asks invariants about an edit that replaces polys of any kind, for operators of other modules.
#pragma once

#include <concino/edit/detail/polys/general_proposal.hpp>
#include <concino/mesh/support/standard_cells.hpp>

#include <span>
#include <vector>

namespace concino::core {

/// What invariants ask about a replacement of polys besides its cavity. Verts and old polys have the numbers that they
/// have in the cavity.
template<class M>
struct replacement_origins {
  std::vector<unsigned> polys;           // the old poly from which each new one comes
  std::vector<replaced_vert> verts;      // old verts, and those that take their places, which may be the same
  std::vector<poly_t<M>> neighbours;     // other polys that have edges or faces of old ones
};

/// Adds the lists of a new poly, whose corners are numbers in the cavity.
template<class M>
void add_lists(detail::general_cavity<M>& to, std::span<const unsigned> corners) {
  if constexpr (VolumeMesh<M>) {  // the faces of a cell; a polygon is one list
    const standard_cell& cell = standard_cell_of(corners.size() == 4 ? cell_shape::tet : cell_shape::hex);
    std::vector<unsigned> list;
    for (unsigned f = 0; f < cell.num_faces; ++f) {
      list.clear();
      for (unsigned i = 0; i < cell.face_size[f]; ++i) list.push_back(corners[cell.face_vert[f][i]]);
      to.add_list(list);
    }
  } else {
    to.add_list(corners);
  }
}

/// Whether invariants allow to replace polys.
/// Needs:  EditableMesh M of a surface, or of tets or hexes; a cavity for `rewire`, and what its elements come from.
/// Result: the first refusal, or a permission. Nothing is computed if there are no invariants.
/// Cost:   the cavity and the neighbours, and what the invariants cost.
/// Errors: what an invariant throws.
template<EditableMesh M>
permission ask_about_replacement(const std::vector<invariant>& keep, const M& m, const cavity<M>& c,
                                 const replacement_origins<M>& from) {
  if (keep.empty()) return {};
  detail::general_cavity<M> all(m);
  std::vector<unsigned> number, corners;
  for (const vert_t<M>& v : c.verts) number.push_back(all.vert(v));
  for (const vec3& x : c.points) number.push_back(all.add_point(x, {}));
  for (const poly_t<M>& p : c.polys) all.add_old(p);
  for (std::size_t k = 0, first = 0; k < c.ends.size(); first = c.ends[k++]) {
    corners.clear();
    for (std::size_t i = first; i < c.ends[k]; ++i) corners.push_back(number[c.corners[i]]);
    add_lists(all, corners);
    all.end_new(from.polys[k]);
  }
  for (const replaced_vert& x : from.verts) all.replace_vert({number[x.vert], number[x.by]});
  for (const poly_t<M>& p : from.neighbours) all.add_neighbour(p);
  return detail::ask_general(keep, all);
}

}  // namespace concino::core
