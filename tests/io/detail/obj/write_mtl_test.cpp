#include <concino/io/detail/obj/write_mtl.hpp>

#include <concino/io/load.hpp>
#include <concino/io/save.hpp>

#include <support/kinds.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

#include <algorithm>
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
  const auto of_polys = [](const M& m) {
    const auto all = property_list(m);
    return std::count_if(all.begin(), all.end(), [](const property_info& p) { return p.kind == element_kind::poly; });
  };
  return of_polys(a) == of_polys(b) && same_property<rgba>(a, b, "color") && same_property<int>(a, b, "label") &&
         same_property<std::string>(a, b, "object") && same_property<std::string>(a, b, "group") &&
         same_property<std::string>(a, b, "material");
}

/// A row of triangles.
trimesh triangles(std::size_t n) {
  surface_arrays a;
  for (std::size_t i = 0; i < n + 2; ++i) a.points.push_back({static_cast<double>(i), static_cast<double>(i % 2), 0});
  a.arity = 3;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < 3; ++k) a.verts.push_back(vert_id{i + k});
  return trimesh(std::move(a));
}

using lines = std::vector<material>;
lines lines_of(const trimesh& m) {
  const auto table = find_mesh_property<material_table>(m, "materials");
  return table ? table->materials : lines{};
}

}  // namespace

TEST_CASE_TEMPLATE("write_mtl: colours of polys are the same to the last bit after saving and loading", M, trimesh, quadmesh, polygonmesh) {
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
  CHECK(r.lost == list{"poly property \"color\": it belongs in a .mtl file beside the .obj file, and text has no folder"});
  CHECK(text.find("mtl") == text.npos);
}

TEST_CASE("write_mtl: materials, groups, objects and labels are the same after saving and loading") {
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
  CHECK(r.lost == list{"poly property \"label\": .obj cannot store it"});
}

TEST_CASE("write_mtl: colours of verts are saved, and their opacity is reported as lost") {
  auto m = grid<quadmesh>(2);
  const auto color = vert_property<rgba>(m, "color");
  for (const auto v : verts(m)) color[v] = {1.0f / 3, static_cast<float>(v.raw()), 1e-7f};
  save_report r;
  const auto again = load_text<quadmesh>(save_text(m, file_format::obj, {.report = &r}), file_format::obj);
  for (const auto v : verts(m)) CHECK(find_vert_property<rgba>(again, "color")[v] == color[v]);
  CHECK(r.lost.empty());
  color[vert_id{0}].a = 0.5f;
  save_text(m, file_format::obj, {.report = &r});
  CHECK(r.lost == list{"opacity of verts: .obj cannot store it"});
}

TEST_CASE("write_mtl: materials are split by colour, and names are changed to fit on a line") {
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
  CHECK(r.lost == list{"materials of several colours: 1 got new names, as a material of .mtl has one colour"});
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

TEST_CASE("write_mtl: if the library cannot be written, the .obj file is unchanged") {
  const temporary_folder dir;
  trimesh m = grid<trimesh>(1);
  poly_property<rgba>(m, "color");
  write_file(dir / "a.obj", "old");
  std::filesystem::create_directory(dir / "a.mtl");
  CHECK_THROWS_AS(save(m, dir / "a.obj"), io_error);
  CHECK(read_file(dir / "a.obj") == "old");
  CHECK(dir.num_files() == 2);
}

TEST_CASE("write_mtl: a poly with a colour of its own gets a copy of its material with that colour") {
  const temporary_folder dir;
  trimesh m = triangles(6);
  mesh_property<material_table>(m, "materials")->materials = {
      {"gold", {"Ka 0.1 0.1 0", "Kd 1 0.75 0", "Tr 0", "Ns 30", "d 1", "# rich"}}, {"plain", {"illum 1"}}, {"glass", {"Kd 0 0 1", "d 0.5", "Tr 0.5"}}, {"unused", {"Kd 1 1 1"}}};
  const auto name = poly_property<std::string>(m, "material");
  const auto color = poly_property<rgba>(m, "color");
  const std::string names[] = {"gold", "gold", "gold", "plain", "glass", ""};
  for (const auto p : polys(m)) name[p] = names[p.raw()];
  color[poly_id{0}] = {0, 1, 0};  // not the colour of gold, which the next poly has
  color[poly_id{1}] = {1, 0.75f, 0};
  color[poly_id{2}] = {1, 0.75f, 0, 0.25f};
  color[poly_id{3}] = {};
  color[poly_id{4}] = {0, 0, 0.5f, 0.5f};  // no poly has the colour of glass
  color[poly_id{5}] = {};                  // white, and no material
  save_report r;
  save(m, dir / "a.obj", {.report = &r});
  CHECK(r.lost == list{"materials of several colours: 2 got new names, as a material of .mtl has one colour"});
  CHECK(r.notes.empty());
  const auto again = load<trimesh>(dir / "a.obj");
  CHECK(same_property<rgba>(m, again, "color"));
  CHECK(lines_of(again) == lines{{"gold", {"Ka 0.1 0.1 0", "Kd 1 0.75 0", "Tr 0", "Ns 30", "d 1", "# rich"}},
                                 {"plain", {"illum 1"}},
                                 {"glass", {"Kd 0 0 0.5", "d 0.5", "Tr 0.5"}},
                                 {"unused", {"Kd 1 1 1"}},
                                 {"gold_1", {"Ka 0.1 0.1 0", "Kd 0 1 0", "Tr 0", "Ns 30", "d 1", "# rich"}},
                                 {"gold_2", {"Ka 0.1 0.1 0", "Kd 1 0.75 0", "Tr 0.75", "Ns 30", "d 0.25", "# rich"}}});
  const auto named = find_poly_property<std::string>(again, "material");
  const std::string expected[] = {"gold_1", "gold", "gold_2", "plain", "glass", ""};
  for (const auto p : polys(m)) CHECK(named[p] == expected[p.raw()]);

  // a material without a colour gets one; a line of its opacity is replaced
  trimesh other = triangles(2);
  mesh_property<material_table>(other, "materials")->materials = {{"plain", {"illum 1", "d 0.5"}}, {"odd", {"Kd xyz 1 1 1", "Kd 0 0", "d -halo 0.5", "Kd 1 1 0"}}};
  for (const auto p : polys(other)) {
    poly_property<std::string>(other, "material")[p] = p.raw() ? "odd" : "plain";
    poly_property<rgba>(other, "color")[p] = {0, 0.5f, 0, p.raw() ? 0.5f : 1};
  }
  save(other, dir / "b.obj", {.report = &r});
  CHECK(r.lost.empty());
  const auto back = load<trimesh>(dir / "b.obj");
  CHECK(same_properties(other, back));
  CHECK(lines_of(back) == lines{{"plain", {"Kd 0 0.5 0", "illum 1", "d 1"}}, {"odd", {"Kd 0 0.5 0", "d 0.5"}}});
}

TEST_CASE("write_mtl: reports what a library cannot store of the materials") {
  const temporary_folder dir;
  trimesh m = triangles(1);
  *mesh_property<material_table>(m, "materials") = {
      .materials = {{"a\nb", {"Ks 1\n1 1 ", " # x", "newmtl c", "  "}}, {"a_b", {}}, {"", {"Kd 1 1 1"}}, {"d", {}}}, .head = {"# head"}};
  save_report r;
  save(m, dir / "a.obj", {.report = &r});
  CHECK(r.lost == list{"materials without a name, or with the name of another: 2 were left out",
                       "lines of materials that are empty or begin another material: 2 were left out",
                       "names of polys that do not fit into a line of .obj: they were changed"});
  const auto again = load<trimesh>(dir / "a.obj");
  CHECK(lines_of(again) == lines{{"a_b", {"Ks 1 1 1", "# x"}}, {"d", {}}});
  CHECK(find_mesh_property<material_table>(again, "materials")->head == list{"# head"});

  save_text(m, file_format::obj, {.report = &r});
  CHECK(r.lost == list{"mesh property \"materials\": it belongs in a .mtl file beside the .obj file, and text has no folder"});
  save_text(m, file_format::off, {.report = &r});
  CHECK(r.lost == list{"mesh property \"materials\": .off cannot store it"});
  const auto text = load_text<trimesh>("mtllib x.mtl\n" + save_text(triangles(1), file_format::obj), file_format::obj);
  CHECK(save_text(text, file_format::obj, {.report = &r}).find("\nmtllib x.mtl\n") != std::string::npos);
  CHECK(r.lost.empty());
}

TEST_CASE("write_mtl: names without a material in the table stay undefined and white") {
  const temporary_folder dir;
  trimesh m = triangles(3);
  mesh_property<material_table>(m, "materials")->materials = {{"red", {"Kd 1 0 0"}}};
  const auto name = poly_property<std::string>(m, "material");
  const auto color = poly_property<rgba>(m, "color");
  name[poly_id{0}] = "red", color[poly_id{0}] = {1, 0, 0};
  name[poly_id{1}] = "grey";
  save(m, dir / "a.obj");
  load_report read;
  const auto again = load<trimesh>(dir / "a.obj", {.report = &read});
  CHECK(same_properties(m, again));
  CHECK(lines_of(again).size() == 1);
  CHECK(read.notes == list{"1 materials have no colour in a library and become white; 'grey'"});
  // a library that defines the name is not used for this mesh
  write_file(dir / "b.mtl", "newmtl grey\nKd 0.5 0.5 0.5\nnewmtl red\nKd 1 0 0\n");
  save(m, dir / "b.obj");
  CHECK(same_properties(m, load<trimesh>(dir / "b.obj")));
  // but a name whose polys have two colours is defined
  name[poly_id{2}] = "grey", color[poly_id{2}] = {0, 0, 0.5f};
  save(m, dir / "c.obj");
  CHECK(same_property<rgba>(m, load<trimesh>(dir / "c.obj"), "color"));
}
