// Lists of cells of any shapes: of standard cells their verts, of a polyhedron the number of its faces, and for each
// the number of its verts and these.
#pragma once

#include <concino/io/detail/cells/corners.hpp>
#include <concino/io/detail/cells/face_key.hpp>
#include <concino/mesh/support/standard_cells.hpp>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// The faces of a standard cell, as a list.
template<class Vert>
std::vector<Vert> faces_of_cell(cell_shape s, const Vert* v) {
  const standard_cell& cell = standard_cell_of(s);
  std::vector<Vert> list{Vert{std::size_t{cell.num_faces}}};
  for (unsigned f = 0; f < cell.num_faces; ++f) {
    list.push_back(Vert{std::size_t{cell.face_size[f]}});
    for (unsigned i = 0; i < cell.face_size[f]; ++i) list.push_back(v[cell.face_vert[f][i]]);
  }
  return list;
}

/// What is wrong with the faces of a polyhedron.
enum class face_fault : std::uint8_t { none, too_few_verts, repeated_vert, equal_faces };

/// Checks the faces of one polyhedron at a time.
template<class Vert>  // vert_id, as in face_merger
class faces_check {
  std::vector<std::uint64_t> scratch_;
  std::vector<std::uint32_t> sums_;  // of the verts of each face

  /// False if no two faces can have the same verts.
  bool has_equal_sums() const {
    const std::size_t n = sums_.size();
    if (n > 64) return true;
    bool equal = false;
    for (std::size_t i = 1; i < n; ++i)
      for (std::size_t j = 0; j < i; ++j) equal |= sums_[i] == sums_[j];
    return equal;
  }
  bool has_equal_faces(const Vert* list) {
    scratch_.clear();
    for (std::uint32_t left = list++->raw(); left > 0; --left) {
      const std::uint32_t n = list++->raw();
      scratch_.push_back(face_key(list, n));
      list += n;
    }
    std::sort(scratch_.begin(), scratch_.end());
    return std::adjacent_find(scratch_.begin(), scratch_.end()) != scratch_.end();
  }

 public:
  std::uint64_t num_corners = 0;  // of the polyhedron
  std::uint32_t number = 0;       // of a fault: the verts of the face, or the repeated vert

  /// Needs: the list of a polyhedron.   Result: its first fault.   Cost: O(n log n) in the corners.
  face_fault operator()(const Vert* list) {
    const Vert* v = list + 1;
    sums_.clear();
    num_corners = 0;
    for (std::uint32_t left = list->raw(); left > 0; --left) {
      const std::uint32_t n = number = v++->raw();
      if (n < 3) return face_fault::too_few_verts;
      std::uint32_t sum = n;
      std::uint64_t bits = 0;  // nearly all faces have verts with different last bits
      for (std::uint32_t i = 0; i < n; ++i) {
        sum += v[i].raw();
        bits |= std::uint64_t{1} << (v[i].raw() & 63);
      }
      if (static_cast<std::uint32_t>(std::popcount(bits)) != n)
        if (const std::size_t k = first_repeated(v, n, scratch_); k != n)
          return number = v[k].raw(), face_fault::repeated_vert;
      sums_.push_back(sum);
      num_corners += n;
      v += n;
    }
    return has_equal_sums() && has_equal_faces(list) ? face_fault::equal_faces : face_fault::none;
  }
};

}  // namespace concino::detail
