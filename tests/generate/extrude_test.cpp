#include <concino/generate/extrude.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/generate/sphere.hpp>
#include <concino/mesh/property.hpp>

#include <support/generated.hpp>
#include <support/kinds.hpp>

#include <limits>

using namespace concino;
using namespace concino::testing;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE_TEMPLATE("extrude: prisms of the known volume, whichever way the direction points", M, CONCINO_SURFACE_KINDS) {
  const M m = grid<M>(3);
  for (const vec3 direction : {vec3{0, 0, 1}, vec3{0, 0, -0.5}, vec3{1, 2, 3}, vec3{0.3, 0, -1e-3}}) {
    const auto v = extrude(m, direction, 4);
    static_assert(std::is_same_v<std::remove_cvref_t<decltype(v)>, std::conditional_t<arity_v<M> == 4, hexmesh, polyhedralmesh>>);
    CHECK(num_verts(v) == 5 * num_verts(m));
    CHECK(num_polys(v) == 4 * num_polys(m));
    CHECK(num_faces(v) == 5 * num_polys(m) + 4 * num_edges(m));
    check_sound(v, 1);
    CHECK(total_measure(v) == doctest::Approx(std::abs(direction.z)).epsilon(1e-12));
    for (const vert_id x : verts(m)) {
      CHECK(point(v, x) == point(m, x));
      CHECK(point(v, vert_id{4 * num_verts(m) + x.raw()}) == to_vec3(point(m, x)) + direction);
    }
    std::size_t k = 0;
    for (const poly_id p : polys(v)) {
      CHECK(measure(v, p) == doctest::Approx(std::abs(direction.z) / 4 * measure(m, poly_id{k % num_polys(m)})).epsilon(1e-12));
      ++k;
    }
  }
  CHECK(num_polys(extrude(m, {0, 0, 1})) == num_polys(m));
  CHECK(num_polys(extrude(M(), {0, 0, 1}, 3)) == 0);
}

TEST_CASE_TEMPLATE("extrude: properties and correspondence; the archetype", M, CONCINO_SURFACE_KINDS) {
  M m = two_grids<M>(1);  // with an isolated vert
  const auto place = vert_property<vec3>(m, "place");
  for (const vert_t<M> v : verts(m)) place[v] = point(m, v);
  const auto name = poly_property<int>(m, "name");
  const auto mass = poly_property<double>(m, "mass");
  set_property_rule(m, element_kind::poly, "mass", property_rule::sum);
  for (const poly_t<M> p : polys(m)) name[p] = 10 + static_cast<int>(p.raw()), mass[p] = 6;
  edge_property<int>(m, "crease");
  correspondence c;
  const auto v = extrude(m, {0, 0, 3}, 3, {.correspondence = &c});
  REQUIRE(c.verts.size() == num_verts(v));
  REQUIRE(c.polys.size() == num_polys(v));
  const auto place_in_volume = find_vert_property<vec3>(v, "place");
  for (const vert_id x : verts(v)) {
    const vec3 at = point(m, vert_id{c.verts.only(x.raw())});
    CHECK(place_in_volume[x] == at);
    CHECK(point(v, x) == at + vec3{0, 0, static_cast<double>(x.raw() / num_verts(m))});
  }
  for (const poly_id p : polys(v)) {
    CHECK(c.polys.only(p.raw()) == p.raw() % num_polys(m));
    CHECK(find_poly_property<int>(v, "name")[p] == 10 + static_cast<int>(p.raw() % num_polys(m)));
    CHECK(find_poly_property<double>(v, "mass")[p] == doctest::Approx(2));
  }
  CHECK(property_list(v).size() == 3);
  CHECK(property_list(extrude(m, {0, 0, 3}, 3, {.properties = false})).empty());
  correspondence of_bare;
  const auto bare = extrude(only_embedded_mesh(m), {0, 0, 3}, 3, {.correspondence = &of_bare});
  CHECK(of_bare.verts.size() == c.verts.size());
  CHECK(num_verts(bare) == num_verts(v));
  CHECK(total_measure(bare) == doctest::Approx(total_measure(v)));
}

TEST_CASE("extrude: any scale, and polys that are not planar") {
  quadmesh m = grid<quadmesh>(4);
  for (const vert_id v : verts(m)) set_point(m, v, to_vec3(point(m, v)) + vec3{0, 0, 0.1 * static_cast<double>(v.raw() % 3)});
  CHECK(total_measure(extrude(m, {0, 0, 2}, 3)) == doctest::Approx(2).epsilon(1e-12));
  for (const double scale : {1e-150, 1e90}) {
    trimesh t = grid<trimesh>(2);
    for (const vert_id v : verts(t)) set_point(t, v, scale * to_vec3(point(t, v)));
    const auto prisms = extrude(t, scale * vec3{0, 0, -1}, 2);
    CHECK(num_polys(prisms) == 2 * num_polys(t));
    if (scale > 1) CHECK(total_measure(prisms) / scale / scale / scale == doctest::Approx(1).epsilon(1e-12));
  }
}

TEST_CASE("extrude: polys that are wound differently but face the direction alike need no change") {
  quadmesh m = grid<quadmesh>(2);
  const double whole = total_measure(extrude(m, {0, 0, 1}, 2));
  const quadmesh turned(std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}}, std::vector<std::vector<unsigned>>{{0, 1, 4, 3}, {1, 4, 5, 2}});
  check_sound(extrude(turned, {0, 0, 1}, 2), 1);
  CHECK(whole == doctest::Approx(1));
}

TEST_CASE("extrude: errors name what is wrong") {
  const trimesh m = grid<trimesh>(1);
  CHECK_THROWS_WITH_AS(extrude(m, {0, 0, 1}, 0), "extrude: layers is 0; it must be at least 1", invalid_argument);
  CHECK_THROWS_WITH_AS(extrude(m, {0, 0, 0}, 1), "extrude: direction is 0; it must have a length", invalid_argument);
  CHECK_THROWS_WITH_AS(extrude(m, {0, infinity, 0}, 1), "extrude: direction.y is not finite", invalid_argument);
  CHECK_THROWS_WITH_AS(extrude(m, {0, 0, 1}, std::size_t{1} << 31), doctest::Contains("extrude: layers asks for "), invalid_argument);
  CHECK_THROWS_WITH_AS(extrude(m, {1, 1, 0}, 1), doctest::Contains("extrude: poly 0 moves parallel to itself"), invalid_argument);
  CHECK_THROWS_WITH_AS(extrude(make_sphere<trimesh>({.cells = 2}), {0.1, 0.2, 1}, 1), doctest::Contains("so that their cells would overlap"), invalid_argument);
  trimesh bad = m;
  set_point(bad, vert_id{1}, vec3{0, std::nan(""), 0});
  CHECK_THROWS_WITH_AS(extrude(bad, {0, 0, 1}, 1), "extrude: the point of vert 1 is not finite", invalid_mesh);
  trimesh flat = m;
  for (const vert_id v : verts(flat)) set_point(flat, v, vec3{0, 0, 0});
  CHECK_THROWS_WITH_AS(extrude(flat, {0, 0, 1}, 1), "extrude: poly 0 has no area; remove it first", invalid_mesh);
  const std::vector<vec3> fan{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {-1, 0, 0}, {-1, 0, 1}};
  CHECK_THROWS_WITH_AS(extrude(trimesh(fan, std::vector<std::vector<unsigned>>{{0, 2, 1}, {0, 1, 3}, {0, 1, 4}}), {0, 0, 1}, 1),
                       doctest::Contains("has more than two polys"), invalid_mesh);
  CHECK_THROWS_WITH_AS(extrude(trimesh(fan, std::vector<std::vector<unsigned>>{{0, 1, 3}, {0, 1, 4}}), {0, 0, 1}, 1),
                       doctest::Contains("extrude: polys 0 and 1 run along edge "), invalid_mesh);
}

TEST_CASE("extrude: cells of polygons that are not convex are listed") {
  std::vector<poly_id> inverted{poly_id{7}};
  extrude(grid<quadmesh>(2), {0, 0, 1}, 2, {.inverted = &inverted});
  CHECK(inverted.empty());
  // a square, and a quad with a reflex vert, 2
  const std::vector<vec3> x{{0, 0, 0}, {1, 0, 0}, {0.25, 0.25, 0}, {0, 1, 0}, {-1, 0, 0}, {-1, 1, 0}};
  const std::vector<std::vector<unsigned>> quads{{4, 0, 3, 5}, {0, 1, 2, 3}};
  for (const double height : {2.0, -2.0}) {
    const hexmesh v = extrude(quadmesh(x, quads), {0, 0, height}, 2, {.inverted = &inverted});
    CHECK(inverted == std::vector<poly_id>{poly_id{1}, poly_id{3}});
    CHECK(total_measure(v) == doctest::Approx(2.5));
  }
  extrude(polygonmesh(x, quads), {1, 0, 2}, 2, {.inverted = &inverted});
  CHECK(inverted == std::vector<poly_id>{poly_id{1}, poly_id{3}});
}
