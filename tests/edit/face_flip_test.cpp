// face_flip and edge_flip of tets: figures, volume, refusals, and that one is the inverse of the other.
#include <concino/edit/edge_flip.hpp>
#include <concino/edit/face_flip.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/mesh.hpp>

#include <support/simplex_edits.hpp>

#include <doctest/doctest.h>

#include <random>

namespace cn = concino;
using cn::testing::edge_between_verts;
using cn::testing::element_counts;
using cn::testing::equals_rebuilt;
using cn::testing::keeps_all_laws;
using cn::testing::polys_as_sets;
using cn::testing::topology;
using lists = std::vector<std::vector<unsigned>>;
using figures = std::vector<std::ptrdiff_t>;
using sets = std::multiset<std::set<unsigned>>;

namespace {

const std::vector<cn::vec3> tet_points{{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {1, 1, 2}, {1, 1, -2}, {4, 4, 4}};

cn::face_id face_of(const cn::tetmesh& m, const std::set<unsigned>& verts) {
  for (const auto f : cn::faces(m))
    if (cn::testing::raw_set(cn::adj_f2v(m, f)) == verts) return f;
  FAIL_CHECK("no such face");
  return {};
}

void face_is_refused(cn::tetmesh m, const std::set<unsigned>& verts, cn::refusal reason) {
  const auto before = cn::testing::whole(m);
  const cn::face_id f = face_of(m, verts);
  CHECK(cn::can_face_flip(m, f).reason == reason);
  const auto made = cn::face_flip(m, f);
  CHECK(made.reason == reason);
  CHECK_FALSE(made.why.empty());
  CHECK(cn::testing::whole(m) == before);
}

void edge_is_refused(cn::tetmesh m, unsigned a, unsigned b, cn::refusal reason) {
  const auto before = cn::testing::whole(m);
  const cn::edge_id e = edge_between_verts(m, a, b);
  for (const unsigned diagonal : {0u, 1u}) {
    CHECK(cn::can_edge_flip(m, e, {.diagonal = diagonal}).reason == reason);
    const auto made = cn::edge_flip(m, e, {.diagonal = diagonal});
    CHECK(made.reason == reason);
    CHECK_FALSE(made.why.empty());
  }
  CHECK(cn::testing::whole(m) == before);
}

/// Four tets around the edge from 0 to 1.
cn::tetmesh octahedron() {
  return cn::tetmesh(std::vector<cn::vec3>{{0, 0, -1}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}},
                     lists{{0, 1, 2, 3}, {0, 1, 4, 5}, {0, 1, 3, 4}, {0, 1, 5, 2}});
}

}  // namespace

TEST_CASE("face_flip and edge_flip: two tets and three tets") {
  cn::tetmesh m(tet_points, lists{{0, 1, 2, 3}, {1, 0, 2, 4}});
  const double volume = cn::total_measure(m);
  REQUIRE(cn::can_face_flip(m, face_of(m, {0, 1, 2})));
  const auto made = cn::face_flip(m, face_of(m, {0, 1, 2}));
  REQUIRE(made);
  CHECK(cn::testing::raw_set(cn::adj_e2v(m, made.edge)) == std::set<unsigned>{3, 4});
  CHECK(polys_as_sets(m) == sets{{0, 1, 3, 4}, {0, 2, 3, 4}, {1, 2, 3, 4}});
  CHECK(element_counts(m) == figures{5, 10, 9, 3});
  for (const auto p : cn::polys(m)) CHECK(cn::measure(m, p) == doctest::Approx(volume / 3));
  keeps_all_laws(m);
  equals_rebuilt(m);

  const auto back = cn::edge_flip(m, made.edge);
  REQUIRE(back);
  CHECK(cn::testing::raw_set(cn::adj_f2v(m, back.face)) == std::set<unsigned>{0, 1, 2});
  CHECK(polys_as_sets(m) == sets{{0, 1, 2, 3}, {0, 1, 2, 4}});
  for (const auto p : cn::polys(m)) CHECK(cn::measure(m, p) == doctest::Approx(volume / 2));
  keeps_all_laws(m);
  equals_rebuilt(m);
}

TEST_CASE("edge_flip: four tets, for both diagonals") {
  for (const unsigned diagonal : {0u, 1u}) {
    cn::tetmesh m = octahedron();
    const double volume = cn::total_measure(m);
    const auto before = element_counts(m);
    const auto made = cn::edge_flip(m, edge_between_verts(m, 0, 1), {.diagonal = diagonal});
    REQUIRE(made);
    CHECK(cn::testing::raw_set(cn::adj_e2v(m, made.edge)) == (diagonal == 0 ? std::set<unsigned>{2, 4} : std::set<unsigned>{3, 5}));
    CHECK(element_counts(m) == before);
    for (const auto p : cn::polys(m)) CHECK(cn::measure(m, p) == doctest::Approx(volume / 4));
    CHECK(cn::num_elements(cn::adj_e2p(m, made.edge)) == 4);
    keeps_all_laws(m);
    equals_rebuilt(m);
  }
  cn::tetmesh m = octahedron();
  CHECK_THROWS_WITH_AS(cn::edge_flip(m, cn::edge_id{0}, {.diagonal = 2}), "edge_flip: options.diagonal is 2; it must be 0 or 1", cn::invalid_argument);
}

TEST_CASE("face_flip: twice, with edge_flip, gives the same tets; counts and topology after many flips") {
  std::mt19937 random(3);
  cn::tetmesh m = cn::testing::grid<cn::tetmesh>(3);
  const auto start = topology(m);
  unsigned flips = 0, of_four = 0;
  for (unsigned i = 0; i < 300; ++i) {
    const auto faces = cn::testing::raw(cn::faces(m)), edges = cn::testing::raw(cn::edges(m));
    const auto tets = polys_as_sets(m);
    const auto n = element_counts(m);
    if (i % 2) {
      const auto made = cn::face_flip(m, cn::face_id{faces[random() % faces.size()]});
      if (!made) continue;
      CHECK(element_counts(m) == figures{n[0], n[1] + 1, n[2] + 2, n[3] + 1});
      if (i % 4 == 1) continue;
      CHECK(cn::edge_flip(m, made.edge));
      CHECK(polys_as_sets(m) == tets);
      ++flips;
    } else {
      const cn::edge_id e{edges[random() % edges.size()]};
      const std::size_t at_edge = cn::num_elements(cn::adj_e2p(m, e));
      const auto made = cn::edge_flip(m, e, {.diagonal = random() % 2 ? 1u : 0u});
      if (!made) continue;
      of_four += at_edge == 4;
      if (at_edge == 3) CHECK(element_counts(m) == figures{n[0], n[1] - 1, n[2] - 2, n[3] - 1});
      else CHECK(element_counts(m) == n);
    }
    CHECK(topology(m) == start);
  }
  CHECK(flips > 20);
  CHECK(of_four > 3);
  keeps_all_laws(m);
  equals_rebuilt(m);
}

TEST_CASE("face_flip and edge_flip of tets: what is refused") {
  using cn::refusal;
  const auto& x = tet_points;
  face_is_refused(cn::tetmesh(x, lists{{0, 1, 2, 3}}), {0, 1, 2}, refusal::wrong_number);
  face_is_refused(cn::tetmesh(x, lists{{0, 1, 2, 3}, {1, 0, 2, 4}, {1, 0, 2, 5}}), {0, 1, 2}, refusal::wrong_number);
  face_is_refused(cn::tetmesh(x, lists{{0, 1, 2, 3}, {0, 1, 2, 4}}), {0, 1, 2}, refusal::winding);
  face_is_refused(cn::tetmesh(x, lists{{0, 1, 2, 3}, {1, 0, 2, 3}}), {0, 1, 2}, refusal::same_verts);
  face_is_refused(cn::tetmesh(x, lists{{0, 1, 2, 3}, {1, 0, 2, 4}, {0, 3, 4, 5}}), {0, 1, 2}, refusal::same_verts);

  edge_is_refused(cn::tetmesh(x, lists{{0, 1, 2, 3}, {0, 1, 3, 4}}), 0, 1, refusal::wrong_number);
  edge_is_refused(cn::tetmesh(x, lists{{0, 1, 2, 3}, {0, 1, 3, 4}, {0, 1, 4, 5}}), 0, 1, refusal::wrong_number);  // not all around it
  edge_is_refused(cn::tetmesh(x, lists{{0, 1, 2, 3}, {0, 1, 3, 4}, {0, 1, 2, 4}}), 0, 1, refusal::winding);
  edge_is_refused(cn::tetmesh(x, lists{{0, 1, 2, 3}, {1, 0, 2, 3}, {0, 1, 4, 5}, {1, 0, 4, 5}}), 0, 1, refusal::wrong_number);  // two pairs
  edge_is_refused(cn::tetmesh(x, lists{{0, 1, 2, 3}, {0, 1, 3, 4}, {0, 1, 4, 2}, {2, 3, 4, 5}}), 0, 1, refusal::same_verts);
  cn::tetmesh m = octahedron();
  for (const auto e : cn::edges(m))
    if (cn::num_elements(cn::adj_e2p(m, e)) < 3) CHECK(cn::edge_flip(m, e).reason == refusal::wrong_number);
  cn::tetmesh joined(std::vector<cn::vec3>(8), lists{{0, 1, 2, 3}, {0, 1, 4, 5}, {0, 1, 3, 4}, {0, 1, 5, 2}, {2, 4, 6, 7}, {3, 5, 6, 7}});
  edge_is_refused(joined, 0, 1, refusal::same_verts);

  cn::hexmesh h = cn::testing::grid<cn::hexmesh>(2);
  const auto before = cn::testing::whole(h);
  for (const auto f : cn::faces(h)) CHECK(cn::face_flip(h, f).reason == refusal::not_simplices);
  for (const auto e : cn::edges(h)) CHECK(cn::edge_flip(h, e).reason == refusal::not_simplices);
  CHECK(cn::testing::whole(h) == before);
  CHECK_THROWS_WITH_AS(cn::face_flip(m, cn::face_id{99}), "face_flip: face 99 is not a face of the mesh", cn::invalid_mesh);
  CHECK_THROWS_AS(cn::can_face_flip(m, cn::face_id{99}), cn::invalid_mesh);
  CHECK_THROWS_AS(cn::edge_flip(m, cn::edge_id{99}), cn::invalid_mesh);
}
