// face_soup: builds polyhedra from cells with separate faces, and merges equal faces.
#pragma once

#include <concino/core/large_pages.hpp>
#include <concino/mesh/arrays.hpp>
#include <concino/mesh/standard_cells.hpp>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace concino {

/// Builds polyhedra from lists of verts, one list per face of each poly. Two equal faces become one face with two polys.
/// Faces are numbered in the order of their first occurrence, and are outward for the poly in which they occur first. Linear time, except for
/// sorting the faces of verts that are the smallest one of many faces.
/// A template only so that programs without volumes need not compile it: face_soup.
template<class Vert>
struct basic_face_soup {
  /// A key for sorting faces. Equal cycles are adjacent in the order, by face number, whatever their first vert and direction.
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
        : verts_(first), size_(size), start_(static_cast<std::uint32_t>(std::min_element(first, first + size) - first)), face_(face), back_(false) {
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

  std::vector<std::uint32_t> face_offsets{0};  // of the faces of all polys, one after another; a common face is listed twice
  std::vector<Vert> face_verts;
  std::vector<std::uint32_t> poly_offsets{0};

  /// Makes room for polys that have so many faces, of so many corners.
  void reserve(std::size_t poly_count, std::size_t face_count, std::size_t corner_count) {
    core::reserve_large(poly_offsets, poly_count + 1);
    core::reserve_large(face_offsets, face_count + 1);
    core::reserve_large(face_verts, corner_count);
  }

  void add_cell(cell_shape s, const Vert* v) {
    const standard_cell& t = standard_cell_of(s);
    for (unsigned f = 0; f < t.num_faces; ++f) {
      for (unsigned i = 0; i < t.face_size[f]; ++i) face_verts.push_back(v[t.face_vert[f][i]]);
      face_offsets.push_back(static_cast<std::uint32_t>(face_verts.size()));
    }
    poly_offsets.push_back(static_cast<std::uint32_t>(face_offsets.size() - 1));
  }

 private:
  static constexpr std::uint32_t none = ~0u, too_many = ~0u - 1;  // no id is as large
  static constexpr unsigned max_compared = 64;                    // faces with the same smallest vert, before they are sorted

  struct entry {
    std::uint32_t sum;   // of the verts modulo 2^32, which equal faces have in common
    std::uint32_t next;  // an earlier face with the same smallest vert
  };
  std::vector<face_id> twins_;  // the first face that is equal to each

  std::uint32_t size(std::size_t f) const { return face_offsets[f + 1] - face_offsets[f]; }
  Vert* first(std::size_t f) { return face_verts.data() + face_offsets[f]; }

  /// Adds the entry of face f, and finds its twin among the faces that have the same smallest vert.
  /// Result: 1 if the directions are equal, -1 if they are not, 0 if there is none.
  int find_twin(std::vector<entry>& entries, std::uint32_t f, std::vector<std::uint32_t>& last) {
    std::uint32_t smallest = none, sum = 0;
    for (const Vert *v = first(f), *end = v + size(f); v != end; ++v) {
      smallest = std::min(smallest, v->raw());
      sum += v->raw();
    }
    const std::uint32_t before = last[smallest];
    entries.push_back({sum, before});
    twins_.push_back(face_id{f});
    if (before == too_many) return 0;
    unsigned compared = 0;
    for (std::uint32_t g = before; g != none; g = entries[g].next, ++compared) {
      if (entries[g].sum != sum || size(g) != size(f)) continue;
      if (const int order = compare_cycles(first(g), first(f), size(f))) {
        twins_[f] = face_id{g};
        return order;
      }
    }
    last[smallest] = compared < max_compared ? f : too_many;
    return 0;
  }

  /// Finds the twins of the faces whose smallest verts have many faces: sorts them, so that equal ones are consecutive.
  [[gnu::noinline, gnu::cold]] void find_twins_by_sorting(const std::vector<std::uint32_t>& last, std::vector<std::uint8_t>& outward) {
    std::vector<cycle> cycles;
    for (std::uint32_t f = 0; f < twins_.size(); ++f)
      if (last[std::min_element(first(f), first(f) + size(f))->raw()] == too_many) cycles.push_back(cycle(first(f), size(f), f));
    std::sort(cycles.begin(), cycles.end());
    std::uint32_t original = none;
    for (const cycle& c : cycles) {
      const std::uint32_t f = c.face();
      if (twins_[f] != face_id{f}) continue;
      const int order = original != none && size(original) == size(f) ? compare_cycles(first(original), first(f), size(f)) : 0;
      if (order == 0) {
        original = f;
        continue;
      }
      twins_[f] = face_id{original};
      outward[f] ^= order < 0;
    }
  }

  /// Result: polyhedra with the faces that are their own twins; the other faces refer to their twin.
  polyhedra_arrays keep_first_faces(std::vector<vec3>&& points, std::vector<std::uint8_t>&& outward) {
    const std::size_t n = twins_.size();
    std::size_t num_first = 0;
    for (std::size_t f = 0; f < n; ++f) num_first += twins_[f] == face_id{f};
    polyhedra_arrays out;
    out.points = std::move(points);
    out.poly_offsets = std::move(poly_offsets);
    out.outward = std::move(outward);
    out.poly_faces = std::move(twins_);
    out.face_offsets = core::large_vector(num_first + 1, std::uint32_t{0});
    std::uint32_t corners = 0, face_count = 0;
    // In place: a face that is kept moves forward, over faces already read. Twins come before, and have their numbers already.
    for (std::size_t f = 0; f < n; ++f) {
      face_id& face = out.poly_faces[f];
      const bool is_first = face == face_id{f};
      face = is_first ? face_id{face_count} : out.poly_faces[face.raw()];
      if (!is_first) continue;
      const std::uint32_t k = size(f);
      const Vert* const from = first(f);
      for (std::uint32_t i = 0; i < k; ++i) face_verts[corners + i] = from[i];
      out.face_offsets[++face_count] = corners += k;
    }
    core::reserve_large(out.face_verts, corners);
    out.face_verts.assign(face_verts.data(), face_verts.data() + corners);
    std::vector<Vert>().swap(face_verts);
    return out;
  }

 public:
  /// Merges equal faces. outward[f] says whether face f, as it is listed, is outward for its poly; empty: all are.
  polyhedra_arrays unite(std::vector<vec3> points, std::vector<std::uint8_t> outward = {}) && {
    const std::size_t n = face_offsets.size() - 1;
    if (outward.empty()) outward = core::large_vector(n, std::uint8_t{1});
    std::vector<std::uint32_t> last = core::large_vector(points.size(), none);  // the last different face with each smallest vert
    std::vector<entry> entries;
    core::reserve_large(entries, n);
    twins_.clear();
    core::reserve_large(twins_, n);
    for (std::uint32_t f = 0; f < n; ++f)
      if (find_twin(entries, f, last) < 0) outward[f] ^= 1;
    if (std::find(last.begin(), last.end(), too_many) != last.end()) find_twins_by_sorting(last, outward);
    std::vector<std::uint32_t>().swap(last);
    std::vector<entry>().swap(entries);
    return keep_first_faces(std::move(points), std::move(outward));
  }
};
using face_soup = basic_face_soup<vert_id>;

}  // namespace concino
