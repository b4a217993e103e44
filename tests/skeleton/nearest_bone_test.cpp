#include <concino/skeleton/nearest_bone.hpp>

#include <concino/concepts/archetypes.hpp>

#include <support/kinds.hpp>
#include <support/skeletons.hpp>

#include <doctest/doctest.h>

#include <cmath>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("nearest_bone: is the nearest one at each vert, on archetypes too", M, CONCINO_ALL_KINDS) {
  const M m(grid_arrays<M>(4));
  const auto all = bones(y_skeleton());
  const auto nearest = nearest_bone(m, all);
  const auto g = only_embedded_mesh(m);
  const auto same = nearest_bone(g, all);
  for (const auto v : verts(m)) {
    CHECK(same[g.vert(v)] == nearest[v]);
    double best = 1e300, found = 1e300;
    for (std::size_t b = 0; b < all.size(); ++b)
      for (int i = 0; i <= 300; ++i) {
        const double d = distance(sample(all[b], i / 300.0).point, point(m, v));
        best = std::min(best, d);
        if (b == nearest[v]) found = std::min(found, d);
      }
    CHECK(found <= best + 0.01);
  }
}

TEST_CASE("nearest_bone: of bones as near as another it is the first, and there has to be one") {
  const trimesh m(grid_arrays<trimesh>(2));
  const auto all = bones(y_skeleton());
  CHECK(nearest_bone(m, all)[vert_id{0}] == 0);  // the joint
  CHECK(nearest_bone(m, bones(skeleton_of_pairs({{0, 0, 0}, {0, 0, 0}}, {{0, 1}})))[vert_id{1}] == 0);
  CHECK_THROWS_WITH_AS((void)nearest_bone(m, std::vector<bone<skeleton>>()), "nearest_bone: there are no bones", invalid_argument);
  CHECK_THROWS_WITH_AS((void)nearest_bone(m, std::vector<bone<skeleton>>(2)), "nearest_bone: bone 0 has no points", invalid_argument);
}
