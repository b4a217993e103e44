#include <concino/deform/heat_weights.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/deform/skin.hpp>

#include <support/closed_surfaces.hpp>
#include <support/kinds.hpp>
#include <support/skeletons.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <set>

using namespace concino;
using namespace concino::testing;

namespace {

surface_arrays bar(int n) {  // n x 1 x 1 voxels, each of 2 x 2 x 2
  std::set<voxel> all;
  for (int i = 0; i < 4 * n; ++i)
    for (int j = 0; j < 4; ++j)
      for (int k = 0; k < 4; ++k) all.insert({i, j, k});
  auto a = voxel_skin(all);
  for (vec3& x : a.points) x = x / 4.0 - vec3{0, 0.5, 0.5};
  return a;
}

}  // namespace

TEST_CASE_TEMPLATE("heat_weights: of a bar with two bones are those of a curve across the joint", M, quadmesh, polygonmesh, trimesh) {
  auto arrays = bar(4);
  if constexpr (std::is_same_v<M, trimesh>) arrays = triangulated(arrays);
  if constexpr (std::is_same_v<M, polygonmesh>) arrays = with_offsets(arrays);
  const M m(arrays);
  const skeleton k = skeleton_of_pairs({{0.25, 0, 0}, {2, 0, 0}, {3.75, 0, 0}}, {{0, 1}, {1, 2}});
  const auto found = heat_weights(m, k);
  const auto& w = found.weights;
  CHECK(w.num_bones() == 2);
  for (const auto v : verts(m)) {
    const std::size_t i = index_of(m, v);
    const auto row = w.weights(i);
    CHECK(std::abs(std::accumulate(row.begin(), row.end(), 0.0) - 1) < 1e-14);
    for (const double x : row) CHECK(x > 0);
    const double x = point(m, v).x;
    if (x < 0.5) CHECK(w.weight(i, 0) > 0.95);
    if (x > 3.5) CHECK(w.weight(i, 1) > 0.95);
    if (x == 2 && !std::is_same_v<M, trimesh>) CHECK(w.weight(i, 0) == doctest::Approx(0.5).epsilon(1e-9));
  }
  const auto g = only_embedded_mesh(m);
  const auto thin = heat_weights(g, k).weights;
  for (std::size_t i = 0; i < w.num_verts(); ++i) CHECK(thin.weight(i, 0) == doctest::Approx(w.weight(i, 0)).epsilon(1e-9));
  // sharper with more heat
  const auto sharp = heat_weights(m, k, {.amount = 10}).weights;
  for (const auto v : verts(m))
    if (point(m, v).x == 1.5) CHECK(sharp.weight(index_of(m, v), 0) > w.weight(index_of(m, v), 0));
  // they bend the bar
  const std::vector<affine_map> bend{affine_map(), rotation({2, 0, 0}, {0, 0, 1}, 1)};
  const auto x = skin(m, w, bend, dual_quaternions);
  for (const auto v : verts(m))
    if (point(m, v).x == 0) CHECK(distance(x[v], point(m, v)) < 0.15);
}

TEST_CASE("heat_weights: a bone does not warm what it does not see") {
  // A U: the bone in one arm is nearest to the inner wall of the other arm only behind two walls.
  const quadmesh m(voxel_skin({{0, 0, 0}, {0, 1, 0}, {0, 2, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}}));
  const skeleton k = skeleton_of_pairs({{0.9, 2.5, 0.5}, {0.9, 0.5, 0.5}, {1.5, 0.5, 0.5}}, {{0, 1}, {1, 2}});
  const auto seen = heat_weights(m, k).weights, all = heat_weights(m, k, {.visible = false}).weights;
  double most_seen = 0, most = 0;
  for (const auto v : verts(m))
    if (point(m, v).x >= 2 && point(m, v).y >= 2) most_seen = std::max(most_seen, seen.weight(v.raw(), 0)), most = std::max(most, all.weight(v.raw(), 0));
  CHECK(most > 0.5);
  CHECK(most_seen < most);
}

TEST_CASE("heat_weights: bad input") {
  const quadmesh m(bar(1));
  const skeleton k = skeleton_of_pairs({{0.2, 0, 0}, {0.8, 0, 0}}, {{0, 1}});
  constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH_AS((void)heat_weights(m, skeleton()), "heat_weights: the skeleton has no edges", invalid_argument);
  CHECK_THROWS_AS((void)heat_weights(m, skeleton_of_pairs({{0, 0, 0}, {not_a_number, 0, 0}}, {{0, 1}})), invalid_argument);
  CHECK_THROWS_AS((void)heat_weights(m, k, {.amount = 0}), invalid_argument);
  CHECK_THROWS_AS((void)heat_weights(m, k, {.amount = not_a_number}), invalid_argument);
  CHECK_THROWS_AS((void)heat_weights(m, k, {.min_weight = 0.5}), invalid_argument);
  CHECK_THROWS_AS((void)heat_weights(m, k, {.progress = [](double, std::string_view) { return false; }}), cancelled);
  // outside, behind a wall of each vert that is far away
  const skeleton out = skeleton_of_pairs({{0.5, 5, 0}, {0.5, 6, 0}}, {{0, 1}});
  CHECK_NOTHROW((void)heat_weights(m, out, {.visible = false}));
  auto bad = m;
  set_point(bad, vert_id{4}, vec3{not_a_number, 0, 0});
  CHECK_THROWS_AS((void)heat_weights(bad, k), invalid_mesh);
  CHECK(heat_weights(quadmesh(), k).weights.num_verts() == 0);
  // verts without polys have the nearest bone; an open surface is fine
  auto with_one_more = triangle_grid(2);
  with_one_more.points.push_back({5, 5, 5});
  const trimesh open(with_one_more);
  const vert_id lonely{9};
  const auto w = heat_weights(open, skeleton_of_pairs({{0.5, 0.5, 1}, {0.5, 0.5, 2}, {0.5, 5, 5}}, {{0, 1}, {1, 2}})).weights;
  CHECK(w.weight(lonely.raw(), 1) == 1);
  // a single bone has all weights
  const auto one = heat_weights(m, k).weights;
  for (const auto v : verts(m)) CHECK(one.weight(v.raw(), 0) == 1);
}
