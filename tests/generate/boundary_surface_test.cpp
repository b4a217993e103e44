#include <concino/generate/boundary_surface.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/generate/sphere.hpp>
#include <concino/mesh/property.hpp>
#include <concino/mesh/submesh.hpp>

#include <support/generated.hpp>
#include <support/kinds.hpp>
#include <support/subdivisions.hpp>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("boundary_surface: closed, outward, with the volume inside", M, CONCINO_VOLUME_KINDS) {
  const M m = grid<M>(3);
  const auto s = boundary_surface(m);
  static_assert(std::is_same_v<std::remove_cvref_t<decltype(s)>,
                               std::conditional_t<arity_v<M> == 4, trimesh, std::conditional_t<arity_v<M> == 8, quadmesh, polygonmesh>>>);
  check_sound(s, 2);
  CHECK(num_polys(s) == num_polys(boundary(m)));
  CHECK(enclosed_volume(s) == doctest::Approx(total_measure(m)).epsilon(1e-12));
  CHECK(record_of(boundary_surface(only_embedded_mesh(m), {.correspondence = nullptr})) == record_of(s));
  CHECK(num_polys(boundary_surface(M())) == 0);
}

TEST_CASE_TEMPLATE("boundary_surface: the map back, and properties", M, CONCINO_VOLUME_KINDS) {
  M m = grid<M>(2);
  const auto place = vert_property<vec3>(m, "place");
  for (const vert_id v : verts(m)) place[v] = point(m, v);
  const auto length = edge_property<double>(m, "name");
  for (const edge_id e : edges(m)) length[e] = edge_length(m, e);
  const auto name = face_property<int>(m, "name");
  for (const face_id f : faces(m)) name[f] = 5 + static_cast<int>(f.raw());
  const auto mass = face_property<double>(m, "mass");
  set_property_rule(m, element_kind::face, "mass", property_rule::sum);
  for (const face_id f : faces(m)) mass[f] = 2;
  poly_property<int>(m, "name");
  *mesh_property<double>(m, "time") = 7;
  correspondence c;
  const auto s = boundary_surface(m, {.correspondence = &c});
  REQUIRE(c.verts.size() == num_verts(s));
  REQUIRE(c.edges.size() == num_edges(s));
  REQUIRE(c.polys.size() == num_polys(s));
  for (const vert_id v : verts(s)) {
    CHECK(point(s, v) == point(m, vert_id{c.verts.only(v.raw())}));
    CHECK(find_vert_property<vec3>(s, "place")[v] == to_vec3(point(s, v)));
  }
  for (const edge_id e : edges(s)) CHECK(find_edge_property<double>(s, "name")[e] == edge_length(s, e));
  for (const poly_id p : polys(s)) {
    const face_id f{c.polys.only(p.raw())};
    CHECK(is_boundary(m, f));
    CHECK(measure(s, p) == doctest::Approx(measure(m, f)));
    CHECK(find_poly_property<int>(s, "name")[p] == name[f]);
    CHECK(find_poly_property<double>(s, "mass")[p] == 2);
  }
  CHECK(*find_mesh_property<double>(s, "time") == 7);
  CHECK(property_list(s).size() == 5);
  CHECK(property_list(s)[3].rule == property_rule::sum);
  CHECK(property_list(boundary_surface(m, {.properties = false})).empty());
}

TEST_CASE("boundary_surface: of part of a volume") {
  const hexmesh m = grid<hexmesh>(3);
  const auto part = submesh(m, [&](poly_id p) { return p.raw() != 13; });  // without the cube in the middle
  const quadmesh s = boundary_surface(part);
  CHECK(check_laws(s).empty());
  CHECK(euler(s) == 4);
  CHECK(num_polys(s) == 60);
  CHECK(enclosed_volume(s) == doctest::Approx(26 / 27.0));
}
