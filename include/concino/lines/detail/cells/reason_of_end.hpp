// Why a line ends at a vert or an edge.
#pragma once

#include <concino/concepts/facets.hpp>
#include <concino/lines/line_end.hpp>

#include <cstddef>

namespace concino::detail {

/// Why no direction leads away from a place, by the facets at it.
/// Needs: whether there are polys at the place, and whether the field is zero in all of them.
template<class M, class Facets>
line_end reason_of_end(const M& m, const Facets& facets, bool has_polys, bool all_are_zero) {
  bool open = false, many = false;
  for (const auto& f : facets) {
    const std::size_t n = num_elements(adj_facet2p(m, f));
    open = open || n < 2;
    many = many || n > 2;
  }
  if (!has_polys) return many ? line_end::non_manifold : line_end::boundary;
  return all_are_zero ? line_end::zero : many ? line_end::non_manifold : open ? line_end::boundary : line_end::sink;
}

}  // namespace concino::detail
