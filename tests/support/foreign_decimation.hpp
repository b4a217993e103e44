// Decimation of a surface of another library beside that of a trimesh with the same verts and triangles.
#pragma once

#include <concino/convert/convert.hpp>
#include <concino/generate/icosphere.hpp>
#include <concino/generate/torus.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/remesh/decimate.hpp>

#include <support/foreign_edits.hpp>
#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <vector>

namespace concino::testing {

/// The numbers of collapses agree. Points do not, as elements that cost the same come in another order; errors are as small.
template<class M>
void decimates_as_trimesh_does(const trimesh& native, const decimate_options& options) {
  auto ours = native;
  auto m = convert<M>(native);
  const auto a = decimate(ours, options), b = decimate(m, options);
  CHECK(b.stopped_by == a.stopped_by);
  if (a.stopped_by == decimation_end::target) {
    CHECK(b.num_collapses == a.num_collapses);
    CHECK(num_polys(m) == num_polys(ours));
  }
  CHECK(b.error <= 1.5 * a.error + 1e-9);
  CHECK(a.error <= 1.5 * b.error + 1e-9);
  CHECK(hausdorff_distance(native, m).upper <= b.error * (1 + 1e-9));
  CHECK(long(num_verts(m)) - long(num_edges(m)) + long(num_polys(m)) == long(num_verts(native)) - long(num_edges(native)) + long(num_polys(native)));
  foreign_laws_hold(m);
}

template<class M>
void decimates_as_trimesh_does() {
  for (const bool memoryless : {false, true}) {
    decimates_as_trimesh_does<M>(icosphere(3), {.target_polys = 200, .memoryless = memoryless});
    decimates_as_trimesh_does<M>(make_torus<trimesh>({.cells = {20, 12}}), {.target_polys = 100, .memoryless = memoryless});
  }
  decimates_as_trimesh_does<M>(grid<trimesh>(8), {.target_polys = 40});
  decimates_as_trimesh_does<M>(icosphere(3), {.max_error = 0.03});
  auto open = convert<M>(grid<trimesh>(8));
  const double area_before = total_measure(open);
  CHECK(decimate(open, {.max_error = 0.001}).error <= 0.001);
  CHECK(total_measure(open) > area_before * 0.99);
  CHECK(num_polys(open) < 128);
  auto m = convert<M>(icosphere(1));
  CHECK_THROWS_AS(decimate(m, {}), invalid_argument);
  CHECK(num_polys(m) == 80);
}

}  // namespace concino::testing
