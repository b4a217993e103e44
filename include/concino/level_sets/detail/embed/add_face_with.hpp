// Finds a face of a volume by its verts.
#pragma once

#include <concino/concepts/volume_mesh.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace concino::detail {

/// Whether these are all the corners and no others.
template<class M, class Verts>
bool are_corners(const Verts& verts, const std::vector<vert_t<M>>& corners) {
  std::size_t n = 0, common = 0;
  for (const vert_t<M> v : verts) {
    ++n;
    common += std::find(corners.begin(), corners.end(), v) != corners.end();
  }
  return n == corners.size() && common == n;
}

/// Adds the face with these corners, which exists, to a list.
template<class M>
void add_face_with(const M& m, const std::vector<vert_t<M>>& corners, std::vector<face_t<M>>& to) {
  for (const face_t<M> f : adj_v2f(m, corners[0]))
    if (are_corners<M>(adj_f2v(m, f), corners)) return to.push_back(f);
}

}  // namespace concino::detail
