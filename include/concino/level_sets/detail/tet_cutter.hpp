// The tets into which a level set cuts tets, by the signs of their verts.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/local_numbers.hpp>
#include <concino/level_sets/detail/embedding_lists.hpp>
#include <concino/level_sets/detail/level_place.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// A tet with verts below the level set and verts strictly above it.
struct crossed_tet {
  std::uint32_t poly;           // its number among the crossed ones
  std::uint32_t verts[4];       // numbers; the first three are those of its first face, as adj_f2v lists them
  unsigned char states[4];      // see level_states.hpp
  unsigned char corners[4][3];  // of its faces, as positions in `verts`
  bool is_outward[4];           // whether these are counter-clockwise seen from outside
  std::uint32_t order[4];       // of faces: the number of the first face of crossed tets that is the same one
};

/// A face of a part of a tet. Corners that are equal and follow each other are one.
struct part_face {
  unsigned size = 0;
  unsigned corners[4];

  void push(unsigned corner) {
    if (size == 0 || corners[size - 1] != corner) corners[size++] = corner;
  }
  void close() {
    while (size > 1 && corners[size - 1] == corners[0]) --size;
  }
  unsigned smallest() const { return *std::min_element(corners, corners + size); }
  /// std::rotate takes longer for so few.
  void start_at_smallest() {
    unsigned at = 0;
    for (unsigned i = 1; i < size; ++i) at = corners[i] < corners[at] ? i : at;
    unsigned twice[8];
    for (unsigned i = 0; i < size; ++i) twice[i] = twice[size + i] = corners[i];
    std::copy_n(twice + at, size, corners);
  }
};

/// Cuts tets one after another. The lists are those of list_embedding() for the parts of these cells, which can be any cells and take much longer.
/// Needs:  no two of the tets have the same verts, and their crossed faces have at most two tets; verts are numbered as the faces have them.
class tet_cutter {
  static constexpr unsigned new_vert = 1u << 31;  // until finish(), numbers of new verts have this bit

  core::local_numbers crossings_;    // edges, by their ends below and above
  std::vector<unsigned> cut_faces_;  // corners of triangles on the level set
  // Of the current tet:
  unsigned places_[4][4];  // by the positions of the ends of an edge, the one below first; `unknown` until it is needed
  unsigned char faces_[4];  // in the order in which they are read
  bool is_first_ = true;

  unsigned place(const crossed_tet& t, unsigned a, unsigned b);
  void add_part(const crossed_tet& t, bool is_above);
  void add_tet(unsigned a, unsigned b, unsigned c, unsigned d);
  void add_cut_face(unsigned a, unsigned b, unsigned c, std::uint32_t poly);
  void add_two_parts(const crossed_tet& t);
  void find_places(const crossed_tet& t, bool first_is_above);
  void add_simple_part(const crossed_tet& t, bool is_above, part_face cap);
  template<class F>
  static void for_each_cap_edge(const crossed_tet& t, const F& f);

 public:
  embedding_lists lists;
  std::vector<level_place> places;

  /// Makes room for the parts of so many tets. All of them follow.
  void resize(std::size_t num_tets);
  void add(const crossed_tet& t);
  /// Adds a face on the level set, with existing verts. Those of cut tets come later.
  void add_whole_face(const std::uint32_t* verts) { add_cut_face(verts[0], verts[1], verts[2], ~0u); }
  /// Completes the lists. The first num_verts verts are those of the cut tets.
  void finish(std::uint32_t num_verts);
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/level_sets/detail/tet_cutter.ipp>
#endif
