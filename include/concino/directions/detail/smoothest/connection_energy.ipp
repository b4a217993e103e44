// Bodies of connection_energy.hpp: the energy of an n-direction field, from the stiffness of polys.
#pragma once

#include <concino/directions/detail/smoothest/connection_energy.hpp>
#include <concino/directions/detail/surface/poly_planes.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/operators/virtual_elements.hpp>

#include <cmath>
#include <utility>

namespace concino::detail {

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
  const poly_planes planes(s);
  std::vector<complex_value> factor;
  std::size_t p = 0;
  for (const poly_id poly : polys(m)) {
    stiffness(poly, local);
    factor.assign(local.size(), {});
    for (std::size_t k = 0; k < local.size(); ++k)
      for (std::uint32_t c = s.first[p]; c < s.first[p + 1]; ++c)
        if (s.vert[c] == index_of(m, local.verts[k]))
          factor[k] = unit_complex(n * (planes.along[c] + planes.inside[c] / 2 - s.from[c] - s.angle[c] / 2));
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
