// Quality of the polys of a mesh: the same as of their points, on every kind of mesh and on the archetype; shapes are recognised in general volumes.
#include <concino/quality/poly_quality.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/mesh/support/to_polyhedra.hpp>

#include <support/generators.hpp>
#include <support/kinds.hpp>
#include <support/motions.hpp>
#include <support/unit_cells.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

namespace cn = concino;

namespace {

using cn::metric;
using cn::poly_shape;
constexpr metric of_all_shapes[] = {metric::scaled_jacobian, metric::mean_ratio, metric::planarity, metric::star_shapedness, metric::edge_ratio, metric::relative_size_squared};

/// A polyhedral mesh of one standard cell, with every second face listed inward.
cn::polyhedralmesh one_cell(cn::cell_shape s, const std::vector<cn::vec3>& points) {
  cn::polyhedra_arrays a;
  const cn::standard_cell& t = cn::standard_cell_of(s);
  a.points = points;
  a.face_offsets = {0};
  for (unsigned f = 0; f < t.num_faces; ++f) {
    for (unsigned i = 0; i < t.face_size[f]; ++i) a.face_verts.push_back(cn::vert_id{t.face_vert[f][f % 2 ? t.face_size[f] - 1 - i : i]});
    a.face_offsets.push_back(static_cast<std::uint32_t>(a.face_verts.size()));
    a.poly_faces.push_back(cn::face_id{f});
    a.outward.push_back(f % 2 == 0);
  }
  a.poly_offsets = {0, t.num_faces};
  return cn::polyhedralmesh(a);
}
cn::poly_shape shape_of_cell(cn::cell_shape s) {
  return s == cn::cell_shape::tet ? poly_shape::tet : s == cn::cell_shape::hex ? poly_shape::hex : s == cn::cell_shape::prism ? poly_shape::prism : poly_shape::pyramid;
}

}  // namespace

TEST_CASE_TEMPLATE("quality: the map has the values of the polys, also on the archetype, and does not depend on rotation and scale", M, CONCINO_ALL_KINDS) {
  const auto arrays = cn::testing::jittered(cn::testing::grid_arrays<M>(2), 0.05);
  const M m(arrays), moved(cn::testing::rotated(arrays)), small(cn::testing::scaled(arrays, 0x1p-20));
  const auto g = cn::only_embedded_mesh(m);
  for (const metric what : of_all_shapes) {
    INFO(std::string(cn::name_of(what)));
    const auto all = cn::quality(m, what);
    const auto of_moved = cn::quality(moved, what), of_small = cn::quality(small, what);
    const auto of_archetype = cn::quality(g, what);
    for (const auto p : cn::polys(m)) {
      CHECK(all[p] == cn::quality(m, p, what));
      CHECK(of_archetype[g.poly(p)] == doctest::Approx(all[p]).epsilon(1e-12));
      CHECK(of_moved[p] == doctest::Approx(all[p]).epsilon(1e-9));
      CHECK(of_small[p] == doctest::Approx(all[p]).epsilon(1e-12));
    }
  }
  for (const auto p : cn::polys(m)) {
    CHECK(cn::scaled_jacobian(m, p) == cn::quality(m, p, metric::scaled_jacobian));
    CHECK(cn::mean_ratio(m, p) == cn::quality(m, p, metric::mean_ratio));
    CHECK(cn::planarity(m, p) == cn::quality(m, p, metric::planarity));
    CHECK(cn::star_shapedness(m, p) == cn::quality(m, p, metric::star_shapedness));
    CHECK(cn::shape_of_poly(g, g.poly(p)) == cn::shape_of_poly(m, p));
  }
}

TEST_CASE("quality: every metric of tets and hexes is the same if they are general polyhedra") {
  const auto compare = [](const auto& m, const cn::cell_arrays& arrays, poly_shape shape) {
    const cn::polyhedralmesh general(cn::to_polyhedra(cn::cell_arrays(arrays)));
    for (std::size_t i = 0; i < cn::num_metrics; ++i) {
      const auto what = static_cast<metric>(i);
      if (!cn::is_defined(what, shape)) continue;
      INFO(std::string(cn::name_of(what)));
      const auto a = cn::quality(m, what);
      const auto b = cn::quality(general, what);
      for (const auto p : cn::polys(m)) CHECK((a[p] == b[p] || b[p] == doctest::Approx(a[p]).epsilon(1e-9)));
    }
  };
  const auto tets = cn::testing::jittered(cn::testing::tet_grid(2), 0.05), hexes = cn::testing::jittered(cn::testing::hex_grid(2), 0.05);
  compare(cn::tetmesh(tets), tets, poly_shape::tet);
  compare(cn::hexmesh(hexes), hexes, poly_shape::hex);
}

TEST_CASE("quality: standard shapes in general volumes, inverted ones negative") {
  for (const cn::cell_shape s : cn::testing::shapes) {
    auto points = cn::testing::unit_cell(s);
    for (cn::vec3& x : points) x = cn::testing::rotated(x);
    const cn::polyhedralmesh m = one_cell(s, points);
    for (cn::vec3& x : points) x.x = -x.x;
    const cn::polyhedralmesh inverted = one_cell(s, points);
    const cn::poly_id p{0};
    CHECK(cn::shape_of_poly(m, p) == shape_of_cell(s));
    CHECK(cn::quality(m, p, metric::volume) == doctest::Approx(cn::testing::six_volumes_of(s) / 6));
    CHECK(cn::mean_poly_size(m) == doctest::Approx(cn::testing::six_volumes_of(s) / 6));
    CHECK(cn::scaled_jacobian(m, p) > 0.4);
    CHECK(cn::mean_ratio(m, p) > 0.4);
    CHECK(cn::planarity(m, p) == doctest::Approx(1));
    CHECK(cn::star_shapedness(m, p) == 1);
    CHECK(cn::quality(inverted, p, metric::volume) == doctest::Approx(-cn::quality(m, p, metric::volume)));
    CHECK(cn::scaled_jacobian(inverted, p) < -0.4);
    CHECK(cn::mean_ratio(inverted, p) < -0.4);
    CHECK(cn::star_shapedness(inverted, p) == 0);
  }
}

TEST_CASE("quality: of polyhedra that are not convex") {
  // an L of three cubes, as one cell: from the cube at the corner all of it is visible
  const cn::surface_arrays outline{{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}}, {0, 6}, {cn::vert_id{0}, cn::vert_id{1}, cn::vert_id{2}, cn::vert_id{3}, cn::vert_id{4}, cn::vert_id{5}}, 0};
  const cn::polyhedralmesh l(cn::testing::extrude(outline, 1));
  const cn::poly_id p{0};
  CHECK(cn::shape_of_poly(l, p) == poly_shape::polyhedron);
  CHECK(cn::star_shapedness(l, p) == doctest::Approx(1.0 / 3));
  CHECK(cn::planarity(l, p) == doctest::Approx(1));
  CHECK(cn::scaled_jacobian(l, p) == doctest::Approx(-1));  // the reflex edge
  // a cube with a pyramid taken out of its top: the apex is at the height 1 - depth
  for (const double depth : {0.25, 0.5}) {
    cn::polyhedra_arrays a;
    a.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}, {0.5, 0.5, 1 - depth}};
    const std::vector<std::vector<unsigned>> faces = {{0, 3, 2, 1}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}, {4, 5, 8}, {5, 6, 8}, {6, 7, 8}, {7, 4, 8}};
    a.face_offsets = {0};
    for (unsigned f = 0; f < faces.size(); ++f) {
      for (const unsigned v : faces[f]) a.face_verts.push_back(cn::vert_id{v});
      a.face_offsets.push_back(static_cast<std::uint32_t>(a.face_verts.size()));
      a.poly_faces.push_back(cn::face_id{f});
      a.outward.push_back(1);
    }
    a.poly_offsets = {0, static_cast<std::uint32_t>(faces.size())};
    const cn::polyhedralmesh m(a);
    // The planes of the inner triangles meet the sides at 1 - 2 depth. Below them remains a box with an inverted pyramid's complement mirrored: a box of that
    // height and a pyramid of height depth on it.
    CHECK(cn::quality(m, p, metric::volume) == doctest::Approx(1 - depth / 3));
    CHECK(cn::star_shapedness(m, p) == doctest::Approx((1 - 2 * depth + depth / 3) / (1 - depth / 3)));
  }
}

TEST_CASE("quality: sizes relative to the mean") {
  const cn::quadmesh m({{0, 0, 0}, {1, 0, 0}, {4, 0, 0}, {0, 1, 0}, {1, 1, 0}, {4, 1, 0}}, {{0, 1, 4, 3}, {1, 2, 5, 4}});  // areas 1 and 3
  const cn::poly_id small{0}, large{1};
  CHECK(cn::mean_poly_size(m) == 2);
  CHECK(cn::quality(m, small, metric::relative_size_squared) == 0.25);
  CHECK(cn::quality(m, large, metric::relative_size_squared) == doctest::Approx(4.0 / 9));
  CHECK(cn::quality(m, large, metric::relative_size_squared, {.mean_size = 3}) == 1);
  CHECK(cn::quality(m, metric::shape_and_size)[large] == doctest::Approx(4.0 / 9 * 0.6));  // shape: 2 * 3 / (1 + 9)
  CHECK(cn::quality(m, metric::shear_and_size)[small] == 0.25);
  CHECK(cn::mean_poly_size(cn::quadmesh()) == 0);
}

TEST_CASE("quality: errors") {
  const cn::polygonmesh m({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0.5, 0}}, {{0, 1, 2, 3}, {1, 4, 2}});
  CHECK_THROWS_WITH_AS(cn::quality(m, metric::oddy), doctest::Contains("oddy is not defined for a triangle, such as poly 1"), cn::unsupported);
  CHECK(cn::quality(m, cn::poly_id{0}, metric::oddy) == 0);
  CHECK_THROWS_AS(cn::quality(m, cn::poly_id{1}, metric::oddy), cn::unsupported);
  CHECK_THROWS_AS(cn::quality(m, metric::area, {.mean_size = -1}), cn::invalid_argument);
  CHECK_THROWS_AS(cn::quality(m, cn::poly_id{1}, metric::area, {.mean_size = std::nan("")}), cn::invalid_argument);
  const cn::tetmesh empty;
  CHECK(cn::quality(empty, metric::volume).values().empty());
}
