// Reads the faces of a volume cell, and recognises the standard shapes among them, whose points it puts in the standard
// order.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/mesh/support/cell_recogniser.hpp>
#include <concino/quality/detail/metric_row.hpp>

#include <vector>

namespace concino::detail {

class cell_reader {
  std::vector<vec3> points_;  // by local number of the vert
  std::vector<unsigned> begins_, verts_;
  cell_recogniser recogniser_;
  vec3 ordered_[8];

 public:
  void clear() {
    points_.clear();
    begins_.clear();
    verts_.clear();
  }
  /// The verts of the cell, each once.
  void add_point(const vec3& p) { points_.push_back(p); }
  void begin_face() { begins_.push_back(static_cast<unsigned>(verts_.size())); }
  void add_corner(unsigned local_vert) { verts_.push_back(local_vert); }
  /// Reverses the orientation of the last face.
  void reverse_face() { std::reverse(verts_.begin() + begins_.back(), verts_.end()); }

  /// The cell; valid until the next call of a member function that changes this.
  poly_geometry geometry();
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/quality/detail/cell_reader.ipp>
#endif
