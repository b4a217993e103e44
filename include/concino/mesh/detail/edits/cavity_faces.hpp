// The faces of a cavity of tets or hexes: those of its old and of its new polys, found by the local numbers of their
// verts.
#pragma once

#include <concino/concepts/descriptors.hpp>
#include <concino/core/small_array.hpp>
#include <concino/mesh/detail/cells/shapes.hpp>
#include <concino/mesh/detail/tables/visited_faces.hpp>

#include <algorithm>
#include <cstdint>

namespace concino::detail {

template<unsigned N>
struct cavity_face {
  std::uint32_t first_use;    // the first of the polys at it, old ones before new ones: the number of the poly times
                              // faces per poly, plus the place of the face there
  face_id id;                 // none if the mesh does not have it yet
  std::uint32_t old_polys = 0;  // of the cavity, at it
  std::uint32_t new_polys = 0;
  std::uint32_t num_polys = 0;  // of the mesh, at it before
  std::uint32_t new_uses[2] = {~0u, 0};  // the first and the last of the new polys at it, numbered without old ones
  std::uint32_t partner = ~0u;  // the number, of a new face, of the old one whose descriptor it takes, and the other
                                // way round

  bool has_partner() const { return partner != ~0u; }
  bool is_unused() const { return !id.is_none() && new_polys == 0 && old_polys == num_polys; }
};

/// The faces of a cavity by the numbers of their edges and verts. The search starts at the edge with the largest
/// number, which is the last one that was added: few faces are listed there, and they were used recently.
template<unsigned N>
class cavity_faces {
  using face_numbers = visited_faces<N, 80, 112>;

  core::small_array<cavity_face<N>, 112> faces_;
  face_numbers visited_;

 public:
  /// Room for the faces of old and new polys that have `uses` faces in all, and for so many edges.
  cavity_faces(std::size_t uses, std::size_t edges) {
    const std::size_t n = uses / 2 + uses / 8;  // most faces are between two polys
    faces_.reserve(n), visited_.reserve(edges, n);
  }

  /// Makes the first n edges known.
  void add_edges(std::size_t n) {
    while (visited_.num_edges() < n) visited_.add_edge();
  }
  /// The edge where a face is listed, and its other verts.
  struct face_key {
    unsigned edge, other[N - 2];
  };
  /// The key of the face with these verts in cyclic order, where edge i joins verts i and i + 1.
  static face_key key(const unsigned (&v)[N], const unsigned (&edges)[N]) {
    static_assert(N == 3 || N == 4);
    unsigned last = edges[0];
    if constexpr (N == 3) {
      unsigned other = v[2];
      other = edges[1] > last ? v[0] : other, last = std::max(last, edges[1]);
      other = edges[2] > last ? v[1] : other, last = std::max(last, edges[2]);
      return {last, {other}};
    } else {
      unsigned at = 0;
      for (unsigned i = 1; i < N; ++i) at = edges[i] > last ? i : at, last = std::max(last, edges[i]);
      const unsigned a = v[at], b = v[(at + 1) % N], after_b = v[(at + 2) % N], before_a = v[(at + 3) % N];
      return {last, {a < b ? before_a : after_b, a < b ? after_b : before_a}};
    }
  }
  /// The number of the face with this key. It is added if it is new.
  unsigned number(const face_key& x, std::uint32_t use) {
    typename face_numbers::face wanted;
    std::copy_n(x.other, N - 2, wanted.other);
    const auto [number, is_new] = visited_.find_or_add(x.edge, wanted);
    if (is_new) faces_.push_back({use, {}});
    return number;
  }

  std::size_t size() const { return faces_.size(); }
  unsigned number(const cavity_face<N>& x) const { return static_cast<unsigned>(&x - faces_.begin()); }
  cavity_face<N>& operator[](unsigned i) { return faces_[i]; }
  const cavity_face<N>& operator[](unsigned i) const { return faces_[i]; }
  cavity_face<N>* begin() { return faces_.begin(); }
  cavity_face<N>* end() { return faces_.end(); }
  const cavity_face<N>* begin() const { return faces_.begin(); }
  const cavity_face<N>* end() const { return faces_.end(); }
};

/// The key of face j of a poly with corners v, of which the edges have these numbers.
template<class Shape>
auto key_of_face(const unsigned* v, const std::uint32_t* edges, unsigned j) {
  unsigned w[Shape::face_verts], e[Shape::face_verts];
  for (unsigned i = 0; i < Shape::face_verts; ++i)
    w[i] = v[Shape::face_vert[j][i]], e[i] = edges[shape_v<Shape>.face_edge[j][i]];
  return cavity_faces<Shape::face_verts>::key(w, e);
}

}  // namespace concino::detail
