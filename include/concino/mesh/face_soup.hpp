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
/// sorting the few faces that have the same smallest vert.
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
  std::uint32_t size(std::size_t f) const { return face_offsets[f + 1] - face_offsets[f]; }
  Vert* first(std::size_t f) { return face_verts.data() + face_offsets[f]; }

  struct entry {
    std::uint64_t others;  // the second and third smallest verts
    std::uint32_t face;
  };

  /// Returns the faces sorted by their smallest vert. Needs: `where` has zeros, one more than there are verts. Result: where[v] is the end of the
  /// faces whose smallest vert is v.
  std::vector<entry> sort_by_smallest_vert(std::vector<std::uint32_t>& where) {
    const std::size_t n = face_offsets.size() - 1;
    const auto smallest = [&](std::size_t f) { return std::min_element(first(f), first(f) + size(f))->raw(); };
    for (std::size_t f = 0; f < n; ++f) ++where[smallest(f) + 1];
    for (std::size_t v = 1; v < where.size(); ++v) where[v] += where[v - 1];
    std::vector<entry> entries = core::large_vector(n, entry{});
    for (std::size_t f = 0; f < n; ++f) {
      std::uint32_t low[3] = {~0u, ~0u, ~0u};
      for (const Vert *v = first(f), *last = v + size(f); v != last; ++v) {
        const std::uint32_t x = v->raw();
        if (x < low[0]) low[2] = low[1], low[1] = low[0], low[0] = x;
        else if (x < low[1]) low[2] = low[1], low[1] = x;
        else if (x < low[2]) low[2] = x;
      }
      entries[where[low[0]]++] = {std::uint64_t{low[1]} << 32 | low[2], static_cast<std::uint32_t>(f)};
    }
    return entries;
  }

  /// Result: polyhedra with the faces that are their own twins; the other faces refer to their twin.
  polyhedra_arrays keep_first_faces(std::vector<vec3>&& points, const std::vector<std::uint32_t>& twin, std::vector<std::uint8_t>&& outward) {
    const std::size_t n = twin.size();
    std::size_t num_first = 0;
    for (std::size_t f = 0; f < n; ++f) num_first += twin[f] == f;
    polyhedra_arrays out;
    out.points = std::move(points);
    out.poly_offsets = std::move(poly_offsets);
    core::reserve_large(out.poly_faces, n);
    out.outward = std::move(outward);
    core::reserve_large(out.face_offsets, num_first + 1);
    out.face_offsets.push_back(0);
    std::uint32_t corners = 0, face_count = 0;
    // In place: a face that is kept moves forward, over faces already read.
    for (std::size_t f = 0; f < n; ++f) {
      if (twin[f] == f) {
        const std::uint32_t k = size(f);
        std::copy_n(first(f), k, face_verts.data() + corners);
        out.face_offsets.push_back(corners += k);
        out.poly_faces.push_back(face_id{face_count++});
      } else {
        out.poly_faces.push_back(out.poly_faces[twin[f]]);
      }
    }
    core::reserve_large(out.face_verts, corners);
    out.face_verts.assign(face_verts.data(), face_verts.data() + corners);
    std::vector<Vert>().swap(face_verts);
    return out;
  }

 public:
  polyhedra_arrays unite(std::vector<vec3> points) && {
    const std::size_t n = face_offsets.size() - 1;
    std::vector<std::uint32_t> where = core::large_vector(points.size() + 1, std::uint32_t{0});
    std::vector<entry> entries = sort_by_smallest_vert(where);

    // twin[f]: the first face equal to f; outward[f]: whether f has the same direction as that face
    std::vector<std::uint32_t> twin = core::large_vector(n, std::uint32_t{0});
    std::vector<std::uint8_t> outward = core::large_vector(n, std::uint8_t{1});
    std::vector<cycle> cycles;
    auto original = entries.begin();  // the last face without a twin, where faces are sorted
    for (std::size_t v = 0, from = 0; v < points.size(); from = where[v++]) {
      const auto b = entries.begin() + static_cast<std::ptrdiff_t>(from), e = entries.begin() + where[v];
      std::sort(b, e, [](const entry& x, const entry& y) { return x.others != y.others ? x.others < y.others : x.face < y.face; });
      for (auto run = b, after = b; run != e; run = after) {
        while (after != e && after->others == run->others) ++after;
        // Many faces with the same three smallest verts are sorted, so that equal ones are consecutive.
        const bool sorted = after - run > 16;
        if (sorted) {
          cycles.clear();
          for (auto i = run; i != after; ++i) cycles.push_back(cycle(first(i->face), size(i->face), i->face));
          std::sort(cycles.begin(), cycles.end());
          for (std::size_t k = 0; k < cycles.size(); ++k) run[static_cast<std::ptrdiff_t>(k)].face = cycles[k].face();
        }
        for (auto i = run; i != after; ++i) {
          twin[i->face] = i->face;
          for (auto j = sorted && i != run ? original : run; j != i; ++j) {
            if (twin[j->face] != j->face || size(j->face) != size(i->face)) continue;
            if (const int order = compare_cycles(first(j->face), first(i->face), size(i->face))) {
              twin[i->face] = j->face;
              outward[i->face] = order > 0;
              break;
            }
          }
          if (twin[i->face] == i->face) original = i;
        }
      }
    }
    entries = {};
    where = {};

    return keep_first_faces(std::move(points), twin, std::move(outward));
  }
};
using face_soup = basic_face_soup<vert_id>;

}  // namespace concino
