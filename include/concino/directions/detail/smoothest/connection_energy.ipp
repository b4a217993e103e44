// Bodies of connection_energy.hpp: the energy of an n-direction field, from the stiffness of polys.
#pragma once

#include <concino/directions/detail/smoothest/connection_energy.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/operators/virtual_elements.hpp>

#include <cmath>
#include <numbers>

namespace concino::detail {

/// By corner: the angle in the plane of the poly minus the angle in the frame of the vert, along the bisector.
inline void corner_turns(const oriented_surface& s, std::size_t p, std::vector<double>& turn) {
  const vec3 area = s.vector_area(p), n = area / norm(area);
  const auto flat = [&](const vec3& x) { return x - dot(x, n) * n; };
  vec3 u;
  for (std::uint32_t c = s.first[p]; c < s.first[p + 1]; ++c)  // the longest edge, which has a direction
    if (const vec3 x = flat(s.points[s.vert[s.next[c]]] - s.points[s.vert[c]]); norm(x) > norm(u)) u = x;
  u = u / norm(u);
  const vec3 v = cross(n, u);
  const auto angle_of = [&](std::uint32_t a, std::uint32_t b) {
    const vec3 x = s.points[s.vert[b]] - s.points[s.vert[a]];
    return std::atan2(dot(x, v), dot(x, u));
  };
  turn.clear();
  for (std::uint32_t c = s.first[p]; c < s.first[p + 1]; ++c) {
    const double along = angle_of(c, s.next[c]);
    double inside = angle_of(c, s.previous[c]) - along;
    if (inside < 0) inside += 2 * std::numbers::pi;
    turn.push_back(along + inside / 2 - (s.from[c] + s.angle[c] / 2));
  }
}

CONCINO_INLINE connection_energy make_connection_energy(const oriented_surface& s, int n) {
  surface_arrays a;
  a.points = s.points;
  a.offsets = s.first;
  for (const std::uint32_t v : s.vert) a.verts.push_back(vert_id{v});
  const polygonmesh m(std::move(a));
  auto stiffness = virtual_elements.poly_matrices(m);
  local_matrix<vert_id> local;
  connection_energy r;
  r.diagonal.assign(s.num_verts(), 0.0);
  std::vector<double> turn;
  std::vector<complex_value> factor;
  std::size_t p = 0;
  for (const poly_id poly : polys(m)) {
    stiffness(poly, local);
    corner_turns(s, p, turn);
    factor.assign(local.size(), {});
    for (std::size_t k = 0; k < local.size(); ++k)
      for (std::uint32_t c = s.first[p]; c < s.first[p + 1]; ++c)
        if (s.vert[c] == index_of(m, local.verts[k])) factor[k] = unit_complex(n * turn[c - s.first[p]]);
    for (std::size_t k = 0; k < local.size(); ++k) {
      const auto i = static_cast<std::uint32_t>(index_of(m, local.verts[k]));
      r.diagonal[i] += local.at(k, k);
      for (std::size_t l = 0; l < k; ++l) {
        const auto j = static_cast<std::uint32_t>(index_of(m, local.verts[l]));
        const complex_value x = local.at(k, l) * std::conj(factor[k]) * factor[l];
        if (j < i) r.entries.push_back({i, j, x});
        else r.entries.push_back({j, i, std::conj(x)});
      }
    }
    ++p;
  }
  return r;
}

}  // namespace concino::detail
