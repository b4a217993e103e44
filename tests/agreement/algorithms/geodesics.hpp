// Compares logarithmic maps, straightest geodesics and straightened paths.
#pragma once

#include <agreement/algorithms/virtual_elements.hpp>

#include <concino/fields/log_map.hpp>
#include <concino/graph/shortest_path.hpp>
#include <concino/lines/straighten.hpp>
#include <concino/lines/trace_geodesic.hpp>

#include <cstddef>
#include <limits>
#include <vector>

namespace concino::agreement {

struct geodesics_of {
  static constexpr const char* name = "geodesics";
  template<class M> static constexpr bool runs_on = SurfaceMesh<M> && Embedded<M>;

  template<class B, class In>
  static bool check(const B& both, const In& in) {
    if (!in.manifold || both.polys.all.empty() || !all_polys_have_measure(both.native)) return false;
    const auto first = *adj_p2v(both.native, both.polys.all.front()).begin();
    const auto expected = log_map(both.native, first);
    const auto found = log_map(both.other, both.verts.to(first));
    const double far = largest_of(both.verts.all, [&](const auto v) { return expected.distance[v]; });
    const auto trace = prepare_trace_geodesic(both.native);
    const auto other_trace = prepare_trace_geodesic(both.other);
    auto last = first;
    for (const auto v : both.verts.all) {
      expect_close(expected.distance[v], found.distance[both.verts.to(v)], far, "the distance");
      if (expected.distance[v] == std::numeric_limits<double>::infinity()) continue;
      last = v;
      const vec3 direction(1, 0.3 * (v.raw() % 5), -0.1);
      const auto line = trace.trace_from(v, direction, far);
      const auto same = other_trace.trace_from(both.verts.to(v), direction, far);
      expect(line.stopped_by == same.stopped_by, "lines stop for the same reason");
      expect(line.points.size() == same.points.size(), "as many points");
      expect_close(line.length, same.length, far, "the length of a line");
      expect_close(distance(line.points.back().position, same.points.back().position), 0, far, "the end of a line");
    }
    const auto path = shortest_path(both.native, first, last);
    std::vector<vert_t<typename B::other_mesh>> same_path;
    for (const auto v : path) same_path.push_back(both.verts.to(v));
    expect_close(straighten(both.native, path).length, straighten(both.other, same_path).length, far, "the length of a straight path");
    return true;
  }
};

}  // namespace concino::agreement
