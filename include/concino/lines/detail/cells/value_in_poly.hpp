// Interpolation of values of verts within a polygon or a polyhedron.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/vec3.hpp>
#include <concino/lines/detail/cells/flat_cell.hpp>
#include <concino/lines/detail/cells/polygon_reader.hpp>
#include <concino/lines/detail/cells/polyhedron_reader.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace concino::detail {

/// values[v] of the verts, linear in each triangle, at x in the polygon that was read last.
template<class M, class H>
vec3 value_in_poly(const polygon_reader<M>& polygon, const vec3& x, const H& values) {
  const polygon_piece<M> t = polygon.piece(polygon.nearest_piece(x));
  vec3 value;
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const vec3& from = t.at[(k + 1) % 3];
    const double weight = std::max(0.0, dot(cross(t.at[(k + 2) % 3] - from, x - from), t.normal));
    value += weight * values[t.verts[k]];
    sum += weight;
  }
  return sum > 0 ? value / sum : values[t.verts[0]];
}

/// values[v] of the verts at x in the cell that was read last: linear in each tet between a triangle of the surface and
/// the mean of the corners, where it is their mean.
template<class M, class H>
vec3 value_in_poly(polyhedron_reader<M>& cell, const vec3& x, const H& values) {
  cell.cut_faces();
  const std::vector<vert_t<M>>& verts = cell.verts;
  const std::vector<vec3>& points = cell.flat.points;
  const double n = static_cast<double>(verts.size());
  vec3 centre, centre_value;
  for (std::size_t k = 0; k < verts.size(); ++k) {
    centre += points[k] / n;
    centre_value += values[verts[k]] / n;
  }
  const auto volume = [](const vec3& p, const vec3& q, const vec3& r, const vec3& s) {
    return dot(cross(q - p, r - p), s - p);
  };
  vec3 value = centre_value;
  double best = -std::numeric_limits<double>::infinity();
  for (const cell_triangle& t : cell.flat.triangles) {
    const vec3 &a = points[t.corner[0]], &b = points[t.corner[1]], &c = points[t.corner[2]];
    const double whole = volume(a, c, b, centre);
    if (!(whole > 0)) continue;
    const double wa = volume(x, c, b, centre) / whole, wb = volume(a, c, x, centre) / whole,
                 wc = volume(a, x, b, centre) / whole;
    const double least = std::min({wa, wb, wc, 1 - wa - wb - wc});
    if (least <= best) continue;
    best = least;
    value = wa * values[verts[t.corner[0]]] + wb * values[verts[t.corner[1]]] + wc * values[verts[t.corner[2]]] +
            (1 - wa - wb - wc) * centre_value;
  }
  return value;
}

}  // namespace concino::detail
