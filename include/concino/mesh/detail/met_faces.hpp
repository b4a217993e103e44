// met_faces: the faces at one vert of a mesh of tets or hexes, found by their other verts while the tables are built.
#pragma once

#include <concino/core/small_array.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino::detail {

/// Faces of FaceVerts verts at their smallest vert a. They are listed at the edge from a to the smaller neighbour of a in the face; edges are numbered
/// in the order of add_edge(). FewEdges and FewFaces: up to so many need no allocation; 0: vectors, for a builder.
template<unsigned FaceVerts, std::size_t FewEdges = 0, std::size_t FewFaces = 0>
class met_faces {
 public:
  /// The verts of a face, except a and the smaller neighbour of a, and the next face at the same edge.
  struct face {
    std::uint32_t other[FaceVerts - 2];
    std::uint32_t next;
  };
  struct found {
    std::uint32_t face;  // faces are numbered in the order in which they were added
    bool is_new;
  };

 private:
  template<class T, std::size_t Few>
  using list = std::conditional_t<Few == 0, std::vector<T>, core::small_array<T, std::max<std::size_t>(Few, 1)>>;
  using face_list = list<face, FewFaces>;

  static constexpr std::uint32_t longest_list = 24;  // of faces at an edge that are searched one by one

  /// A hash table of the faces beyond `longest_list` per edge, so that the number of faces at an edge does not matter.
  class further_faces {
    struct slot {
      std::uint32_t edge = 0, face = ~0u;
    };
    std::vector<slot> slots_;
    std::size_t used_ = 0;

    static std::size_t hash(std::uint32_t edge, const face& f) {
      std::uint64_t x = edge;
      for (const std::uint32_t v : f.other) {
        x = (x + 1) * 0x9e3779b97f4a7c15u;
        x ^= (x >> 32) ^ v;
      }
      x *= 0x9e3779b97f4a7c15u;
      x ^= x >> 32;
      return static_cast<std::size_t>(x);
    }
    std::size_t find_slot(std::uint32_t edge, const face& wanted, const face_list& all) const {
      std::size_t i = hash(edge, wanted) & (slots_.size() - 1);
      while (slots_[i].face != ~0u && !(slots_[i].edge == edge && have_equal_verts(wanted, all[slots_[i].face]))) i = (i + 1) & (slots_.size() - 1);
      return i;
    }

   public:
    void clear() {
      slots_.clear();
      used_ = 0;
    }
    std::uint32_t find(std::uint32_t edge, const face& wanted, const face_list& all) const {
      return slots_.empty() ? ~0u : slots_[find_slot(edge, wanted, all)].face;
    }
    /// Adds the last face of `all`, which find() does not find.
    void add(std::uint32_t edge, const face_list& all) {
      if (2 * ++used_ > slots_.size()) {
        const std::vector<slot> old = std::exchange(slots_, std::vector<slot>(std::max<std::size_t>(64, 2 * slots_.size())));
        for (const slot& s : old)
          if (s.face != ~0u) slots_[find_slot(s.edge, all[s.face], all)] = s;
      }
      slots_[find_slot(edge, all[all.size() - 1], all)] = {edge, static_cast<std::uint32_t>(all.size() - 1)};
    }
  };

  list<std::uint32_t, FewEdges> first_at_;  // per edge: its first face
  face_list faces_;
  further_faces further_;

  static bool have_equal_verts(const face& a, const face& b) { return std::equal(a.other, std::end(a.other), b.other); }

 public:
  void clear() {
    first_at_.clear();
    faces_.clear();
    further_.clear();
  }
  /// Makes room for so many edges and faces.
  void reserve(std::size_t edges, std::size_t faces) { first_at_.reserve(edges), faces_.reserve(faces); }
  std::size_t num_edges() const { return first_at_.size(); }
  void add_edge() { first_at_.push_back(~0u); }

  /// The face with the verts of `wanted` at an edge, which is added if it was not met before.
  [[gnu::always_inline]] inline found find_or_add(std::uint32_t edge, face wanted) {
    std::uint32_t& first = first_at_[edge];
    std::uint32_t f = first, listed = 0;
    for (; f != ~0u && !have_equal_verts(wanted, faces_[f]); ++listed) f = faces_[f].next;
    if (f == ~0u && listed == longest_list) f = further_.find(edge, wanted, faces_);
    if (f != ~0u) return {f, false};
    wanted.next = first;
    f = static_cast<std::uint32_t>(faces_.size());
    if (listed < longest_list) first = f;
    faces_.push_back(wanted);
    if (listed == longest_list) further_.add(edge, faces_);
    return {f, true};
  }
};

}  // namespace concino::detail
