// The number of corners of a mesh.
#pragma once

#include <concino/concepts/mesh.hpp>

#include <cstddef>

namespace concino::detail {

/// The number of corners of all polys.
template<class M>
std::size_t num_poly_corners(const M& m) {
  std::size_t n = 0;
  for (const poly_t<M> p : polys(m)) n += num_elements(adj_p2v(m, p));
  return n;
}

}  // namespace concino::detail
