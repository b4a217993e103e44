#include <concino/remesh/improve.hpp>

#include <concino/concepts/end_verts.hpp>
#include <concino/edit/flip_winding.hpp>
#include <concino/edit/transaction.hpp>
#include <concino/geometry/dihedral_angles.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/quality/worst.hpp>
#include <concino/io/load.hpp>
#include <concino/validate/check_laws.hpp>

#include <support/corpus_meshes.hpp>
#include <support/kinds.hpp>
#include <support/whole_mesh.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

/// A grid whose inner verts are moved by up to `noise` of an edge.
tetmesh noisy_grid(unsigned n, double noise, unsigned seed = 1) {
  auto m = grid<tetmesh>(n);
  std::mt19937 random(seed);
  const auto d = [&] { return noise / n * (2 * std::ldexp(double(random()), -32) - 1); };
  for (const auto v : verts(m)) {
    const double x = d(), y = d(), z = d();
    if (!is_boundary(m, v)) set_point(m, v, point(m, v) + vec3{x, y, z});
  }
  return m;
}

/// The faces that separate polys of different labels, or polys from nothing, as sorted lists of points.
template<class F>
std::vector<std::array<vec3, 3>> walls(const tetmesh& m, const F& label) {
  const auto is_less = [](const vec3& a, const vec3& b) { return std::array{a.x, a.y, a.z} < std::array{b.x, b.y, b.z}; };
  std::vector<std::array<vec3, 3>> all;
  for (const auto f : faces(m)) {
    std::vector<int> labels;
    for (const auto p : adj_f2p(m, f)) labels.push_back(label(p));
    if (labels.size() == 2 && labels[0] == labels[1]) continue;
    std::array<vec3, 3> x;
    std::size_t n = 0;
    for (const auto v : adj_f2v(m, f)) x[n++] = point(m, v);
    std::sort(x.begin(), x.end(), is_less);
    all.push_back(x);
  }
  std::sort(all.begin(), all.end(), [&](const auto& a, const auto& b) { return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), is_less); });
  return all;
}
std::vector<std::array<vec3, 3>> boundary(const tetmesh& m) {
  return walls(m, [](poly_id) { return 0; });
}

/// What improve promises, whatever the mesh.
void check_improvement(const tetmesh& before, const tetmesh& m, const improvement<tetmesh>& r, const improve_options& options) {
  CHECK(boundary(m) == boundary(before));
  CHECK(total_measure(m) == doctest::Approx(total_measure(before)).epsilon(1e-12));
  CHECK(check_laws(m).empty());
  CHECK(r.least_after >= r.least_before);
  CHECK(contains(m, r.poly));
  if (r.least_before >= 0) {
    CHECK(r.least_before == doctest::Approx(worst(before, metric::minimum_angle).value).epsilon(1e-6));
    CHECK(r.least_after == doctest::Approx(worst(m, metric::minimum_angle).value).epsilon(1e-6));
    CHECK(r.least_after == doctest::Approx(dihedral_angle(m, r.poly, r.edge) * 180 / std::numbers::pi).epsilon(1e-6));
    for (const auto p : polys(m)) CHECK(volume(m, p) > 0);
  }
  CHECK((r.stopped_by == improvement_end::target) == (r.least_after >= options.min_dihedral_deg));
  if (r.stopped_by == improvement_end::boundary) {
    double sum = 0;
    for (const auto p : adj_e2p(m, r.edge)) sum += dihedral_angle(m, p, r.edge) * 180 / std::numbers::pi;
    CHECK(is_boundary(m, r.edge));
    CHECK(sum == doctest::Approx(r.least_after * double(num_elements(adj_e2p(m, r.edge)))).epsilon(1e-5));
  }
}

}  // namespace

TEST_CASE("improve: thin tets, and boundaries that stay as they are") {
  for (const double noise : {0.1, 0.3}) {
    for (const double target : {15.0, 30.0, 70.0}) {
      const auto before = noisy_grid(target > 40 ? 2 : 5, noise);
      CAPTURE(noise);
      CAPTURE(target);
      auto m = before;
      const improve_options options{.min_dihedral_deg = target};
      const auto r = improve(m, options);
      check_improvement(before, m, r, options);
      CHECK(r.least_after >= std::min(target, 27.0));
      auto again = before;
      improve(again, options);
      CHECK(whole(again) == whole(m));
    }
  }
}

TEST_CASE("improve: inverted tets are turned back") {
  for (const unsigned seed : {1u, 2u, 3u}) {
    const auto before = noisy_grid(5, 0.45, seed);
    auto m = before;
    const auto r = improve(m, {.min_dihedral_deg = 15});
    check_improvement(before, m, r, {.min_dihedral_deg = 15});
    CHECK(r.least_before < 0);
    CHECK(r.least_after >= 15);
    for (const auto p : polys(m)) CHECK(volume(m, p) > 0);
  }
}

TEST_CASE("improve: no new verts, if the caller wants none") {
  const auto before = noisy_grid(3, 0.3);
  auto m = before;
  const auto r = improve(m, {.min_dihedral_deg = 60, .adds_verts = false});
  check_improvement(before, m, r, {.min_dihedral_deg = 60});
  CHECK(r.num_new_verts == 0);
  CHECK(num_verts(m) == num_verts(before) - r.num_collapses);
  auto other = before;
  CHECK(improve(other, {.min_dihedral_deg = 60}).num_new_verts > 0);
}

TEST_CASE("improve: labels keep their regions") {
  auto m = noisy_grid(6, 0.2);
  const auto material = poly_property<int>(m, "material");
  set_property_rule(m, element_kind::poly, "material", property_rule::copy);
  for (const auto p : polys(m)) {
    vec3 sum;
    for (const auto v : adj_p2v(m, p)) sum += point(m, v);
    material[p] = sum.x + sum.y < 4 ? 1 : sum.z < 2 ? 2 : 3;
  }
  const auto volume_of = [&](int label) {
    double sum = 0;
    for (const auto p : polys(m))
      if (material[p] == label) sum += volume(m, p);
    return sum;
  };
  const auto label = [&](poly_id p) { return material[p]; };
  const auto before = walls(m, label);
  const double volumes[] = {volume_of(1), volume_of(2), volume_of(3)};
  const auto r = improve(m, {.min_dihedral_deg = 35}, material);
  CHECK(r.num_flips > 0);
  CHECK(r.num_new_verts > 0);
  CHECK(walls(m, label) == before);
  for (const int i : {1, 2, 3}) CHECK(volume_of(i) == doctest::Approx(volumes[i - 1]).epsilon(1e-12));
  CHECK(check_laws(m).empty());
  CHECK(r.least_after > r.least_before);
}

TEST_CASE("improve: a sharp boundary stops it, at the edge that the result names") {
  // a wedge of 5 degrees, which is an edge of one tet
  const double angle = 5 * std::numbers::pi / 180;
  tetmesh m({{0, 0, 0}, {0, 0, 1}, {1, 0, 0.5}, {std::cos(angle), std::sin(angle), 0.5}}, {{0, 1, 2, 3}});
  if (volume(m, poly_id{0}) < 0) flip_winding(m);
  const auto before = m;
  const auto r = improve(m, {.min_dihedral_deg = 20});
  CHECK(r.stopped_by == improvement_end::boundary);
  CHECK(r.least_after == doctest::Approx(5));
  const auto ends = end_verts(m, r.edge);
  CHECK(ends.first.raw() + ends.second.raw() == 1);
  CHECK(whole(m) == whole(before));
}

TEST_CASE("improve: the same result at any power of two") {
  const auto before = noisy_grid(4, 0.3);
  auto m = before;
  improve(m, {.min_dihedral_deg = 40});
  for (const double scale : {0x1p-500, 0x1p500}) {
    auto other = before;
    for (const auto v : verts(other)) set_point(other, v, scale * point(other, v));
    improve(other, {.min_dihedral_deg = 40});
    REQUIRE(num_polys(other) == num_polys(m));
    CHECK(worst(other, metric::minimum_angle).value == doctest::Approx(worst(m, metric::minimum_angle).value).epsilon(1e-12));
  }
}

TEST_CASE("improve: nothing to do, flat tets, tets that share a vert, and two copies of a tet") {
  tetmesh empty;
  const auto r = improve(empty);
  CHECK(r.stopped_by == improvement_end::target);
  CHECK(std::isnan(r.least_before));
  tetmesh flat({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}});
  CHECK(improve(flat).least_after == 0);
  tetmesh one_point({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {{0, 1, 2, 3}});
  CHECK(improve(one_point).least_after == 0);
  tetmesh two({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -9}}, {{0, 1, 2, 3}, {0, 4, 5, 6}});
  const auto end = improve(two, {.min_dihedral_deg = 60}).stopped_by;
  CHECK(end == improvement_end::boundary);
  tetmesh copies({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}, {0, 1, 2, 3}});
  improve(copies, {.min_dihedral_deg = 60});
  CHECK(num_polys(copies) == 2);
  auto all_inverted = noisy_grid(2, 0.1);
  flip_winding(all_inverted);
  const auto inverted = improve(all_inverted);
  CHECK(inverted.least_before < 0);
  CHECK(inverted.least_after >= inverted.least_before);
  CHECK(check_laws(all_inverted).empty());
}

TEST_CASE("improve: can be cancelled; a transaction then restores the mesh") {
  auto m = noisy_grid(5, 0.3);
  const auto before = whole(m);
  unsigned calls = 0;
  double last = 0;
  const auto count = [&](double fraction, const char* label) {
    CHECK(std::string(label) == "improving");
    CHECK(fraction >= last);
    last = fraction;
    return ++calls < 100;
  };
  {
    transaction t(m);
    CHECK_THROWS_AS(improve(m, {.min_dihedral_deg = 40, .progress = count}), cancelled);
    CHECK(whole(m) != before);
  }
  CHECK(whole(m) == before);
  CHECK(check_laws(m).empty());
}

TEST_CASE("improve: errors leave the mesh as it was") {
  constexpr double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  auto m = noisy_grid(2, 0.3);
  const auto before = whole(m);
  for (const double angle : {0.0, -1.0, nan, infinity, 71.0}) CHECK_THROWS_AS(improve(m, {.min_dihedral_deg = angle}), invalid_argument);
  CHECK(whole(m) == before);
  for (const double x : {nan, infinity}) {
    set_point(m, vert_id{13}, vec3{x, 0, 0});
    CHECK_THROWS_WITH_AS(improve(m), doctest::Contains("vert 13"), invalid_mesh);
  }
}

TEST_CASE("improve: real meshes") {
  unsigned seen = 0;
  for (const char* const name : {"fields/kuhn_6.mesh", "tet/capsule_cavity.vtk", "tet/cube_tet.vtk", "tet/quarter_crown.mesh",
                                 "tet/sphere_octant.mesh"}) {
    const auto file = corpus(name);
    if (file.empty()) continue;
    const auto before = load<tetmesh>(file.string());
    for (const double target : {15.0, 30.0, 60.0}) {
      if (num_polys(before) > (target < 40 ? 2000 : 600) && target > 15 && !long_run()) continue;
      CAPTURE(name);
      CAPTURE(target);
      ++seen;
      auto m = before;
      const improve_options options{.min_dihedral_deg = target};
      const auto r = improve(m, options);
      check_improvement(before, m, r, options);
      if (r.least_before < target && r.stopped_by != improvement_end::boundary) CHECK(r.least_after > r.least_before);
    }
  }
  if (seen == 0) skip("no corpus");
}
