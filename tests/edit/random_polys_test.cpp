// Random edits by the operators on polygons and polyhedra.
#include <concino/mesh.hpp>

#include <support/corpus.hpp>
#include <support/random_poly_edits.hpp>

#include <doctest/doctest.h>

#include <random>
#include <string>

namespace cn = concino;
using namespace cn::testing;

namespace {

template<class M>
void edit(const M& start, unsigned seed, unsigned tries) {
  std::mt19937 random(seed);
  const auto count = edit_polys_at_random(start, random, tries);
  for (unsigned what = 0; what < num_poly_operators; ++what)
    if (what <= p_collapse || cn::VolumeMesh<M>) CHECK_MESSAGE(count.done[what] > 0, "operator " << what);
  std::string counts;
  for (unsigned what = 0; what < num_poly_operators; ++what) counts += " " + std::to_string(count.done[what]) + "/" + std::to_string(count.refused[what]);
  MESSAGE("done/refused:" << counts);
}
/// For each operator, as many as those of triangles and tets in random_edits_test.cpp and random_elements_test.cpp.
unsigned num_tries() { return long_run() ? 1000000 : 10000; }

}  // namespace

TEST_CASE("random edits of polys: polygons") { edit(grid<cn::polygonmesh>(4), 1, num_tries()); }
TEST_CASE("random edits of polys: polyhedra") { edit(grid<cn::polyhedralmesh>(2), 2, num_tries() / 2); }
TEST_CASE("random edits of polys: hexes as polyhedra") { edit(cn::polyhedralmesh(extrude(quad_grid(3), 3)), 3, num_tries() / 2); }
