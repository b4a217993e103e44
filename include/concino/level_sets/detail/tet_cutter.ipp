// The tets into which a level set cuts tets; see tet_cutter.hpp.
#pragma once

#include <concino/core/large_pages.hpp>
#include <concino/level_sets/detail/level_states.hpp>
#include <concino/level_sets/detail/tet_caps.hpp>
#include <concino/level_sets/detail/tet_cutter.hpp>

#include <algorithm>
#include <numeric>
#include <utility>

namespace concino::detail {

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
  void start_at_smallest() { std::rotate(corners, std::min_element(corners, corners + size), corners + size); }
};

CONCINO_INLINE void tet_cutter::resize(std::size_t num_tets) {
  constexpr std::size_t parts = 5;  // of a tet: often four or six
  core::reserve_large(lists.corners, 4 * parts * num_tets), core::reserve_large(lists.origins, parts * num_tets);
  lists.corners.resize(4 * num_tets), lists.origins.resize(num_tets);
  lists.old_polys.reserve(num_tets), places.reserve(num_tets), cut_faces_.reserve(6 * num_tets);
  crossings_.reserve(num_tets);
}

/// The vert between two verts of t, of which one is below: a new one, or one on the level set.
CONCINO_INLINE unsigned tet_cutter::place(const crossed_tet& t, unsigned a, unsigned b) {
  if (t.states[a] != below_level) std::swap(a, b);
  if (t.states[b] == on_level) return t.verts[b];
  unsigned& known = places_[a][b];
  if (known != 0) return known;
  const unsigned number = crossings_.add(std::size_t{t.verts[a]} << 32 | t.verts[b]);
  if (number == places.size()) places.push_back({level_place::edge, 0, t.verts[a], t.verts[b]});
  return known = new_vert | number;
}

CONCINO_INLINE void tet_cutter::add_tet(unsigned a, unsigned b, unsigned c, unsigned d) {
  const auto old = static_cast<std::uint32_t>(lists.old_polys.size() - 1);
  if (is_first_) {
    const unsigned corners[] = {a, b, c, d};
    std::copy_n(corners, 4, lists.corners.data() + std::size_t{4} * old);
    lists.origins[old] = old;
    is_first_ = false;
    return;
  }
  lists.corners.insert(lists.corners.end(), {a, b, c, d});
  lists.origins.push_back(old);
}

CONCINO_INLINE void tet_cutter::add(const crossed_tet& t) {
  lists.old_polys.push_back(t.poly);
  is_first_ = true;
  for (auto& row : places_) std::fill(row, row + 4, 0u);
  for (unsigned char k = 0; k < 4; ++k) {
    unsigned char i = k;
    for (; i > 0 && t.order[faces_[i - 1]] > t.order[k]; --i) faces_[i] = faces_[i - 1];
    faces_[i] = k;
  }
  const bool first_is_above = t.states[0] != below_level;
  add_part(t, first_is_above);
  add_part(t, !first_is_above);
}

/// Adds the tets between the smallest vert of a part and the triangles of its faces that do not have it.
CONCINO_INLINE void tet_cutter::add_part(const crossed_tet& t, bool is_above) {
  const auto is_in_part = [&](unsigned position) { return (t.states[position] != below_level) == is_above; };
  part_face faces[5];
  unsigned num_faces = 0;
  for (const unsigned char k : faces_) {
    const unsigned char* const c = t.corners[k];
    unsigned start = 0;
    while (start < 3 && !is_in_part(c[start])) ++start;
    if (start == 3) continue;
    part_face& f = faces[num_faces];
    f.size = 0;
    for (unsigned i = 0; i < 3; ++i) {
      const unsigned a = c[(start + i) % 3], b = c[(start + i + 1) % 3];
      if (is_in_part(a)) f.push(t.verts[a]);
      if (is_in_part(a) != is_in_part(b)) f.push(place(t, a, b));
    }
    f.close();
    if (f.size < 3) continue;
    if (!t.is_outward[k]) std::reverse(f.corners, f.corners + f.size);
    ++num_faces;
  }
  // tet_caps is about tets whose first three verts are clockwise seen from outside.
  const unsigned position[4] = {0, t.is_outward[0] ? 2u : 1u, t.is_outward[0] ? 1u : 2u, 3};
  constexpr unsigned char ends[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
  unsigned signs = 0;
  for (unsigned k = 0; k < 4; ++k) signs |= (t.states[position[k]] != below_level ? 1u : 0u) << k;
  const tet_cap& edges = tet_caps[signs];
  part_face& cap = faces[num_faces++];
  cap.size = 0;
  for (unsigned k = 0; k < edges.size; ++k) cap.push(place(t, position[ends[edges.edges[k]][0]], position[ends[edges.edges[k]][1]]));
  cap.close();
  if (is_above) {
    std::reverse(cap.corners, cap.corners + cap.size);
  } else {
    cap.start_at_smallest();
    for (unsigned k = 1; k + 1 < cap.size; ++k) cut_faces_.insert(cut_faces_.end(), {cap.corners[0], cap.corners[k], cap.corners[k + 1]});
  }
  unsigned top = ~0u;
  for (unsigned i = 0; i < num_faces; ++i) top = std::min(top, faces[i].smallest());
  for (unsigned i = 0; i < num_faces; ++i) {
    part_face& f = faces[i];
    f.start_at_smallest();
    for (unsigned k = 1; f.corners[0] != top && k + 1 < f.size; ++k) add_tet(top, f.corners[0], f.corners[k], f.corners[k + 1]);
  }
}

CONCINO_INLINE void tet_cutter::finish(std::uint32_t num_verts) {
  const auto num_places = static_cast<std::uint32_t>(places.size());
  lists.verts.resize(num_verts), lists.places.resize(num_places);
  std::iota(lists.verts.begin(), lists.verts.end(), 0u);
  std::iota(lists.places.begin(), lists.places.end(), 0u);
  lists.number_of_place = lists.places;
  for (unsigned& v : lists.corners) v = v & new_vert ? num_verts + (v ^ new_vert) : v;
  lists.ends.reserve(lists.origins.size());
  for (unsigned k = 1; k <= lists.origins.size(); ++k) lists.ends.push_back(4 * k);
  lists.cut_places.reserve(cut_faces_.size());
  for (const unsigned v : cut_faces_) {
    if (v & new_vert) {
      lists.cut_places.push_back(v ^ new_vert);
      continue;
    }
    lists.cut_places.push_back(static_cast<std::uint32_t>(places.size()));
    lists.number_of_place.push_back(~0u);
    places.push_back({level_place::vert, v, v, v});
  }
  lists.cut_ends.reserve(cut_faces_.size() / 3);
  for (std::uint32_t k = 3; k <= cut_faces_.size(); k += 3) lists.cut_ends.push_back(k);
}

}  // namespace concino::detail
