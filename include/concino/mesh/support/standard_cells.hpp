// The standard cells (tet, hex, prism, pyramid): the verts of their faces, their volume, and the reordering of inverted
// cells.
#pragma once

#include <concino/concepts/descriptors.hpp>
#include <concino/core/vec3.hpp>
#include <concino/mesh/support/volume_sign.hpp>

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace concino {

/// The shapes of the standard cells, and `general` for all others.
enum class cell_shape : std::uint8_t { tet, hex, prism, pyramid, general };

/// A table for one standard cell. Verts are in the order of MEDIT, which is that of VTK but for its wedges, whose base
/// is reversed. Faces run counter-clockwise seen from outside if the cell's volume is positive.
struct standard_cell {
  const char* name;
  unsigned num_verts, num_faces;
  std::uint8_t face_size[6];
  std::uint8_t face_vert[6][4];
  std::uint8_t mirrored[8];  // the verts of the mirror image: a cell of negative volume has a positive one if read in
                             // this order
};

inline constexpr standard_cell standard_cells[] = {
    {"tet", 4, 4, {3, 3, 3, 3}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}, {0, 1, 3, 2}},
    {"hex",
     8,
     6,
     {4, 4, 4, 4, 4, 4},
     {{0, 3, 2, 1}, {1, 2, 6, 5}, {4, 5, 6, 7}, {3, 0, 4, 7}, {0, 1, 5, 4}, {2, 3, 7, 6}},
     {0, 3, 2, 1, 4, 7, 6, 5}},
    {"prism",
     6,
     5,
     {3, 3, 4, 4, 4},
     {{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}},
     {0, 2, 1, 3, 5, 4}},
    {"pyramid", 5, 5, {4, 3, 3, 3, 3}, {{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}, {0, 3, 2, 1, 4}},
};
/// The table of a shape.
/// Needs:  a shape that is not general.
/// Result: a reference with static lifetime.                                       Cost: O(1).
/// Errors: none.
inline constexpr const standard_cell& standard_cell_of(cell_shape s) {
  return standard_cells[static_cast<unsigned>(s)];
}

/// Six times the signed volume between a face and `apex`. The face is split into triangles from its mean point to its
/// edges; the volume is positive if they face away from the apex.
/// Needs:  point_of(i), the i-th of the n > 0 verts of the face.
/// Result: volume units, six times.                                                Cost: O(n).
/// Errors: none.
template<class Point>
double six_times_volume_under(std::size_t n, const Point& point_of, const vec3& apex) {
  detail::volume_under_face volume;
  vec3 a = point_of(n - 1) - apex;
  for (std::size_t i = 0; i < n; ++i) {
    const vec3 b = point_of(i) - apex;
    volume.add_edge(a, b);
    a = b;
  }
  return volume.six_times(n);
}

/// Six times the signed volume of a standard cell. Each face is split into triangles from its mean point.
/// Needs:  the verts of the cell in the standard order of its shape, which is not general; a point for each.
/// Result: volume units, six times; negative if the cell is inverted.              Cost: O(1).
/// Errors: none.
inline double six_times_volume(cell_shape s, const vert_id* v, std::span<const vec3> points) {
  const auto at = [&](unsigned i) -> const vec3& { return points[v[i].raw()]; };
  if (s == cell_shape::tet) return dot(at(1) - at(0), cross(at(2) - at(0), at(3) - at(0)));
  const standard_cell& t = standard_cell_of(s);
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

/// Whether the volume of a standard cell is negative, by more than rounding errors.
/// Needs:  as six_times_volume.
/// Result: true if it is; false also if a double cannot tell.                      Cost: O(1).
/// Errors: none.
inline bool has_negative_volume(cell_shape s, const vert_id* v, std::span<const vec3> points) {
  const double x = six_times_volume(s, v, points);
  const standard_cell& t = standard_cell_of(s);
  if (x > 1e-100 && x < 1e100) {  // nearly all cells
    bool is_certain = true;
    for (unsigned i = 0; i < t.num_verts; ++i) is_certain = is_certain && has_moderate_coordinates(points[v[i].raw()]);
    if (is_certain) return false;
  }
  volume_box box;
  std::size_t num_corners = 0;
  for (unsigned i = 0; i < t.num_verts; ++i) box.add(points[v[i].raw()]);
  for (unsigned f = 0; f < t.num_faces; ++f) num_corners += t.face_size[f];
  if (box.is_moderate()) return x < -box.error(num_corners);
  vec3 scaled[8];
  vert_id ids[8];
  for (unsigned i = 0; i < t.num_verts; ++i) {
    scaled[i] = box.scaled(points[v[i].raw()]);
    ids[i] = vert_id{i};
  }
  return six_times_volume(s, ids, scaled) < -box.error(num_corners);
}

/// Reorders the verts of a cell of negative volume to the standard order.
/// Needs:  as six_times_volume.
/// Result: whether the verts were changed.                                         Cost: O(1).
/// Errors: none.
inline bool make_volume_positive(cell_shape s, vert_id* v, std::span<const vec3> points) {
  if (!has_negative_volume(s, v, points)) return false;
  vert_id was[8];
  const standard_cell& t = standard_cell_of(s);
  std::copy_n(v, t.num_verts, was);
  for (unsigned i = 0; i < t.num_verts; ++i) v[i] = was[t.mirrored[i]];
  return true;
}

/// Whether a and b are the same cycle of n verts.
/// Needs:  no vert twice in a, nor in b.
/// Result: 1 if both have the same direction, -1 if opposite directions, 0 if they are not the same cycle.      Cost:
///         O(n).
/// Errors: none.
inline int compare_cycles(const vert_id* a, const vert_id* b, std::size_t n) {
  std::size_t k = 0;
  while (k < n && b[k] != a[0]) ++k;
  if (k == n) return 0;
  const auto at = [&](std::size_t i) { return b[i < n ? i : i - n]; };  // i < 2 n
  std::size_t i = 1;
  if (n < 2 || a[1] == at(k + 1)) {
    while (i < n && a[i] == at(k + i)) ++i;
    return i == n ? 1 : 0;
  }
  while (i < n && a[i] == at(k + n - i)) ++i;
  return i == n ? -1 : 0;
}

}  // namespace concino
