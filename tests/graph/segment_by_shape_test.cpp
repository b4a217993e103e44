#include <concino/graph/segment_by_shape.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/mesh/boundary.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

/// The cubes of a grid of 6 x 6 x 6 for which keep(i, j, k) is true, as hexes.
template<class F>
hexmesh blocks(const F& keep) {
  std::vector<vec3> points;
  std::vector<std::vector<unsigned>> cells;
  const unsigned n = 6, w = n + 1;
  for (unsigned k = 0; k <= n; ++k)
    for (unsigned j = 0; j <= n; ++j)
      for (unsigned i = 0; i <= n; ++i) points.push_back({i, j, k});
  for (unsigned k = 0; k < n; ++k)
    for (unsigned j = 0; j < n; ++j)
      for (unsigned i = 0; i < n; ++i) {
        if (!keep(i, j, k)) continue;
        std::vector<unsigned> cell;
        for (const unsigned up : {k, k + 1})
          for (const unsigned v : {(up * w + j) * w + i, (up * w + j) * w + i + 1, (up * w + j + 1) * w + i + 1, (up * w + j + 1) * w + i}) cell.push_back(v);
        cells.push_back(cell);
      }
  return hexmesh(points, cells);
}

/// The lengths of the edges between different labels: concave ones, and others.
template<class M, class L>
std::array<double, 2> boundary_lengths(const M& m, const L& label) {
  std::array<double, 2> sum = {};
  for (const auto e : edges(m)) {
    std::set<int> labels;
    for (const auto p : adj_e2p(m, e)) labels.insert(label[p]);
    if (labels.size() > 1) sum[dihedral_angle(m, e) > 3.2 ? 0 : 1] += edge_length(m, e);
  }
  return sum;
}

}  // namespace

TEST_CASE("segment_by_shape: by normals, the parts of a cube are its six squares") {
  const auto cube = blocks([](unsigned, unsigned, unsigned) { return true; });
  const auto s = boundary(cube);
  const auto parts = segment_by_shape(s, {.labels = 6});
  std::map<int, vec3> normal_of;
  for (const auto p : polys(s)) {
    const auto [there, is_new] = normal_of.try_emplace(parts.label[p], normal(s, p));
    if (!is_new) CHECK(dot(there->second, normal(s, p)) == doctest::Approx(1));
  }
  CHECK(normal_of.size() == 6);
  // 12 edges of length 6, with smoothness 0.1 and parts of size 6.
  CHECK(parts.energy == doctest::Approx(12 * 6 * 0.1 * 6));
  // There are no more clusters than different normals.
  CHECK(segment_by_shape(s, {.labels = 9}).energy == doctest::Approx(12 * 6 * 0.1 * std::sqrt(24.0)));
}

TEST_CASE("segment_by_shape: cuts follow concave edges") {
  // A tower on a plate.
  const auto tower = blocks([](unsigned i, unsigned j, unsigned k) { return k < 2 || (i >= 2 && i < 4 && j >= 2 && j < 4); });
  const auto s = boundary(tower);
  const auto parts = segment_by_shape(s, {.labels = 2, .likeness = part_likeness::distance, .smoothness = 1, .concave_cost = 0});
  const auto [concave, other] = boundary_lengths(s, parts.label);
  CHECK(concave == 8);
  CHECK(other == 0);
  for (const auto p : polys(s)) {
    const bool is_top = centroid(s, p).z > 2;
    const bool is_first = parts.label[p] == parts.label[*polys(s).begin()];
    if (is_top) CHECK(!is_first);
  }
}

TEST_CASE_TEMPLATE("segment_by_shape: by distance on every kind, independent of scale", M, CONCINO_KINDS) {
  const M m = grid<M>(4);
  const segment_by_shape_options options = {.labels = 2, .likeness = part_likeness::distance, .smoothness = 0.01};
  const auto parts = segment_by_shape(m, options);
  std::array<std::size_t, 2> sizes = {};
  for (const poly_id p : polys(m)) ++sizes[static_cast<std::size_t>(parts.label[p])];
  CHECK(std::min(sizes[0], sizes[1]) * 4 >= num_polys(m));

  M large = m;
  for (const vert_id v : verts(m)) set_point(large, v, 1024 * to_vec3(point(m, v)));
  const auto same = segment_by_shape(large, options);
  for (const poly_id p : polys(m)) CHECK(same.label[p] == parts.label[p]);
  CHECK(same.energy == doctest::Approx(std::pow(1024, dimension_v<M>) * parts.energy));

  // Without costs of boundaries the clusters stay; they are connected.
  const auto clusters = segment_by_shape(m, {.labels = 3, .likeness = part_likeness::distance, .smoothness = 0});
  CHECK(clusters.energy == 0);
  const auto one = segment_by_shape(m, {.labels = 1, .likeness = part_likeness::distance, .rounds = 0});
  for (const poly_id p : polys(m)) CHECK(one.label[p] == 0);
}

TEST_CASE("segment_by_shape: runs on the archetypes, on empty meshes, and on several components") {
  const auto m = grid<trimesh>(3);
  const auto bare = only_embedded_mesh(m);
  const auto parts = segment_by_shape(m, {.labels = 3, .likeness = part_likeness::distance});
  const auto found = segment_by_shape(bare, {.labels = 3, .likeness = part_likeness::distance});
  CHECK(found.energy == doctest::Approx(parts.energy));
  const quadmesh none;
  CHECK(segment_by_shape(none).energy == 0);
  const auto two = two_grids<quadmesh>(2);
  const auto apart = segment_by_shape(two, {.labels = 2, .likeness = part_likeness::distance});
  for (const poly_id p : polys(two)) CHECK((apart.label[p] == apart.label[poly_id{0}]) == (p.raw() < 4));
  CHECK(segment_by_shape(two).energy == 0);  // all normals are equal
}

TEST_CASE("segment_by_shape: throws if an argument is invalid") {
  const auto m = grid<quadmesh>(2);
  CHECK_THROWS_WITH_AS(segment_by_shape(m, {.labels = 0}), "segment_by_shape: labels must be 1 or more", invalid_argument);
  CHECK_THROWS_WITH_AS(segment_by_shape(m, {.rounds = -1}), "segment_by_shape: rounds must be 0 or more", invalid_argument);
  CHECK_THROWS_WITH_AS(segment_by_shape(m, {.smoothness = -1}), "segment_by_shape: smoothness must be finite and 0 or more", invalid_argument);
  CHECK_THROWS_WITH_AS(segment_by_shape(m, {.concave_cost = 2}), "segment_by_shape: concave_cost must be in [0, 1]", invalid_argument);
  const auto v = grid<hexmesh>(2);
  CHECK_THROWS_WITH_AS(segment_by_shape(v), "segment_by_shape: polys of volumes have no normals; use part_likeness::distance", invalid_argument);
  auto wrong = m;
  set_point(wrong, vert_id{0}, vec3{std::numeric_limits<double>::quiet_NaN(), 0, 0});
  CHECK_THROWS_WITH_AS(segment_by_shape(wrong), "segment_by_shape: a point of poly 0 is not finite, or too far from the others", invalid_mesh);
  CHECK_THROWS_AS(segment_by_shape(m, {.progress = [](double, const char*) { return false; }}), cancelled);
}
