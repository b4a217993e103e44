#include <concino/print/wall_thickness.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/generate/box.hpp>
#include <concino/generate/sphere.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/geometry/normals.hpp>

#include <support/kinds.hpp>
#include <support/motions.hpp>
#include <support/printed_parts.hpp>
#include <support/threads.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <set>
#include <vector>

using namespace concino;
using testing::voxel_part;

namespace {

/// A block of 4 x 4 x 4 with a slot of width 1 from above, between walls of widths 1 and 2.
std::set<testing::voxel> slotted() {
  std::set<testing::voxel> v;
  testing::add_voxels(v, {0, 0, 0}, {4, 4, 2});
  testing::add_voxels(v, {0, 0, 2}, {1, 4, 4});
  testing::add_voxels(v, {2, 0, 2}, {4, 4, 4});
  return v;
}

}  // namespace

TEST_CASE_TEMPLATE("thin_walls, narrow_gaps: a slotted block, in any position and size", M, CONCINO_KINDS) {
  for (int motion = 0; motion < 3; ++motion) {
    const double unit = motion == 2 ? 0x1p-200 : 1;
    const auto moved = [&](const vec3& x) { return motion == 1 ? testing::rotated(x) + vec3{5, 6, 7} : unit * x; };
    const M m = voxel_part<M>(slotted(), moved);
    const wall_options rays{.spacing = 0.3 * unit};
    const auto thin = thin_walls(m, 1.5 * unit, rays);
    double area_of_thin = 0;
    for (const auto& w : thin) {
      CHECK(w.thickness == doctest::Approx(unit).epsilon(1e-12));
      CHECK(distance(w.from, w.to) == doctest::Approx(unit).epsilon(1e-12));
      CHECK(dot(normal(m, w.poly), normal(m, w.opposite)) == doctest::Approx(-1));
      area_of_thin += area(m, w.poly);
    }
    CHECK(area_of_thin == doctest::Approx(16 * unit * unit));  // 4 x 2 on either face of the thin wall
    double area_of_gap = 0;
    for (const auto& g : narrow_gaps(m, 1.5 * unit, rays)) {
      CHECK(g.thickness == doctest::Approx(unit).epsilon(1e-12));
      area_of_gap += area(m, g.poly);
    }
    CHECK(area_of_gap == doctest::Approx(16 * unit * unit));
    // what is exactly as thick as the limit is thick enough
    CHECK(thin_walls(m, unit, rays).empty());
    CHECK(narrow_gaps(m, unit, rays).empty());
    CHECK(narrow_gaps(m, std::numeric_limits<double>::infinity(), rays).size() == narrow_gaps(m, 2 * unit, rays).size());  // no other gaps
    std::size_t outer = 0;
    for_each_outer_polygon(m, [&](const auto&, const auto&, bool) { ++outer; });
    const auto all = thin_walls(m, std::numeric_limits<double>::infinity(), rays);
    CHECK(all.size() == outer);  // each poly has a thickness
    for (std::size_t i = 1; i < all.size(); ++i) CHECK(index_of(m, all[i - 1].poly) < index_of(m, all[i].poly));
  }
}

TEST_CASE("thin_walls: a shell between two spheres") {
  surface_arrays a;
  const auto outer = make_sphere<trimesh>({.cells = 12});
  a.arity = 3;
  for (const double radius : {1.0, 0.9}) {
    const auto first = static_cast<unsigned>(a.points.size());
    for (const auto v : verts(outer)) a.points.push_back(radius * point(outer, v));
    for (const auto p : polys(outer)) {
      std::vector<vert_id> ring;
      for (const auto v : adj_p2v(outer, p)) ring.push_back(vert_id{first + v.raw()});
      if (radius < 1) std::swap(ring[1], ring[2]);  // the inner one is turned: the material is between them
      a.verts.insert(a.verts.end(), ring.begin(), ring.end());
    }
  }
  const trimesh shell(a);
  const auto thin = thin_walls(shell, 0.15);
  CHECK(thin.size() == num_polys(shell));
  for (const auto& w : thin) CHECK(w.thickness == doctest::Approx(0.1).epsilon(0.02));
  CHECK(thin_walls(shell, 0.09).empty());
  CHECK(narrow_gaps(shell, 1).empty());
  CHECK(narrow_gaps(shell, 2).size() == num_polys(shell) / 2);  // through the hollow
}

TEST_CASE("thin_walls: a wedge is no wall where its polys are not parallel; rays are spread over large polys") {
  // a prism over a triangle with an angle of 30 degrees at x = 0
  const double h = std::tan(3.14159265358979 / 6);
  const polygonmesh wedge({{0, 0, 0}, {1, 0, 0}, {1, 0, h}, {0, 1, 0}, {1, 1, 0}, {1, 1, h}}, {{0, 1, 2}, {5, 4, 3}, {0, 3, 4, 1}, {1, 4, 5, 2}, {2, 5, 3, 0}});
  CHECK(thin_walls(wedge, 0.1, {.max_tilt_deg = 29}).empty());
  const auto thin = thin_walls(wedge, 0.1, {.spacing = 0.02});
  REQUIRE(thin.size() == 2);
  for (const auto& w : thin) {
    CHECK(w.thickness > 0);
    CHECK(w.thickness < 0.01);  // near the edge; one ray in the middle of a triangle would not see it
  }
  CHECK(thin_walls(wedge, 0.1, {.spacing = 10}).empty());
}

TEST_CASE("narrow_gaps: parts that touch have a gap of width 0") {
  std::set<testing::voxel> lower, upper;
  testing::add_voxels(lower, {0, 0, 0}, {1, 1, 1});
  surface_arrays a = testing::voxel_skin(lower);
  const auto n = a.points.size();
  const auto corners = a.verts;
  for (std::size_t i = 0; i < n; ++i) a.points.push_back(a.points[i] + vec3{0, 0, 1});
  for (const vert_id v : corners) a.verts.push_back(vert_id(v.raw() + n));
  for (vec3& x : a.points) x = testing::rotated(x);
  const auto gaps = narrow_gaps(quadmesh(a), 0.1);
  CHECK(gaps.size() == 2);
  for (const auto& g : gaps) CHECK(g.thickness < 1e-14);
}

TEST_CASE("thin_walls: archetypes, threads, and what is refused") {
  const auto m = voxel_part<polygonmesh>(slotted());
  CHECK(thin_walls(only_embedded_mesh(m), 1.5).size() == thin_walls(m, 1.5).size());
  const auto bits = [&](int threads) {
    const testing::with_num_threads now(threads);
    std::vector<double> all;
    for (const auto& w : thin_walls(m, 10)) all.push_back(w.thickness), all.push_back(w.to.x);
    return all;
  };
  CHECK(bits(1) == bits(3));
  CHECK(thin_walls(trimesh{}, 1).empty());
  CHECK(thin_walls(trimesh({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}), 1).empty());
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH_AS(thin_walls(trimesh({{0, 0, 0}, {1, 0, 0}, {2, nan, 0}}, {{0, 1, 2}}), 1), "thin_walls: vert 2 is not finite", invalid_mesh);
  CHECK_THROWS_WITH_AS(thin_walls(m, 0), "thin_walls: thickness must be positive", invalid_argument);
  CHECK_THROWS_WITH_AS(narrow_gaps(m, nan), "narrow_gaps: width must be positive", invalid_argument);
  CHECK_THROWS_AS(thin_walls(m, 1, {.spacing = 0.0}), invalid_argument);
  CHECK_THROWS_AS(thin_walls(m, 1, {.spacing = nan}), invalid_argument);
  CHECK_THROWS_AS(thin_walls(m, 1, {.max_tilt_deg = 91}), invalid_argument);
}
