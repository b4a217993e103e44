// The cells that have a name: how their faces are made of their verts, their volume, and turning the verts of inverted ones.
#pragma once

#include <concino/concepts/descriptors.hpp>
#include <concino/core/vec3.hpp>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace concino::detail {

enum class cell_shape : std::uint8_t { tet, hex, prism, pyramid, general };

/// One standard cell. Verts are in the order of VTK and MEDIT; faces run counter-clockwise seen from outside where the cell's volume is
/// positive.
struct standard_cell {
  const char* name;
  unsigned num_verts, num_faces;
  std::uint8_t face_size[6];
  std::uint8_t face_vert[6][4];
  std::uint8_t mirrored[8];  // the verts of the mirror image: a cell of negative volume, read in this order, has a positive one
};

inline constexpr standard_cell standard_cells[] = {
    {"tet", 4, 4, {3, 3, 3, 3}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}, {0, 1, 3, 2}},
    {"hex",
     8,
     6,
     {4, 4, 4, 4, 4, 4},
     {{0, 3, 2, 1}, {1, 2, 6, 5}, {4, 5, 6, 7}, {3, 0, 4, 7}, {0, 1, 5, 4}, {2, 3, 7, 6}},
     {0, 3, 2, 1, 4, 7, 6, 5}},
    {"prism", 6, 5, {3, 3, 4, 4, 4}, {{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}, {0, 2, 1, 3, 5, 4}},
    {"pyramid", 5, 5, {4, 3, 3, 3, 3}, {{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}, {0, 3, 2, 1, 4}},
};
inline constexpr const standard_cell& table_of(cell_shape s) { return standard_cells[static_cast<unsigned>(s)]; }

/// The volume under one face seen from `apex`, six times: the triangles from the face's mean point to its edges, positive if they turn
/// away from the apex. They are the mean point times the face's vector area. point(i) is the i-th of the n verts.
template<class Point>
double six_volumes_under(std::size_t n, const Point& point, const vec3& apex) {
  vec3 middle, doubled_area, a = point(n - 1) - apex;
  for (std::size_t i = 0; i < n; ++i) {
    const vec3 b = point(i) - apex;
    middle += b;
    doubled_area += cross(a, b);
    a = b;
  }
  return dot(middle, doubled_area) / static_cast<double>(n);
}

/// Six times the signed volume of a standard cell, each face a fan about its mean point.
inline double six_volumes(cell_shape s, const vert_id* v, const std::vector<vec3>& points) {
  const auto at = [&](unsigned i) -> const vec3& { return points[v[i].raw()]; };
  if (s == cell_shape::tet) return dot(at(1) - at(0), cross(at(2) - at(0), at(3) - at(0)));
  const standard_cell& t = table_of(s);
  vec3 q[8];
  for (unsigned i = 0; i < t.num_verts; ++i) q[i] = at(i) - at(0);
  double of_triangles = 0, of_quads = 0;
  for (unsigned f = 0; f < t.num_faces; ++f) {
    const std::uint8_t* const k = t.face_vert[f];
    if (t.face_size[f] == 3) of_triangles += dot(q[k[0]], cross(q[k[1]], q[k[2]]));
    else of_quads += dot(q[k[0]] + q[k[1]] + q[k[2]] + q[k[3]], cross(q[k[2]] - q[k[0]], q[k[3]] - q[k[1]]));
  }
  return of_triangles + of_quads / 4;
}

/// Puts the verts of a cell of negative volume into the standard order. Returns whether it did.
inline bool make_positive(cell_shape s, vert_id* v, const std::vector<vec3>& points) {
  if (!(six_volumes(s, v, points) < 0)) return false;
  vert_id was[8];
  const standard_cell& t = table_of(s);
  std::copy_n(v, t.num_verts, was);
  for (unsigned i = 0; i < t.num_verts; ++i) v[i] = was[t.mirrored[i]];
  return true;
}

/// Whether a and b are one cycle, walked the same way (1) or opposite ways (-1), or are not (0). Verts are not repeated.
inline int compare_cycles(const vert_id* a, const vert_id* b, std::size_t n) {
  const auto k = static_cast<std::size_t>(std::find(b, b + n, a[0]) - b);
  if (k == n) return 0;
  bool same = true, opposite = true;
  for (std::size_t i = 0; i < n && (same || opposite); ++i) {
    same = same && a[i] == b[(k + i) % n];
    opposite = opposite && a[i] == b[(k + n - i) % n];
  }
  return same ? 1 : opposite ? -1 : 0;
}

}  // namespace concino::detail
