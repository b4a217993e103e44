// Bodies of cell_tets.hpp: cuts the faces of volumes into triangles and their cells into tets.
#pragma once

#include <concino/generate/detail/volumes/cell_tets.hpp>
#include <concino/geometry/orientation.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace concino::detail {

// Whether the triangles at a corner have the orientation of the face, and more than 10^-10 of its area: what is less
// may be rounding errors.
CONCINO_INLINE bool face_triangles::is_fan(std::size_t from) const {
  const std::size_t n = points_.size();
  const vec3 origin = points_[from];
  double size = 0;
  for (const vec3& x : points_)
    size = std::max({size, std::abs(x.x - origin.x), std::abs(x.y - origin.y), std::abs(x.z - origin.z)});
  const auto step = [&](std::size_t k) { return (points_[(from + k) % n] - origin) / size; };
  vec3 area;
  for (std::size_t k = 2; k < n; ++k) area += cross(step(k - 1), step(k));
  for (std::size_t k = 2; k < n; ++k)
    if (!(dot(cross(step(k - 1), step(k)), area) > 1e-10 * dot(area, area))) return false;
  return true;
}

CONCINO_INLINE void face_triangles::add(std::size_t face, std::span<const vert_id> verts,
                                        std::span<const vec3> points) {
  first_[face] = corners_.size();
  const std::size_t n = verts.size();
  const std::size_t from = static_cast<std::size_t>(std::min_element(verts.begin(), verts.end()) - verts.begin());
  points_.clear();
  for (const vert_id v : verts) points_.push_back(points[v.raw()]);
  if (n == 3 || (n > 3 && is_fan(from))) {
    for (std::size_t k = 2; k < n; ++k)
      corners_.insert(corners_.end(), {verts[from], verts[(from + k - 1) % n], verts[(from + k) % n]});
  } else {
    for (const auto& [a, b, c] : cut_(points_)) corners_.insert(corners_.end(), {verts[a], verts[b], verts[c]});
  }
  last_[face] = corners_.size();
}

CONCINO_INLINE cell_cutter::cell_cutter(std::vector<vec3> points) {
  double largest = 0;
  for (const vec3& x : points) largest = std::max({largest, std::abs(x.x), std::abs(x.y), std::abs(x.z)});
  int exponent = 0;
  std::frexp(largest, &exponent);
  if (std::abs(exponent) > 60) scale_ = std::ldexp(1.0, std::clamp(-exponent, -1020, 1020));
  tets.points = std::move(points);
}

CONCINO_INLINE bool cell_cutter::is_positive(vert_id a, vert_id b, vert_id c, vert_id d) const {
  const auto at = [&](vert_id v) { return scale_ * tets.points[v.raw()]; };
  return orient3d(at(a), at(b), at(c), at(d)) > 0;
}

CONCINO_INLINE void cell_cutter::begin_cell() {
  outer_.clear();
  triangles_ = quads_ = 0;
  has_others_ = false;
}

CONCINO_INLINE void cell_cutter::add_face(std::span<const vert_id> corners, bool outward) {
  if (corners.size() == 3) ++triangles_;
  else if (corners.size() == 6) ++quads_;
  else has_others_ = true;
  for (std::size_t i = 0; i < corners.size(); i += 3)
    outer_.insert(outer_.end(), {corners[i], corners[i + (outward ? 1 : 2)], corners[i + (outward ? 2 : 1)]});
}

// By Euler's formula, no other polyhedra have these numbers of faces and verts, if three or more edges meet at each
// vert.
CONCINO_INLINE bool cell_cutter::is_standard_cell(std::size_t n) const {
  if (has_others_) return false;
  if (triangles_ == 4) return (quads_ == 0 && n == 4) || (quads_ == 1 && n == 5);
  return (triangles_ == 2 && quads_ == 3 && n == 6) || (triangles_ == 0 && quads_ == 6 && n == 8);
}

CONCINO_INLINE void cell_cutter::add_tet(vert_id a, vert_id b, vert_id c, vert_id d) {
  tets.verts.insert(tets.verts.end(), {a, b, c, d});
}

/// Adds the tets of the apex and the triangles in far_. Returns whether all are positive.
CONCINO_INLINE bool cell_cutter::join(vert_id apex) {
  bool positive = true;
  for (std::size_t i = 0; i < far_.size(); i += 3) {
    add_tet(far_[i], far_[i + 2], far_[i + 1], apex);
    positive = positive && is_positive(far_[i], far_[i + 2], far_[i + 1], apex);
  }
  return positive;
}

// Three tets around the line from the apex to the opposite corner of a hex become two, if no face is cut at this
// corner: the hex has five tets.
CONCINO_INLINE void cell_cutter::cut_corner(vert_id apex) {
  for (const vert_id corner : far_) {
    vert_id next[3];  // in the three triangles at the corner, the verts after it
    vert_id last[3];
    unsigned n = 0;
    bool meets_apex = false;
    for (std::size_t i = 0; i < outer_.size(); ++i) {
      if (outer_[i] != corner) continue;
      const std::size_t first = i - i % 3;
      const vert_id b = outer_[first + (i + 1) % 3], c = outer_[first + (i + 2) % 3];
      if (n < 3) next[n] = b, last[n] = c;
      ++n;
      meets_apex = meets_apex || b == apex || c == apex;
    }
    if (n != 3 || meets_apex) continue;
    const vert_id x = next[0], y = last[0], z = next[1] == y ? last[1] : last[2];
    if (!is_positive(x, y, z, corner) || !is_positive(x, z, y, apex)) return;
    add_tet(x, y, z, corner);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < far_.size(); i += 3)
      if (far_[i] != corner && far_[i + 1] != corner && far_[i + 2] != corner)
        for (const std::size_t k : {0u, 1u, 2u}) far_[kept++] = far_[i + k];
    far_.resize(kept);
    far_.insert(far_.end(), {x, y, z});
    return;
  }
}

CONCINO_INLINE bool cell_cutter::cut_at_smallest_vert(bool is_hex) {
  const vert_id apex = *std::min_element(outer_.begin(), outer_.end());
  far_.clear();
  for (std::size_t i = 0; i < outer_.size(); i += 3)
    if (outer_[i] != apex && outer_[i + 1] != apex && outer_[i + 2] != apex)
      far_.insert(far_.end(), outer_.begin() + static_cast<std::ptrdiff_t>(i),
                  outer_.begin() + static_cast<std::ptrdiff_t>(i + 3));
  if (is_hex) cut_corner(apex);
  return join(apex);
}

CONCINO_INLINE void cell_cutter::set_weights(std::size_t first) {
  const auto at = [&](std::size_t i) { return scale_ * tets.points[tets.verts[i].raw()]; };
  for (std::size_t i = first; i < tets.verts.size(); i += 4)
    weight_.push_back(std::abs(dot(at(i + 1) - at(i), cross(at(i + 2) - at(i), at(i + 3) - at(i)))));
}

CONCINO_INLINE bool cell_cutter::cut(std::size_t poly, std::size_t num_verts, function_ref<vec3()> mean) {
  if (outer_.empty()) return false;
  const std::size_t first = tets.verts.size();
  const bool is_standard = is_standard_cell(num_verts);
  bool positive = is_standard && cut_at_smallest_vert(quads_ == 6), has_centre = false;
  if (!positive) {  // a cone over the same triangles, so that cells still fit together
    tets.verts.resize(first);
    has_centre = true;
    far_ = outer_;
    const vert_id centre{tets.points.size()};
    tets.points.push_back(mean());
    positive = join(centre);
    if (!positive && is_standard) {  // no better: the new vert is of no use
      tets.points.pop_back();
      tets.verts.resize(first);
      cut_at_smallest_vert(quads_ == 6);
      has_centre = false;
    }
  }
  if (!positive) {
    inverted_cells.push_back(poly);
    for (std::size_t i = first; i < tets.verts.size(); i += 4)
      if (!is_positive(tets.verts[i], tets.verts[i + 1], tets.verts[i + 2], tets.verts[i + 3]))
        inverted.push_back(poly_id{i / 4});
  }
  poly_.resize(tets.verts.size() / 4, static_cast<std::uint32_t>(poly));
  set_weights(first);
  return has_centre;
}

CONCINO_INLINE element_origins cell_cutter::poly_origins() const {
  element_origins origins;
  for (std::size_t i = 0; i < poly_.size(); ++i) {
    const bool is_whole = (i == 0 || poly_[i - 1] != poly_[i]) && (i + 1 == poly_.size() || poly_[i + 1] != poly_[i]);
    if (is_whole) origins.add(poly_[i]);
    else origins.add({{poly_[i], weight_[i]}});
  }
  return origins;
}

}  // namespace concino::detail
