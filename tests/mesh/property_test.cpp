// Named properties are typed, created on first use, copied with the mesh, and follow edits.
#include <concino/edit.hpp>
#include <concino/mesh/property.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <cstdint>
#include <string>

namespace cn = concino;

static_assert(cn::HasProperties<cn::trimesh> && cn::HasProperties<const cn::hexmesh&>);
static_assert(!cn::HasProperties<int>);

TEST_CASE_TEMPLATE("properties: are created if absent, and found by name and type", M, CONCINO_KINDS) {
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

TEST_CASE("properties: another type under the same name throws") {
  auto m = cn::testing::grid<cn::trimesh>(1);
  cn::vert_property<double>(m, "u");
  CHECK_THROWS_WITH_AS(cn::vert_property<int>(m, "u"), "vert_property: the property \"u\" holds values of type double, not int; use another name or remove it first",
                       cn::invalid_argument);
  CHECK_THROWS_AS(cn::find_vert_property<float>(m, "u"), cn::invalid_argument);
}

TEST_CASE("properties: a handle is valid after its property is removed") {
  auto m = cn::testing::grid<cn::trimesh>(1);
  auto u = cn::vert_property<double>(m, "u");
  u[cn::vert_id{0}] = 5;
  CHECK(cn::remove_property(m, cn::element_kind::vert, "u"));
  CHECK_FALSE(cn::remove_property(m, cn::element_kind::vert, "u"));
  CHECK(u[cn::vert_id{0}] == 5);
  CHECK_FALSE(cn::find_vert_property<double>(m, "u"));
}

TEST_CASE_TEMPLATE("properties: of the mesh have one value, which edits do not change", M, CONCINO_KINDS) {
  M m = cn::testing::grid<M>(2);
  CHECK_FALSE(cn::find_mesh_property<std::string>(m, "title"));
  const auto title = cn::mesh_property<std::string>(m, "title");
  CHECK(title->empty());
  *title = "a mesh with a title";
  cn::vert_property<double>(m, "title");
  CHECK(cn::to_string(cn::property_list(m)[0].kind) == "mesh");
  const M copy = m;
  cn::remove_poly(m, cn::poly_id{0});
  cn::add_vert(m, {7, 7, 7});
  CHECK(*cn::mesh_property<std::string>(m, "title") == "a mesh with a title");
  *title = "changed";
  CHECK(*cn::find_mesh_property<std::string>(copy, "title") == "a mesh with a title");
  CHECK_THROWS_AS(cn::mesh_property<int>(m, "title"), cn::invalid_argument);
  CHECK_THROWS_AS(cn::find_mesh_property<int>(m, "title"), cn::invalid_argument);
  CHECK(cn::remove_property(m, cn::element_kind::mesh, "title"));
  CHECK(*title == "changed");
  CHECK_FALSE(cn::find_mesh_property<std::string>(m, "title"));
  CHECK(cn::find_vert_property<double>(m, "title"));
}

TEST_CASE_TEMPLATE("properties: follow their elements through edits", M, CONCINO_KINDS) {
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

namespace {

/// Counts its objects. Constructors count `left` down, and throw where it is 0.
struct counted {
  static inline int alive = 0, left = 1 << 30;
  std::string text = "as made, and too long to be kept inside of the string";
  counted() { arrive(); }
  counted(const counted& o) : text(o.text) { arrive(); }
  ~counted() { --alive; }

 private:
  static void arrive() {
    if (left-- == 0) throw 7;
    ++alive;
  }
};

struct alignas(64) wide {
  float part[16] = {1, 2};
};

}  // namespace

TEST_CASE("properties: values of any type are constructed, copied, moved and destroyed correctly") {
  {
    auto m = cn::testing::grid<cn::trimesh>(3);
    auto text = cn::vert_property<counted>(m, "text");
    auto part = cn::poly_property<wide>(m, "part");
    const cn::vert_id a{0}, z{cn::num_verts(m) - 1};
    text[a].text = "first";
    text[z].text += ", and more";
    part[cn::poly_id{0}].part[1] = 3;
    const auto copy = m;
    text[a].text = "changed";
    for (int i = 0; i < 100; ++i) cn::add_vert(m, {0, 0, 0});
    CHECK(text[a].text == "changed");
    CHECK(text[z].text == counted().text + ", and more");
    CHECK(text[cn::vert_id{cn::num_verts(m) - 1}].text == counted().text);
    CHECK(cn::find_vert_property<counted>(copy, "text")[a].text == "first");
    CHECK(cn::find_poly_property<wide>(copy, "part")[cn::poly_id{0}].part[1] == 3);
    for (const auto p : cn::polys(m)) {
      CHECK(reinterpret_cast<std::uintptr_t>(&part[p]) % 64 == 0);
      CHECK(part[p].part[0] == 1);
      CHECK(part[p].part[1] == (p.raw() == 0 ? 3 : 2));
    }
  }
  CHECK(counted::alive == 0);
}

TEST_CASE("properties: a value that cannot be constructed or copied changes nothing") {
  {
    auto m = cn::testing::grid<cn::trimesh>(2);
    counted::left = 3;
    CHECK_THROWS_AS(cn::vert_property<counted>(m, "text"), int);
    CHECK(counted::alive == 0);
    CHECK(cn::property_list(m).empty());
    counted::left = 1 << 30;
    auto text = cn::vert_property<counted>(m, "text");
    text[cn::vert_id{1}].text = "kept";
    const int before = counted::alive;
    counted::left = 3;
    CHECK_THROWS_AS(cn::trimesh{m}, int);
    counted::left = 3;
    CHECK_THROWS_AS(cn::add_vert(m, {0, 0, 0}), int);
    counted::left = 1 << 30;
    CHECK(counted::alive == before);
    CHECK(text[cn::vert_id{1}].text == "kept");
  }
  CHECK(counted::alive == 0);
}
