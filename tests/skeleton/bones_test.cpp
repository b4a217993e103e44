#include <concino/skeleton/bones.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/io/skeleton.hpp>
#include <concino/mesh/element_map.hpp>
#include <concino/mesh/polygonmesh.hpp>

#include <support/corpus.hpp>
#include <support/kinds.hpp>
#include <support/skeletons.hpp>

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <set>

using namespace concino;
using namespace concino::testing;

namespace {

/// Each edge is in one bone; ends are leaves or joints; what is between them has two neighbours.
template<class M>
void check_bones(const M& g) {
  std::set<std::array<std::size_t, 2>> seen;
  for (const auto& b : bones(g)) {
    REQUIRE(b.verts.size() >= 2);
    REQUIRE(b.points.size() == b.verts.size());
    for (std::size_t i = 0; i + 1 < b.verts.size(); ++i) {
      const std::size_t v = index_of(g, b.verts[i]), w = index_of(g, b.verts[i + 1]);
      CHECK(seen.insert({std::min(v, w), std::max(v, w)}).second);
      bool joined = false;
      for (const auto n : adj_v2v(g, b.verts[i])) joined = joined || index_of(g, n) == w;
      CHECK(joined);
      if (i > 0) CHECK(num_elements(adj_v2v(g, b.verts[i])) == 2);
    }
    const bool ends = num_elements(adj_v2v(g, b.verts.front())) != 2 && num_elements(adj_v2v(g, b.verts.back())) != 2;
    CHECK((ends || b.verts.front() == b.verts.back()));
    CHECK((b.verts.front() == b.verts.back()) == b.is_cycle());
  }
  std::size_t twice = 0, num_leaves = 0, num_joints = 0;
  for (const auto v : verts(g)) {
    const std::size_t n = num_elements(adj_v2v(g, v));
    twice += n, num_leaves += n == 1, num_joints += n >= 3;
  }
  CHECK(2 * seen.size() == twice);
  CHECK(leaves(g).size() == num_leaves);
  CHECK(joints(g).size() == num_joints);
}

}  // namespace

TEST_CASE("bones: a Y has three and a joint, a cycle is one, and so is a path") {
  const skeleton y = y_skeleton();
  check_bones(y);
  CHECK(bones(y).size() == 3);
  CHECK(joints(y) == std::vector<vert_id>{vert_id{0}});
  CHECK(leaves(y).size() == 3);
  CHECK(bones(y)[0].verts == std::vector<vert_id>{vert_id{0}, vert_id{1}, vert_id{2}});
  const auto cycle = bones(cycle_skeleton(7));
  REQUIRE(cycle.size() == 1);
  CHECK(cycle[0].is_cycle());
  CHECK(cycle[0].verts.size() == 8);
  CHECK(leaves(cycle_skeleton(7)).empty());
  CHECK(joints(cycle_skeleton(7)).empty());
  CHECK(bones(skeleton({{0, 0, 0}, {1, 0, 0}, {3, 0, 0}}, {{vert_id{1}, vert_id{0}}, {vert_id{1}, vert_id{2}}})).size() == 1);
  CHECK(bones(skeleton()).empty());
  CHECK(bones(skeleton({{1, 2, 3}})).empty());
  check_bones(theta_skeleton());
  CHECK(bones(theta_skeleton()).size() == 4);  // three between the joints, and a cycle at one of them
}

TEST_CASE("bones: partition the edges of the skeletons of the corpus") {
  for (const char* file : {"skeletons/cactus.skel", "skeletons/stickwoman.cg", "skeletons/moebius.cg"}) {
    const auto path = corpus(file);
    if (path.empty()) {
      skip(std::string(file) + " is absent");
      continue;
    }
    CAPTURE(file);
    const skeleton k = load_skeleton(path);
    check_bones(k);
    std::size_t n = 0;
    for (const auto& b : bones(load_skeleton(path))) {
      n += b.verts.size() - 1;
      CHECK(norm(sample(b, 0.5).point) < 1e9);
    }
    CHECK(n == k.num_edges());
  }
}

TEST_CASE("bones: of random graphs") {
  std::mt19937 random(4);
  for (int round = 0; round < 200; ++round) {
    const std::size_t n = 1 + static_cast<std::size_t>(round % 20);
    std::uniform_int_distribution<std::uint32_t> vert(0, static_cast<std::uint32_t>(n - 1));
    std::set<std::array<std::uint32_t, 2>> pairs;
    for (std::size_t i = 0; i < n + n / 4; ++i)
      if (const auto a = vert(random), b = vert(random); a < b) pairs.insert({a, b});
    std::vector<std::array<vert_id, 2>> pairs_of_verts;
    for (const auto& [a, b] : pairs) pairs_of_verts.push_back({vert_id{a}, vert_id{b}});
    std::vector<vec3> points;
    for (std::size_t i = 0; i < n; ++i) points.push_back({i, i * i % 7, 0});
    check_bones(skeleton(points, pairs_of_verts));
  }
}

TEST_CASE_TEMPLATE("bones: of the edges of meshes, and on archetypes", M, CONCINO_ALL_KINDS) {
  const M m(grid_arrays<M>(2));
  check_bones(m);
  const auto g = only_embedded_mesh(m);
  CHECK(bones(g).size() == bones(m).size());
  CHECK(joints(g).size() == joints(m).size());
  CHECK(leaves(g).size() == leaves(m).size());
}

TEST_CASE("bones: radii of a map, and values that are not finite") {
  const skeleton y = y_skeleton();
  std::vector<double> r(y.num_verts(), 2);
  const auto radius = make_vert_map<double>(y, 2.0);
  CHECK(bones(y, radius)[1].radii == std::vector<double>(bones(y)[1].verts.size(), 2));
  CHECK(bones(skeleton(y.points(), y.edges()))[0].radii.empty());
  auto bad = make_vert_map<double>(y, 1.0);
  bad[vert_id{1}] = -1;
  CHECK_THROWS_WITH_AS((void)bones(y, bad), "bones: vert 1 has a radius that is negative or not finite", invalid_argument);
  auto points = y.points();
  points[2].y = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH_AS((void)bones(skeleton(points, y.edges())), "bones: vert 2 has a coordinate that is not finite", invalid_mesh);
}
