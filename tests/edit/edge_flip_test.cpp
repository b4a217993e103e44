// edge_flip: the new edge and triangles, and each reason for which it is refused.
#include <concino/edit/edge_flip.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/mesh.hpp>

#include <support/kinds.hpp>
#include <support/rebuilt.hpp>
#include <support/whole_mesh.hpp>

#include <doctest/doctest.h>

#include <random>

namespace cn = concino;
using cn::testing::equals_rebuilt;
using cn::testing::keeps_all_laws;
using cn::testing::raw;

namespace {

template<class M>
cn::edge_id edge_of(const M& m, unsigned a, unsigned b) {
  for (const auto e : cn::edges(m))
    if (raw(cn::adj_e2v(m, e)) == std::vector<unsigned>{a, b}) return e;
  return {};
}

void is_refused(cn::trimesh m, unsigned a, unsigned b, cn::refusal reason) {
  const auto before = cn::testing::whole(m);
  const cn::edge_id e = edge_of(m, a, b);
  CHECK(cn::can_edge_flip(m, e).reason == reason);
  const auto made = cn::edge_flip(m, e);
  CHECK(made.reason == reason);
  CHECK_FALSE(made.why.empty());
  CHECK(cn::testing::whole(m) == before);
}

}  // namespace

TEST_CASE("edge_flip: the diagonal of a square") {
  cn::trimesh m({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  REQUIRE(cn::can_edge_flip(m, edge_of(m, 0, 2)));
  const auto made = cn::edge_flip(m, edge_of(m, 0, 2));
  REQUIRE(made);
  CHECK(raw(cn::adj_e2v(m, made.edge)) == std::vector<unsigned>{1, 3});
  CHECK(raw(cn::adj_p2v(m, cn::poly_id{0})) == std::vector<unsigned>{0, 1, 3});
  CHECK(raw(cn::adj_p2v(m, cn::poly_id{1})) == std::vector<unsigned>{1, 2, 3});
  CHECK(cn::total_measure(m) == doctest::Approx(1));
  keeps_all_laws(m);
}

TEST_CASE("edge_flip: twice gives the same triangles again") {
  std::mt19937 random(3);
  const cn::trimesh before = cn::testing::grid<cn::trimesh>(5);
  cn::trimesh m = before;
  for (unsigned i = 0; i < 100; ++i) {
    const cn::edge_id e{random() % cn::edge_index_bound(m)};
    const auto old = raw(cn::adj_e2v(m, e));
    if (const auto once = cn::edge_flip(m, e)) {
      const auto twice = cn::edge_flip(m, once.edge);
      REQUIRE(twice);
      CHECK(raw(cn::adj_e2v(m, twice.edge)) == old);
    }
  }
  CHECK(cn::num_edges(m) == cn::num_edges(before));
  CHECK(cn::edge_index_bound(m) == cn::edge_index_bound(before));
  const auto triangles = [](const cn::trimesh& x) {  // two flips may exchange the descriptors of the triangles
    std::set<std::set<unsigned>> all;
    for (const auto p : cn::polys(x)) all.insert(cn::testing::raw_set(cn::adj_p2v(x, p)));
    return all;
  };
  CHECK(triangles(m) == triangles(before));
  equals_rebuilt(m);
}

TEST_CASE("edge_flip: what is refused") {
  const std::vector<cn::vec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  using lists = std::vector<std::vector<unsigned>>;
  is_refused({points, lists{{0, 1, 2}}}, 0, 1, cn::refusal::wrong_number);                           // one triangle
  is_refused({points, lists{{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}}, 0, 1, cn::refusal::wrong_number);      // three
  is_refused({points, lists{{0, 1, 2}, {0, 1, 3}}}, 0, 1, cn::refusal::winding);
  is_refused({points, lists{{0, 1, 2}, {1, 0, 2}}}, 0, 1, cn::refusal::same_verts);                   // both have the same opposite vert
  is_refused({points, lists{{0, 1, 2}, {1, 0, 3}, {2, 3, 4}}}, 0, 1, cn::refusal::same_verts);        // 2 and 3 are joined
  is_refused({points, lists{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}}, 0, 1, cn::refusal::same_verts);  // a tetrahedron
  cn::quadmesh q = cn::testing::grid<cn::quadmesh>(2);
  for (const auto e : cn::edges(q))
    if (cn::num_elements(cn::adj_e2p(q, e)) == 2) CHECK(cn::edge_flip(q, e).reason == cn::refusal::not_simplices);
  cn::trimesh m = cn::testing::grid<cn::trimesh>(2);
  CHECK_THROWS_WITH_AS(cn::edge_flip(m, cn::edge_id{99}), "edge_flip: edge 99 is not an edge of the mesh", cn::invalid_mesh);
}
