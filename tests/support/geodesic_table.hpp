// Errors of heat geodesics on the meshes of geodesic_meshes.hpp, for docs/convergence.md and for the tests that compare with it.
#pragma once

#include <concino/fields/heat_geodesics.hpp>
#include <concino/geometry/edge_length.hpp>

#include <support/convergence_families.hpp>
#include <support/convergence_table.hpp>
#include <support/geodesic_meshes.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace concino::testing {

inline constexpr unsigned coarse_geodesic_mesh = 500, fine_geodesic_mesh = 5000;  // polys, about

/// One row for each mesh of about this many polys: the mean and the largest error, in mean edges.
template<class M>
std::vector<convergence_row> measure_geodesics(unsigned count) {
  std::vector<convergence_row> rows;
  for_each_geodesic_mesh<M>(count, [&](std::string name, const M& m, const vert_id& source, const vert_map<M, double>& known) {
    double edge = 0, mean = 0, n = 0, largest = 0;
    for (const auto e : edges(m)) edge += edge_length(m, e) / static_cast<double>(num_edges(m));
    const auto d = heat_geodesics(m, source, {.clamp = true});
    for (const auto v : verts(m)) {
      const double wrong = std::abs(d[v] - known[v]) / edge;
      mean += wrong;
      n += 1;
      largest = std::max(largest, wrong);
    }
    std::replace(name.begin(), name.end(), ' ', '_');
    rows.push_back({"geodesics", "-", kind_name<M>, name, {mean / n, largest}});
  });
  return rows;
}

}  // namespace concino::testing
