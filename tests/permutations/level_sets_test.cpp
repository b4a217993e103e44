// Level sets and integral lines do not depend on the order in which a mesh is stored.
#include <concino/level_sets/clip.hpp>
#include <concino/level_sets/isolines.hpp>
#include <concino/level_sets/isosurface.hpp>
#include <concino/level_sets/measure_between.hpp>
#include <concino/lines/integral_line.hpp>

#include <support/permuted.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("level sets do not depend on storage", M, CONCINO_KINDS) {
  for_each_stored_mesh<M>([](const storage_check<M>& check) {
    using s = stored_mesh<M>;
    const std::vector<double> levels = {0.4123, 0.8711, 1.2347};
    check.number("measure_between", [&](const s& x) { return measure_between(x.mesh, x.smooth_values(), levels); });
    check.number("measure of clip", [&](const s& x) { return total_measure(clip(x.mesh, x.smooth_values(), 0.8711).mesh); });
    if constexpr (SurfaceMesh<M>) {
      check.number("length of isolines", [&](const s& x) {
        double sum = 0;
        for (const auto& line : isolines(x.mesh, x.smooth_values(), levels))
          for (std::size_t i = 1; i < line.points.size(); ++i) sum += distance(line.points[i - 1], line.points[i]);
        return sum;
      });
    } else {
      check.number("area of isosurfaces", [&](const s& x) {
        const auto surface = isosurface(x.mesh, x.smooth_values(), levels);
        return total_measure(surface.mesh);
      });
    }
  });
}

TEST_CASE_TEMPLATE("ends of integral lines do not depend on storage", M, CONCINO_KINDS) {
  for_each_stored_mesh<M>([](const storage_check<M>& check) {
    using s = stored_mesh<M>;
    check.number("integral_line", [](const s& x) {
      auto g = make_poly_map<vec3>(x.mesh);
      for (const poly_id p : x.polys) g[p] = vec3{1, 0.3217, SurfaceMesh<M> ? 0 : 0.2113};
      const auto line = integral_line(x.mesh, g, x[poly_id{1}]);
      const vec3 end = line.points.back().position;
      return std::vector<double>{end.x, end.y, end.z};
    });
  });
}
