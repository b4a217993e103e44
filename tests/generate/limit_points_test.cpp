#include <concino/generate/limit_points.hpp>

#include <concino/convert.hpp>
#include <concino/generate/icosphere.hpp>
#include <concino/generate/sphere.hpp>
#include <concino/generate/subdivide_catmull_clark.hpp>
#include <concino/generate/subdivide_loop.hpp>
#include <concino/mesh/submesh.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <random>

using namespace concino;
using namespace concino::testing;

namespace {

/// The polys around the first vert, which stays the first.
template<class M>
M ring(const M& m) {
  const auto part = submesh(m, [&](const poly_id& p) {
    for (const vert_id v : adj_p2v(m, p))
      if (v.raw() == 0) return true;
    return false;
  });
  return convert<M>(part);
}

/// n polygons of `size` verts around vert 0, all around it or half around it, at random places near a saddle.
template<class M>
M fan(unsigned n, bool closed, unsigned size, std::mt19937& random) {
  std::uniform_real_distribution<double> near(-0.15, 0.15);
  const auto place = [&](double r, double angle) {
    const double x = r * std::cos(angle), y = r * std::sin(angle);
    return vec3{x + near(random), y + near(random), 0.4 * x * y + near(random)};
  };
  const double step = (closed ? 2 : n == 1 ? 0.5 : 1) * std::numbers::pi / n;
  std::vector<vec3> points{{0, 0, 0.1}};
  std::vector<std::vector<unsigned>> cells;
  const unsigned spokes = closed ? n : n + 1;
  for (unsigned k = 0; k < spokes; ++k) points.push_back(place(1, k * step));
  for (unsigned k = 0; k < n; ++k) {
    std::vector<unsigned> p{0, 1 + k};
    for (unsigned i = 3; i < size; ++i) {
      p.push_back(static_cast<unsigned>(points.size()));
      points.push_back(place(1.4, (k + double(i - 2) / (size - 2)) * step));
    }
    p.push_back(1 + (k + 1) % spokes);
    cells.push_back(p);
  }
  return M(points, cells);
}

/// The point and the normal at vert 0 after many steps. Verts farther away do not matter. The ring is moved to the origin and enlarged after each step, so that its
/// shape does not get lost in rounding.
template<class M, class Step>
std::pair<vec3, vec3> after(M m, unsigned times, const Step& step) {
  vec3 at;
  double size = 1;
  for (unsigned k = 0; k < times; ++k) {
    m = ring(step(m));
    const vec3 x = point(m, vert_id{0u});
    at += size * x;
    size /= 2;
    for (const vert_id v : verts(m)) set_point(m, v, 2.0 * (point(m, v) - x));
  }
  vec3 area;
  for (const poly_id p : polys(m)) {
    std::vector<vec3> corner;
    for (const vert_id v : adj_p2v(m, p)) corner.push_back(point(m, v));
    for (std::size_t k = 0; k < corner.size(); ++k) area += cross(corner[k], corner[(k + 1) % corner.size()]);
  }
  return {at, area / norm(area)};
}

/// Compares a limit with eight steps, and with as many as its slowest part needs.
template<class M, class Limit, class Step>
void check_limit(const M& m, unsigned many, bool eight_are_near, const Limit& limit_of, const Step& step) {
  const auto limit = limit_of(m);
  const auto [x, normal] = after(m, 8, step);
  CHECK(norm(limit.points[vert_id{0u}] - x) < 1e-3);
  const auto [y, more] = after(m, many, step);
  CHECK(norm(limit.points[vert_id{0u}] - y) < 1e-7);
  if (eight_are_near) CHECK(norm(limit.normals[vert_id{0u}] - normal) < 1e-3);
  CHECK(norm(limit.normals[vert_id{0u}] - more) < 1e-5);
}

}  // namespace

// At the boundary, the ring of four or five triangles flattens slowly: by 3/4 and 9/10 a step.
TEST_CASE("loop_limit: what many steps come near to") {
  std::mt19937 random(5);
  for (const bool closed : {true, false})
    for (unsigned n = closed ? 3 : 1; n <= (closed ? 8 : 5); ++n) {
      CAPTURE(closed);
      CAPTURE(n);
      check_limit(fan<trimesh>(n, closed, 3, random), closed || n < 4 ? 24 : n == 4 ? 50 : 140, closed || n < 4, [](const auto& m) { return loop_limit(m); },
                  [](const trimesh& x) { return subdivide_loop(x); });
    }
}

// At a corner of one polygon, the ring nears its tangent plane too slowly to be compared: by 1 / n after n steps. The plane below has such a corner.
TEST_CASE("catmull_clark_limit: what many steps come near to") {
  std::mt19937 random(6);
  for (const unsigned size : {3u, 4u, 5u})
    for (const bool closed : {true, false})
      for (unsigned n = closed ? 3 : 2; n <= (closed ? 8 : 3); ++n) {
        CAPTURE(size);
        CAPTURE(closed);
        CAPTURE(n);
        check_limit(fan<polygonmesh>(n, closed, size, random), closed || n < 3 ? 24 : 80, size < 5 && (closed || n < 3) && n < 8, [](const auto& m) { return catmull_clark_limit(m); },
                    [](const polygonmesh& x) { return convert<polygonmesh>(subdivide_catmull_clark(x)); });
      }
}

TEST_CASE("limits: the normals of a plane, at verts of any number of polys") {
  std::mt19937 random(7);
  for (unsigned n = 1; n <= 12; ++n) {
    auto m = fan<trimesh>(n, false, 3, random);
    for (const vert_id v : verts(m)) set_point(m, v, vec3{point(m, v).x, point(m, v).y, 3});
    for (const auto& limit : {loop_limit(m), catmull_clark_limit(m)}) CHECK(norm(limit.normals[vert_id{0u}] - vec3{0, 0, 1}) < 1e-12);
  }
}

TEST_CASE("limits: the verts of a symmetric sphere stay on one, with its normals") {
  const trimesh m = icosphere(0);
  const auto limit = loop_limit(m);
  for (const vert_id v : verts(m)) {
    CHECK(norm(limit.points[v]) == doctest::Approx(norm(limit.points[vert_id{0u}])).epsilon(1e-14));
    CHECK(norm(limit.normals[v] - limit.points[v] / norm(limit.points[v])) < 1e-14);
  }
}

TEST_CASE("limits: verts without a tangent plane have no normal") {
  // Two triangles that meet at a vert; a vert of no poly; three triangles at an edge.
  const trimesh bow(std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}, {7, 7, 7}}, std::vector<std::vector<unsigned>>{{0, 1, 2}, {0, 3, 4}});
  for (const auto& limit : {loop_limit(bow), catmull_clark_limit(bow)}) {
    CHECK(norm(limit.normals[vert_id{0u}]) == 0);
    CHECK(limit.points[vert_id{0u}] == point(bow, vert_id{0u}));
    CHECK(limit.points[vert_id{5u}] == point(bow, vert_id{5u}));
    CHECK(norm(limit.normals[vert_id{5u}]) == 0);
    CHECK(norm(limit.normals[vert_id{1u}] - vec3{0, 0, 1}) < 1e-14);
  }
  const quadmesh pillow(std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, std::vector<std::vector<unsigned>>{{0, 1, 2, 3}, {3, 2, 1, 0}});
  const auto flat = catmull_clark_limit(pillow);
  for (const vert_id v : verts(pillow)) CHECK(norm(flat.normals[v]) == 0);
  CHECK_THROWS_WITH_AS(loop_limit(pillow), doctest::Contains("loop_limit: poly 0 has 4 verts, but must have 3"), unsupported);
}
