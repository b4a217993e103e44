// A replacement of polys that throws std::bad_alloc at any of its allocations changes nothing.
#include <concino/mesh.hpp>

#include <support/all_or_nothing.hpp>
#include <support/cavities.hpp>
#include <support/polyhedra_cavities.hpp>

#include <doctest/doctest.h>

#include <random>

namespace cn = concino;
using cn::testing::all_or_nothing;

namespace {

template<class M>
cn::testing::owned_cavity cavity_in(const M& m, std::mt19937& random) {
  if constexpr (std::same_as<M, cn::polyhedralmesh>) return cn::testing::random_polyhedra(m, random);
  else return cn::testing::random_cavity(m, random);
}

}  // namespace

TEST_CASE_TEMPLATE("rewire that runs out of memory changes nothing", M, cn::trimesh, cn::polygonmesh, cn::tetmesh, cn::hexmesh, cn::polyhedralmesh) {
  std::mt19937 random(31);
  for (const bool grid : {true, false}) {
    M m = grid ? cn::testing::grid<M>(2) : cn::testing::random_soup<M>(random, 11, 12).mesh();
    cn::testing::give_properties(m);
    std::size_t failed = 0;
    for (unsigned step = 0; step < 16; ++step) {
      const auto c = cavity_in(m, random);
      failed += all_or_nothing(m, [&](M& x) { c.apply_to(x); });
      c.apply_to(m);
    }
    CHECK(failed > 100);
    cn::testing::keeps_all_laws(m);
  }
}

TEST_CASE_TEMPLATE("rewire of a large cavity that runs out of memory changes nothing", M, cn::trimesh, cn::tetmesh) {
  std::mt19937 random(32);
  M m = cn::testing::grid<M>(3);
  cn::testing::give_properties(m);
  cn::testing::owned_cavity c;
  for (const auto p : cn::polys(m)) c.polys.push_back(p);
  for (const auto v : cn::verts(m)) c.verts.push_back(v);
  for (unsigned i = 0; i < 60; ++i) c.add_poly(cn::testing::some_of(random, static_cast<unsigned>(c.verts.size()), cn::arity_v<M>));
  c.kept = 10;
  all_or_nothing(m, [&](M& x) { c.apply_to(x); });
}
