// Gradients and divergences on generated families: Voronoi cells, duals, concave agglomerates, graded and distorted grids.
#include <concino/operators/divergence_matrix.hpp>
#include <concino/operators/gradient_matrix.hpp>

#include <concino/generate.hpp>

#include <support/fields.hpp>
#include <support/kinds.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

namespace {

template<class M>
void check_operators(const M& m) {
  CHECK(linear_error(m, gradient_matrix(m)) < 1);
  CHECK(constant_divergence(m, divergence_matrix(m)) < 1e-13);
}

}  // namespace

TEST_CASE_TEMPLATE("gradients and divergences are exact on graded and distorted grids", M, CONCINO_KINDS) {
  auto m = make_grid<M>({.cells = {4, 3, 5}, .min = {-1, 0, 100}, .max = {2, 1, 101}});
  check_operators(m);
  jitter(m, 0.15);
  check_operators(m);
  auto graded = make_grid<M>({.cells = {5, 4, 3}});
  grade(graded, {2, 1, 1.5});
  check_operators(graded);
}

TEST_CASE("gradients and divergences are exact on Voronoi, dual and concave polygons") {
  const box square{{0, 0, 0}, {1, 1, 0}};
  check_operators(voronoi_polygons(random_points(60, square), square));
  auto triangles = make_grid<trimesh>({.cells = {8, 8, 1}});
  jitter(triangles, 0.2);
  check_operators(dual_mesh(triangles));
  check_operators(agglomerate(triangles, random_labels(triangles, 8)));
}

TEST_CASE("gradients and divergences are exact on Voronoi, dual and concave polyhedra") {
  const box cube{{0, 0, 0}, {1, 1, 1}};
  check_operators(voronoi_polyhedra(random_points(40, cube), cube));
  auto tets = make_grid<tetmesh>({.cells = {3, 3, 3}});
  jitter(tets, 0.1);
  check_operators(dual_mesh(tets));
  check_operators(agglomerate(tets, random_labels(tets, 6)));
}
