#include <concino/level_sets/detail/simple_lines.hpp>

#include <concino/generate/icosphere.hpp>
#include <concino/level_sets/isolines.hpp>
#include <concino/mesh/polygonmesh.hpp>

#include <support/kinds.hpp>
#include <support/level_sets.hpp>
#include <support/random_meshes.hpp>
#include <support/threads.hpp>

#include <doctest/doctest.h>

#include <random>
#include <variant>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

/// Whether the fast way applies; if so, its lines have to be those of the general way.
template<class M, class U>
bool compare_ways(const M& m, const U& u, double level) {
  const auto states = detail::level_states(m, u, level, "test");
  const auto polys = detail::crossed_polys(m, states);
  detail::simple_lines<M> simple;
  if (!simple.find(m, states.data(), polys)) return false;
  const detail::crossed_surface_reader<M> crossed(m, u, level, polys);
  const detail::poly_cuts cuts(crossed.arrays, level);
  const detail::level_lines fast = simple.join(), general = detail::line_pieces(cuts).join();
  CHECK(fast.ends == general.ends);
  CHECK(fast.closed == general.closed);
  REQUIRE(fast.places.size() == general.places.size());
  std::size_t next = 0, different = 0;
  for (const auto& line : isolines(m, u, level))
    for (std::size_t i = 0; i < line.places.size(); ++i, ++next) {
      REQUIRE(next < general.places.size());
      const auto expected = crossed.mesh_point_of(m, general.places[next], level);
      const auto &a = std::get<edge_point<M>>(expected.element), &b = std::get<edge_point<M>>(line.places[i].element);
      different += a.edge != b.edge || a.parameter != b.parameter || norm(expected.position - line.points[i]) != 0 ||
                   norm(expected.position - line.places[i].position) != 0 || simple.edge_of(fast.places[next].element) != a.edge;
    }
  CHECK(next == general.places.size());
  CHECK(different == 0);
  return true;
}

}  // namespace

TEST_CASE_TEMPLATE("simple_lines: the lines of the general way, to the bit", M, CONCINO_SURFACE_KINDS) {
  std::mt19937 random(1);
  int simple = 0;
  for (int i = 0; i < 300; ++i) {
    const M m = i % 2 == 0 ? mesh_to_cut<M>(random) : grid_to_cut<M>(random, 3);
    simple += compare_ways(m, random_values(m, random, false), 1.0);
    compare_ways(m, random_values(m, random, true), 1.0);
  }
  CHECK(simple > 5);
}

TEST_CASE("simple_lines: three polys at an edge, polys turned over, and two polys with the same verts") {
  const std::vector<vec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {1, 1, 0}};
  using lists = std::vector<std::vector<unsigned>>;
  std::mt19937 random(2);
  std::uniform_real_distribution<double> value(0, 2);
  const lists surfaces[] = {
      {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {1, 5, 2}}, {{0, 1, 2}, {0, 1, 3}}, {{0, 1, 2}, {2, 5, 1}}, {{0, 1, 2}, {0, 2, 1}}, {{0, 1, 2}, {0, 1, 2}, {1, 0, 3}},
  };
  for (const lists& list : surfaces) {
    const polygonmesh m(points, list);
    auto u = make_vert_map<double>(m);
    int simple = 0;
    for (int i = 0; i < 50; ++i) {
      for (const auto v : verts(m)) u[v] = value(random);
      simple += compare_ways(m, u, 1.0);
    }
    CHECK(simple == 50);
  }
}

TEST_CASE("simple_lines: refuse verts on the level set, polygons that are not convex, and saddles") {
  const polygonmesh dart({{0, 0, 0}, {2, 1, 0}, {0, 2, 0}, {1, 1, 0}}, {{0, 1, 2, 3}}), square({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}});
  const auto is_simple = [](const polygonmesh& m, std::vector<double> values) {
    auto u = make_vert_map<double>(m);
    for (const auto v : verts(m)) u[v] = values[v.raw()];
    return compare_ways(m, u, 1.0);
  };
  CHECK(is_simple(square, {0, 0, 2, 2}));
  CHECK(is_simple(square, {0, 2, 2, 2}));
  CHECK_FALSE(is_simple(square, {0, 2, 0, 2}));
  CHECK_FALSE(is_simple(square, {0, 1, 2, 2}));
  CHECK_FALSE(is_simple(dart, {0, 0, 2, 2}));
}

TEST_CASE("isolines: the same for any number of threads") {
  const auto m = icosphere(6);
  auto u = make_vert_map<double>(m);
  for (const auto v : verts(m)) u[v] = point(m, v).x * point(m, v).y + 0.3 * point(m, v).z;
  CHECK(compare_ways(m, u, 0.1));  // some lines of more than 256 points, which are located in parts
  for (const double level : {0.1, 0.0}) {
    const auto with = [&](int threads) {
      const with_num_threads fixed(threads);
      const core::thread_team team(true);
      return isolines(m, u, level);
    };
    const auto one = with(1), three = with(3);
    REQUIRE(one.size() == three.size());
    std::size_t different = 0;
    for (std::size_t i = 0; i < one.size(); ++i) {
      REQUIRE(one[i].points.size() == three[i].points.size());
      REQUIRE(one[i].edge_points.size() == three[i].edge_points.size());
      for (std::size_t k = 0; k < one[i].points.size(); ++k) different += norm(one[i].points[k] - three[i].points[k]) != 0;
      for (std::size_t k = 0; k < one[i].edge_points.size(); ++k) different += one[i].edge_points[k].edge != three[i].edge_points[k].edge;
    }
    CHECK(different == 0);
  }
}
