// poly_split: counts, measure, descriptors and corners of the parts of triangles and tets.
#include <concino/edit/poly_split.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/mesh.hpp>

#include <support/simplex_edits.hpp>

#include <doctest/doctest.h>

#include <limits>
#include <random>

namespace cn = concino;
using cn::testing::element_counts;
using cn::testing::equals_rebuilt;
using cn::testing::keeps_all_laws;
using cn::testing::raw;

TEST_CASE("poly_split: the parts of a triangle and of a tet") {
  const std::vector<cn::vec3> x{{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, 3}};
  cn::trimesh m(x, std::vector<std::vector<unsigned>>{{0, 1, 2}});
  const auto made = cn::poly_split(m, cn::poly_id{0});
  REQUIRE(made);
  CHECK(made.vert == cn::vert_id{4});
  CHECK(cn::to_vec3(cn::point(m, made.vert)) == cn::vec3{1, 1, 0});
  CHECK(raw(cn::adj_p2v(m, cn::poly_id{0})) == std::vector<unsigned>{4, 1, 2});
  CHECK(raw(cn::adj_p2v(m, cn::poly_id{1})) == std::vector<unsigned>{0, 4, 2});
  CHECK(raw(cn::adj_p2v(m, cn::poly_id{2})) == std::vector<unsigned>{0, 1, 4});
  keeps_all_laws(m);

  cn::tetmesh t(x, std::vector<std::vector<unsigned>>{{0, 1, 2, 3}});
  REQUIRE(cn::poly_split(t, cn::poly_id{0}, {0.5, 1, 1}));
  CHECK(cn::to_vec3(cn::point(t, cn::vert_id{4})) == cn::vec3{0.5, 1, 1});
  CHECK(raw(cn::adj_p2v(t, cn::poly_id{0})) == std::vector<unsigned>{4, 1, 2, 3});
  CHECK(raw(cn::adj_p2v(t, cn::poly_id{3})) == std::vector<unsigned>{0, 1, 2, 4});
  CHECK(element_counts(t) == std::vector<std::ptrdiff_t>{5, 10, 10, 4});
  keeps_all_laws(t);
}

TEST_CASE_TEMPLATE("poly_split: counts, measure and topology of a mesh of which many polys are split", M, cn::trimesh, cn::tetmesh) {
  std::mt19937 random(2);
  M m = cn::testing::grid<M>(3);
  const double measure = cn::total_measure(m);
  const auto before = cn::testing::topology(m);
  const std::size_t verts = cn::num_verts(m), edges = cn::num_edges(m), polys = cn::num_polys(m);
  const std::size_t d = cn::dimension_v<M>;
  for (std::size_t i = 1; i <= 60; ++i) {
    REQUIRE(cn::poly_split(m, cn::poly_id{random() % cn::num_polys(m)}));
    CHECK(cn::num_verts(m) == verts + i);
    CHECK(cn::num_edges(m) == edges + i * (d + 1));
    CHECK(cn::num_polys(m) == polys + i * d);
  }
  CHECK(cn::total_measure(m) == doctest::Approx(measure));
  CHECK(cn::testing::topology(m) == before);
  keeps_all_laws(m);
  equals_rebuilt(m);
}

TEST_CASE("poly_split: refuses quads, and throws for polys of other meshes and points that are not finite; nothing changes") {
  cn::quadmesh q = cn::testing::grid<cn::quadmesh>(2);
  const auto before = cn::testing::whole(q);
  CHECK(cn::can_poly_split(q, cn::poly_id{0}).reason == cn::refusal::not_simplices);
  CHECK(cn::poly_split(q, cn::poly_id{0}).why == "a poly at the element is not a triangle or a tet");
  CHECK(cn::testing::whole(q) == before);
  cn::trimesh m = cn::testing::grid<cn::trimesh>(2);
  const auto old = cn::testing::whole(m);
  CHECK(cn::can_poly_split(m, cn::poly_id{1}));
  CHECK_THROWS_WITH_AS(cn::poly_split(m, cn::poly_id{99}), "poly_split: poly 99 is not a poly of the mesh", cn::invalid_mesh);
  CHECK_THROWS_AS(cn::can_poly_split(m, cn::poly_id{99}), cn::invalid_mesh);
  CHECK_THROWS_WITH_AS(cn::poly_split(m, cn::poly_id{0}, {0, std::numeric_limits<double>::infinity(), 0}), "poly_split: the point is not finite", cn::invalid_argument);
  CHECK(cn::testing::whole(m) == old);
}
