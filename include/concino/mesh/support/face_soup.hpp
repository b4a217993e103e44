// face_soup: builds polyhedra from cells with separate faces, and merges equal faces.
#pragma once

#include <concino/mesh/arrays.hpp>
#include <concino/mesh/support/face_merger.hpp>
#include <concino/mesh/support/standard_cells.hpp>

#include <cstdint>
#include <utility>
#include <vector>

namespace concino {

/// Builds polyhedra from lists of verts, one list per face of each poly. Two equal faces become one face with two
/// polys. Faces are numbered in the order of their first occurrence, and are outward for the poly in which they occur
/// first. Linear time, except for sorting the faces of verts that are the smallest one of many faces.
/// A template only so that programs without volumes need not compile it: face_soup.
template<class Vert>
struct basic_face_soup {
  std::vector<std::uint32_t> face_offsets{0};  // of the faces of all polys, one after another; a common face is listed
                                               // twice
  std::vector<Vert> face_verts;
  std::vector<std::uint32_t> poly_offsets{0};

  /// Makes room for polys that have so many faces, of so many corners.
  void reserve(std::size_t poly_count, std::size_t face_count, std::size_t corner_count) {
    poly_offsets.reserve(poly_count + 1);
    face_offsets.reserve(face_count + 1);
    face_verts.reserve(corner_count);
  }

  void add_cell(cell_shape s, const Vert* v) {
    const standard_cell& t = standard_cell_of(s);
    for (unsigned f = 0; f < t.num_faces; ++f) {
      for (unsigned i = 0; i < t.face_size[f]; ++i) face_verts.push_back(v[t.face_vert[f][i]]);
      face_offsets.push_back(static_cast<std::uint32_t>(face_verts.size()));
    }
    poly_offsets.push_back(static_cast<std::uint32_t>(face_offsets.size() - 1));
  }

  /// Merges equal faces. outward[f] says whether face f, as it is listed, is outward for its poly; empty: all are.
  polyhedra_arrays unite(std::vector<vec3> points, std::vector<std::uint8_t> outward = {}) && {
    const std::size_t n = face_offsets.size() - 1;
    if (outward.empty()) outward.assign(n, 1);
    basic_face_merger<Vert> merger(points.size());
    merger.reserve(n / 2 + n / 32, face_verts.size() / 2 + face_verts.size() / 32);  // few faces are at the boundary
    polyhedra_arrays m;
    m.poly_faces.reserve(n);
    for (std::size_t f = 0; f < n; ++f) {
      const std::size_t size = face_offsets[f + 1] - face_offsets[f];
      const auto merged = merger.add(face_verts.data() + face_offsets[f], size);
      m.poly_faces.push_back(merged.face);
      if (merged.order < 0) outward[f] ^= 1;
    }
    m.points = std::move(points);
    m.poly_offsets = std::move(poly_offsets);
    m.outward = std::move(outward);
    merger.finish(m);
    return m;
  }
};
using face_soup = basic_face_soup<vert_id>;

}  // namespace concino
