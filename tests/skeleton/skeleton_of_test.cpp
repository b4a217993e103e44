#include <concino/skeleton/skeleton_of.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/generate/icosphere.hpp>
#include <concino/generate/subdivide_catmull_clark.hpp>
#include <concino/generate/to_triangles.hpp>
#include <concino/generate/torus.hpp>
#include <concino/graph/components.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/quadmesh.hpp>
#include <concino/skeleton/bones.hpp>
#include <concino/skeleton/tube.hpp>

#include <support/kinds.hpp>
#include <support/motions.hpp>
#include <support/skeletons.hpp>

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

long num_cycles(const skeleton& k) {
  return static_cast<long>(k.num_edges()) + connected_components(k).count - static_cast<long>(k.num_verts());
}

/// Each vert is in one node.
template<class M>
void check_origins(const M& m, const skeleton_of_result<M>& s) {
  REQUIRE(s.from.size() == s.skeleton.num_verts());
  std::vector<int> count(vert_index_bound(m), 0);
  for (std::size_t n = 0; n < s.from.size(); ++n) {
    CHECK(!s.from[n].empty());
    for (const auto v : s.from[n]) ++count[index_of(m, v)];
  }
  for (const auto v : verts(m)) CHECK(count[index_of(m, v)] == 1);
}

}  // namespace

TEST_CASE("skeleton_of: a torus has one cycle, in its middle") {
  for (const double tube : {0.15, 0.35}) {
    const auto m = make_torus<trimesh>({.cells = {40, 12}, .tube_radius = tube});
    const auto s = skeleton_of(m);
    check_origins(m, s);
    CHECK(num_cycles(s.skeleton) == 1);
    CHECK(connected_components(s.skeleton).count == 1);
    const auto all = bones(s.skeleton);
    REQUIRE(all.size() == 1);
    CHECK(all[0].is_cycle());
    CHECK(length(all[0]) == doctest::Approx(2 * std::numbers::pi).epsilon(0.05));
    for (const auto v : verts(s.skeleton)) {
      const vec3 x = s.skeleton.point(v);
      CHECK(std::hypot(std::hypot(x.x, x.y) - 1, x.z) < 0.25 * tube);
      CHECK(s.skeleton.radius(v) == doctest::Approx(tube).epsilon(0.3));
    }
  }
}

TEST_CASE("skeleton_of: finds all limbs, thin ones beside thick ones and a thick body too, at any size and position") {
  for (const std::size_t k : std::vector<std::size_t>{3, 4, 5})
    for (const double body : {0.1, 0.4})
      for (const double thin : {0.1, 0.03}) {
        CAPTURE(k);
        CAPTURE(body);
        CAPTURE(thin);
        std::vector<vec3> points{{0, 0, 0}}, tips;
        std::vector<std::array<std::uint32_t, 2>> pairs;
        std::vector<double> radii{body};
        for (std::size_t i = 0; i < k; ++i) {
          const double a = 0.2 + 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(k);
          tips.push_back({std::cos(a), std::sin(a), 0});
          for (int j = 1; j <= 5; ++j) {
            const auto id = static_cast<std::uint32_t>(points.size());
            points.push_back((body + (1 - body) * j / 5.0) * tips.back());
            radii.push_back(i % 2 ? thin : 0.1);
            pairs.push_back({j == 1 ? 0 : id - 1, id});
          }
        }
        auto m = to_triangles(subdivide_catmull_clark(tube(skeleton_of_pairs(points, pairs, radii)), {.times = 2}));
        const double scale = body > 0.2 ? 1e3 : 1e-3;
        for (const auto v : verts(m)) set_point(m, v, scale * rotated(point(m, v) + vec3{3, 1, 0.5}));
        const auto s = skeleton_of(m);
        check_origins(m, s);
        CHECK(num_cycles(s.skeleton) == 0);
        CHECK(connected_components(s.skeleton).count == 1);
        for (const vec3& tip : tips) {
          double nearest = 1e300;
          for (const auto v : leaves(s.skeleton)) nearest = std::min(nearest, distance(s.skeleton.point(v), scale * rotated(tip + vec3{3, 1, 0.5})) / scale);
          CHECK(nearest < 0.1);
        }
        CHECK(leaves(s.skeleton).size() >= k);
        if (body < 0.2 && k < 5) CHECK(leaves(s.skeleton).size() == k);  // a lump where many limbs meet may have a bone
      }
}

TEST_CASE("skeleton_of: what is like a ball has no cycles") {
  for (const vec3& stretch : {vec3{1, 1, 1}, vec3{1, 1, 6}, vec3{1, 0.3, 4}}) {
    auto m = icosphere(3);
    for (const auto v : verts(m)) set_point(m, v, vec3{stretch.x * point(m, v).x, stretch.y * point(m, v).y, stretch.z * point(m, v).z});
    const auto s = skeleton_of(m);
    check_origins(m, s);
    CHECK(num_cycles(s.skeleton) == 0);
    CHECK(connected_components(s.skeleton).count == 1);
  }
}

TEST_CASE("skeleton_of: components stay apart, and any type of mesh with triangles will do") {
  const auto torus = make_torus<trimesh>({.cells = {20, 8}, .tube_radius = 0.2});
  surface_arrays two{{}, {0}, {}, 0};
  for (const double at : {0.0, 5.0})
    for (const auto v : verts(torus)) two.points.push_back(point(torus, v) + vec3{at, 0, 0});
  for (const std::uint32_t base : {0u, static_cast<std::uint32_t>(num_verts(torus))})
    for (const auto p : polys(torus)) {
      for (const auto v : adj_p2v(torus, p)) two.verts.push_back(vert_id{base + v.raw()});
      two.offsets.push_back(static_cast<std::uint32_t>(two.verts.size()));
    }
  const polygonmesh m(two);
  const auto s = skeleton_of(m);
  check_origins(m, s);
  CHECK(connected_components(s.skeleton).count == 2);
  CHECK(num_cycles(s.skeleton) == 2);
  const auto g = only_embedded_mesh(m);
  CHECK(skeleton_of(g).skeleton == s.skeleton);
  auto large = two;
  for (vec3& x : large.points) x *= 0x1p300;
  const auto scaled = skeleton_of(polygonmesh(large));
  REQUIRE(scaled.skeleton.num_verts() == s.skeleton.num_verts());
  for (const auto v : verts(s.skeleton)) CHECK(scaled.skeleton.point(v) == 0x1p300 * s.skeleton.point(v));
}

TEST_CASE("skeleton_of: refuses surfaces that are not closed or not of triangles, and wrong options") {
  const auto torus = make_torus<trimesh>();
  CHECK_THROWS_AS((void)skeleton_of(trimesh(grid_arrays<trimesh>(2))), invalid_mesh);
  CHECK_THROWS_WITH_AS((void)skeleton_of(trimesh()), "skeleton_of: the surface has no polys", invalid_mesh);
  CHECK_THROWS_WITH_AS((void)skeleton_of(make_torus<quadmesh>()), "skeleton_of: poly 0 has 4 verts; pass to_triangles(m)", unsupported);
  auto bad = make_torus<trimesh>();
  set_point(bad, vert_id{5}, vec3{std::numeric_limits<double>::quiet_NaN(), 0, 0});
  CHECK_THROWS_WITH_AS((void)skeleton_of(bad), "skeleton_of: vert 5 has a coordinate that is not finite", invalid_mesh);
  for (const double area : {0.0, 1.0, std::numeric_limits<double>::quiet_NaN()}) CHECK_THROWS_AS((void)skeleton_of(torus, {.area = area}), invalid_argument);
  CHECK_THROWS_AS((void)skeleton_of(torus, {.max_steps = 0}), invalid_argument);
  const auto stop = [](double, const char*) { return false; };
  CHECK_THROWS_AS((void)skeleton_of(torus, {.progress = stop}), cancelled);
  trimesh flat({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}});
  CHECK_THROWS_WITH_AS((void)skeleton_of(flat), "skeleton_of: the surface has no area", invalid_mesh);
}
