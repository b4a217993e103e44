#include <concino/deform/bounded_biharmonic_weights.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/generate/boundary_surface.hpp>
#include <concino/generate/grid.hpp>
#include <concino/generate/voxel_hexes.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numeric>

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
