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
  std::size_t n = 0, met = 0;
  for (const vert_t<M> v : verts) {
    ++n;
    met += std::find(corners.begin(), corners.end(), v) != corners.end();
  }
  return n == corners.size() && met == n;
}

/// Adds the face of tet p that has these corners to a list, and returns true, if there is one.
template<class M>
bool add_face_of_tet(const M& m, const poly_t<M>& p, const std::vector<vert_t<M>>& corners, std::vector<face_t<M>>& to) {
  std::size_t met = 0;
  for (const vert_t<M> v : adj_p2v(m, p)) met += v == corners[0] || v == corners[1] || v == corners[2];
  if (met != 3) return false;
  for (const face_t<M> f : adj_p2f(m, p)) {
    if (!are_corners<M>(adj_f2v(m, f), corners)) continue;
    to.push_back(f);
    return true;
  }
  return false;
}

/// Adds the face with these corners, which exists, to a list.
template<class M>
void add_face_with(const M& m, const std::vector<vert_t<M>>& corners, std::vector<face_t<M>>& to) {
  if constexpr (arity_v<M> == 4) {  // the verts of tets are read in less time than those of faces, and no two faces of tets have the same verts
    for (const poly_t<M> p : adj_v2p(m, corners[0]))
      if (add_face_of_tet(m, p, corners, to)) return;
  } else {
    for (const face_t<M> f : adj_v2f(m, corners[0]))
      if (are_corners<M>(adj_f2v(m, f), corners)) return to.push_back(f);
  }
}

}  // namespace concino::detail
