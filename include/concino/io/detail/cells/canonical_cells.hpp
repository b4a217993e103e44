// Lists the verts of cells so that the list does not depend on how the mesh stores the cell: for writers that recognise
// cells by their faces.
#pragma once

#include <concino/mesh/support/cell_recogniser.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace concino::detail {

/// Bit j of entry i: verts i and j of the standard cell have an edge in common.
constexpr std::array<unsigned, 8> neighbours_in(const standard_cell& t) {
  std::array<unsigned, 8> bits{};
  for (unsigned f = 0; f < t.num_faces; ++f)
    for (unsigned i = 0; i < t.face_size[f]; ++i) {
      const unsigned a = t.face_vert[f][i], b = t.face_vert[f][(i + 1) % t.face_size[f]];
      bits[a] |= 1u << b;
      bits[b] |= 1u << a;
    }
  return bits;
}

/// Calls use(verts) for each equal cell with the same orientation: the verts of a standard cell in all orders that keep
/// its faces.
template<class Use>
void for_each_equal_cell(cell_shape s, const vert_id* v, const Use& use) {
  static constexpr std::array<unsigned, 8> neighbours[] = {
      neighbours_in(standard_cells[0]), neighbours_in(standard_cells[1]), neighbours_in(standard_cells[2]),
      neighbours_in(standard_cells[3])};
  const standard_cell& t = standard_cell_of(s);
  const std::array<unsigned, 8>& adjacent = neighbours[static_cast<unsigned>(s)];
  vert_id now[8];
  const unsigned base_size = t.face_size[0];
  for (unsigned f = 0; f < t.num_faces; ++f) {
    if (t.face_size[f] != base_size) continue;
    unsigned base = 0;
    for (unsigned i = 0; i < base_size; ++i) base |= 1u << t.face_vert[f][i];
    for (unsigned k = 0; k < base_size; ++k) {
      for (unsigned i = 0; i < base_size; ++i) {
        const unsigned from = t.face_vert[f][(i + k) % base_size], to = t.face_vert[0][i];
        now[to] = v[from];
        const unsigned above = adjacent[from] & ~base;  // the vert over this one; the apex of a tet or pyramid is over
                                                        // all of them
        now[std::min(to + base_size, t.num_verts - 1)] = v[std::countr_zero(above)];
      }
      use(static_cast<const vert_id*>(now));
    }
  }
}

/// Replaces the verts of a standard cell by those of the equal cell, with the same orientation, that come first in
/// lexicographic order.
inline void make_canonical(cell_shape s, vert_id* v) {
  const unsigned n = standard_cell_of(s).num_verts;
  vert_id best[8];
  bool any = false;
  for_each_equal_cell(s, v, [&](const vert_id* now) {
    if (!any || std::lexicographical_compare(now, now + n, best, best + n)) std::copy_n(now, n, best);
    any = true;
  });
  std::copy_n(best, n, v);
}

/// Replaces the verts of a standard cell by those of the equal cell whose faces come in the order of a list, if there
/// is one. A cell that was written as its faces is then the same again. is_in_face(k, vert) says whether face k of the
/// list has a vert.
template<class IsInFace>
void match_face_order(cell_shape s, vert_id* v, const IsInFace& is_in_face) {
  const standard_cell& t = standard_cell_of(s);
  vert_id best[8];
  bool any = false;
  for_each_equal_cell(s, v, [&](const vert_id* now) {
    bool matches = !any;
    for (unsigned f = 0; f < t.num_faces && matches; ++f)
      for (unsigned i = 0; i < t.face_size[f]; ++i) matches = matches && is_in_face(f, now[t.face_vert[f][i]]);
    if (matches) std::copy_n(now, t.num_verts, best);
    any = any || matches;
  });
  if (any) std::copy_n(best, t.num_verts, v);
}

/// Rotates the cycle of n verts so that it begins with the smallest one.
inline void rotate_to_smallest(vert_id* v, std::size_t n) { std::rotate(v, std::min_element(v, v + n), v + n); }

}  // namespace concino::detail
