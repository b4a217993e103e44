// Remeshing of a surface of another library beside that of a trimesh with the same verts and triangles.
#pragma once

#include <concino/convert/convert.hpp>
#include <concino/generate/cylinder.hpp>
#include <concino/generate/icosphere.hpp>
#include <concino/generate/torus.hpp>
#include <concino/remesh/adaptive_size.hpp>
#include <concino/remesh/remesh.hpp>
#include <concino/remesh/smooth_points.hpp>

#include <support/foreign_edits.hpp>
#include <support/kinds.hpp>
#include <support/remeshing.hpp>

#include <doctest/doctest.h>

#include <cmath>

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

/// Verts slide along the rims of a cylinder, but for those that are fixed, and along edges that are named.
template<class M>
void slides_as_trimesh_does() {
  auto native = make_cylinder<trimesh>({.cells = {16, 4}});
  for (const vert_id v : verts(native)) {
    const vec3 x = point(native, v);
    const double a = std::atan2(x.y, x.x) + 0.1 * std::sin(7.0 * v.raw()), r = std::hypot(x.x, x.y);
    if (r > 0.99) set_point(native, v, vec3{r * std::cos(a), r * std::sin(a), x.z});
  }
  auto m = convert<M>(native);
  const smooth_points_options options{.max_rounds = 200, .slides = true};
  const auto a = smooth_points(native, options), b = smooth_points(m, options);
  CHECK(b.num_moves > 100);
  CHECK(b.min_shape_after > 1.02 * b.min_shape_before);
  CHECK(b.min_shape_after == doctest::Approx(a.min_shape_after).epsilon(0.02));
  unsigned on_rims = 0;
  for (const vert_t<M> v : verts(m)) {
    const double z = to_vec3(point(m, v)).z;
    on_rims += std::abs(z) < 1e-12 || std::abs(z - 1) < 1e-12;
  }
  unsigned expected = 0;
  for (const vert_id v : verts(native)) expected += std::abs(point(native, v).z) < 1e-12 || std::abs(point(native, v).z - 1) < 1e-12;
  CHECK(on_rims == expected);
  const auto no_vert = [](const vert_t<M>&) { return false; };
  const auto all_edges = [](const edge_t<M>&) { return true; };
  CHECK(smooth_points(m, options, no_vert, all_edges).num_moves == 0);
  CHECK(smooth_points(m, options, no_vert, [](const edge_t<M>&) { return false; }, [&](const poly_t<M>& p) { return index_of(m, p); }).num_moves == 0);
}

template<class M>
void remeshes_as_trimesh_does() {
  smooths_as_trimesh_does<M>();
  slides_as_trimesh_does<M>();
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
