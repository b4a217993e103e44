// Whether a surface is closed, and the axis along which its projected area is largest, for queries of its bounding
// tree.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/vec3.hpp>

#include <cmath>
#include <cstddef>
#include <initializer_list>

namespace concino::detail {

struct surface_facts {
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  std::size_t open_edge = none;  // the index of the first edge with an odd number of polys, if any has
  std::size_t axis = 2;          // the axis along which the projected signed area is largest; z for closed surfaces,
                                 // whose signed area is 0
};

/// pieces: the triangles of m.
template<SurfaceMesh M, class Pieces>
surface_facts facts_of(const M& m, const Pieces& pieces) {
  surface_facts facts;
  for (const edge_t<M> e : edges(m)) {
    bool odd = false;
    for ([[maybe_unused]] const poly_t<M> p : adj_e2p(m, e)) odd = !odd;
    if (!odd) continue;
    facts.open_edge = index_of(m, e);
    break;
  }
  if (facts.open_edge == surface_facts::none) return facts;
  vec3 area;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    pieces.for_each_triangle(i, [&](const vec3& a, const vec3& b, const vec3& c) { area += cross(b - a, c - a); });
  for (const std::size_t k : {std::size_t{1}, std::size_t{0}})
    if (std::abs(area[k]) > std::abs(area[facts.axis])) facts.axis = k;
  return facts;
}

/// The distance of triangle a, b, c from x along axis k, if the projection of the triangle along this axis contains x.
inline double height_difference(const vec3& a, const vec3& b, const vec3& c, const vec3& x, std::size_t k) {
  const std::size_t i = k == 2 ? 0 : k + 1, j = k == 0 ? 2 : k - 1;
  const auto part = [&](const vec3& p, const vec3& q) {
    return (p[i] - x[i]) * (q[j] - x[j]) - (p[j] - x[j]) * (q[i] - x[i]);
  };
  const double u = part(b, c), v = part(c, a), w = part(a, b), whole = u + v + w;
  if (!(std::abs(whole) > 0)) return std::abs(a[k] - x[k]);
  return std::abs((u * a[k] + v * b[k] + w * c[k]) / whole - x[k]);
}

}  // namespace concino::detail
