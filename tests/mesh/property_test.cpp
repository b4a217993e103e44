// Named properties: typed, made on first use, copied with the mesh, grown by edits.
#include <concino/edit.hpp>
#include <concino/mesh/property.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <string>

namespace cn = concino;

static_assert(cn::HasProperties<cn::trimesh> && cn::HasProperties<const cn::hexmesh&>);
static_assert(!cn::HasProperties<int>);

TEST_CASE_TEMPLATE("made if absent, found again by name and type", M, CONCINO_ALL_KINDS) {
  M m = cn::testing::grid<M>(2);
  CHECK_FALSE(cn::find_vert_property<double>(m, "heat"));
  auto heat = cn::vert_property<double>(m, "heat");
  for (const auto v : cn::verts(m)) CHECK(heat[v] == 0.0);
  heat[cn::vert_id{2}] = 20;
  CHECK(cn::find_vert_property<double>(m, "heat")[cn::vert_id{2}] == 20);
  auto flag = cn::poly_property<bool>(m, "heat");
  flag[cn::poly_id{1}] = true;
  CHECK(cn::poly_property<bool>(m, "heat")[cn::poly_id{1}]);
  cn::edge_property<std::string>(m, "name")[cn::edge_id{0}] = "first";
  if constexpr (cn::VolumeMesh<M>) cn::face_property<int>(m, "label")[cn::face_id{0}] = 3;
  CHECK(cn::property_list(m).size() == (cn::VolumeMesh<M> ? 4 : 3));
  CHECK(cn::property_list(m)[0].name == "heat");
  CHECK(cn::property_list(m)[0].kind == cn::element_kind::vert);
  CHECK(*cn::property_list(m)[1].type == typeid(bool));
}

TEST_CASE("another type under the same name is an error") {
  auto m = cn::testing::grid<cn::trimesh>(1);
  cn::vert_property<double>(m, "u");
  CHECK_THROWS_AS(cn::vert_property<int>(m, "u"), cn::invalid_argument);
  CHECK_THROWS_AS(cn::find_vert_property<float>(m, "u"), cn::invalid_argument);
}

TEST_CASE("a handle outlives the removal of its property") {
  auto m = cn::testing::grid<cn::trimesh>(1);
  auto u = cn::vert_property<double>(m, "u");
  u[cn::vert_id{0}] = 5;
  CHECK(cn::remove_property(m, cn::element_kind::vert, "u"));
  CHECK_FALSE(cn::remove_property(m, cn::element_kind::vert, "u"));
  CHECK(u[cn::vert_id{0}] == 5);
  CHECK_FALSE(cn::find_vert_property<double>(m, "u"));
}

TEST_CASE_TEMPLATE("properties follow their elements through edits", M, CONCINO_ALL_KINDS) {
  M m = cn::testing::grid<M>(2);
  auto u = cn::vert_property<unsigned>(m, "u");
  auto w = cn::poly_property<unsigned>(m, "w");
  for (const auto v : cn::verts(m)) u[v] = 10 * v.raw();
  for (const auto p : cn::polys(m)) w[p] = 10 * p.raw();
  cn::remove_poly(m, cn::poly_id{0});
  const auto fresh = cn::add_vert(m, {7, 7, 7});
  CHECK(u[fresh] == 0);
  u[fresh] = 1;
  for (const auto v : cn::verts(m))
    if (v != fresh) CHECK(u[v] == 10 * v.raw());
  for (const auto p : cn::polys(m)) CHECK(w[p] == 10 * p.raw());
}
