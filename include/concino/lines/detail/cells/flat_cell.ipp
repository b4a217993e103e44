// Bodies of flat_cell.hpp: the surface of a polyhedron as triangles in flat arrays, and where a line inside leaves it.
#pragma once

#include <concino/lines/detail/cells/flat_cell.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace concino::detail {

CONCINO_INLINE bool is_corner_of(std::uint32_t c, std::span<const std::uint32_t> entry) {
  for (const std::uint32_t e : entry)
    if (e == c) return true;
  return false;
}

CONCINO_INLINE void flat_cell::clear() {
  points.clear();
  triangles.clear();
  faces_.clear();
  corners_.clear();
}

CONCINO_INLINE void flat_cell::set_face(std::uint32_t face, std::span<const std::uint32_t> ring, bool is_outward) {
  faces_[face] = {static_cast<std::uint32_t>(corners_.size()), static_cast<std::uint32_t>(ring.size()), is_outward,
                  false};
  corners_.insert(corners_.end(), ring.begin(), ring.end());
}

CONCINO_INLINE bool flat_cell::has_corner(std::uint32_t face, std::uint32_t corner) const {
  return is_corner_of(corner, std::span(corners_).subspan(faces_[face].first, faces_[face].size));
}

CONCINO_INLINE void flat_cell::cut_face(std::uint32_t face) {
  face_ring& f = faces_[face];
  if (f.is_cut) return;
  f.is_cut = true;
  const std::uint32_t n = f.size;
  bool outward = f.is_outward;
  const std::uint32_t* const c = corners_.data() + f.first;
  if (n == 3) {
    if (outward) triangles.push_back({{c[0], c[1], c[2]}, {0, 1, 2}, face, 0, 3});
    else triangles.push_back({{c[0], c[2], c[1]}, {0, 2, 1}, face, 0, 3});
    return;
  }
  std::uint32_t first = 0;
  for (std::uint32_t i = 1; i < n; ++i)
    if (lies_before(points[c[i]], points[c[first]])) first = i;
  const bool turns = lies_before(points[c[(first + n - 1) % n]], points[c[(first + 1) % n]]);
  ring_.clear();
  for (std::uint32_t i = 0; i < n; ++i) ring_.push_back(c[(first + (turns ? n - i : i)) % n]);
  if (turns) outward = !outward;
  std::uint32_t number = 0;
  const auto add = [&](const polygon_triangle& t) {
    const std::uint32_t second = outward ? t[1] : t[2], third = outward ? t[2] : t[1];
    triangles.push_back({{ring_[t[0]], ring_[second], ring_[third]}, {t[0], second, third}, face, number++, n});
  };
  ring_points_.clear();
  for (const std::uint32_t i : ring_) ring_points_.push_back(points[i]);
  for (const polygon_triangle& t : cut_(ring_points_)) add(t);
}

CONCINO_INLINE void flat_cell::add_cut_face(std::uint32_t face, std::span<const vec3> ring,
                                            std::span<const cell_triangle> cut, bool same_way) {
  const auto first = static_cast<std::uint32_t>(points.size()), n = static_cast<std::uint32_t>(ring.size());
  faces_[face] = {static_cast<std::uint32_t>(corners_.size()), n, false, true};
  for (std::uint32_t i = 0; i < n; ++i) corners_.push_back(first + i);
  points.insert(points.end(), ring.begin(), ring.end());
  for (const cell_triangle& t : cut) {
    const std::array<std::uint32_t, 3> r = {t.ring[0], t.ring[same_way ? 1 : 2], t.ring[same_way ? 2 : 1]};
    triangles.push_back({{first + r[0], first + r[1], first + r[2]}, r, face, t.number, n});
  }
}

CONCINO_INLINE void flat_cell::look(const vec3& x, const vec3& g) {
  const vec3 along = g / norm(g);
  x_ = x;
  u_ = cross(along, std::abs(along.x) < 0.6 ? vec3{1, 0, 0} : vec3{0, 1, 0});
  u_ /= norm(u_);
  v_ = cross(along, u_);
}

CONCINO_INLINE void flat_cell::project_corners(std::span<const std::uint32_t> entry) {
  if (projected_.size() < points.size()) projected_.resize(points.size());
  double farthest = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const vec3 d = points[i] - x_;
    projected_[i] = {dot(d, u_), dot(d, v_), false};
    farthest = std::max(farthest, dot(d, d));
  }
  for (const std::uint32_t c : entry) projected_[c].is_entry = true;
  product_error_ = 1e-14 * farthest;
}

/// The sign of side_of_line where it is certain, else 0.
CONCINO_INLINE int flat_cell::quick_side(std::uint32_t a, std::uint32_t b) const {
  const double turn = projected_[a].u * projected_[b].v - projected_[a].v * projected_[b].u;
  return turn > product_error_ ? 1 : turn < -product_error_ ? -1 : 0;
}

/// The side of the line on which a to b passes. A side of the triangle of entry is known: the line enters between its
/// three sides.
CONCINO_INLINE signed_value flat_cell::side(std::uint32_t a, std::uint32_t b, const vec3& x, const vec3& g,
                                            std::span<const std::uint32_t> entry) const {
  signed_value s = side_of_line(g, points[a], points[b], x);
  if (entry.size() == 3 && is_corner_of(a, entry) && is_corner_of(b, entry)) {
    const std::ptrdiff_t i = std::find(entry.begin(), entry.end(), a) - entry.begin();
    const int sign = entry[static_cast<std::size_t>((i + 1) % 3)] == b ? -1 : 1;
    if (s.sign != sign) s = {0, sign};
  }
  return s;
}

CONCINO_INLINE bool flat_cell::leaves_through(const cell_triangle& t, const vec3& x, const vec3& g,
                                              std::span<const std::uint32_t> entry) const {
  bool turns = false;
  for (unsigned k = 0; k < 3; ++k) {
    const std::uint32_t a = t.corner[k], b = t.corner[(k + 1) % 3];
    const bool at_entry = entry.size() == 3 && projected_[a].is_entry && projected_[b].is_entry;
    int sign = at_entry ? 0 : quick_side(a, b);
    if (sign == 0) sign = side(a, b, x, g, entry).sign;
    if (sign < 0) return false;
    turns = turns || sign > 0;
  }
  return turns;
}

CONCINO_INLINE double flat_cell::distance_to(std::uint32_t triangle, const vec3& x, const vec3& g) const {
  const auto& c = triangles[triangle].corner;
  const vec3 &p = points[c[0]], n = cross(points[c[1]] - p, points[c[2]] - p);
  const double speed = dot(n, g);
  return speed > 0 ? dot(n, p - x) / speed : 0;
}

CONCINO_INLINE cell_exit flat_cell::exit_in(std::uint32_t t, const vec3& x, const vec3& g,
                                            std::span<const std::uint32_t> entry, std::uint32_t first) const {
  const auto& c = triangles[t].corner;
  std::array<signed_value, 3> s;
  for (std::uint32_t k = 0; k < 3; ++k) s[k] = side(c[k], c[(k + 1) % 3], x, g, entry);
  for (std::uint32_t k = 0; k < 3; ++k)
    if (s[k].sign == 0 && s[(k + 2) % 3].sign == 0) return {cell_exit::kind::corner, t, k, 0, points[c[k]]};
  for (std::uint32_t k = 0; k < 3; ++k) {
    if (s[k].sign != 0) continue;
    const double a = s[(k + 1) % 3].value, b = s[(k + 2) % 3].value, parameter = a + b > 0 ? b / (a + b) : 0.5;
    const vec3 &from = points[c[k]], &to = points[c[(k + 1) % 3]];
    return {cell_exit::kind::side, t, k, parameter, from + parameter * (to - from)};
  }
  const std::uint32_t second = (first + 1) % 3, third = (first + 2) % 3;
  const vec3 &p = points[c[first]], &q = points[c[second]], &r = points[c[third]];
  const double whole = s[first].value + s[second].value + s[third].value;
  return {cell_exit::kind::triangle, t, 0, 0,
          whole > 0 ? p + (s[third].value * (q - p) + s[first].value * (r - p)) / whole : (p + q + r) / 3};
}

/// The sides on which the edges that are not those of entry pass the line tell it: three determinants instead of nine.
CONCINO_INLINE std::uint32_t flat_cell::corner_left_behind(const vec3& x, const vec3& g,
                                                           std::span<const std::uint32_t> entry) const {
  const std::uint32_t top = 6 - entry[0] - entry[1] - entry[2];
  std::array<int, 3> s;
  for (std::size_t k = 0; k < 3; ++k) s[k] = side_of_line(g, points[entry[k]], points[top], x).sign;
  for (std::size_t k = 0; k < 3; ++k)
    if (s[k] >= 0 && s[(k + 1) % 3] <= 0) return entry[(k + 2) % 3];
  return no_corner;
}

CONCINO_INLINE cell_exit flat_cell::leave_through(std::uint32_t face, const vec3& x, const vec3& g,
                                                  std::span<const std::uint32_t> entry) {
  cut_face(face);
  std::uint32_t t = 0;
  while (triangles[t].face != face) ++t;
  std::uint32_t k = 0;
  while (is_corner_of(triangles[t].corner[k], entry)) ++k;
  return exit_in(t, x, g, entry, k);
}

CONCINO_INLINE cell_exit flat_cell::leave(const vec3& x, const vec3& g, std::span<const std::uint32_t> entry) {
  look(x, g);
  for (std::uint32_t f = 0; f < faces_.size(); ++f) {
    const std::span<const std::uint32_t> ring = std::span(corners_).subspan(faces_[f].first, faces_[f].size);
    if (!faces_[f].is_cut && may_cross(ring, [&](std::uint32_t c) { return points[c]; })) cut_face(f);
  }
  return find_exit(x, g, entry);
}

CONCINO_INLINE cell_exit flat_cell::find_exit(const vec3& x, const vec3& g, std::span<const std::uint32_t> entry) {
  project_corners(entry);
  std::uint32_t found = 0, best = 0;
  double best_distance = 0;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    std::size_t entries = 0;
    for (const std::uint32_t k : triangles[t].corner) entries += projected_[k].is_entry;
    if ((!entry.empty() && entries == entry.size()) || !leaves_through(triangles[t], x, g, entry)) continue;
    if (found++ == 0) {
      best = t;
      continue;
    }
    if (found == 2) best_distance = distance_to(best, x, g);
    const double d = distance_to(t, x, g);
    if (best_distance > 0 ? d > 0 && d < best_distance : d > best_distance) {
      best = t;
      best_distance = d;
    }
  }
  return found == 0 ? cell_exit() : exit_in(best, x, g, entry, 0);
}

}  // namespace concino::detail
