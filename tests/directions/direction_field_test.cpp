// direction_field: energies of spheres and planes, hard and soft directions, alignment, motions and numbers, bad input.
#include <concino/directions/direction_field.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/directions/singularities.hpp>
#include <concino/generate/icosphere.hpp>
#include <concino/generate/dual_mesh.hpp>

#include <support/closed_surfaces.hpp>
#include <support/motions.hpp>
#include <support/uv_disks.hpp>

#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

/// The smallest angle between a vector and the n directions of a field at a vert, projected to its tangent plane.
template<class F, class V>
double angle_to(const F& f, const V& v, const vec3& to) {
  const auto [x, y] = f.basis(v);
  const double n = f.symmetry(), turns = (std::atan2(dot(to, y), dot(to, x)) - f.angle(v)) * n / (2 * std::numbers::pi);
  return std::abs(turns - std::round(turns)) * 2 * std::numbers::pi / n;
}

/// A closed surface without symmetries: a ball that is stretched and bent.
surface_arrays uneven_ball(unsigned subdivisions) {
  const auto m = icosphere(subdivisions);
  surface_arrays a{{}, {}, {}, 3};
  for (const auto v : verts(m)) {
    const vec3 x = point(m, v);
    a.points.push_back({2 * x.x + 0.3 * x.y * x.y, 1.4 * x.y + 0.2 * x.x * x.z, x.z * (1 + 0.3 * x.x + 0.2 * x.y)});
  }
  for (const auto p : polys(m))
    for (const auto v : adj_p2v(m, p)) a.verts.push_back(v);
  return a;
}

std::vector<std::pair<vec3, int>> places(const auto& f, double unit) {
  std::vector<std::pair<vec3, int>> all;
  for (const auto& s : singularities(f)) {
    vec3 sum;
    for (const auto v : adj_p2v(f.mesh(), s.element)) sum += point(f.mesh(), v) / unit;
    all.push_back({sum, s.index});
  }
  return all;
}

}  // namespace

TEST_CASE("direction_field: on a sphere the energy tends to n / R^2 with order 2") {
  for (const int n : {1, 2, 4}) {
    CAPTURE(n);
    const double radius = 3;
    const auto coarse = icosphere(2, radius), fine = icosphere(3, radius);
    const auto f = direction_field(coarse, {.symmetry = n}), g = direction_field(fine, {.symmetry = n});
    CHECK(f.residual() < 1e-9);
    const double exact = n / (radius * radius), a = std::abs(f.energies()[0] - exact), b = std::abs(g.energies()[0] - exact);
    CHECK(a < 0.02 * exact);
    CHECK(std::log2(a / b) > 1.9);
    const auto duals = dual_mesh(coarse);  // of pentagons and hexagons
    CHECK(direction_field(duals, {.symmetry = n}).energies()[0] == doctest::Approx(exact).epsilon(0.05));
  }
}

TEST_CASE("direction_field: the smallest eigenvalue of a sphere has 2 n + 1 dimensions") {
  // The Bochner Laplacian of degree n on the unit sphere has the eigenvalues l (l + 1) - n^2 for l = n, n + 1, ..., each 2 l + 1 times.
  const auto m = icosphere(1);
  const auto s = detail::read_oriented_surface(m, "test");
  for (const int n : {1, 2, 3}) {
    CAPTURE(n);
    const auto e = detail::make_connection_energy(s, n);
    const auto size = static_cast<Eigen::Index>(num_verts(m));
    Eigen::MatrixXcd k = Eigen::MatrixXcd::Zero(size, size);
    const auto factor = [&](std::uint32_t v) { return 1 / std::sqrt(s.mass[v]); };
    for (std::uint32_t v = 0; v < num_verts(m); ++v) k(v, v) = e.diagonal[v] * factor(v) * factor(v);
    for (const auto& x : e.entries) {
      k(x.i, x.j) += x.value * factor(x.i) * factor(x.j);
      k(x.j, x.i) += std::conj(x.value) * factor(x.i) * factor(x.j);
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXcd> all(k, Eigen::EigenvaluesOnly);
    CHECK(all.eigenvalues()[0] == doctest::Approx(direction_field(m, {.symmetry = n}).energies()[0]).epsilon(1e-8));
    for (int i = 0; i < 2 * n + 1; ++i) CHECK(all.eigenvalues()[i] == doctest::Approx(n).epsilon(0.12));
    for (int i = 2 * n + 1; i < 4 * n + 4; ++i) CHECK(all.eigenvalues()[i] == doctest::Approx(3 * n + 2).epsilon(0.25));
  }
}

TEST_CASE_TEMPLATE("direction_field: in the plane and on developable surfaces directions are parallel", M, CONCINO_ALL_SURFACE_KINDS) {
  for (const int n : {1, 3, 4}) {
    const auto m = grid_on<M>(5, [](double x, double y) { return rotated(vec3{x + 0.5 * y * y, 2 * y, 0}); });
    const auto f = direction_field(m, {.symmetry = n});
    CHECK(f.energies().size() == 1);
    CHECK(f.energies()[0] < 1e-8);
    const vec3 first = f.direction(*verts(m).begin());
    for (const auto v : verts(m)) {
      CHECK(angle_to(f, v, first) < 1e-6);
      CHECK(norm(f.direction(v)) == doctest::Approx(1));
      CHECK(f.directions(v).size() == static_cast<std::size_t>(n));
      CHECK(std::abs(f.value(v)) > 0);
    }
    CHECK(singularities(f).empty());
  }
  const auto plane = grid<M>(4);
  const auto only = only_embedded_mesh(plane);
  const auto f = direction_field(only, {.symmetry = 4, .align_with_boundary = true});
  for (const auto v : verts(only)) CHECK(angle_to(f, v, {1, 0, 0}) < 1e-6);
  CHECK(f.energies()[0] < 1e-10);
  CHECK(singularities(f).empty());
  CHECK(boundary_turns(f).size() == 1);
  CHECK(boundary_turns(f)[0].index == 4);
}

TEST_CASE_TEMPLATE("direction_field: hard and soft directions", M, CONCINO_ALL_SURFACE_KINDS) {
  const M m = grid_on<M>(5, on_hill);
  const vert_id a{0}, b{7}, c{12};
  for (const int n : {1, 2, 4}) {
    const auto f = direction_field(m, {.symmetry = n, .hard = {{a, {1, 0.5, 0}}, {b, {0, 2, 0}}}});
    CHECK(angle_to(f, a, {1, 0.5, 0}) < 1e-9);
    CHECK(angle_to(f, b, {0, 2, 0}) < 1e-9);
    const auto weak = direction_field(m, {.symmetry = n, .soft = {{a, {1, 0, 0}}, {c, {1, 0.3, 0}}}, .soft_weight = 1e-3});
    const auto strong = direction_field(m, {.symmetry = n, .soft = {{a, {1, 0, 0}}, {c, {1, 0.3, 0}}}, .soft_weight = 1e4});
    CHECK(angle_to(strong, a, {1, 0, 0}) < 1e-3);
    CHECK(angle_to(strong, c, {1, 0.3, 0}) < 1e-3);
    CHECK(angle_to(weak, a, {1, 0, 0}) > angle_to(strong, a, {1, 0, 0}));
    CHECK(weak.energies()[0] < strong.energies()[0]);
  }
  // all verts are given: nothing is left to solve
  std::vector<std::pair<vert_id, vec3>> all;
  for (const auto v : verts(m)) all.push_back({v, {1, 0, 0}});
  const auto f = direction_field(m, {.symmetry = 1, .hard = all});
  for (const auto v : verts(m)) CHECK(angle_to(f, v, {1, 0, 0}) < 1e-9);
}

TEST_CASE("direction_field: along the boundary, and along curvature") {
  const auto cylinder = grid_on<trimesh>(10, on_cylinder);
  const auto along = direction_field(cylinder, {.symmetry = 2, .align_with_curvature = 1});
  for (const auto v : verts(cylinder)) CHECK(angle_to(along, v, {0, 0, 1}) < 0.05);
  const auto crosses = direction_field(cylinder, {.symmetry = 4, .align_with_curvature = 10});
  for (const auto v : verts(cylinder)) CHECK(angle_to(crosses, v, {0, 0, 1}) < 0.05);
  // a disk: a cross field along its circle turns once, a field of vectors too
  surface_arrays disk{{{0, 0, 0}}, {}, {}, 3};
  const unsigned sectors = 24, rings = 5;
  for (unsigned r = 1; r <= rings; ++r)
    for (unsigned k = 0; k < sectors; ++k) {
      const double t = 2 * std::numbers::pi * k / sectors;
      disk.points.push_back({r * std::cos(t), r * std::sin(t), 0});
      const unsigned next = (k + 1) % sectors, out = 1 + (r - 1) * sectors, in = r == 1 ? 0 : out - sectors;
      if (r == 1) {
        for (const unsigned v : {0u, out + k, out + next}) disk.verts.push_back(vert_id{v});
        continue;
      }
      for (const unsigned v : {in + k, out + k, out + next, in + k, out + next, in + next}) disk.verts.push_back(vert_id{v});
    }
  const trimesh m(disk);
  for (const int n : {1, 2, 3, 4}) {
    const auto f = direction_field(m, {.symmetry = n, .align_with_boundary = true});
    for (const auto v : verts(m)) {
      const vec3 x = point(m, v);
      if (is_boundary(m, v)) CHECK(angle_to(f, v, {-x.y, x.x, 0}) < 1e-9);
    }
    int sum = 0;
    for (const auto& s : singularities(f)) sum += s.index;
    CHECK(sum == n);
    CHECK(boundary_turns(f)[0].index == 0);
    // a direction at the boundary that differs contradicts
    const vert_id last{disk.points.size() - 1};
    const vec3 x = point(m, last);
    CHECK_THROWS_AS((void)direction_field(m, {.symmetry = n, .hard = {{last, vec3{-x.y, x.x, 0} + 0.3 * x}}, .align_with_boundary = true}), invalid_argument);
  }
}

TEST_CASE("direction_field: rotations, scales and numbers of verts do not matter") {
  const auto arrays = uneven_ball(2);
  const trimesh m(arrays), turned(rotated(arrays)), large(scaled(arrays, std::ldexp(1.0, 300))), tiny(scaled(arrays, std::ldexp(1.0, -400))), other(numbered_backwards(arrays));
  for (const int n : {1, 4}) {
    const auto f = direction_field(m, {.symmetry = n});
    const double energy = f.energies()[0];
    CHECK(f.residual() < 1e-9);
    CHECK(direction_field(turned, {.symmetry = n}).energies()[0] == doctest::Approx(energy).epsilon(1e-9));
    const auto g = direction_field(large, {.symmetry = n}), h = direction_field(tiny, {.symmetry = n}), back = direction_field(other, {.symmetry = n});
    CHECK(g.energies()[0] == std::ldexp(energy, -600));
    CHECK(h.energies()[0] == std::ldexp(energy, 800));
    CHECK(back.energies()[0] == doctest::Approx(energy).epsilon(1e-9));
    const auto at = places(f, 1);
    CHECK(at == places(g, std::ldexp(1.0, 300)));
    CHECK(at == places(h, std::ldexp(1.0, -400)));
    const auto same = places(back, 1);
    CHECK(same.size() == at.size());
    for (const auto& x : at)
      CHECK(std::any_of(same.begin(), same.end(), [&](const auto& y) { return distance(x.first, y.first) < 1e-9 && x.second == y.second; }));
    const auto is_turned = places(direction_field(turned, {.symmetry = n}), 1);
    CHECK(is_turned.size() == at.size());
  }
}

TEST_CASE("direction_field: components have fields of their own, verts without polys none") {
  auto two = beside(uneven_ball(1), scaled(uneven_ball(1), 2));
  two.points.push_back({std::numeric_limits<double>::quiet_NaN(), 0, 0});
  const trimesh m(two), one(uneven_ball(1));
  const auto f = direction_field(m, {.symmetry = 2});
  CHECK(f.energies().size() == 2);
  const double energy = direction_field(one, {.symmetry = 2}).energies()[0];
  CHECK(f.energies()[0] == doctest::Approx(energy).epsilon(1e-9));
  CHECK(f.energies()[1] == doctest::Approx(energy / 4).epsilon(1e-9));
  const vert_id alone{two.points.size() - 1};
  CHECK(f.value(alone) == std::complex<double>());
  CHECK(f.direction(alone) == vec3{});
  // one component has a wish, the other the smallest eigenvalue
  const auto g = direction_field(m, {.symmetry = 2, .hard = {{vert_id{0}, {1, 0.2, 0.3}}}});
  CHECK(g.energies()[0] > f.energies()[0]);
  CHECK(g.energies()[1] == doctest::Approx(f.energies()[1]).epsilon(1e-9));
  // polys that are oriented against each other
  auto turned = uneven_ball(1);
  for (std::size_t p = 3; p < turned.verts.size(); p += 6) std::swap(turned.verts[p], turned.verts[p + 1]);
  const trimesh mixed(turned);
  CHECK(direction_field(mixed, {.symmetry = 2}).energies()[0] == doctest::Approx(energy).epsilon(1e-9));
}

TEST_CASE("direction_field: bad input") {
  const auto m = grid_on<trimesh>(3, on_hill);
  const vert_id v{5};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const int n : {0, -1, 17}) CHECK_THROWS_AS((void)direction_field(m, {.symmetry = n}), invalid_argument);
  for (const double w : {0.0, -1.0, nan}) CHECK_THROWS_AS((void)direction_field(m, {.soft_weight = w}), invalid_argument);
  CHECK_THROWS_AS((void)direction_field(m, {.align_with_curvature = nan}), invalid_argument);
  CHECK_THROWS_AS((void)direction_field(m, {.symmetry = 3, .align_with_curvature = 1}), invalid_argument);
  CHECK_THROWS_WITH_AS((void)direction_field(m, {.hard = {{v, {0, 0, 0}}}}),
                       "direction_field: the direction of vert 5 is 0 in its tangent plane; give one along the surface", invalid_argument);
  const auto axes = direction_field(m).basis(v);
  CHECK_THROWS_AS((void)direction_field(m, {.hard = {{v, cross(axes[0], axes[1])}}}), invalid_argument);
  CHECK_THROWS_AS((void)direction_field(m, {.soft = {{v, {1, nan, 0}}}}), invalid_argument);
  CHECK_THROWS_WITH_AS((void)direction_field(m, {.hard = {{v, {1, 0, 0}}, {v, {1, 0.5, 0}}}}),
                       "direction_field: two directions that contradict are given at vert 5; give one, or make them soft", invalid_argument);
  CHECK_NOTHROW((void)direction_field(m, {.symmetry = 2, .hard = {{v, {1, 0, 0}}, {v, {-2, 0, 0}}}}));
  CHECK_THROWS_AS((void)direction_field(m, {.hard = {{vert_id{999}, {1, 0, 0}}}}), invalid_mesh);
  const polygonmesh none;
  CHECK_THROWS_AS((void)direction_field(none), invalid_mesh);
  const trimesh flat({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  CHECK_THROWS_WITH_AS((void)direction_field(flat),
                       "direction_field: poly 0 has no area, or points that are not finite; remove it or move its verts", invalid_mesh);
  const trimesh infinite({{0, 0, 0}, {1, 0, 0}, {nan, 1, 0}}, {{0, 1, 2}});
  CHECK_THROWS_AS((void)direction_field(infinite), invalid_mesh);
  const trimesh three({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}}, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}});
  CHECK_THROWS_AS((void)direction_field(three), unsupported);
  const trimesh fans({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 3, 4}});
  CHECK_THROWS_AS((void)direction_field(fans), unsupported);
  const trimesh projective(projective_plane());
  CHECK_THROWS_AS((void)direction_field(projective), unsupported);
  const quadmesh klein(rolled_grid(5, 6, true));
  CHECK_THROWS_AS((void)direction_field(klein), unsupported);
  CHECK_THROWS_AS((void)direction_field(m, {.progress = [](double, const char*) { return false; }}), cancelled);
  const trimesh one({{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}, {{0, 1, 2}});
  CHECK(direction_field(one).energies()[0] < 1e-12);
}
