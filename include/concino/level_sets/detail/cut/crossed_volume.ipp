// The polys of a volume that a level set crosses; see crossed_volume.hpp.
#pragma once

#include <concino/level_sets/detail/cut/crossed_volume.hpp>
#include <concino/level_sets/detail/cut/level_states.hpp>
#include <concino/level_sets/detail/cut/polygon_crossings.hpp>

#include <cmath>

namespace concino::detail {

CONCINO_INLINE void crossed_volume::add_vert(std::uint32_t index, const vec3& x, double value) {
  vert_indices.push_back(index);
  points.push_back(x);
  values.push_back(value);
  states.push_back(level_state(value, level_));
}

CONCINO_INLINE level_place crossed_volume::place_between(level_place::kind_type kind, std::uint32_t element,
                                                         std::uint32_t a, std::uint32_t b) const {
  const std::uint32_t below = states[a] == below_level ? a : b, above = below == a ? b : a;
  if (states[above] == on_level) return {level_place::vert, above, above, above};
  return {kind, element, below, above};
}

CONCINO_INLINE void crossed_volume::reserve(std::size_t num_cells, std::size_t num_facets, std::size_t num_corners) {
  first_facet.reserve(num_cells + 1);
  faces.reserve(num_facets), fan_of.reserve(num_facets), first_corner.reserve(num_facets + 1),
      outward.reserve(num_facets), num_polys.reserve(num_facets);
  verts.reserve(num_corners), edges.reserve(num_corners);
  const std::size_t num_verts = 3 * num_cells;  // a layer of hexes has two verts a cell, and one of tets fewer
  vert_indices.reserve(num_verts), points.reserve(num_verts), values.reserve(num_verts), states.reserve(num_verts);
}

CONCINO_INLINE void crossed_volume::push_facet(std::uint32_t face, bool is_outward, unsigned char polys,
                                               std::uint32_t fan_number) {
  faces.push_back(face);
  outward.push_back(is_outward);
  num_polys.push_back(polys);
  fan_of.push_back(fan_number);
  first_corner.push_back(num_corners());
}

CONCINO_INLINE void crossed_volume::end_facet(std::uint32_t face, bool is_outward, unsigned char polys) {
  const std::uint32_t first = first_corner.back(), n = num_corners() - first;
  if (polys != 2 && n > 3) {
    unsigned char joint = 0;
    for (std::uint32_t c = first; c < first + n; ++c) joint |= states[verts[c]];
    facet_points_.clear();
    for (std::uint32_t c = first; c < first + n; ++c) facet_points_.push_back(points[verts[c]]);
    if (is_crossed(joint) && !is_planar_polygon(facet_points_)) {
      replace_by_fan(face, is_outward, polys);
      return;
    }
  }
  push_facet(face, is_outward, polys, none);
}

/// The number of the centre of a face with these corners in whole_verts.
CONCINO_INLINE std::uint32_t crossed_volume::centre_of(std::uint32_t face, std::uint32_t first, std::uint32_t last) {
  const unsigned number = centre_numbers_.add(face);
  if (number < centres.size()) return number;
  vec3 mean;
  double value = 0;
  const double n = static_cast<double>(last - first);
  for (std::uint32_t c = first; c < last; ++c) {
    mean += (points[whole_verts[c]] - points[whole_verts[first]]) / n;
    value += values[whole_verts[c]] / n;
  }
  centres.push_back(
      {static_cast<std::uint32_t>(vert_indices.size()), static_cast<std::uint32_t>(next_edge_), num_facets()});
  next_edge_ += last - first;
  numbers_.add(~std::size_t{0} - face);  // no vert of the mesh has this index
  add_vert(none, points[whole_verts[first]] + mean, std::isnan(value) ? level_ : value);
  return number;
}

CONCINO_INLINE void crossed_volume::replace_by_fan(std::uint32_t face, bool is_outward, unsigned char polys) {
  const std::uint32_t first = first_corner.back(), n = num_corners() - first,
                      whole = static_cast<std::uint32_t>(whole_verts.size());
  whole_verts.insert(whole_verts.end(), verts.begin() + first, verts.end());
  whole_edges.insert(whole_edges.end(), edges.begin() + first, edges.end());
  verts.resize(first), edges.resize(first);
  const centre to = centres[centre_of(face, whole, whole + n)];
  const std::uint32_t fan_number = static_cast<std::uint32_t>(fans.size()), facet = num_facets();
  fans.push_back({facet, facet + n, whole, whole + n});
  for (std::uint32_t k = 0; k < n; ++k) {
    const std::uint32_t next = k + 1 < n ? k + 1 : 0;
    verts.insert(verts.end(), {whole_verts[whole + k], whole_verts[whole + next], to.vert});
    edges.insert(edges.end(), {whole_edges[whole + k], to.first_edge + next, to.first_edge + k});
    push_facet(face, is_outward, polys, fan_number);
  }
}

}  // namespace concino::detail
