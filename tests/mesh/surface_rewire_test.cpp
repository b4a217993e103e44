// rewire of the native surfaces: after any replacement of polys the mesh obeys all laws and equals a newly constructed mesh, what is not in the cavity keeps
// its descriptors, and a cavity that is refused changes nothing.
#include <concino/core/error.hpp>
#include <concino/mesh.hpp>

#include <support/cavities.hpp>
#include <support/corpus.hpp>
#include <support/whole_mesh.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <set>
#include <vector>

namespace cn = concino;
using cn::testing::equals_rebuilt;
using cn::testing::keeps_all_laws;
using cn::testing::owned_cavity;
using cn::testing::rewires_as_told;

namespace {

}  // namespace

TEST_CASE_TEMPLATE("rewire: random cavities of random meshes give the mesh that they describe", M, CONCINO_ALL_SURFACE_KINDS) {
  std::mt19937 random(11);
  const unsigned rounds = cn::testing::long_run() ? 300 : 12;
  for (unsigned round = 0; round < rounds; ++round) {
    M m = round % 2 ? cn::testing::grid<M>(3) : cn::testing::random_soup<M>(random, 12, 14).mesh();
    for (unsigned step = 0; step < 40; ++step) {
      rewires_as_told(m, cn::testing::random_cavity(m, random));
      if (step % 4 == 0) keeps_all_laws(m);
    }
    keeps_all_laws(m);
    equals_rebuilt(m);
  }
}

TEST_CASE("rewire: long polygons, many of them at one edge") {
  std::mt19937 random(12);
  for (unsigned round = 0; round < 6; ++round) {
    cn::polygonmesh m(std::vector<cn::vec3>(60), std::vector<std::vector<unsigned>>{});
    for (unsigned step = 0; step < 12; ++step) {
      owned_cavity c;
      for (unsigned i = 0; i < 60; ++i) c.verts.push_back(cn::vert_id{i});
      for (const auto p : cn::polys(m))
        if (random() % 3 == 0) c.polys.push_back(p);
      for (auto i = random() % 4; i > 0; --i) {
        std::vector<unsigned> v = cn::testing::some_of(random, 60, 3 + static_cast<unsigned>(random() % 50));
        if (random() % 2 == 0) std::sort(v.begin(), v.end());
        c.add_poly(v);
      }
      c.kept = random() % (1 + std::min(c.polys.size(), c.ends.size()));
      rewires_as_told(m, c);
    }
    keeps_all_laws(m);
    equals_rebuilt(m);
  }
}

TEST_CASE("rewire: an edge of old polys that no poly has afterwards gives its descriptor to a new edge") {
  cn::trimesh m({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  owned_cavity c{{cn::poly_id{0}, cn::poly_id{1}}, {cn::vert_id{0}, cn::vert_id{1}, cn::vert_id{2}, cn::vert_id{3}}, {}, {}, {}, 2, 0};
  c.add_poly({0, 1, 3});
  c.add_poly({1, 2, 3});
  for (unsigned round = 0; round < 5; ++round) {
    rewires_as_told(m, c);
    CHECK(cn::edge_index_bound(m) == 5);
    CHECK(cn::poly_index_bound(m) == 2);
    owned_cavity back = c;
    back.corners.clear(), back.ends.clear();
    back.add_poly({0, 1, 2});
    back.add_poly({0, 2, 3});
    rewires_as_told(m, back);
  }
  keeps_all_laws(m);
}

TEST_CASE_TEMPLATE("rewire: a cavity with a mistake is refused, and nothing changes", M, CONCINO_SURFACE_KINDS) {
  cn::testing::refuses_mistakes(cn::testing::grid<M>(3));
}
