// The functions of deform open scopes in a profiler.
#include <concino/deform/bounded_biharmonic_weights.hpp>
#include <concino/deform/heat_weights.hpp>
#include <concino/deform/prepare_deform.hpp>
#include <concino/mesh/trimesh.hpp>

#include <support/meshes.hpp>
#include <support/profiled.hpp>
#include <support/skeletons.hpp>

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace concino;
using namespace concino::testing;

TEST_CASE("profiler: prepare_deform and weights open scopes") {
  const trimesh m(triangle_grid(2));
  profiler p;
  (void)prepare_deform(m, {vert_id{0}}, {.profiler = &p});
  CHECK(names_of(p).front() == "prepare_deform");
  profiler q;
  (void)heat_weights(m, skeleton_of_pairs({{0, 0, 1}, {1, 1, 1}}, {{0, 1}}), {.profiler = &q});
  CHECK(names_of(q).front() == "heat_weights");
  profiler r;
  (void)bounded_biharmonic_weights(m, {{vert_id{0}}, {vert_id{8}}}, {.profiler = &r});
  CHECK(names_of(r).front() == "bounded_biharmonic_weights");
}
