// Defines combine_regions.hpp.
#pragma once

#include <concino/print/combine_regions.hpp>
#include <concino/print/detail/regions/lattice.hpp>

namespace concino::detail {

CONCINO_INLINE planar_regions combine(const char* caller, region_operation what, const planar_regions& a,
                                      const planar_regions& b, const polygon_clipper& back_end) {
  check_finite_points(caller, a, "first regions");
  check_finite_points(caller, b, "second regions");
  planar_box around;
  around.add(a.points);
  around.add(b.points);
  const lattice to(caller, around, 0, 40);
  return regions_from(back_end.combine(what, snap(a, to), snap(b, to)), to);
}

}  // namespace concino::detail

namespace concino {

CONCINO_INLINE planar_regions region_union(const planar_regions& a, const planar_regions& b,
                                           const polygon_clipper& back_end) {
  return detail::combine("region_union", region_operation::unite, a, b, back_end);
}
CONCINO_INLINE planar_regions region_difference(const planar_regions& a, const planar_regions& b,
                                                const polygon_clipper& back_end) {
  return detail::combine("region_difference", region_operation::subtract, a, b, back_end);
}
CONCINO_INLINE planar_regions region_intersection(const planar_regions& a, const planar_regions& b,
                                                  const polygon_clipper& back_end) {
  return detail::combine("region_intersection", region_operation::intersect, a, b, back_end);
}

}  // namespace concino
