// Remeshing of a surface of another library beside that of a trimesh with the same verts and triangles.
#pragma once

#include <concino/convert/convert.hpp>
#include <concino/generate/icosphere.hpp>
#include <concino/generate/torus.hpp>
#include <concino/remesh/adaptive_size.hpp>
#include <concino/remesh/remesh.hpp>
#include <concino/remesh/smooth_points.hpp>

#include <support/foreign_edits.hpp>
#include <support/kinds.hpp>
#include <support/remeshing.hpp>

#include <doctest/doctest.h>

namespace concino::testing {

/// Elements come in other orders, so points differ; numbers of triangles and errors are about the same.
template<class M>
void remeshes_as_trimesh_does(const trimesh& native, double length) {
  auto ours = native;
  auto m = convert<M>(native);
  const auto a = remesh(ours, {.edge_length = length}), b = remesh(m, {.edge_length = length});
  check_remeshing(native, m, b, length);
  CHECK(double(num_polys(m)) == doctest::Approx(double(num_polys(ours))).epsilon(0.05));
  CHECK(b.error <= 1.5 * a.error + 0.1 * length);
  CHECK(hausdorff_distance(native, m).upper <= b.error * (1 + 1e-9));
}

/// Smoothing gives the same shapes.
template<class M>
void smooths_as_trimesh_does() {
  auto native = make_torus<trimesh>({.cells = {20, 12}});
  for (const vert_id v : verts(native))
    if (v.raw() % 3 == 0) set_point(native, v, point(native, v) + vec3{0.05, 0, 0.05});
  auto m = convert<M>(native);
  const auto a = smooth_points(native, {.feature_angle_deg = 90}), b = smooth_points(m, {.feature_angle_deg = 90});
  CHECK(a.num_moves > 100);
  CHECK(b.min_shape_before == doctest::Approx(a.min_shape_before));
  CHECK(b.min_shape_after == doctest::Approx(a.min_shape_after).epsilon(1e-3));
}

template<class M>
void remeshes_as_trimesh_does() {
  smooths_as_trimesh_does<M>();
  const auto sphere = icosphere(2);
  remeshes_as_trimesh_does<M>(sphere, 0.7 * mean_edge_length(sphere));
  remeshes_as_trimesh_does<M>(make_torus<trimesh>({.cells = {20, 12}}), 0.35);
  remeshes_as_trimesh_does<M>(grid<trimesh>(8), 0.1);
  auto m = convert<M>(sphere);
  const auto r = remesh(m, adaptive_size(m, {.chord_error = 0.01}));
  CHECK(r.share_of_lengths > 0.9);
  foreign_laws_hold(m);
  const std::size_t n = num_polys(m);
  CHECK_THROWS_AS(remesh(m, {}), invalid_argument);
  CHECK(num_polys(m) == n);
}

}  // namespace concino::testing
