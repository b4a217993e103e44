// Lines over surfaces and means of verts do not depend on the order in which a mesh is stored. Frames of tangent vectors follow the first edge of a vert, so
// geodesics start in a direction of space.
#include <concino/graph/shortest_path.hpp>
#include <concino/lines/karcher_mean.hpp>
#include <concino/lines/straighten.hpp>
#include <concino/lines/trace_geodesic.hpp>

#include <support/permuted.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("geodesics and means of verts do not depend on storage", M, CONCINO_SURFACE_KINDS) {
  for_each_stored_mesh<M>([](const storage_check<M>& check) {
    using s = stored_mesh<M>;
    const std::size_t size = check.original().verts.size();
    const vert_id a{1}, b{size - 2}, c{size / 2};
    check.number("trace_geodesic", [&](const s& x) {
      const poly_id p = x[poly_id{1}];
      const auto line = trace_geodesic(x.mesh, p, centroid(x.mesh, p), vec3{1, 0.4217, 0}, 0.7);
      const vec3 end = line.points.back().position;
      return std::vector<double>{end.x, end.y, end.z, line.length};
    });
    if (check.name() == "regular") return;  // paths of the same length, and verts at the same distance
    check.number("straighten", [&](const s& x) {
      const auto length = [&](vert_id v, vert_id w) { return distance(point(x.mesh, v), point(x.mesh, w)); };
      const auto path = shortest_path(x.mesh, x[a], x[b], length);
      double sum = 0;
      const auto line = straighten(x.mesh, path);
      for (std::size_t i = 1; i < line.points.size(); ++i) sum += distance(line.points[i - 1].position, line.points[i].position);
      return sum;
    });
    check.number("karcher_mean", [&](const s& x) {
      return karcher_mean(x.mesh, std::vector<std::pair<vert_id, double>>{{x[a], 1.0}, {x[b], 1.7}, {x[c], 1.2}}).position;
    });
  });
}
