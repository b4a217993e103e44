// Lloyd's iteration, which moves sites to the centroids of their Voronoi cells.
#pragma once

#include <concino/generate/detail/voronoi/voronoi_complex.hpp>
#include <concino/geometry/centroid.hpp>

namespace concino::detail {

/// The sites as points.
template<class Sites>
std::vector<vec3> points_of_sites(const Sites& sites) {
  std::vector<vec3> points;
  for (const auto& x : sites) points.push_back(to_vec3(x));
  return points;
}

/// The diagram(sites, domain) after `rounds` iterations. D is the number of coordinates that are used.
template<std::size_t D, class Sites, class Diagram>
auto with_relaxed_sites(const Sites& initial_sites, const box& domain, unsigned rounds, const Diagram& diagram) {
  std::vector<vec3> sites = points_of_sites(initial_sites);
  for (; rounds > 0; --rounds) {
    const auto m = diagram(sites, domain);
    parallel_for(sites.size(), [&](std::size_t i) {
      const vec3 c = centroid(m, poly_id{i});
      for (std::size_t k = 0; k < D; ++k) sites[i][k] = std::clamp(c[k], domain.min[k], domain.max[k]);
    });
  }
  return diagram(sites, domain);
}

}  // namespace concino::detail
