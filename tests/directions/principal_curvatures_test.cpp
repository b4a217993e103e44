#include <concino/directions/principal_curvatures.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/generate/cylinder.hpp>
#include <concino/generate/grid.hpp>
#include <concino/generate/icosphere.hpp>
#include <concino/generate/sphere.hpp>
#include <concino/generate/torus.hpp>

#include <support/kinds.hpp>
#include <support/motions.hpp>
#include <support/permuted.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace concino;
using namespace concino::testing;

namespace {

/// The largest error of both curvatures of a torus with radii 1 and 0.4, and of the first direction, which is around the tube.
template<class M>
std::pair<double, double> errors_on_torus(std::size_t n) {
  const M m = make_torus<M>({.cells = {2 * n, n}});
  const auto k = principal_curvatures(m);
  double worst = 0, turned = 0;
  for (const auto v : verts(m)) {
    const vec3 x = point(m, v);
    const double r = std::hypot(x.x, x.y), cosine = (r - 1) / std::hypot(r - 1, x.z);
    worst = std::max({worst, std::abs(k[v].k1 - 1 / 0.4), std::abs(k[v].k2 - cosine / r)});
    turned = std::max(turned, std::abs(dot(k[v].d1, vec3{-x.y, x.x, 0} / r)));
  }
  return {worst, turned};
}

template<class M>
double error_on_sphere(const M& m, double radius) {
  const auto k = principal_curvatures(m);
  double worst = 0;
  for (const auto v : verts(m)) {
    const auto c = k[v];
    worst = std::max({worst, std::abs(c.k1 - 1 / radius), std::abs(c.k2 - 1 / radius)});
    CHECK(std::abs(norm(c.d1) - 1) < 1e-12);
    CHECK(std::abs(norm(c.d2) - 1) < 1e-12);
    CHECK(std::abs(dot(c.d1, c.d2)) < 1e-12);
    CHECK(c.k1 >= c.k2);
  }
  return worst * radius;
}

}  // namespace

TEST_CASE_TEMPLATE("principal_curvatures: of a torus tend to its own to order 2, and so do the directions", M, CONCINO_ALL_SURFACE_KINDS) {
  const auto [coarse, coarse_turn] = errors_on_torus<M>(16);
  const auto [fine, fine_turn] = errors_on_torus<M>(32);
  MESSAGE("errors on a torus: " << coarse << ", " << fine << "; directions " << coarse_turn << ", " << fine_turn);
  CHECK(coarse < 0.6);
  CHECK(fine < coarse / 3);
  CHECK(coarse_turn < 0.1);
  CHECK(fine_turn <= std::max(coarse_turn / 2, 1e-12));
}

TEST_CASE_TEMPLATE("principal_curvatures: of a sphere are 1 / R", M, CONCINO_SURFACE_KINDS) {
  const double coarse = error_on_sphere(make_sphere<M>({.cells = 8, .radius = 3}), 3);
  const double fine = error_on_sphere(make_sphere<M>({.cells = 16, .radius = 3}), 3);
  MESSAGE("relative errors on a sphere: " << coarse << ", " << fine);
  CHECK(coarse < 0.1);
  CHECK(fine < coarse / 1.8);
}

TEST_CASE("principal_curvatures: of a sphere of triangles, seen from outside and from inside") {
  const double coarse = error_on_sphere(icosphere(2), 1), fine = error_on_sphere(icosphere(3), 1);
  MESSAGE("errors on an icosphere: " << coarse << ", " << fine);
  CHECK(coarse < 0.12);
  CHECK(fine < coarse / 3);
  auto m = icosphere(2);
  const auto k = principal_curvatures(m);
  trimesh mirrored = m;
  for (const auto v : verts(m)) set_point(mirrored, v, -1.0 * to_vec3(point(m, v)));
  const auto inside = principal_curvatures(mirrored);
  for (const auto v : verts(m)) {
    CHECK(inside[v].k1 == doctest::Approx(-k[v].k2));
    CHECK(inside[v].k2 == doctest::Approx(-k[v].k1));
    CHECK(dot(cross(k[v].d1, k[v].d2), to_vec3(point(m, v))) > 0.99);
  }
}

TEST_CASE_TEMPLATE("principal_curvatures: a cylinder is straight along its axis, a plane is flat", M, CONCINO_SURFACE_KINDS) {
  const M m = make_cylinder<M>({.cells = {48, 10}, .radius = 2, .height = 3});
  const auto k = principal_curvatures(m);
  for (const auto v : verts(m)) {
    const vec3 x = point(m, v);
    if (x.z < 0.7 || x.z > 2.3) continue;  // two rings from the rims
    CHECK(k[v].k1 == doctest::Approx(0.5).epsilon(0.01));
    CHECK(std::abs(k[v].k2) < 1e-3);  // of order 2, as the error of k1
    CHECK(norm(cross(k[v].d2, {0, 0, 1})) < (arity_v<M> == 3 ? 2e-3 : 1e-9));  // quads are mirror images of each other, triangles are not
  }
  const M flat(rotated(grid_arrays<M>(4)));
  const auto none = principal_curvatures(flat);
  for (const auto v : verts(flat)) {
    CHECK(std::abs(none[v].k1) < 1e-11);
    CHECK(std::abs(none[v].k2) < 1e-11);
  }
}

TEST_CASE_TEMPLATE("principal_curvatures: do not depend on the order of elements, motions and scale; archetype", M, CONCINO_SURFACE_KINDS) {
  const M m = make_torus<M>({.cells = {12, 8}});
  const auto k = principal_curvatures(m);
  const auto other = permute(m, 3);
  const auto there = principal_curvatures(other.mesh);
  M moved = m;
  for (const auto v : verts(m)) set_point(moved, v, 1e-6 * rotated(point(m, v)));
  const auto at_moved = principal_curvatures(moved);
  const auto g = only_embedded_mesh(m);
  const auto thin = principal_curvatures(g);
  for (const auto v : verts(m)) {
    CHECK(there[other.verts[v.raw()]].k1 == doctest::Approx(k[v].k1));
    CHECK(there[other.verts[v.raw()]].k2 == doctest::Approx(k[v].k2));
    CHECK(std::abs(dot(there[other.verts[v.raw()]].d1, k[v].d1)) == doctest::Approx(1));
    CHECK(at_moved[v].k1 == doctest::Approx(1e6 * k[v].k1));
    CHECK(std::abs(dot(at_moved[v].d1, rotated(k[v].d1))) == doctest::Approx(1));
    CHECK(thin.data()[v.raw()].k1 == k[v].k1);
    CHECK(thin.data()[v.raw()].d1 == k[v].d1);
  }
}

TEST_CASE("principal_curvatures: few verts, no polys, bad input") {
  constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
  const polygonmesh empty;
  CHECK(principal_curvatures(empty).values().empty());
  const polygonmesh one(surface_arrays{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {7, 7, 7}}, {0, 3}, {vert_id{0}, vert_id{1}, vert_id{2}}, 0});
  const auto k = principal_curvatures(one);
  for (const auto v : verts(one)) CHECK((k[v].k1 == 0 && k[v].k2 == 0));
  CHECK(norm(k[vert_id{3}].d1) == 0);
  CHECK(norm(k[vert_id{0}].d1) == doctest::Approx(1));
  trimesh bad = icosphere(0);
  set_point(bad, vert_id{2}, vec3{not_a_number, 0, 0});
  CHECK_THROWS_WITH_AS((void)principal_curvatures(bad), "principal_curvatures: the point of vert 2 is not finite", invalid_mesh);
  // a tetrahedron: three verts around each do not determine the polynomial, and the results are finite
  const auto number = [](unsigned i) { return vert_id{i}; };
  const trimesh tet(surface_arrays{{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, {}, {number(0), number(1), number(2), number(0), number(3), number(1), number(0), number(2), number(3), number(1), number(3), number(2)}, 3});
  const auto at_corners = principal_curvatures(tet);
  for (const auto v : verts(tet)) CHECK((std::isfinite(at_corners[v].k1) && at_corners[v].k1 > 0));
}
