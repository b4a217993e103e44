#include <concino/io/write_mtl.hpp>

#include <concino/io/load.hpp>
#include <concino/io/save.hpp>

#include <support/kinds.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

#include <limits>

using namespace concino;
using namespace concino::testing;

namespace {

using list = std::vector<std::string>;

/// Whether polys have the same values of a property, or neither mesh has it.
template<class T, class M>
bool same_property(const M& a, const M& b, const char* name) {
  const auto x = find_poly_property<T>(a, name), y = find_poly_property<T>(b, name);
  if (bool(x) != bool(y)) return false;
  if (x)
    for (const auto p : polys(a))
      if (!(x[p] == y[p])) return false;
  return true;
}
template<class M>
bool same_properties(const M& a, const M& b) {
  return property_list(a).size() == property_list(b).size() && same_property<rgba>(a, b, "color") && same_property<int>(a, b, "label") &&
         same_property<std::string>(a, b, "object") && same_property<std::string>(a, b, "group") &&
         same_property<std::string>(a, b, "material");
}

}  // namespace

TEST_CASE_TEMPLATE("write_mtl: colours of polys come back through the library, to the last bit", M, trimesh, quadmesh, polygonmesh) {
  const temporary_folder dir;
  M m = grid<M>(3);
  const auto color = poly_property<rgba>(m, "color");
  for (const auto p : polys(m)) color[p] = {0.1f * static_cast<float>(p.raw() % 3), 1.0f / 3, 1, p.raw() % 2 ? 1.0f : 0.7f};
  save_report r;
  save(m, dir / "a.b.obj", {.report = &r});
  CHECK(r.lost.empty());
  CHECK(dir.num_files() == 2);
  CHECK(read_file(dir / "a.b.mtl").starts_with("# "));
  load_report read;
  CHECK(same_properties(m, load<M>(dir / "a.b.obj", {.report = &read})));
  CHECK(read.notes.empty());
  const auto text = save_text(m, file_format::obj, {.report = &r});
  CHECK(r.lost == list{"poly property \"color\": it goes to a .mtl file beside the .obj file, and text has none beside it"});
  CHECK(text.find("mtl") == text.npos);
}

TEST_CASE("write_mtl: materials, groups, objects and labels come back") {
  const temporary_folder dir;
  const auto comes_back = [&](const trimesh& m) {
    save_report r;
    save(m, dir / "a.obj", {.report = &r});
    return r.lost.empty() && same_properties(m, load<trimesh>(dir / "a.obj"));
  };
  const auto with = [](auto... dress) {
    trimesh m = grid<trimesh>(2);
    (dress(m), ...);
    return m;
  };
  const auto material = [](trimesh& m) {
    const auto name = poly_property<std::string>(m, "material");
    for (const auto p : polys(m)) name[p] = p.raw() % 3 == 0 ? "" : p.raw() % 3 == 1 ? "old gold" : "x#1";
  };
  const auto color = [](trimesh& m) {
    const auto c = poly_property<rgba>(m, "color");
    for (const auto p : polys(m)) c[p].r = static_cast<float>(p.raw() % 3) / 3;
  };
  const auto group = [](trimesh& m) {
    const auto name = poly_property<std::string>(m, "group");
    for (const auto p : polys(m)) name[p] = p.raw() % 2 ? "odd" : "";
  };
  const auto object = [](trimesh& m) {
    const auto name = poly_property<std::string>(m, "object");
    for (const auto p : polys(m)) name[p] = p.raw() < 3 ? "b" : "a";
  };
  const auto group_labels = [](trimesh& m) {
    const auto label = poly_property<int>(m, "label");
    for (const auto p : polys(m)) label[p] = p.raw() % 2;
  };
  const auto object_labels = [](trimesh& m) {
    const auto label = poly_property<int>(m, "label");
    for (const auto p : polys(m)) label[p] = p.raw() < 3 ? 1 : 2;
  };
  const auto labels = [](trimesh& m) {
    const auto label = poly_property<int>(m, "label");
    label[poly_id{1}] = std::numeric_limits<int>::min();
    label[poly_id{3}] = 7;
  };
  CHECK(comes_back(with(material)));
  CHECK(comes_back(with(color, material)));
  CHECK(comes_back(with(color, labels)));
  CHECK(comes_back(with(labels)));
  CHECK(comes_back(with(group, group_labels)));
  CHECK(comes_back(with(object, object_labels)));
  CHECK(comes_back(with(object, labels)));
  CHECK(comes_back(with(object, group, material, color, group_labels)));

  save_report r;
  save(with(group, labels), dir / "a.obj", {.report = &r});
  CHECK(r.lost == list{"poly property \"label\": .obj has no place for it"});
}

TEST_CASE("write_mtl: colours of verts come back, opacity does not") {
  auto m = grid<quadmesh>(2);
  const auto color = vert_property<rgba>(m, "color");
  for (const auto v : verts(m)) color[v] = {1.0f / 3, static_cast<float>(v.raw()), 1e-7f};
  save_report r;
  const auto again = load_text<quadmesh>(save_text(m, file_format::obj, {.report = &r}), file_format::obj);
  for (const auto v : verts(m)) CHECK(find_vert_property<rgba>(again, "color")[v] == color[v]);
  CHECK(r.lost.empty());
  color[vert_id{0}].a = 0.5f;
  save_text(m, file_format::obj, {.report = &r});
  CHECK(r.lost == list{"opacity of verts: .obj has no place for it"});
}

TEST_CASE("write_mtl: a material has one colour, and a name fits on a line") {
  const temporary_folder dir;
  trimesh m = grid<trimesh>(2);
  const auto name = poly_property<std::string>(m, "material");
  const auto color = poly_property<rgba>(m, "color");
  for (const auto p : polys(m)) {
    name[p] = p.raw() == 0 ? "wood_1" : "wood";
    color[p].g = p.raw() < 2 ? 0 : 0.5f;
  }
  save_report r;
  save(m, dir / "a.obj", {.report = &r});
  CHECK(r.lost == list{"materials of several colours: 1 were given names of their own, as a material of .mtl has one colour"});
  const auto again = load<trimesh>(dir / "a.obj");
  CHECK(same_property<rgba>(m, again, "color"));
  CHECK(find_poly_property<std::string>(again, "material")[poly_id{1}] == "wood");
  CHECK(find_poly_property<std::string>(again, "material")[poly_id{2}] == "wood_2");
  for (const auto p : polys(m)) name[p] = " a\nf 1 2 3\\ #x ";
  color[poly_id{0}].r = std::numeric_limits<float>::quiet_NaN();
  save(m, dir / "b.obj", {.report = &r});
  CHECK(r.lost.size() == 3);
  const auto changed = load<trimesh>(dir / "b.obj");
  CHECK(num_polys(changed) == num_polys(m));
  CHECK(find_poly_property<rgba>(changed, "color")[poly_id{7}] == color[poly_id{7}]);
  CHECK(find_poly_property<std::string>(changed, "material")[poly_id{7}].starts_with("_a_f 1 2 3_ _x_"));
}

TEST_CASE("write_mtl: a library that cannot be written leaves the mesh's file as it was") {
  const temporary_folder dir;
  trimesh m = grid<trimesh>(1);
  poly_property<rgba>(m, "color");
  write_file(dir / "a.obj", "old");
  std::filesystem::create_directory(dir / "a.mtl");
  CHECK_THROWS_AS(save(m, dir / "a.obj"), io_error);
  CHECK(read_file(dir / "a.obj") == "old");
  CHECK(dir.num_files() == 2);
}
