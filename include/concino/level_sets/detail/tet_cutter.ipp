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

CONCINO_INLINE void tet_cutter::resize(std::size_t num_tets) {
  constexpr std::size_t parts = 5;  // of a tet: often four or six
  core::reserve_large(lists.corners, 4 * parts * num_tets), core::reserve_large(lists.origins, parts * num_tets);
  lists.corners.resize(4 * num_tets), lists.origins.resize(num_tets);
  lists.old_polys.reserve(num_tets), places.reserve(num_tets), cut_faces_.reserve(6 * num_tets), lists.cut_polys.reserve(2 * num_tets);
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
  for (const unsigned v : {a, b, c, d}) lists.corners.push_back(v);  // insert() takes longer
  lists.origins.push_back(old);
}

/// poly: the number of a new tet that has this face, or ~0u if it is not known.
CONCINO_INLINE void tet_cutter::add_cut_face(unsigned a, unsigned b, unsigned c, std::uint32_t poly) {
  cut_faces_.insert(cut_faces_.end(), {a, b, c});
  lists.cut_polys.push_back(poly);
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
  if (!((t.states[0] | t.states[1] | t.states[2] | t.states[3]) & on_level)) return add_two_parts(t);
  const bool first_is_above = t.states[0] != below_level;
  add_part(t, first_is_above);
  add_part(t, !first_is_above);
}

/// Calls f(a, b) for the edges at the corners of the face between both parts, counter-clockwise seen from above.
template<class F>
void tet_cutter::for_each_cap_edge(const crossed_tet& t, const F& f) {
  // tet_caps is about tets whose first three verts are clockwise seen from outside.
  const unsigned position[4] = {0, t.is_outward[0] ? 2u : 1u, t.is_outward[0] ? 1u : 2u, 3};
  constexpr unsigned char ends[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
  unsigned signs = 0;
  for (unsigned k = 0; k < 4; ++k) signs |= (t.states[position[k]] != below_level ? 1u : 0u) << k;
  const tet_cap& cap = tet_caps[signs];
  for (unsigned k = 0; k < cap.size; ++k) f(position[ends[cap.edges[k]][0]], position[ends[cap.edges[k]][1]]);
}

/// Finds all new verts of a tet, in the order in which add_part() does.
CONCINO_INLINE void tet_cutter::find_places(const crossed_tet& t, bool first_is_above) {
  constexpr unsigned char crossed[8][2] = {{}, {0, 2}, {1, 0}, {1, 2}, {2, 1}, {0, 1}, {2, 0}, {}};  // edges, by which of the three corners are in the first part
  for (const unsigned char k : faces_) {
    const unsigned char* const c = t.corners[k];
    unsigned in_part = 0;
    for (unsigned i = 0; i < 3; ++i) in_part |= ((t.states[c[i]] != below_level) == first_is_above ? 1u : 0u) << i;
    if (in_part == 0 || in_part == 7) continue;
    for (const unsigned char i : crossed[in_part]) {
      const unsigned a = c[i], b = c[i == 2 ? 0 : i + 1];
      places_[a][b] = places_[b][a] = place(t, a, b);
    }
  }
}

/// Adds the parts of a tet without verts on the level set. Then all shapes are known: only the face opposite to the smallest vert of a part and the cap do
/// not have that vert, and in the cap all verts are new.
CONCINO_INLINE void tet_cutter::add_two_parts(const crossed_tet& t) {
  const bool first_is_above = t.states[0] != below_level;
  find_places(t, first_is_above);
  part_face cap;
  for_each_cap_edge(t, [&](unsigned a, unsigned b) { cap.corners[cap.size++] = places_[a][b]; });
  cap.start_at_smallest();
  add_simple_part(t, first_is_above, cap);
  add_simple_part(t, !first_is_above, cap);
}

/// cap: the face between both parts. It begins at its smallest vert, and is counter-clockwise seen from above.
CONCINO_INLINE void tet_cutter::add_simple_part(const crossed_tet& t, bool is_above, part_face cap) {
  unsigned top = 4, top_number = ~0u, size = 0;
  for (unsigned i = 0; i < 4; ++i) {
    const bool is_in = (t.states[i] != below_level) == is_above;
    size += is_in;
    const bool is_smaller = is_in && t.verts[i] < top_number;
    top = is_smaller ? i : top, top_number = is_smaller ? t.verts[i] : top_number;
  }
  if (size > 1) {
    unsigned k = 0;
    for (unsigned i = 1; i < 4; ++i) k = 6u - t.corners[i][0] - t.corners[i][1] - t.corners[i][2] == top ? i : k;
    const unsigned char* const c = t.corners[k];
    const unsigned char outward[3] = {c[0], c[t.is_outward[k] ? 1 : 2], c[t.is_outward[k] ? 2 : 1]};
    // Begin at the first of the corners in the part, which follow each other.
    unsigned start = 0;
    for (unsigned i = 0; i < 3; ++i)
      if ((t.states[outward[i]] != below_level) == is_above && (t.states[outward[i == 0 ? 2 : i - 1]] != below_level) != is_above) start = i;
    const unsigned a = outward[start], b = outward[(start + 1) % 3], d = outward[(start + 2) % 3];
    if (size == 2) {
      add_tet(top_number, t.verts[a], places_[a][b], places_[a][d]);
    } else if (t.verts[a] < t.verts[b]) {
      add_tet(top_number, t.verts[a], t.verts[b], places_[b][d]);
      add_tet(top_number, t.verts[a], places_[b][d], places_[a][d]);
    } else {
      add_tet(top_number, t.verts[b], places_[b][d], places_[a][d]);
      add_tet(top_number, t.verts[b], places_[a][d], t.verts[a]);
    }
  }
  if (is_above) std::reverse(cap.corners + 1, cap.corners + cap.size);
  for (unsigned k = 1; k + 1 < cap.size; ++k) {
    const unsigned x = cap.corners[0], y = cap.corners[k], z = cap.corners[k + 1];
    if (!is_above) add_cut_face(x, y, z, static_cast<std::uint32_t>(is_first_ ? lists.old_polys.size() - 1 : lists.origins.size()));
    add_tet(top_number, x, y, z);
  }
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
  part_face& cap = faces[num_faces++];
  cap.size = 0;
  for_each_cap_edge(t, [&](unsigned a, unsigned b) { cap.push(place(t, a, b)); });
  cap.close();
  if (is_above) {
    std::reverse(cap.corners, cap.corners + cap.size);
  } else {
    cap.start_at_smallest();
    for (unsigned k = 1; k + 1 < cap.size; ++k) add_cut_face(cap.corners[0], cap.corners[k], cap.corners[k + 1], ~0u);
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
