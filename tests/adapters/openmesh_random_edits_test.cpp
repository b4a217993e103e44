// Random edits of OpenMesh's meshes by every operator: numbers of elements, areas and values of properties as the laws say, and refused edits change nothing.
#include <support/openmesh.hpp>
#include <support/random_edits.hpp>
#include <support/random_poly_edits.hpp>

#include <random>
#include <tuple>

using namespace concino;
using namespace concino::testing::om;
namespace ct = concino::testing;

TEST_CASE_TEMPLATE("OpenMesh: random edits by every operator", M, tri_double, poly_double) {
  std::mt19937 random(12);
  M m;
  fill(m, two_grids<tri_double>(2));  // the topological operators need triangles
  OpenMesh::VPropHandleT<int> v;
  OpenMesh::EPropHandleT<int> e;
  OpenMesh::FPropHandleT<int> p;
  m.add_property(v), m.add_property(e), m.add_property(p);
  const auto maps_of = [&](M& x) { return std::tuple(as_map(x, v), as_map(x, e), as_map(x, p)); };
  ct::edits_of_all_kinds(m, random, ct::kept_values<decltype(maps_of)>{maps_of});
}

TEST_CASE("OpenMesh: random edits of polygons") {
  std::mt19937 random(13);
  poly_double m;
  fill(m, ct::polygon_grid(3));
  const auto count = ct::edit_polys_at_random(m, random, ct::long_run() ? 1000000 : 10000);
  for (unsigned what = 0; what <= ct::p_collapse; ++what) CHECK_MESSAGE(count.done[what] > 0, "operator " << what);
}
