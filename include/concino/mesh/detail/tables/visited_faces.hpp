// The faces at one vert of a mesh of tets or hexes, found by their other verts while the tables are built.
#pragma once

#include <concino/core/index_table.hpp>
#include <concino/core/small_array.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <type_traits>
#include <vector>

namespace concino::detail {

/// Faces of FaceVerts verts at their smallest vert a. They are listed at the edge from a to the smaller neighbour of a
/// in the face; edges are numbered in the order of add_edge(). FewEdges and FewFaces: up to so many need no allocation;
/// 0: vectors, for a builder.
template<unsigned FaceVerts, std::size_t FewEdges = 0, std::size_t FewFaces = 0>
class visited_faces {
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

  struct further_face {
    std::uint32_t edge, face;
  };

  list<std::uint32_t, FewEdges> first_at_;  // per edge: its first face
  face_list faces_;
  // Faces beyond `longest_list` per edge, so that the number of faces at an edge does not matter.
  std::vector<further_face> further_;
  core::index_table further_numbers_;

  static std::uint32_t hash(std::uint32_t edge, const face& f) {
    std::uint32_t h = core::index_table::hash(edge);
    for (const std::uint32_t v : f.other) h = core::index_table::hash(std::uint64_t{v} << 32, h);
    return h;
  }
  std::uint32_t find_further(std::uint32_t edge, const face& wanted) const {
    const auto is_wanted = [&](std::uint32_t i) {
      return further_[i].edge == edge && have_equal_verts(wanted, faces_[further_[i].face]);
    };
    const std::uint32_t i = further_numbers_.find(hash(edge, wanted), is_wanted);
    return i == core::index_table::none ? ~0u : further_[i].face;
  }
  static bool have_equal_verts(const face& a, const face& b) { return std::equal(a.other, std::end(a.other), b.other); }

 public:
  void clear() {
    first_at_.clear();
    faces_.clear();
    further_.clear(), further_numbers_.clear();
  }
  /// Makes room for so many edges and faces.
  void reserve(std::size_t edges, std::size_t faces) { first_at_.reserve(edges), faces_.reserve(faces); }
  std::size_t num_edges() const { return first_at_.size(); }
  void add_edge() { first_at_.push_back(~0u); }

  /// The face with the verts of `wanted` at an edge, which is added if it was not met before.
  found find_or_add(std::uint32_t edge, face wanted) {
    std::uint32_t& first = first_at_[edge];
    std::uint32_t f = first, listed = 0;
    for (; f != ~0u && !have_equal_verts(wanted, faces_[f]); ++listed) f = faces_[f].next;
    if (f == ~0u && listed == longest_list) f = find_further(edge, wanted);
    if (f != ~0u) return {f, false};
    wanted.next = first;
    f = static_cast<std::uint32_t>(faces_.size());
    if (listed < longest_list) first = f;
    faces_.push_back(wanted);
    if (listed == longest_list) {
      further_numbers_.add(hash(edge, wanted), static_cast<std::uint32_t>(further_.size()));
      further_.push_back({edge, f});
    }
    return {f, true};
  }
};

}  // namespace concino::detail
