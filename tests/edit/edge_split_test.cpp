// edge_split: counts, measure, descriptors and winding of the halves, also at edges of one and of many triangles.
#include <concino/edit.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/mesh.hpp>

#include <support/simplex_edits.hpp>

#include <doctest/doctest.h>

#include <limits>
#include <random>

namespace cn = concino;
using cn::testing::equals_rebuilt;
using cn::testing::keeps_all_laws;
using cn::testing::raw;

TEST_CASE("edge_split: the halves of two triangles") {
  cn::trimesh m({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  cn::edge_id diagonal;
  for (const auto e : cn::edges(m))
    if (raw(cn::adj_e2v(m, e)) == std::vector<unsigned>{0, 2}) diagonal = e;
  REQUIRE(cn::can_edge_split(m, diagonal));
  const auto made = cn::edge_split(m, diagonal, 0.25);
  REQUIRE(made);
  CHECK(made.vert == cn::vert_id{4});
  CHECK(cn::to_vec3(cn::point(m, made.vert)) == cn::vec3{0.25, 0.25, 0});
  CHECK(cn::num_polys(m) == 4);
  CHECK(cn::num_edges(m) == 8);
  CHECK(raw(cn::adj_p2v(m, cn::poly_id{0})) == std::vector<unsigned>{0, 1, 4});  // at vert 0, the first end
  CHECK(raw(cn::adj_p2v(m, cn::poly_id{1})) == std::vector<unsigned>{0, 4, 3});
  CHECK(cn::total_measure(m) == doctest::Approx(1));
  keeps_all_laws(m);
  equals_rebuilt(m);
}

TEST_CASE("edge_split: edges of one triangle and of five") {
  cn::trimesh m({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}, {0, 0, -1}, {0, 1, 1}},
                {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}, {0, 1, 5}, {1, 0, 6}});
  const double area = cn::total_measure(m);
  for (unsigned round = 0; round < 6; ++round) {
    std::vector<cn::edge_id> all;
    for (const auto e : cn::edges(m)) all.push_back(e);
    for (const auto e : all) {
      if (!cn::contains(m, e) || round > 2) continue;
      const std::size_t polys = cn::num_polys(m), at_edge = cn::num_elements(cn::adj_e2p(m, e)), verts = cn::num_verts(m), edges = cn::num_edges(m);
      REQUIRE(cn::edge_split(m, e, 0.3));
      CHECK(cn::num_polys(m) == polys + at_edge);
      CHECK(cn::num_verts(m) == verts + 1);
      CHECK(cn::num_edges(m) == edges + 1 + at_edge);
    }
  }
  CHECK(cn::total_measure(m) == doctest::Approx(area));
  keeps_all_laws(m);
  equals_rebuilt(m);
}

template<class M> concept has_edge_split = requires(M m, cn::edge_t<M> e) { cn::edge_split(m, e); cn::can_edge_split(m, e); };
static_assert(has_edge_split<cn::trimesh> && has_edge_split<cn::polygonmesh> && has_edge_split<cn::tetmesh> && has_edge_split<cn::polyhedralmesh>);
static_assert(!has_edge_split<cn::quadmesh> && !has_edge_split<cn::hexmesh>);

TEST_CASE("edge_split: refuses quads where simplices are asked for, and throws for edges of other meshes and parameters outside the edge; nothing changes") {
  cn::polygonmesh q(cn::testing::quad_grid(2));
  const auto before = cn::testing::whole(q);
  CHECK(cn::can_edge_split(q, cn::edge_id{0}, 0.5, {.only_simplices = true}).reason == cn::refusal::not_simplices);
  const auto made = cn::edge_split(q, cn::edge_id{0}, 0.5, {.only_simplices = true});
  CHECK_FALSE(made);
  CHECK(made.why == "a poly at the element is not a triangle or a tet");
  CHECK(cn::testing::whole(q) == before);

  cn::trimesh m = cn::testing::grid<cn::trimesh>(2);
  const auto old = cn::testing::whole(m);
  CHECK_THROWS_WITH_AS(cn::edge_split(m, cn::edge_id{99}), "edge_split: edge 99 is not an edge of the mesh", cn::invalid_mesh);
  CHECK_THROWS_WITH_AS(cn::can_edge_split(m, cn::edge_id{99}), "can_edge_split: edge 99 is not an edge of the mesh", cn::invalid_mesh);
  for (const double t : {0.0, 1.0, -2.0, std::numeric_limits<double>::quiet_NaN()}) CHECK_THROWS_AS(cn::edge_split(m, cn::edge_id{0}, t), cn::invalid_argument);
  CHECK(cn::testing::whole(m) == old);
}

TEST_CASE("edge_split: a mesh of general polygons: triangles are divided, if no other polys are at the edge") {
  cn::polygonmesh m({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}}, {{0, 1, 2}, {0, 2, 3}, {1, 4, 5, 2}});
  for (const auto e : cn::edges(m)) {
    cn::polygonmesh copy = m;
    std::size_t num_triangles = 0, num_quads = 0;
    for (const auto p : cn::adj_e2p(m, e)) ++(cn::num_elements(cn::adj_p2v(m, p)) == 3 ? num_triangles : num_quads);
    REQUIRE(cn::can_edge_split(copy, e));
    REQUIRE(cn::edge_split(copy, e));
    CHECK(cn::num_polys(copy) == 3 + (num_quads == 0 ? num_triangles : 0));
    CHECK(cn::total_measure(copy) == doctest::Approx(2));
    keeps_all_laws(copy);
    equals_rebuilt(copy);
  }
}

TEST_CASE("edge_split: tets, inside, at the boundary and around one edge that has many") {
  std::mt19937 random(4);
  const std::vector<cn::vec3> points = cn::testing::random_points(random, 8);
  std::set<std::set<unsigned>> different;
  while (different.size() < 20) {
    const auto four = cn::testing::some_of(random, 8, 4);
    different.insert({four.begin(), four.end()});
  }
  std::vector<std::vector<unsigned>> soup;
  for (const auto& tet : different) soup.emplace_back(tet.begin(), tet.end());
  for (cn::tetmesh m : {cn::testing::grid<cn::tetmesh>(2), cn::tetmesh(points, soup)}) {
    const double volume = cn::total_measure(m);
    const auto before = cn::testing::topology(m);
    for (unsigned i = 0; i < 40; ++i) {
      const std::vector<unsigned> all = raw(cn::edges(m));
      const cn::edge_id e{all[random() % all.size()]};
      const auto ends = cn::end_verts(m, e);
      const std::vector<unsigned> at_edge = raw(cn::adj_e2p(m, e));
      const std::size_t verts = cn::num_verts(m), edges = cn::num_edges(m), faces = cn::num_faces(m), polys = cn::num_polys(m), at = cn::num_elements(cn::adj_e2f(m, e));
      const auto made = cn::edge_split(m, e, 0.3);
      REQUIRE(made);
      CHECK(cn::num_verts(m) == verts + 1);
      CHECK(cn::num_edges(m) == edges + 1 + at);
      CHECK(cn::num_faces(m) == faces + at + at_edge.size());
      CHECK(cn::num_polys(m) == polys + at_edge.size());
      for (const unsigned p : at_edge) CHECK(cn::testing::raw_set(cn::adj_p2v(m, cn::poly_id{p})).count(ends.first.raw()) == 1);
    }
    CHECK(cn::total_measure(m) == doctest::Approx(volume));
    CHECK(cn::testing::topology(m) == before);
    keeps_all_laws(m);
    equals_rebuilt(m);
  }
}

TEST_CASE("operators on tets refuse general polyhedra, also if they are tetrahedra; edge_split gives these a vert more") {
  cn::polyhedralmesh m;
  std::vector<cn::vert_id> v;
  for (const cn::vec3& x : {cn::vec3{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) v.push_back(cn::add_vert(m, x));
  const auto a = cn::add_face(m, {v[0], v[2], v[1]}), b = cn::add_face(m, {v[0], v[1], v[3]}), c = cn::add_face(m, {v[1], v[2], v[3]}), d = cn::add_face(m, {v[0], v[3], v[2]});
  const cn::poly_id p = cn::add_poly(m, {{a, true}, {b, true}, {c, true}, {d, true}});
  const auto before = cn::testing::whole(m);
  CHECK(cn::edge_collapse(m, cn::edge_id{0}).reason == cn::refusal::link_condition);  // the last tet
  CHECK(cn::poly_split(m, p).reason == cn::refusal::not_simplices);
  CHECK(cn::face_split(m, a, {0.3, 0.3, 0}).reason == cn::refusal::not_simplices);
  CHECK(cn::testing::whole(m) == before);
  REQUIRE(cn::can_edge_split(m, cn::edge_id{0}));
  const auto made = cn::edge_split(m, cn::edge_id{0}, 0.25);
  REQUIRE(made);
  CHECK(cn::num_polys(m) == 1);
  CHECK(cn::num_elements(cn::adj_p2v(m, p)) == 5);
  CHECK(cn::num_elements(cn::adj_v2e(m, made.vert)) == 2);
  keeps_all_laws(m);
  equals_rebuilt(m);
}

TEST_CASE("edge_split: polys on the same verts are refused, as edges would become one") {
  const std::vector<cn::vec3> x{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}};
  using lists = std::vector<std::vector<unsigned>>;
  cn::trimesh s(x, lists{{0, 1, 2}, {1, 0, 2}, {0, 1, 3}});  // a sphere of two triangles, and a third one
  cn::tetmesh v(x, lists{{0, 1, 2, 3}, {1, 0, 2, 3}, {0, 1, 2, 4}});
  const auto refuse = [](auto& m, unsigned a, unsigned b) {
    const auto before = cn::testing::whole(m);
    const auto e = cn::testing::edge_between_verts(m, a, b);
    CHECK(cn::can_edge_split(m, e).reason == cn::refusal::same_verts);
    CHECK(cn::edge_split(m, e).reason == cn::refusal::same_verts);
    CHECK(cn::testing::whole(m) == before);
  };
  refuse(s, 0, 1), refuse(s, 0, 2), refuse(v, 0, 1), refuse(v, 2, 3);
  CHECK(cn::edge_split(s, cn::testing::edge_between_verts(s, 0, 3)));
  CHECK(cn::edge_split(v, cn::testing::edge_between_verts(v, 0, 4)));
  const std::size_t n = 40;  // many triangles at one edge, of which two are the same
  std::vector<cn::vec3> points(n + 2);
  lists book;
  for (unsigned i = 0; i < n; ++i) book.push_back({0, 1, i + 2});
  cn::trimesh m(points, book);
  CHECK(cn::can_edge_split(m, cn::testing::edge_between_verts(m, 0, 1)));
  book.push_back({30, 0, 1});
  cn::trimesh twice(points, book);
  refuse(twice, 0, 1);
}
