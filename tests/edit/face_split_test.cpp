// face_split: counts, volume, descriptors and corners of the parts of tets, inside and at the boundary.
#include <concino/edit/face_split.hpp>
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

namespace {

template<class M>
cn::vec3 mean_of_face(const M& m, cn::face_id f) {
  cn::vec3 sum;
  for (const auto v : cn::adj_f2v(m, f)) sum += cn::to_vec3(cn::point(m, v)) / 3;
  return sum;
}

}  // namespace

TEST_CASE("face_split: the parts of two tets and of three at one face") {
  for (const bool third : {false, true}) {
    std::vector<std::vector<unsigned>> tets{{0, 1, 2, 3}, {1, 0, 2, 4}};
    if (third) tets.push_back({0, 1, 2, 5});
    cn::tetmesh m(std::vector<cn::vec3>{{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, 3}, {0, 0, -3}, {1, 1, 1}}, tets);
    cn::face_id f;
    for (const auto x : cn::faces(m))
      if (cn::num_elements(cn::adj_f2p(m, x)) > 1) f = x;
    const unsigned first = raw(cn::adj_f2v(m, f))[0];
    std::vector<unsigned> expected = raw(cn::adj_p2v(m, cn::poly_id{1}));
    std::replace(expected.begin(), expected.end(), first, 6u);
    REQUIRE(cn::can_face_split(m, f, {1, 1, 0}));
    const auto made = cn::face_split(m, f, {1, 1, 0});
    REQUIRE(made);
    CHECK(made.vert == cn::vert_id{6});
    CHECK(cn::to_vec3(cn::point(m, made.vert)) == cn::vec3{1, 1, 0});
    CHECK(cn::num_polys(m) == 3 * tets.size());
    CHECK(raw(cn::adj_p2v(m, cn::poly_id{1})) == expected);
    keeps_all_laws(m);
    equals_rebuilt(m);
  }
}

TEST_CASE("face_split: counts, volume and topology of a mesh of which many faces are split") {
  std::mt19937 random(2);
  cn::tetmesh m = cn::testing::grid<cn::tetmesh>(3);
  const double volume = cn::total_measure(m);
  const auto before = cn::testing::topology(m);
  for (unsigned i = 0; i < 60; ++i) {
    const std::vector<unsigned> all = raw(cn::faces(m));
    const cn::face_id f{all[random() % all.size()]};
    const std::size_t at_face = cn::num_elements(cn::adj_f2p(m, f)), verts = cn::num_verts(m), edges = cn::num_edges(m), faces = cn::num_faces(m), polys = cn::num_polys(m);
    REQUIRE(cn::face_split(m, f, mean_of_face(m, f)));
    CHECK(cn::num_verts(m) == verts + 1);
    CHECK(cn::num_edges(m) == edges + 3 + at_face);
    CHECK(cn::num_faces(m) == faces + 2 + 3 * at_face);
    CHECK(cn::num_polys(m) == polys + 2 * at_face);
  }
  CHECK(cn::total_measure(m) == doctest::Approx(volume));
  CHECK(cn::testing::topology(m) == before);
  keeps_all_laws(m);
  equals_rebuilt(m);
}

TEST_CASE("face_split: refuses hexes, and throws for faces of other meshes and points that are not finite; nothing changes") {
  cn::hexmesh h = cn::testing::grid<cn::hexmesh>(2);
  const auto before = cn::testing::whole(h);
  CHECK(cn::can_face_split(h, cn::face_id{0}, {}).reason == cn::refusal::not_simplices);
  CHECK(cn::face_split(h, cn::face_id{0}, {0, 0, 0}).why == "a poly at the element is not a triangle or a tet");
  CHECK(cn::testing::whole(h) == before);
  cn::tetmesh m = cn::testing::grid<cn::tetmesh>(1);
  const auto old = cn::testing::whole(m);
  CHECK_THROWS_WITH_AS(cn::face_split(m, cn::face_id{99}, {}), "face_split: face 99 is not a face of the mesh", cn::invalid_mesh);
  CHECK_THROWS_AS(cn::can_face_split(m, cn::face_id{99}, {}), cn::invalid_mesh);
  CHECK_THROWS_AS(cn::face_split(m, cn::face_id{0}, {std::numeric_limits<double>::quiet_NaN(), 0, 0}), cn::invalid_argument);
  CHECK(cn::testing::whole(m) == old);
}
