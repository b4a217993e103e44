// check_laws on the six native meshes: connected, with two components and an isolated vert, empty, non-manifold; and on every archetype.
#include <concino/concepts/archetypes.hpp>
#include <concino/validate.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace cn = concino;

namespace {

template<class M>
void keeps_all_laws(const M& m) {
  const auto found = cn::check_laws(m);
  for (const auto& b : found) MESSAGE(b.law << ": " << b.what << " [" << b.witness << "]");
  CHECK(found.empty());
}

}  // namespace

TEST_CASE_TEMPLATE("check_laws: native meshes obey all laws", M, CONCINO_KINDS) {
  keeps_all_laws(M());
  for (unsigned n : {1u, 2u, 3u, 5u}) keeps_all_laws(cn::testing::grid<M>(n));
  keeps_all_laws(cn::testing::two_grids<M>(2));
}

TEST_CASE_TEMPLATE("check_laws: archetypes of native meshes obey all laws", M, concino::trimesh, concino::polyhedralmesh) {
  const M two = cn::testing::two_grids<M>(2);
  keeps_all_laws(cn::only_primal_graph(two));
  keeps_all_laws(cn::only_embedded_graph(two));
  keeps_all_laws(cn::only_dual_graph(two));
  keeps_all_laws(cn::only_graphs(two));
  keeps_all_laws(cn::only_mesh(two));
  keeps_all_laws(cn::only_embedded_mesh(two));
  if constexpr (cn::arity_v<M> > 0) keeps_all_laws(cn::only_fixed_arity_mesh(two));
}

TEST_CASE("check_laws: non-manifold surfaces obey all laws") {
  // Three polys at an edge, two of them with the same orientation; two fans that share a vert; the same poly twice.
  const std::vector<cn::vec3> x{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}, {-1, -1, 0}, {-1, 0, 0}};
  keeps_all_laws(cn::trimesh(x, std::vector<std::array<int, 3>>{{0, 1, 2}, {0, 1, 3}, {1, 0, 4}, {0, 5, 6}, {0, 6, 5}, {0, 5, 6}}));
  keeps_all_laws(
      cn::polygonmesh(x, std::vector<std::vector<int>>{{0, 1, 2}, {0, 1, 3}, {1, 0, 4}, {0, 4, 5, 6}, {0, 4, 5, 6}, {0, 1, 4, 5}}));
  keeps_all_laws(cn::quadmesh(x, std::vector<std::array<int, 4>>{{0, 1, 2, 3}, {0, 1, 4, 5}, {0, 1, 6, 5}, {0, 1, 2, 3}}));
}

TEST_CASE("check_laws: non-manifold volumes obey all laws") {
  const std::vector<cn::vec3> x{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}, {1, 1, 1}, {9, 9, 9}};
  // Three tets at a face, one of them inverted, and one that only shares an edge.
  keeps_all_laws(cn::tetmesh(x, std::vector<std::array<int, 4>>{{0, 1, 2, 3}, {0, 2, 1, 4}, {0, 1, 2, 5}, {0, 3, 4, 6}}));
  keeps_all_laws(cn::tetmesh(x, std::vector<std::array<int, 4>>{{0, 1, 2, 3}, {0, 1, 2, 3}}));
  // A poly that is not closed, and a face without polys.
  using faces = std::vector<std::vector<int>>;
  using cells = std::vector<std::vector<std::pair<int, bool>>>;
  keeps_all_laws(cn::polyhedralmesh(x, faces{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}, {1, 2, 5}},
                                    cells{{{0, true}, {1, true}, {2, true}, {3, true}}, {{3, false}, {0, false}}}));
}

TEST_CASE("check_laws: a native mesh with a point that is not finite breaks only EM1") {
  cn::trimesh m = cn::testing::grid<cn::trimesh>(2);
  cn::set_point(m, cn::vert_id{3}, cn::vec3{0, std::nan(""), 0});
  const auto found = cn::check_laws(m);
  REQUIRE(found.size() == 1);
  CHECK(found[0].law == "EM1");
  CHECK(found[0].witness == "v3");
}
