#include <concino/skeleton/respace.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/mesh/polygonmesh.hpp>

#include <support/kinds.hpp>
#include <support/skeletons.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace concino;
using namespace concino::testing;

namespace {

std::size_t num_cycles(const skeleton& k, std::size_t num_components) { return k.num_edges() + num_components - k.num_verts(); }

}  // namespace

TEST_CASE("respace: bones have evenly spaced verts, and leaves and joints remain") {
  const skeleton y = y_skeleton(), r = respace(y, 0.5);
  CHECK(bones(r).size() == 3);
  CHECK(r.num_edges() == 18);
  CHECK(r.num_verts() == 19);
  for (const auto& b : bones(r)) {
    CHECK(length(b) == doctest::Approx(3));
    for (std::size_t i = 0; i + 1 < b.points.size(); ++i) CHECK(distance(b.points[i], b.points[i + 1]) == doctest::Approx(0.5));
  }
  CHECK(bones(r)[0].radii[1] == doctest::Approx(0.35));
  CHECK(r.point(vert_id{0}) == y.point(vert_id{0}));
  CHECK(joints(r).size() == 1);
  const skeleton coarse = respace(y, 100);
  CHECK(coarse.num_edges() == 3);
  CHECK(bones(coarse).size() == 3);
}

TEST_CASE("respace: keeps the cycles, however coarse it is") {
  CHECK(respace(cycle_skeleton(20), 100).num_edges() == 3);
  CHECK(num_cycles(respace(cycle_skeleton(20), 0.1), 1) == 1);
  CHECK(num_cycles(theta_skeleton(), 2) == 3);
  for (const double spacing : {100.0, 1.0, 0.1}) {
    const skeleton r = respace(theta_skeleton(), spacing);
    CHECK(num_cycles(r, 2) == 3);
    CHECK(bones(r).size() == 4);
    CHECK(leaves(r).empty());
    CHECK(r.num_verts() >= 7);
  }
  CHECK(!respace(skeleton({{0, 0, 0}, {1, 0, 0}}, {{vert_id{0}, vert_id{1}}}), 0.25).has_radii());
}

TEST_CASE_TEMPLATE("respace: of the edges of meshes, and on the archetype", M, trimesh, hexmesh) {
  const M m(grid_arrays<M>(2));
  CHECK(respace(m, 0.1) == respace(only_embedded_mesh(m), 0.1));
  CHECK(respace(m, 0.1).num_edges() > 2 * num_edges(m));
}

TEST_CASE("split_bone: adds a vert on an edge, or finds one") {
  const skeleton y = y_skeleton();
  const auto b = bones(y)[1];
  const auto s = split_bone(y, b, 0.5);
  CHECK(s.is_added);
  CHECK(s.vert == vert_id{7});
  CHECK(s.result.point(s.vert) == vec3{0, 1.5, 0});
  CHECK(s.result.radius(s.vert) == doctest::Approx(0.275));
  CHECK(s.result.num_edges() == y.num_edges() + 1);
  CHECK(bones(s.result).size() == 3);
  CHECK(bones(s.result)[1].verts.size() == b.verts.size() + 1);
  const auto end = split_bone(y, b, 1);
  CHECK(!end.is_added);
  CHECK(end.vert == b.verts.back());
  CHECK(end.result == y);
  CHECK(split_bone(y, b, 1.0 / 3).vert == b.verts[1]);
  const skeleton c = cycle_skeleton(5);
  CHECK(bones(split_bone(c, bones(c)[0], 0.55).result).size() == 1);
}

TEST_CASE("respace and split_bone: refuse what makes no sense") {
  const skeleton y = y_skeleton();
  for (const double spacing : {0.0, -1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    CHECK_THROWS_AS((void)respace(y, spacing), invalid_argument);
  CHECK_THROWS_AS((void)respace(y, 1e-200), invalid_argument);
  auto other = bones(y)[0];
  other.verts[1] = vert_id{4};
  CHECK_THROWS_WITH_AS((void)split_bone(y, other, 0.1), "split_bone: verts 0 and 4 are not joined in the skeleton; pass one of bones(k)", invalid_argument);
  other.verts[1] = vert_id{40};
  CHECK_THROWS_AS((void)split_bone(y, other, 0.1), invalid_argument);
  CHECK_THROWS_AS((void)split_bone(y, bone<skeleton>(), 0.1), invalid_argument);
  CHECK_THROWS_AS((void)split_bone(y, bones(y)[0], 2), invalid_argument);
}
