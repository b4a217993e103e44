// Random edits by every topological operator on triangles and tets, with and without boundary, manifold or not: laws, topology and defects as before, and
// refused edits change nothing.
#include <concino/generate/icosphere.hpp>
#include <concino/mesh.hpp>

#include <support/corpus.hpp>
#include <support/random_edits.hpp>

#include <doctest/doctest.h>

#include <random>

namespace cn = concino;
using namespace cn::testing;

namespace {

/// Each operator is asked `tries` times, and allowed at least once.
template<class M>
void keeps_topology(const M& start, std::mt19937& random, unsigned tries, bool may_flip_tets = true) {
  const auto r = edit_at_random(start, random, tries, num_topological_operators);
  for (unsigned what = 0; what < num_topological_operators; ++what)
    if (has_operator<M>(what) && (may_flip_tets || (what != flip_face && what != flip_edge))) CHECK_MESSAGE(r.done[what] > 0, "operator " << what);
}

/// Different polys on few verts.
template<class M>
M soup_of_different_polys(std::mt19937& random, unsigned verts, unsigned polys) {
  std::set<std::set<unsigned>> different;
  while (different.size() < polys) {
    const auto corners = some_of(random, verts, cn::dimension_v<M> + 1);
    different.insert({corners.begin(), corners.end()});
  }
  std::vector<std::vector<unsigned>> lists;
  for (const auto& p : different) lists.emplace_back(p.begin(), p.end());
  return M(random_points(random, verts), lists);
}

/// For each operator, in all test cases of triangles together, and in those of tets. With those of random_elements_test.cpp they are 10,000.
unsigned num_tries() { return long_run() ? 750000 : 8750; }

}  // namespace

TEST_CASE("random edits: a closed surface") {
  std::mt19937 random(1);
  keeps_topology(cn::icosphere(0), random, num_tries() / 2);
}

TEST_CASE("random edits: a surface with boundary") {
  std::mt19937 random(2);
  keeps_topology(grid<cn::trimesh>(3), random, num_tries() / 4);
}

TEST_CASE("random edits: non-manifold triangles") {
  std::mt19937 random(3);
  for (unsigned round = 0; round < 5; ++round) keeps_topology(soup_of_different_polys<cn::trimesh>(random, 10, 14), random, num_tries() / 20);
}

TEST_CASE("random edits: tets") {
  std::mt19937 random(4);
  keeps_topology(grid<cn::tetmesh>(2), random, num_tries() / 4);
  keeps_topology(grid<cn::tetmesh>(1), random, num_tries() / 2);
}

TEST_CASE("random edits: non-manifold tets") {
  std::mt19937 random(5);
  for (unsigned round = 0; round < 5; ++round) keeps_topology(soup_of_different_polys<cn::tetmesh>(random, 9, 10), random, num_tries() / 20, false);
}
