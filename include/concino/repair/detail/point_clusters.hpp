// Clusters of points: the components of "at most a tolerance apart".
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/vec3.hpp>

#include <cstdint>
#include <vector>

namespace concino::detail {

/// Points that become one.
struct point_clusters {
  std::vector<std::uint32_t> first;  // by point: the first point of its cluster
  std::vector<vec3> mean;            // by point: of each first point, the mean of its cluster
};

/// The connected components of the points where two are connected if they are at most `tolerance` apart. Points that
/// are not finite are alone. The clusters and their means do not depend on the order of the points.
/// Cost:   linear, unless two dense parts of one component are closer than three tolerances, but not connected there.
point_clusters find_clusters(std::vector<vec3> points, double tolerance);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/repair/detail/point_clusters.ipp>
#endif
