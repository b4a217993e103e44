#include <concino/geometry/kernel.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/geometry/centroid.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/polyhedralmesh.hpp>

#include <support/corpus.hpp>
#include <support/kinds.hpp>
#include <support/motions.hpp>
#include <support/polygons.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

using namespace concino;
using namespace concino::testing;

namespace {

/// The height of x above the line of an edge, to its left.
double height_above(const std::vector<vec3>& polygon, std::size_t i, const vec3& x) {
  const vec3 d = polygon[(i + 1) % polygon.size()] - polygon[i];
  return cross(d, x - polygon[i]).z / norm(d);
}

/// The linear programme max t: all heights at least t, over all points; by trying each three lines.
double largest_smallest_height(const std::vector<vec3>& polygon) {
  const std::size_t n = polygon.size();
  double best = -std::numeric_limits<double>::infinity();
  const auto row = [&](std::size_t i) {
    const vec3 d = polygon[(i + 1) % n] - polygon[i], u = d / norm(d);
    return std::array<double, 3>{-u.y, u.x, -cross(u, polygon[i]).z};  // the height is r0 x + r1 y + r2
  };
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j)
      for (std::size_t k = j + 1; k < n; ++k) {
        const auto a = row(i), b = row(j), c = row(k);
        const double p = b[0] - a[0], q = b[1] - a[1], r = c[0] - a[0], s = c[1] - a[1], det = p * s - q * r;
        if (std::abs(det) < 1e-12) continue;
        const vec3 x{(-(b[2] - a[2]) * s + q * (c[2] - a[2])) / det, (-p * (c[2] - a[2]) + r * (b[2] - a[2])) / det, 0};
        double t = std::numeric_limits<double>::infinity();
        for (std::size_t l = 0; l < n; ++l) t = std::min(t, height_above(polygon, l, x));
        best = std::max(best, t);
      }
  return best;
}

double area_of(const std::vector<vec3>& x) {
  double doubled = 0;
  for (std::size_t i = 0; i < x.size(); ++i) doubled += cross(x[i], x[(i + 1) % x.size()]).z;
  return doubled / 2;
}

/// The area of the convex hull of all crossings of two lines that are above all lines, up to 1e-13.
double area_by_crossings(const std::vector<vec3>& polygon) {
  const std::size_t n = polygon.size();
  std::vector<vec3> corners;
  vec3 sum;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) {
      const vec3 d = polygon[(i + 1) % n] - polygon[i], e = polygon[(j + 1) % n] - polygon[j];
      const double det = cross(d, e).z;
      if (std::abs(det) < 1e-12) continue;
      const vec3 x = polygon[i] + cross(polygon[j] - polygon[i], e).z / det * d;
      double t = std::numeric_limits<double>::infinity();
      for (std::size_t l = 0; l < n; ++l) t = std::min(t, height_above(polygon, l, x));
      if (t > -1e-13) corners.push_back(x), sum += x;
    }
  if (corners.empty()) return 0;
  const vec3 mean = sum / static_cast<double>(corners.size());
  const auto angle = [&](const vec3& x) { return std::atan2(x.y - mean.y, x.x - mean.x); };
  std::sort(corners.begin(), corners.end(), [&](const vec3& a, const vec3& b) { return angle(a) < angle(b); });
  return area_of(corners);
}

/// An L of height h, in cells of a polyhedral mesh: one cell, an extruded polygon.
polyhedra_arrays extruded(const std::vector<vec3>& polygon, double h) {
  polyhedra_arrays a;
  const auto n = static_cast<unsigned>(polygon.size());
  for (const double z : {0.0, h})
    for (const vec3& x : polygon) a.points.push_back({x.x, x.y, z});
  a.face_offsets.push_back(0);
  a.poly_offsets = {0, n + 2};
  const auto close = [&] {
    a.poly_faces.push_back(face_id{static_cast<unsigned>(a.face_offsets.size() - 1)});
    a.face_offsets.push_back(static_cast<unsigned>(a.face_verts.size()));
    a.outward.push_back(1);
  };
  for (unsigned i = n; i-- > 0;) a.face_verts.push_back(vert_id{i});
  close();
  for (unsigned i = 0; i < n; ++i) a.face_verts.push_back(vert_id{n + i});
  close();
  for (unsigned i = 0; i < n; ++i) {
    for (const unsigned v : {i, (i + 1) % n, n + (i + 1) % n, n + i}) a.face_verts.push_back(vert_id{v});
    close();
  }
  return a;
}

/// The laws of a kernel: a closed, convex polyhedron around its witness.
void check_polyhedron(const polyhedron_kernel& k, double size) {
  const polygonmesh m(k.surface);
  CHECK(num_verts(m) + num_polys(m) == num_edges(m) + 2);
  for (const auto e : edges(m)) CHECK(num_elements(adj_e2p(m, e)) == 2);
  double volume = 0;
  for (const auto p : polys(m)) {
    const vec3 c = vert_mean(m, p), n = area_vector(m, p);
    CHECK(dot(n, c - k.witness) > 0);
    volume += dot(n, c - k.witness) / 3;
    for (const auto v : verts(m)) CHECK(dot(n, point(m, v) - c) <= 1e-12 * norm(n) * size);
  }
  CHECK(volume == doctest::Approx(k.volume).epsilon(1e-10));
}

}  // namespace

TEST_CASE("kernel: of convex polygons, combs, stars and spirals") {
  for (const std::size_t n : std::vector<std::size_t>{3, 4, 9}) {
    const auto x = regular_polygon(n);
    const auto k = kernel(x);
    CHECK(k.area == doctest::Approx(area_of(x)).epsilon(1e-14));
    CHECK(k.corners.size() == n);
    CHECK(norm(k.witness) < 1e-14);
  }
  CHECK(kernel(comb_polygon(1, 2)).area == doctest::Approx(3));
  CHECK(kernel(comb_polygon(2, 2)).is_empty());
  CHECK(std::isnan(kernel(comb_polygon(2, 2)).witness.x));
  CHECK(kernel(spiral_polygon(3)).is_empty());
  CHECK(kernel(spiral_polygon(2)).area == doctest::Approx(1));  // an L
  const auto turn = kernel(spiral_polygon(1));
  CHECK(turn.area == doctest::Approx(2));
  const auto corner = kernel(std::vector<vec3>{{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0}, {1, 4, 0}, {0, 4, 0}});  // an L
  CHECK(corner.area == doctest::Approx(1).epsilon(1e-14));
  CHECK(norm(corner.witness - vec3{0.5, 0.5, 0}) < 1e-14);
  // The five lines of a pentagram: the pentagon inside.
  const double phi = std::numbers::phi, inner = 1 / (phi * phi);
  const auto k = kernel(star_polygon(5, inner));
  CHECK(k.area == doctest::Approx(area_of(regular_polygon(5, inner))).epsilon(1e-12));
  CHECK(k.area / area_of(star_polygon(5, inner)) == doctest::Approx((std::sqrt(5.0) - 1) / 4));
}

TEST_CASE("kernel: is empty where the linear programme says so, else all of the polygon is visible from it") {
  std::mt19937 random(8);
  std::size_t num_empty = 0, num_concave = 0;
  for (int round = 0; round < (long_run() ? 10000 : 600); ++round) {
    const auto x = random_polygon(random, 3 + static_cast<std::size_t>(round % 9));
    const auto k = kernel(x);
    const double t = largest_smallest_height(x);
    if (t > 1e-9) CHECK(!k.is_empty());
    if (t < -1e-9) CHECK(k.is_empty());
    num_empty += k.is_empty();
    for (std::size_t i = 0; i < x.size() && !k.is_empty(); ++i) {
      CHECK(height_above(x, i, k.witness) > 0);
      for (const vec3& c : k.corners) CHECK(height_above(x, i, c) > -1e-12);
    }
    CHECK(k.area == doctest::Approx(area_of(k.corners)).epsilon(1e-9));
    CHECK(std::abs(k.area - area_by_crossings(x)) < 1e-9);
    num_concave += k.area < 0.99 * area_of(x) && !k.is_empty();
    auto turned = x, large = x;
    for (vec3& y : turned) y = rotated(y + vec3{0, 0, 1});
    for (vec3& y : large) y *= 0x1p600;
    CHECK(std::abs(kernel(turned).area - k.area) < 1e-11);
    CHECK(kernel(large).corners.size() == k.corners.size());
    if (!k.is_empty()) CHECK(kernel(large).witness == 0x1p600 * k.witness);
  }
  CHECK(num_empty > 50);
  CHECK(num_concave > 50);
}

TEST_CASE_TEMPLATE("kernel: of convex polys is all of them, on archetypes too", M, CONCINO_ALL_KINDS) {
  const M m(rotated(grid_arrays<M>(2)));
  const auto g = only_embedded_mesh(m);
  for (const auto p : polys(m)) {
    const auto k = kernel(m, p);
    CHECK(kernel(g, g.poly(p)).witness == k.witness);
    if constexpr (VolumeMesh<M>) {
      CHECK(k.volume <= measure(m, p) * (1 + 1e-12));
      check_polyhedron(k, 1);
      if (arity_v<M> > 0) CHECK(k.volume == doctest::Approx(measure(m, p)).epsilon(1e-12));
      if (arity_v<M> > 0) CHECK(norm(k.witness - centroid(m, p)) < 1e-12);
      if (arity_v<M> > 0) CHECK(k.surface.points.size() == arity_v<M>);
    } else if (arity_v<M> > 0) {
      CHECK(k.area == doctest::Approx(measure(m, p)).epsilon(1e-12));
      CHECK(norm(k.witness - centroid(m, p)) < 1e-12);
    }
  }
}

TEST_CASE("kernel: of an extruded polygon is its kernel, extruded") {
  std::mt19937 random(1);
  for (int round = 0; round < 60; ++round) {
    const auto x = random_polygon(random, 4 + static_cast<std::size_t>(round % 5));
    const auto flat = kernel(x);
    auto arrays = extruded(x, 2);
    if (round % 2 == 1) arrays = rotated(arrays);
    for (const double scale : {1.0, 0x1p-300}) {
      const polyhedralmesh m(scaled(arrays, scale));
      const auto k = kernel(m, poly_id{0});
      CHECK(std::abs(k.volume / (scale * scale * scale) - 2 * flat.area) < 1e-11);
      if (flat.area < 1e-6) continue;
      REQUIRE(!k.is_empty());
      if (scale == 1) check_polyhedron(k, 3);
      CHECK(k.surface.points.size() <= 2 * flat.corners.size());
    }
  }
  // The verts of a convex cell remain, where four faces meet too.
  const polyhedralmesh box(extruded(regular_polygon(8), 1));
  CHECK(kernel(box, poly_id{0}).surface.points.size() == 16);
  CHECK(kernel(box, poly_id{0}).surface.num_polys() == 10);
}

TEST_CASE("kernel: polygons that touch themselves and points that are not finite are refused") {
  CHECK_THROWS_WITH_AS((void)kernel(std::vector<vec3>{{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 2, 0}}), "kernel: the polygon touches itself: its edges from corners 1 and 3 meet; give one that is simple, seen along its vector area", invalid_argument);
  auto arrays = extruded(regular_polygon(3), 1);
  const polygonmesh cross({{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 2, 0}}, {{0, 1, 2, 3}});
  CHECK_THROWS_WITH_AS((void)kernel(cross, poly_id{0}), "kernel: poly 0 touches itself: its edges from corners 1 and 3 meet; validate(m) finds such polys", invalid_mesh);
  arrays.points[2].z = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH_AS((void)kernel(polyhedralmesh(arrays), poly_id{0}), "kernel: poly 0 has a vert that is not finite; validate(m) finds such verts", invalid_mesh);
  auto inverted = extruded(regular_polygon(3), -1);
  CHECK(kernel(polyhedralmesh(inverted), poly_id{0}).is_empty());
}
