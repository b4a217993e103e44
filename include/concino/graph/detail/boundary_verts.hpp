// Which verts lie on the boundary of a surface or volume.
#pragma once

#include <concino/concepts/facets.hpp>

#include <cstddef>
#include <vector>

namespace concino::detail {

/// By index: the verts of facets with exactly one poly.
template<AnyMesh M>
std::vector<unsigned char> boundary_verts(const M& m) {
  std::vector<unsigned char> on_boundary(vert_index_bound(m));
  for (const facet_t<M> x : facets(m)) {
    if (!is_boundary(m, x)) continue;
    for (const vert_t<M> v : adj_facet2v(m, x)) on_boundary[index_of(m, v)] = 1;
  }
  return on_boundary;
}

}  // namespace concino::detail
