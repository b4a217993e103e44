#include <concino/render/any_field.hpp>

#include <concino/edit/elements.hpp>
#include <concino/mesh/element_map.hpp>
#include <concino/mesh/facet_map.hpp>
#include <concino/mesh/hexmesh.hpp>
#include <concino/mesh/property.hpp>
#include <concino/mesh/submesh.hpp>
#include <concino/mesh/trimesh.hpp>

#include <support/meshes.hpp>

#include <doctest/doctest.h>

#include <cmath>

using namespace concino;

namespace {

struct options {
  any_field<trimesh> field = {};
};

std::vector<double> values(const trimesh& m, const options& o) {
  std::vector<double> all{7};
  o.field.fill(m, all);
  return all;
}

/// Numbers at verts and polys.
struct both_kinds {
  double operator[](const vert_id& v) const { return v.raw(); }
  double operator[](const poly_id& p) const { return -1.0 - p.raw(); }
};
struct no_numbers {
  const char* operator[](const vert_id&) const { return ""; }
};

static_assert(!std::is_convertible_v<no_numbers, any_field<trimesh>> && !std::is_convertible_v<int, any_field<trimesh>>);
static_assert(!std::is_convertible_v<face_map<hexmesh, double>, any_field<trimesh>> && std::is_convertible_v<face_map<hexmesh, double>, any_field<hexmesh>>);

}  // namespace

TEST_CASE("any_field: holds maps of verts, polys, edges, faces") {
  trimesh m(testing::triangle_grid(2));
  auto at_verts = make_vert_map<double>(m, 0.5);
  CHECK(any_field<trimesh>().at() == element_kind::mesh);
  CHECK(!any_field<trimesh>());
  const options o{.field = at_verts};
  CHECK(o.field.at() == element_kind::vert);
  at_verts[vert_id{1}] = 3;  // it refers to the map
  CHECK(values(m, o)[1] == 3);
  CHECK(values(m, o).size() == num_verts(m));
  CHECK(values(m, {.field = make_edge_map<int>(m, 4)}) == std::vector<double>(num_edges(m), 4));
  CHECK(options{.field = make_poly_map<bool>(m)}.field.at() == element_kind::poly);
  CHECK(values(m, {.field = both_kinds{}})[2] == 2);
  vert_property<float>(m, "u")[vert_id{3}] = 8;
  const options copy = options{.field = find_vert_property<float>(m, "u")};
  CHECK(values(m, copy)[3] == 8);
  const hexmesh cube(testing::hex_grid(2));
  const any_field<hexmesh> at_faces = make_facet_map<double>(cube, 2.0);
  CHECK(at_faces.at() == element_kind::face);
  std::vector<double> all;
  at_faces.fill(cube, all);
  CHECK(all == std::vector<double>(num_faces(cube), 2));
}

TEST_CASE("any_field: indices without an element have no value; views have the maps of their meshes") {
  trimesh m(testing::triangle_grid(2));
  const auto u = make_poly_map<double>(m, 1.0);
  const auto half = submesh(m, [](const poly_id& p) { return p.raw() > 3; });
  any_field<std::remove_cvref_t<decltype(half)>> field = u;
  std::vector<double> all;
  field.fill(half, all);
  CHECK(std::isnan(all[3]));
  CHECK(all[4] == 1);
}

TEST_CASE("any_field: a map of another mesh is refused") {
  trimesh m(testing::triangle_grid(1));
  const trimesh other(testing::triangle_grid(3));
  const hexmesh cube(testing::hex_grid(2));
  const auto u = make_vert_map<double>(other);
  CHECK_THROWS_WITH_AS(values(m, {.field = u}), "any_field: the map belongs to another mesh; make it with make_vert_map<...>(m)", invalid_argument);
  CHECK_THROWS_AS(values(m, {.field = make_poly_map<double>(cube)}), invalid_argument);
  const auto before = make_vert_map<double>(m);
  add_vert(m, {5, 5, 5});
  CHECK_THROWS_AS(values(m, {.field = before}), invalid_argument);
}
