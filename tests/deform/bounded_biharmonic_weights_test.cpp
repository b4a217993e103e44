#include <concino/deform/bounded_biharmonic_weights.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/generate/boundary_surface.hpp>
#include <concino/generate/grid.hpp>
#include <concino/generate/subdivide_1_to_8.hpp>
#include <concino/generate/voxel_hexes.hpp>
#include <concino/geometry/bounding_box.hpp>
#include <concino/io/load.hpp>
#include <concino/mesh/tetmesh.hpp>

#include <support/corpus.hpp>
#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <string>

using namespace concino;
using namespace concino::testing;

namespace {

/// The verts with x = low and x = high.
template<class M>
std::vector<std::vector<vert_t<M>>> two_ends(const M& m, double low, double high) {
  std::vector<std::vector<vert_t<M>>> all(2);
  for (const auto v : verts(m)) {
    if (point(m, v)[0] <= low) all[0].push_back(v);
    if (point(m, v)[0] >= high) all[1].push_back(v);
  }
  return all;
}

}  // namespace

TEST_CASE_TEMPLATE("bounded_biharmonic_weights: of a bar are those of a beam, within the bounds", M, CONCINO_ALL_KINDS) {
  const M m(grid_arrays<M>(4));
  const auto handles = two_ends(m, 0, 1);
  const auto w = bounded_biharmonic_weights(m, handles);
  CHECK(w.num_bones() == 2);
  for (const auto v : verts(m)) {
    const std::size_t i = index_of(m, v);
    const auto row = w.weights(i);
    CHECK(std::abs(std::accumulate(row.begin(), row.end(), 0.0) - 1) < 1e-14);
    for (const double x : row) CHECK((x >= 0 && x <= 1));
    if (point(m, v)[0] == 0) CHECK(w.weight(i, 0) == 1);
    if (point(m, v)[0] == 1) CHECK(w.weight(i, 1) == 1);
  }
  const auto g = only_embedded_mesh(m);
  const auto thin = bounded_biharmonic_weights(g, two_ends(g, 0, 1));
  for (std::size_t i = 0; i < w.num_verts(); ++i) CHECK(thin.weight(i, 0) == doctest::Approx(w.weight(i, 0)).epsilon(1e-6));
}

TEST_CASE("bounded_biharmonic_weights: on voxels are near those on tets") {
  const tetmesh tets = make_grid<tetmesh>({.cells = {16, 8, 8}, .max = {2, 1, 1}});
  const auto surface = boundary_surface(tets);
  const hexmesh voxels = voxel_hexes(surface, 16);
  // balls around two opposite corners; their cells are small beside them
  const auto balls = [](const auto& m) {
    std::vector<std::vector<vert_id>> all(2);
    for (const auto v : verts(m)) {
      if (distance(point(m, v), {0, 0, 0}) < 0.7) all[0].push_back(v);
      if (distance(point(m, v), {2, 1, 1}) < 0.7) all[1].push_back(v);
    }
    return all;
  };
  const auto on_tets = transfer_weights(tets, bounded_biharmonic_weights(tets, balls(tets)), surface);
  const auto on_voxels = transfer_weights(voxels, bounded_biharmonic_weights(voxels, balls(voxels)), surface);
  double worst = 0;
  for (const auto v : verts(surface)) {
    for (const std::size_t j : {0u, 1u}) worst = std::max(worst, std::abs(on_tets.weight(v.raw(), j) - on_voxels.weight(v.raw(), j)));
    const auto row = on_voxels.weights(v.raw());
    CHECK(std::abs(std::accumulate(row.begin(), row.end(), 0.0) - 1) < 1e-14);
  }
  MESSAGE("difference of weights on voxels and on tets: " << worst);
  CHECK(worst < 0.02);
}

TEST_CASE("bounded_biharmonic_weights: on voxels are near those on tets of shapes of the corpus") {
  if (!long_run()) return skip("only in long runs");
  // Handles are balls around the two surface verts that are farthest along a direction; the radius is a part of the longest side of the box.
  struct shape {
    const char* file;
    int refinements;  // of the tets, so that they are accurate enough to compare with
    std::size_t n;    // voxels along the box
    double radius, max_difference, mean_difference;
  };
  for (const shape& one :
       {shape{"tet/cube_tet.vtk", 1, 16, 0.4, 0.02, 0.01}, shape{"fields/kuhn_6.mesh", 1, 16, 0.4, 0.02, 0.01}, shape{"tet/tet_in_box.node", 3, 20, 0.4, 0.02, 0.01},
        shape{"tet/sphere_octant.mesh", 0, 20, 0.3, 0.1, 0.02}}) {
    const std::string file = one.file;
    CAPTURE(file);
    const auto path = corpus(file);
    if (path.empty()) {
      skip(file + " is absent");
      continue;
    }
    tetmesh tets = load<tetmesh>(path);
    for (int i = 0; i < one.refinements; ++i) tets = subdivide_1_to_8(tets);
    const auto surface = boundary_surface(tets);
    const auto box = bounding_box(surface);
    const vec3 sides = box.max - box.min, direction{1, 0.37, 0.11};
    vec3 low = point(surface, vert_id{0}), high = low;
    for (const auto v : verts(surface)) {
      const vec3 p = point(surface, v);
      if (dot(p, direction) < dot(low, direction)) low = p;
      if (dot(p, direction) > dot(high, direction)) high = p;
    }
    const double size = one.radius * std::max({sides.x, sides.y, sides.z});
    const auto weights_on = [&](const auto& volume) {
      std::vector<std::vector<vert_id>> balls(2);
      for (const auto v : verts(volume)) {
        if (distance(point(volume, v), low) < size) balls[0].push_back(v);
        else if (distance(point(volume, v), high) < size) balls[1].push_back(v);
      }
      return transfer_weights(volume, bounded_biharmonic_weights(volume, balls), surface);
    };
    const auto on_tets = weights_on(tets), on_voxels = weights_on(voxel_hexes(surface, one.n));
    double worst = 0, sum = 0;
    for (const auto v : verts(surface)) {
      const double d = std::abs(on_tets.weight(v.raw(), 0) - on_voxels.weight(v.raw(), 0));
      worst = std::max(worst, d);
      sum += d;
    }
    const double mean = sum / static_cast<double>(num_verts(surface));
    MESSAGE(file << ": difference of weights on voxels and on tets: " << worst << ", in the mean " << mean);
    CHECK(worst < one.max_difference);
    CHECK(mean < one.mean_difference);
  }
}

TEST_CASE("bounded_biharmonic_weights, transfer_weights: bad input") {
  const hexmesh m(hex_grid(2));
  constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH_AS((void)bounded_biharmonic_weights(m, std::vector<std::vector<vert_id>>{}), "bounded_biharmonic_weights: there are no handles", invalid_argument);
  CHECK_THROWS_WITH_AS((void)bounded_biharmonic_weights(m, std::vector<std::vector<vert_id>>{{}}), "bounded_biharmonic_weights: handle 0 has no verts", invalid_argument);
  CHECK_THROWS_WITH_AS((void)bounded_biharmonic_weights(m, {{vert_id{0}}, {vert_id{0}}}), "bounded_biharmonic_weights: vert 0 is in handles 0 and 1", invalid_argument);
  CHECK_THROWS_AS((void)bounded_biharmonic_weights(m, {{vert_id{99}}}), invalid_mesh);
  CHECK_THROWS_AS((void)bounded_biharmonic_weights(m, {{vert_id{0}}}, {.min_weight = 0.5}), invalid_argument);
  CHECK_THROWS_AS((void)bounded_biharmonic_weights(m, {{vert_id{0}}}, {.tolerance = not_a_number}), invalid_argument);
  CHECK_THROWS_AS((void)bounded_biharmonic_weights(m, {{vert_id{0}}}, {.max_iterations = 0}), invalid_argument);
  CHECK_THROWS_AS((void)bounded_biharmonic_weights(m, {{vert_id{0}}}, {.progress = [](double, std::string_view) { return false; }}), cancelled);
  const trimesh two(two_grids_arrays<trimesh>(2));
  CHECK_THROWS_WITH_AS((void)bounded_biharmonic_weights(two, {{vert_id{0}}}), "bounded_biharmonic_weights: the component of vert 9 has no vert of a handle", solver_error);
  auto bad = m;
  set_point(bad, vert_id{4}, vec3{not_a_number, 0, 0});
  CHECK_THROWS_AS((void)bounded_biharmonic_weights(bad, {{vert_id{0}}}), invalid_mesh);
  CHECK_THROWS_AS((void)transfer_weights(m, skin_weights(), m), invalid_argument);
  const auto one = bounded_biharmonic_weights(m, {{vert_id{0}}});
  for (const auto v : verts(m)) CHECK(one.weight(v.raw(), 0) == 1);
}
