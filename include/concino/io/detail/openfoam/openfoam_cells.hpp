// The cells of a polyMesh as tets or hexes, for meshes that hold nothing else.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/message.hpp>
#include <concino/io/detail/cells/canonical_cells.hpp>
#include <concino/io/detail/cells/face_key.hpp>
#include <concino/io/detail/cells/orient.hpp>
#include <concino/io/detail/formats/contents.hpp>

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace concino::detail {

/// The verts of all polyhedra in the standard order, up to the first that is no tet or hex like those before it.
/// A template only so that programs without volumes need not compile it: cells_of_polyhedra(mesh, arity).
template<std::same_as<polyhedra_arrays> Arrays>
struct cells_of_polyhedra {
  mutable std::vector<vert_id> verts;
  std::uint32_t arity;  // 4 or 8; of a mesh without cells 4
  std::size_t num_fitting = 0;

  cells_of_polyhedra(const Arrays& m, std::uint32_t wanted_arity) : arity(wanted_arity) {
    cell_recogniser known;
    for (; num_fitting < m.num_polys(); ++num_fitting) {
      const std::uint32_t first = m.poly_offsets[num_fitting], last = m.poly_offsets[num_fitting + 1];
      if (last - first != 4 && last - first != 6) break;
      const cell_shape s = recognise(m, num_fitting, known);
      const std::uint32_t n = s == cell_shape::tet ? 4 : s == cell_shape::hex ? 8 : 0;
      if (arity == 0) arity = n;
      if (n == 0 || n != arity) break;
      make_canonical(s, known.cell);
      verts.insert(verts.end(), known.cell, known.cell + n);
    }
    if (arity == 0) arity = 4;
  }

  /// Errors: parse_error for the first cell that does not fit.
  [[noreturn, gnu::noinline, gnu::cold]] void fail(std::string_view name, const Arrays& m) const {
    cell_recogniser known;
    const cell_shape s = recognise(m, num_fitting, known);
    throw parse_error(
        std::string(name), 1,
        core::joined({name_of_poly(true, arity), " (polyhedralmesh and load_any take any polyhedron)"}),
        core::joined({"cell ", num_fitting, ", a ", s == cell_shape::general ? "polyhedron" : standard_cell_of(s).name,
                      " of ", m.poly_offsets[num_fitting + 1] - m.poly_offsets[num_fitting], " faces"}));
  }
};

/// The number of faces with the verts of another one.
template<std::same_as<polyhedra_arrays> Arrays>
std::size_t num_equal_faces(const Arrays& m) {
  std::vector<std::uint64_t> keys;
  keys.reserve(m.num_faces());
  for (std::size_t f = 0; f < m.num_faces(); ++f)
    keys.push_back(face_key(m.face_verts.data() + m.face_offsets[f], m.face_offsets[f + 1] - m.face_offsets[f]));
  std::sort(keys.begin(), keys.end());
  return keys.size() - static_cast<std::size_t>(std::unique(keys.begin(), keys.end()) - keys.begin());
}

}  // namespace concino::detail
