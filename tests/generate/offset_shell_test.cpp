#include <concino/generate/offset_shell.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/generate/box.hpp>
#include <concino/generate/extrude.hpp>
#include <concino/generate/sphere.hpp>
#include <concino/mesh/property.hpp>

#include <support/generated.hpp>
#include <support/kinds.hpp>
#include <support/same_mesh.hpp>

#include <limits>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("offset_shell: of a plane, as extrude", M, CONCINO_SURFACE_KINDS) {
  const M m = grid<M>(3);
  CHECK(record_of(offset_shell(m, 0.5, 2)) == record_of(extrude(m, {0, 0, 0.5}, 2)));
  CHECK(record_of(offset_shell(m, -0.5, 2)) == record_of(extrude(m, {0, 0, -0.5}, 2)));
  CHECK(record_of(offset_shell(only_embedded_mesh(m), 0.5)) == record_of(extrude(only_embedded_mesh(m), {0, 0, 0.5})));
  CHECK(num_polys(offset_shell(M(), 1)) == 0);
}

TEST_CASE_TEMPLATE("offset_shell: of a sphere, outward and inward", M, CONCINO_SURFACE_KINDS) {
  const M m = make_sphere<M>({.cells = 5});
  for (const double thickness : {0.5, -0.5}) {
    const auto v = offset_shell(m, thickness, 3);
    check_sound(v, 2);
    CHECK(num_polys(v) == 3 * num_polys(m));
    const double outer = thickness > 0 ? 1.5 : 1, inner = thickness > 0 ? 1 : 0.5;
    CHECK(total_measure(v) == doctest::Approx(4.18879 * (outer * outer * outer - inner * inner * inner)).epsilon(0.06));
    for (const vert_id x : verts(m)) CHECK(distance(point(v, vert_id{3 * num_verts(m) + x.raw()}), point(m, x)) == doctest::Approx(0.5));
  }
}

TEST_CASE_TEMPLATE("offset_shell: the planes of a box move by the thickness, whatever the polys at its corners", M, trimesh, polygonmesh) {
  const M m = make_box<M>({.cells = {3, 2, 1}, .max = {3, 2, 1}});
  const auto v = offset_shell(m, 0.5, 2, {.distance = offset_distance::of_planes});
  check_sound(v, 2);
  CHECK(total_measure(v) == doctest::Approx(4 * 3 * 2 - 3 * 2 * 1).epsilon(1e-12));
  CHECK(total_measure(offset_shell(m, -0.25, 1, {.distance = offset_distance::of_planes})) == doctest::Approx(6 - 2.5 * 1.5 * 0.5).epsilon(1e-12));
  const double by_normals = total_measure(offset_shell(m, 0.5, 2));
  CHECK(by_normals < 17);
  const M flat = grid<M>(2);
  CHECK(total_measure(offset_shell(flat, 0.5, 2, {.distance = offset_distance::of_planes})) == doctest::Approx(0.5).epsilon(1e-12));
}

TEST_CASE("offset_shell: inverted polys are listed, or an error") {
  const trimesh m = make_sphere<trimesh>({.cells = 4});
  std::vector<poly_id> inverted{poly_id{3}};
  check_sound(offset_shell(m, -0.8, 4, {.inverted = &inverted}), 2);
  CHECK(inverted.empty());
  const auto v = offset_shell(m, -2, 3, {.inverted = &inverted});  // two levels are beyond the centre
  CHECK(check_laws(v).empty());
  REQUIRE(inverted.size() == 2 * num_polys(m));
  CHECK(inverted.front() == poly_id{num_polys(m)});
  CHECK_THROWS_WITH_AS(offset_shell(m, -2, 3), "offset_shell: thickness -2 inverts a corner or an edge of the offset of poly 0; choose a smaller one, or let options.inverted list such polys", invalid_argument);
  for (const double scale : {1e-100, 1e90}) {
    trimesh small = m;
    for (const vert_id x : verts(small)) set_point(small, x, scale * to_vec3(point(small, x)));
    offset_shell(small, -0.8 * scale, 4, {.inverted = &inverted});
    CHECK(inverted.empty());
    offset_shell(small, -2 * scale, 3, {.inverted = &inverted});
    CHECK(inverted.size() == 2 * num_polys(m));
  }
}

TEST_CASE("offset_shell: properties, correspondence, and a vert without polys") {
  polygonmesh m = two_grids<polygonmesh>(2);  // with concave polygons
  const auto name = poly_property<int>(m, "name");
  for (const poly_id p : polys(m)) name[p] = 4 + static_cast<int>(p.raw());
  const auto place = vert_property<vec3>(m, "place");
  for (const vert_id v : verts(m)) place[v] = point(m, v);
  correspondence c;
  const auto v = offset_shell(m, 1, 2, {.correspondence = &c});
  CHECK(check_laws(v).empty());
  REQUIRE(num_verts(v) == 3 * (num_verts(m) - 1) + 1);
  REQUIRE(c.verts.size() == num_verts(v));
  for (const vert_id x : verts(v)) {
    CHECK(find_vert_property<vec3>(v, "place")[x] == to_vec3(point(m, vert_id{c.verts.only(x.raw())})));
    CHECK(norm(point(v, x) - find_vert_property<vec3>(v, "place")[x]) <= 1);
  }
  for (const poly_id p : polys(v)) CHECK(find_poly_property<int>(v, "name")[p] == 4 + static_cast<int>(c.polys.only(p.raw())));
  CHECK(property_list(offset_shell(m, 1, 2, {.properties = false})).empty());
}

TEST_CASE("offset_shell: errors name what is wrong") {
  const trimesh m = grid<trimesh>(1);
  CHECK_THROWS_WITH_AS(offset_shell(m, 1, 0), "offset_shell: layers is 0; it must be at least 1", invalid_argument);
  CHECK_THROWS_WITH_AS(offset_shell(m, 0), "offset_shell: thickness is 0; it must be finite and not 0", invalid_argument);
  CHECK_THROWS_WITH_AS(offset_shell(m, std::numeric_limits<double>::infinity()), doctest::Contains("offset_shell: thickness is "), invalid_argument);
  CHECK_THROWS_WITH_AS(offset_shell(m, 1, std::size_t{1} << 31), doctest::Contains("offset_shell: layers asks for "), invalid_argument);
  trimesh bad = m;
  set_point(bad, vert_id{1}, vec3{0, std::nan(""), 0});
  CHECK_THROWS_WITH_AS(offset_shell(bad, 1), "offset_shell: the point of vert 1 is not finite", invalid_mesh);
  for (const vert_id v : verts(bad)) set_point(bad, v, vec3{});
  CHECK_THROWS_WITH_AS(offset_shell(bad, 1), doctest::Contains("has no normal, as the areas around it cancel or are 0"), invalid_mesh);
  const std::vector<vec3> fan{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {-1, 0, 0}, {-1, 0, 1}};
  CHECK_THROWS_WITH_AS(offset_shell(trimesh(fan, std::vector<std::vector<unsigned>>{{0, 2, 1}, {0, 1, 3}, {0, 1, 4}}), 1), doctest::Contains("has more than two polys"), invalid_mesh);
  CHECK_THROWS_WITH_AS(offset_shell(trimesh(fan, std::vector<std::vector<unsigned>>{{0, 1, 3}, {0, 1, 4}}), 1), doctest::Contains("offset_shell: polys 0 and 1 run along edge "), invalid_mesh);
}
