// Recognises tets, hexes, prisms and pyramids among general polyhedra.
#pragma once

#include <concino/mesh/support/standard_cells.hpp>

namespace concino {

/// Recognises a standard cell by its faces alone and lists its verts in the standard order, so that the input faces
/// have the same orientation as in the table. face(k) is the verts of the k-th of n faces, oriented outward. The result
/// is `general` if the poly is no standard cell.
class cell_recogniser {
  struct span_of_face {
    std::uint32_t begin, size;
  };
  std::vector<vert_id> verts_;
  std::vector<span_of_face> faces_;

 public:
  vert_id cell[8];

  void clear() {
    verts_.clear();
    faces_.clear();
  }
  void begin_face() { faces_.push_back({static_cast<std::uint32_t>(verts_.size()), 0}); }
  void push(vert_id v) {
    verts_.push_back(v);
    ++faces_.back().size;
  }
  /// Reverses the orientation of the last face.
  void reverse_face() {
    for (std::size_t i = faces_.back().begin, k = verts_.size(); i + 1 < k--; ++i) std::swap(verts_[i], verts_[k]);
  }

  cell_shape recognise() {
    unsigned triangles = 0, quads = 0;
    for (const span_of_face& f : faces_) {
      triangles += f.size == 3;
      quads += f.size == 4;
    }
    if (triangles + quads != faces_.size()) return cell_shape::general;
    cell_shape s = cell_shape::general;
    if (triangles == 4 && quads == 0) s = cell_shape::tet;
    if (triangles == 0 && quads == 6) s = cell_shape::hex;
    if (triangles == 2 && quads == 3) s = cell_shape::prism;
    if (triangles == 4 && quads == 1) s = cell_shape::pyramid;
    if (s == cell_shape::general) return s;

    // The base is the first face with as many verts as the first face of the table. That one is listed outward, so
    // reading the base backwards gives the verts from 0 on. The other verts are above those of the base.
    const standard_cell& t = standard_cell_of(s);
    std::size_t first = 0;
    while (faces_[first].size != t.face_size[0]) ++first;
    const span_of_face base = faces_[first];
    const unsigned b = base.size;
    for (unsigned i = 0; i < b; ++i) cell[t.face_vert[0][i]] = verts_[base.begin + i];
    for (unsigned i = b; i < t.num_verts; ++i) {
      const vert_id under = cell[i - b];
      cell[i] = s == cell_shape::tet || s == cell_shape::pyramid ? apex(b) : over(under, b);
      if (cell[i].is_none()) return cell_shape::general;
    }
    return matches(t) ? s : cell_shape::general;
  }

 private:
  bool in_base(vert_id v, unsigned b) const {
    for (unsigned i = 0; i < b; ++i)
      if (cell[i] == v) return true;
    return false;
  }
  vert_id apex(unsigned b) const {
    for (vert_id v : verts_)
      if (!in_base(v, b)) return v;
    return {};
  }
  /// The neighbour of a base vert that is not in the base.
  vert_id over(vert_id under, unsigned b) const {
    for (const span_of_face& f : faces_)
      for (std::uint32_t i = 0; i < f.size; ++i) {
        const vert_id v = verts_[f.begin + i], next = verts_[f.begin + (i + 1) % f.size];
        if (v == under && !in_base(next, b)) return next;
        if (next == under && !in_base(v, b)) return v;
      }
    return {};
  }
  bool matches(const standard_cell& t) const {
    for (unsigned i = 0; i < t.num_verts; ++i)
      for (unsigned j = 0; j < i; ++j)
        if (cell[i] == cell[j]) return false;
    unsigned used = 0;
    for (unsigned f = 0; f < t.num_faces; ++f) {
      vert_id want[4];
      for (unsigned i = 0; i < t.face_size[f]; ++i) want[i] = cell[t.face_vert[f][i]];
      unsigned k = 0;
      while (k < faces_.size() && ((used >> k & 1) || faces_[k].size != t.face_size[f] ||
                                   compare_cycles(want, verts_.data() + faces_[k].begin, faces_[k].size) == 0))
        ++k;
      if (k == faces_.size()) return false;
      used |= 1u << k;
    }
    return true;
  }
};

}  // namespace concino
