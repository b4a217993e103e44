// The faces of a cavity of tets or hexes: those of its old and of its new polys, found by the local numbers of their verts.
#pragma once

#include <concino/concepts/descriptors.hpp>
#include <concino/core/small_array.hpp>

#include <algorithm>
#include <cstdint>

namespace concino::detail {

template<unsigned N>
struct cavity_face {
  unsigned verts[N];       // local numbers in cyclic order: the smallest first, then the smaller of its neighbours
  unsigned edges[N];       // numbers of its edges in the cavity
  face_id id;              // none if the mesh does not have it yet
  std::uint32_t old_polys;   // of the cavity, at it
  std::uint32_t new_polys;
  std::uint32_t num_polys;   // of the mesh, at it before
  std::uint32_t new_uses[2];  // the first two of the new polys at it: number of the poly times faces per poly, plus the place of the face there
  cavity_face* partner;    // of a new face, the old one whose descriptor it takes, and the other way round

  bool is_left_over() const { return !id.is_none() && new_polys == 0 && old_polys == num_polys; }
  bool shares_all_but_one(const cavity_face& x) const {
    unsigned common = 0;
    for (const unsigned v : verts)
      for (const unsigned w : x.verts) common += v == w;
    return common + 1 == N;
  }
};

template<unsigned N>
class cavity_faces {
  core::small_array<cavity_face<N>, 112> faces_;
  core::small_array<std::uint32_t, 256> slots_;  // a hash table of the numbers of the faces plus 1

  static void put_in_order(unsigned (&v)[N]) {
    static_assert(N == 3 || N == 4);
    if constexpr (N == 3) {
      const unsigned least = std::min(std::min(v[0], v[1]), v[2]), most = std::max(std::max(v[0], v[1]), v[2]);  // no branch that is often predicted wrongly
      v[1] = v[0] ^ v[1] ^ v[2] ^ least ^ most;
      v[0] = least, v[2] = most;
    } else {
      if (std::min(v[2], v[3]) < std::min(v[0], v[1])) std::swap(v[0], v[2]), std::swap(v[1], v[3]);
      if (v[1] < v[0]) std::swap(v[0], v[1]), std::swap(v[2], v[3]);
      if (v[3] < v[1]) std::swap(v[1], v[3]);
    }
  }
  static bool are_equal(const unsigned (&a)[N], const unsigned (&b)[N]) {  // std::equal reads several numbers at once, and waits until they are all written
    bool are = true;
    for (unsigned i = 0; i < N; ++i) are &= a[i] == b[i];
    return are;
  }
  static std::size_t hash(const unsigned (&v)[N]) {
    std::uint64_t x = 0;
    for (const unsigned i : v) x = x << 12 ^ i;  // different for few verts
    return static_cast<std::size_t>(x * 0x9e3779b97f4a7c15u >> 32);
  }

 public:
  /// Room for the faces of old and new polys that have `uses` faces in all.
  explicit cavity_faces(std::size_t uses) {
    std::size_t n = 32;
    while (n < uses + uses / 4) n *= 2;
    slots_.resize(n, 0);
    faces_.reserve(uses / 2 + uses / 8);  // most faces are between two polys
  }

  /// Requests the memory where at() will look for a face.
  void prefetch(unsigned (&v)[N]) const {
    put_in_order(v);
    __builtin_prefetch(&slots_[hash(v) & (slots_.size() - 1)], 1);
  }
  /// Requests the face that at() will probably find, after prefetch() has requested where it looks.
  void prefetch_found(unsigned (&v)[N]) const {
    put_in_order(v);
    const std::uint32_t plus_one = slots_[hash(v) & (slots_.size() - 1)];
    __builtin_prefetch(faces_.begin() + (plus_one == 0 ? 0 : plus_one - 1), 1);
  }

  /// The face with these verts in cyclic order; it is added if it is new, without edges.
  cavity_face<N>& at(unsigned (&v)[N]) {
    put_in_order(v);
    std::size_t i = hash(v) & (slots_.size() - 1);
    for (; slots_[i] != 0; i = (i + 1) & (slots_.size() - 1))
      if (are_equal(v, faces_[slots_[i] - 1].verts)) return faces_[slots_[i] - 1];
    cavity_face<N> face{};
    std::copy_n(v, N, face.verts);
    faces_.push_back(face);
    slots_[i] = static_cast<std::uint32_t>(faces_.size());
    return faces_.back();
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

}  // namespace concino::detail
