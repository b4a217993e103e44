// face_merger: merges equal faces of polys while they are listed.
#pragma once

#include <concino/mesh/arrays.hpp>
#include <concino/mesh/detail/rows/offsets.hpp>
#include <concino/mesh/support/standard_cells.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace concino {

/// Collects faces, which are cycles of verts. Equal faces become one, whatever their first vert and direction. Faces
/// are numbered in the order of their first occurrence. Linear time, except for sorting the faces of verts that are the
/// smallest one of many faces. A template only so that programs without volumes need not compile it: face_merger.
template<class Vert>
class basic_face_merger {
  static constexpr std::uint32_t none = ~0u, too_many = ~0u - 1;  // no id is as large
  static constexpr unsigned max_compared = 64;                    // faces with the same smallest vert, before they are
                                                                  // sorted

  struct entry {
    std::uint32_t sum;   // of the verts and their number modulo 2^32, which equal faces have in common
    std::uint32_t next;  // an earlier face with the same smallest vert
  };

  /// A key for sorting faces. Equal cycles are adjacent in the order, by face number, whatever their first vert and
  /// direction.
  class cycle {
    const Vert* verts_;
    std::uint32_t size_, start_, face_;
    bool back_;

    Vert vert(std::uint32_t i) const {
      const std::uint32_t k = back_ ? start_ + size_ - i : start_ + i;
      return verts_[k < size_ ? k : k - size_];
    }

   public:
    cycle(const Vert* first, std::uint32_t size, std::uint32_t face)
        : verts_(first), size_(size), start_(static_cast<std::uint32_t>(std::min_element(first, first + size) - first)),
          face_(face), back_(false) {
      back_ = vert(size - 1) < vert(1);
    }
    std::uint32_t face() const { return face_; }
    friend bool operator<(const cycle& a, const cycle& b) {
      if (a.size_ != b.size_) return a.size_ < b.size_;
      for (std::uint32_t i = 0; i < a.size_; ++i)
        if (const Vert x = a.vert(i), y = b.vert(i); x != y) return x < y;
      return a.face_ < b.face_;
    }
  };

  std::vector<std::uint32_t> offsets_{0};  // of the different faces
  std::vector<Vert> verts_;
  std::vector<entry> entries_;      // of the different faces
  std::vector<std::uint32_t> last_;  // the last different face with each smallest vert
  bool has_many_ = false;                  // some vert is the smallest one of too many faces

  std::uint32_t size(std::size_t f) const { return offsets_[f + 1] - offsets_[f]; }
  const Vert* first(std::size_t f) const { return verts_.data() + offsets_[f]; }

  face_id push(const Vert* v, std::size_t n, std::uint32_t sum, std::uint32_t next) {
    verts_.insert(verts_.end(), v, v + n);
    offsets_.push_back(static_cast<std::uint32_t>(verts_.size()));
    entries_.push_back({sum, next});
    return face_id{entries_.size() - 1};
  }

  /// The faces whose smallest verts have many faces, in an order in which equal ones are consecutive.
  std::vector<cycle> sorted_cycles() const {
    std::vector<cycle> cycles;
    for (std::uint32_t f = 0; f < num_faces(); ++f)
      if (last_[std::min_element(first(f), first(f) + size(f))->raw()] == too_many)
        cycles.push_back(cycle(first(f), size(f), f));
    std::sort(cycles.begin(), cycles.end());
    return cycles;
  }
  /// Merges the faces that were not compared, by sorting them, and renumbers the faces of polys.
  void merge_many(std::vector<face_id>& poly_faces, std::vector<std::uint8_t>& outward) {
    std::vector<std::uint32_t> number(num_faces());  // first the equal face, and then the new number of each
    std::vector<std::uint8_t> is_reversed(num_faces(), 0);
    for (std::uint32_t f = 0; f < number.size(); ++f) number[f] = f;
    std::uint32_t original = none;
    for (const cycle& c : sorted_cycles()) {
      const std::uint32_t f = c.face();
      const int order =
          original != none && size(original) == size(f) ? compare_cycles(first(original), first(f), size(f)) : 0;
      if (order == 0) original = f;
      number[f] = original;
      is_reversed[f] = order < 0;
    }
    std::uint32_t kept = 0, end = 0;
    // in place: a face that is kept moves over faces already read
    for (std::uint32_t f = 0, from = 0, to; f < number.size(); ++f, from = to) {
      to = offsets_[f + 1];
      if (number[f] != f) {
        number[f] = number[number[f]];
        continue;
      }
      while (from < to) verts_[end++] = verts_[from++];
      number[f] = kept;
      offsets_[++kept] = end;
    }
    offsets_.resize(kept + 1);
    verts_.resize(end);
    for (std::size_t i = 0; i < poly_faces.size(); ++i) {
      const std::uint32_t f = poly_faces[i].raw();
      outward[i] ^= is_reversed[f];
      poly_faces[i] = face_id{number[f]};
    }
  }

 public:
  /// What a face that was added became: the face that equals it, and 1 if both have the same direction, -1 if opposite
  /// directions.
  struct merged_face {
    face_id face;
    int order;
  };

  /// Needs: verts below `bound`.
  explicit basic_face_merger(std::size_t bound) : last_(bound, none) {}

  std::size_t num_faces() const { return entries_.size(); }
  std::size_t num_corners() const { return verts_.size(); }
  /// Makes room for so many different faces, of so many corners.
  void reserve(std::size_t face_count, std::size_t corner_count) {
    offsets_.reserve(face_count + 1);
    verts_.reserve(corner_count);
    entries_.reserve(face_count);
  }
  /// Adds a face, unless an equal one is there already.
  /// Needs: at least three different verts; the smallest one, and the sum of their number and of all of them modulo
  ///        2^32.
  merged_face add(const Vert* v, std::size_t n, std::uint32_t smallest, std::uint32_t sum) {
    const std::uint32_t before = last_[smallest];
    unsigned compared = 0;
    if (before != too_many)
      for (std::uint32_t g = before; g != none; g = entries_[g].next, ++compared) {
        if (entries_[g].sum != sum || size(g) != n) continue;
        if (const int order = compare_cycles(first(g), v, n)) return {face_id{g}, order};
      }
    const face_id f = push(v, n, sum, before);
    has_many_ = has_many_ || compared >= max_compared;
    if (before != too_many) last_[smallest] = compared < max_compared ? f.raw() : too_many;
    return {f, 1};
  }
  merged_face add(const Vert* v, std::size_t n) {
    std::uint32_t smallest = none, sum = static_cast<std::uint32_t>(n);
    for (std::size_t i = 0; i < n; ++i) {
      smallest = std::min(smallest, v[i].raw());
      sum += v[i].raw();
    }
    return add(v, n, smallest, sum);
  }

  /// Moves the faces into the arrays of a mesh, which list the faces of its polys: those that add() returned.
  /// outward[i] is 1 if face poly_faces[i], in the direction of the face of the merger, is outward for its poly, else
  /// 0.
  void finish(polyhedra_arrays& m) {
    if (has_many_) merge_many(m.poly_faces, m.outward);
    std::vector<entry>().swap(entries_);
    std::vector<std::uint32_t>().swap(last_);
    detail::shrink_if_wasteful(offsets_);
    detail::shrink_if_wasteful(verts_);
    m.face_offsets = std::move(offsets_);
    m.face_verts = std::move(verts_);
  }
};
using face_merger = basic_face_merger<vert_id>;

}  // namespace concino
