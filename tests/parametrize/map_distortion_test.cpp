// The distortion of maps to the plane: closed forms of linear maps, flips, corners, any polys, any scale, bad input.
#include <concino/parametrize/map_distortion.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/generate/icosphere.hpp>

#include <support/uv_disks.hpp>

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

/// The points of a planar mesh after (a b; c d).
template<class M>
auto mapped(const M& m, double a, double b, double c, double d) {
  auto uv = make_vert_map<uv_point>(m);
  for (const auto v : verts(m)) {
    const vec3 x = to_vec3(point(m, v));
    uv[v] = {a * x.x + b * x.y + 3, c * x.x + d * x.y - 7};
  }
  return uv;
}

}  // namespace

TEST_CASE_TEMPLATE("map_distortion: of a linear map, by closed forms, for polys of any shape", M, CONCINO_ALL_SURFACE_KINDS) {
  const M m = grid<M>(4);
  for (const auto& abcd : std::vector<std::array<double, 4>>{{1, 0, 0, 1}, {3, 0, 0, 2}, {1, 0.7, 0.2, 1}, {0.6, -0.8, 0.8, 0.6}, {0.01, 0, 5, 8}}) {
    const double a = abcd[0], b = abcd[1], c = abcd[2], d = abcd[3];
    CAPTURE(a);
    CAPTURE(d);
    // Singular values are roots of s^4 - f s^2 + det^2.
    const double f = a * a + b * b + c * c + d * d, det = a * d - b * c, root = std::sqrt(std::max(0.0, f * f / 4 - det * det));
    const double large = std::sqrt(f / 2 + root), small = det / large;
    const auto r = map_distortion(m, mapped(m, a, b, c, d));
    CHECK(r.flipped == 0);
    CHECK(r.flips.empty());
    CHECK(r.max_angle == doctest::Approx(2 * std::asin((large - small) / (large + small))).epsilon(1e-7).scale(0.01));
    CHECK(r.mean_angle == doctest::Approx(r.max_angle).epsilon(1e-6).scale(0.01));
    CHECK(r.max_stretch == doctest::Approx(std::max(large, 1 / small)).epsilon(1e-9));
    CHECK(r.min_area == doctest::Approx(1).epsilon(1e-9));
    CHECK(r.max_area == doctest::Approx(1).epsilon(1e-9));
    CHECK(r.scale == doctest::Approx(det).epsilon(1e-9));
    const auto mirrored = map_distortion(m, mapped(m, -a, -b, c, d));
    CHECK(mirrored.flipped == num_polys(m));
    CHECK(mirrored.max_angle == doctest::Approx(std::numbers::pi));
    CHECK(mirrored.scale == doctest::Approx(det).epsilon(1e-9));
  }
  const auto only = only_embedded_mesh(m);
  CHECK(map_distortion(only, mapped(only, 2, 0, 0, 1)).max_stretch == doctest::Approx(2));
  const auto line = map_distortion(m, mapped(m, 1, 0, 2, 0));
  CHECK(line.flipped == num_polys(m));
  CHECK(line.max_angle == doctest::Approx(std::numbers::pi));
  CHECK(line.max_stretch > 1e12);
  CHECK(line.min_area == 1);
}

TEST_CASE("map_distortion: names the polys that are flipped, and measures areas against the whole") {
  const trimesh m({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  auto uv = mapped(m, 1, 0, 0, 1);
  uv[vert_id{1}] = {3 + 0.1, -7 + 0.9};
  auto r = map_distortion(m, uv);
  CHECK(r.flips == std::vector{poly_id{0}});
  CHECK(r.flipped == 1);
  CHECK(r.angle[poly_id{0}] == doctest::Approx(std::numbers::pi));
  CHECK(r.angle[poly_id{1}] == doctest::Approx(0).scale(1));
  uv[vert_id{1}] = {3 + 2, -7 - 1};
  r = map_distortion(m, uv);
  CHECK(r.flipped == 0);
  CHECK(r.area[poly_id{0}] == doctest::Approx(1.5));
  CHECK(r.area[poly_id{1}] == doctest::Approx(0.5));
  CHECK(r.scale == doctest::Approx(2));
  // A quad is flipped if one of its triangles is: it is not convex in the plane.
  const quadmesh q({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}});
  auto dart = mapped(q, 1, 0, 0, 1);
  CHECK(map_distortion(q, dart).flipped == 0);
  dart[vert_id{0}] = {3 + 0.9, -7 + 0.9};
  dart[vert_id{2}] = {3 + 0.95, -7 + 0.95};
  CHECK(map_distortion(q, dart).angle[poly_id{0}] > 1);
}

TEST_CASE("map_distortion: at corners, so that surfaces with seams and closed ones have maps") {
  const auto m = icosphere(0);
  auto uv = make_corner_map<uv_point>(m);
  for (const auto p : polys(m)) {
    const auto x = uv.of(p);
    x[0] = {0, 0}, x[1] = {2, 0}, x[2] = {1, std::sqrt(3.0)};
  }
  const auto r = map_distortion(m, uv);
  CHECK(r.flipped == 0);
  CHECK(r.max_angle < 1e-6);
  CHECK(r.max_area == doctest::Approx(1));
}

TEST_CASE("map_distortion: at any scale, of surfaces with triangles without area, and bad input") {
  const auto m = grid_on<polygonmesh>(3, on_hill);
  const auto uv = mapped(m, 1, 0.5, 0, 1);
  const auto r = map_distortion(m, uv);
  for (const int e : {-1000, -500, 500, 1000}) {
    auto a = grid_arrays<polygonmesh>(3);
    for (vec3& x : a.points) {
      x = on_hill(x.x, x.y);
      x = {std::ldexp(x.x, e), std::ldexp(x.y, e), std::ldexp(x.z, e)};
    }
    const polygonmesh large(a);
    auto same = make_vert_map<uv_point>(large), far = same;
    for (const auto v : verts(m)) same[v] = uv[v], far[v] = {std::ldexp(uv[v][0], e), std::ldexp(uv[v][1], e)};
    const auto s = map_distortion(large, same), t = map_distortion(large, far);
    CHECK(s.max_angle == r.max_angle);
    CHECK(s.max_area == r.max_area);
    CHECK(s.flips == r.flips);
    CHECK(t.max_stretch == r.max_stretch);
    CHECK(t.scale == r.scale);
  }
  const trimesh flat({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  auto some = mapped(flat, 1, 0, 0, 1);
  const auto f = map_distortion(flat, some);
  CHECK(f.flips == std::vector{poly_id{0}});
  CHECK(f.angle[poly_id{0}] == 0);
  CHECK(f.max_angle < 1e-7);
  some[vert_id{1}][1] = -9;
  CHECK(map_distortion(flat, some).flipped == 0);
  some[vert_id{1}][0] = std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS((void)map_distortion(flat, some), invalid_argument);
  const trimesh nan({{0, 0, 0}, {1, std::numeric_limits<double>::quiet_NaN(), 0}, {2, 0, 0}}, {{0, 1, 2}});
  CHECK_THROWS_AS((void)map_distortion(nan, make_vert_map<uv_point>(nan)), invalid_mesh);
  const polygonmesh none;
  CHECK_THROWS_AS((void)map_distortion(none, make_vert_map<uv_point>(none)), invalid_mesh);
  const trimesh point_only({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {{0, 1, 2}});
  CHECK(map_distortion(point_only, make_vert_map<uv_point>(point_only)).flipped == 1);
}
