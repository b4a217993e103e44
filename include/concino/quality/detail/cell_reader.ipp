// Bodies of cell_reader.hpp: reads the faces of a volume cell, and recognises the standard shapes among them, whose
// points it puts in the standard order.
#pragma once

#include <concino/quality/detail/cell_reader.hpp>

namespace concino::detail {

CONCINO_INLINE poly_geometry cell_reader::geometry() {
  static constexpr poly_shape shape_of_cell[] = {poly_shape::tet, poly_shape::hex, poly_shape::prism,
                                                 poly_shape::pyramid};
  begins_.push_back(static_cast<unsigned>(verts_.size()));
  const std::size_t num_faces = begins_.size() - 1;
  if (points_.size() <= 8 && num_faces <= 6) {
    recogniser_.clear();
    for (std::size_t k = 0; k < num_faces; ++k) {
      recogniser_.begin_face();
      for (unsigned i = begins_[k]; i < begins_[k + 1]; ++i) recogniser_.push(vert_id{verts_[i]});
    }
    const cell_shape s = recogniser_.recognise();
    if (s != cell_shape::general) {
      const unsigned n = standard_cell_of(s).num_verts;
      for (unsigned i = 0; i < n; ++i) ordered_[i] = points_[recogniser_.cell[i].raw()];
      poly_geometry g{shape_of_cell[static_cast<unsigned>(s)], {ordered_, n}, {}, {}, 0};
      set_standard_faces(g);
      return g;
    }
  }
  return {poly_shape::polyhedron, points_, begins_, verts_, 0};
}

}  // namespace concino::detail
