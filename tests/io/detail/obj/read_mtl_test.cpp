#include <concino/io/detail/obj/read_mtl.hpp>

#include <concino/io/load.hpp>
#include <concino/mesh/trimesh.hpp>

#include <support/corpus.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

namespace {

const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
const std::string face = "f 1 2 3\n";
using list = std::vector<std::string>;

concino::detail::material_library library(const std::string& text, load_report& r) {
  r = {};
  concino::detail::material_library l;
  concino::detail::read_mtl(text, "t.mtl", l, r);
  return l;
}

}  // namespace

TEST_CASE("read_mtl: reads colours and opacities of materials, among other lines") {
  load_report r;
  auto l = library(
      "# c\r\nKd 9 9 9\nnewmtl  a b # c\n  Ka 1 1 1\n\tKd 0.5 0 1 # c\nd 0.25\nmap_Kd x.png\n\nnewmtl none\nillum 2\n"
      "newmtl xyz\nKd xyz 1 1 1\nnewmtl a b\nKd 0 0 0\nnewmtl last\nd -halo 1\nKd 1 1 0",
      r);
  CHECK(l.names.size() == 2);
  CHECK(l.colors[l.names.find("a b")] == rgba{0.5f, 0, 1, 0.25f});
  CHECK(l.colors[l.names.find("last")] == rgba{1, 1, 0});
  CHECK(l.num_textures == 1);
  CHECK(r.notes.empty());
  CHECK(library("", r).names.size() == 0);
}

TEST_CASE("read_mtl: an invalid line is noted in the report, and no error") {
  load_report r;
  auto l = library("newmtl a\nKd 1 2\nKd 1 x 2\nnewmtl b\nKd 0 0 0\n", r);
  CHECK(l.names.size() == 1);
  REQUIRE(r.notes.size() == 1);
  CHECK(r.notes[0].starts_with("t.mtl:2: expected three numbers after Kd"));
}

TEST_CASE("read_mtl: polys get the colours of their materials, from libraries in the folder of the file") {
  const temporary_folder dir;
  write_file(dir / "one.mtl", "newmtl red\nKd 1 0 0\n");
  write_file(dir / "two words.mtl", "newmtl blue\nKd 0 0 1\nmap_Kd blue.png\n");
  const std::string uses = points + face + "usemtl red\n" + face + "usemtl blue\n" + face + "usemtl grey\n" + face;
  const auto read = [&](const std::string& libraries, load_report& r) {
    write_file(dir / "a.obj", libraries + uses);
    return load<trimesh>(dir / "a.obj", {.report = &r});
  };
  load_report r;
  for (const std::string libraries : {"mtllib one.mtl\nmtllib two words.mtl\n", "mtllib .\\one.mtl\nmtllib C:\\x\\two words.mtl\n",
                                      "mtllib /elsewhere/two words.mtl\nmtllib one.mtl\n"}) {
    const trimesh m = read(libraries, r);
    const auto color = find_poly_property<rgba>(m, "color");
    const auto material = find_poly_property<std::string>(m, "material");
    REQUIRE(bool(color));
    const rgba expected[] = {{}, {1, 0, 0}, {0, 0, 1}, {}};
    const std::string names[] = {"", "red", "blue", "grey"};
    for (unsigned p = 0; p < 4; ++p) {
      CHECK(color[poly_id{p}] == expected[p]);
      CHECK(material[poly_id{p}] == names[p]);
    }
    CHECK(r.skipped == list{"1 textures of materials (map_Kd and the like)"});
    CHECK(r.notes == list{"1 materials have no colour in a library and become white; 'grey'"});
  }
  CHECK(find_poly_property<rgba>(read("mtllib none.mtl one.mtl\n", r), "color")[poly_id{1}] == rgba{1, 0, 0});
  CHECK(r.notes[0] == "material library 'none.mtl': there is no such file beside this one");
  CHECK(!find_poly_property<rgba>(read("mtllib none.mtl\n", r), "color"));
  CHECK(r.notes.size() == 1);
  CHECK(!find_poly_property<rgba>(read("mtllib .\n", r), "color"));  // a folder
  CHECK(r.notes.size() == 1);
  CHECK(!find_poly_property<rgba>(read("mtllib\n", r), "color"));
  const auto m = load_text<trimesh>("mtllib one.mtl\n" + uses, file_format::obj, {.report = &r});
  CHECK(!find_poly_property<rgba>(m, "color"));
  CHECK(r.notes == list{"material library 'one.mtl': not read, as text has no folder"});
}

TEST_CASE("read_mtl: the table keeps all lines of a material, also unknown ones") {
  load_report r;
  const auto l = library(
      "# made by hand\r\n\r\n# twice\nnewmtl  a b # c\r\n  Ka 0.1 0.2 0.3  \n\tKd 0.5 0 1 # c\n# a comment\nillum 2\n\nNs 96.078431\nTr 0.5\n"
      "map_Kd -s 1 1 1 x y.png\nfoo  bar \\\nbaz\nnewmtl b\nnewmtl\nKd 1 1 1\nnewmtl a b\nKd 0 0 0\nnewmtl b",
      r);
  const std::vector<material> expected = {
      {"a b", {"Ka 0.1 0.2 0.3", "Kd 0.5 0 1 # c", "# a comment", "illum 2", "Ns 96.078431", "Tr 0.5", "map_Kd -s 1 1 1 x y.png", "foo  bar \\", "baz"}}, {"b", {}}};
  CHECK(l.table.materials == expected);
  CHECK(l.table.head == list{"# made by hand", "# twice"});
  CHECK(l.names.size() == 1);
  CHECK(l.num_redefined == 1);
  CHECK(r.notes == list{"t.mtl: a material without a name was skipped"});
}

TEST_CASE("read_mtl: the mesh has the materials of all libraries that its file names") {
  const temporary_folder dir;
  write_file(dir / "one.mtl", "newmtl red\nKd 1 0 0\nillum 1\nnewmtl color_1\nKd 0 1 0\nd 0.5\n");
  write_file(dir / "two.mtl", "newmtl red\nKd 0 0 1\nnewmtl color_2\nKd 0 1 0\nKs 1 1 1\nnewmtl unused\nKa 0 0 0\nnewmtl color_3\nKd 1 1 0\n");
  write_file(dir / "a.obj", "mtllib one.mtl none.mtl\nmtllib two.mtl\n" + points + "usemtl red\n" + face + "usemtl color_1\n" + face + "usemtl color_2\n" + face);
  load_report r;
  const auto m = load<trimesh>(dir / "a.obj", {.report = &r});
  CHECK(r.notes == list{"material library 'none.mtl': there is no such file beside this one",
                        "1 materials have several definitions: the first one is used; 'red'"});
  const auto table = find_mesh_property<material_table>(m, "materials");
  REQUIRE(bool(table));
  CHECK(table->libraries == list{"one.mtl", "none.mtl", "two.mtl"});
  CHECK(table->unread == list{"none.mtl"});
  CHECK(table->materials == std::vector<material>{{"red", {"Kd 1 0 0", "illum 1"}}, {"color_2", {"Kd 0 1 0", "Ks 1 1 1"}}, {"unused", {"Ka 0 0 0"}}, {"color_3", {"Kd 1 1 0"}}});
  CHECK(table->find("unused") == &table->materials[2]);
  CHECK(!table->find("color_1"));
  const auto name = find_poly_property<std::string>(m, "material");
  CHECK(name[poly_id{0}] == "red");
  CHECK(name[poly_id{1}] == "");
  CHECK(name[poly_id{2}] == "color_2");
  CHECK(find_poly_property<rgba>(m, "color")[poly_id{1}] == rgba{0, 1, 0, 0.5f});

  write_file(dir / "b.obj", "mtllib two.mtl\n" + points + face);  // no poly has a material
  const auto bare = load<trimesh>(dir / "b.obj", {.report = &r});
  CHECK(find_mesh_property<material_table>(bare, "materials")->materials.size() == 4);
  CHECK(property_list(bare).size() == 1);
  CHECK(r.notes.empty());
  load<surface_arrays>(dir / "b.obj", {.report = &r});
  CHECK(r.skipped == list{"definitions of materials in libraries"});
}

TEST_CASE("read_mtl: a library is read once, even if its path is written in several ways") {
  const temporary_folder dir;
  std::string library = "newmtl red\nKd 1 0 0\n", lines;
  for (int i = 0; i < 2000; ++i) {
    library += "newmtl m" + std::to_string(i) + "\nKd 1 2\n";
    lines += i % 2 ? "mtllib one.mtl\n" : "mtllib ./" + std::string(static_cast<std::size_t>(i % 100), '/') + "one.mtl\n";
  }
  write_file(dir / "one.mtl", library);
  write_file(dir / "a.obj", lines + points + "usemtl red\n" + face);
  load_report r;
  const auto m = load<trimesh>(dir / "a.obj", {.report = &r});
  CHECK(find_poly_property<rgba>(m, "color")[poly_id{0}] == rgba{1, 0, 0});
  CHECK(r.notes.size() == 1);
  // the name contains a character of value 0: there is no such file
  write_file(dir / "b.obj", "mtllib one.mtl" + std::string("\0x\n", 3) + points + "usemtl red\n" + face);
  CHECK(!find_poly_property<rgba>(load<trimesh>(dir / "b.obj", {.report = &r}), "color"));
  CHECK(r.notes.size() == 1);
}

TEST_CASE("read_mtl: the polys of the football of the corpus have the colours of two materials") {
  CONCINO_CORPUS_OR_SKIP(ball, "tri/soccerball_materials.obj");
  load_report r;
  const trimesh m = load<trimesh>(ball, {.report = &r});
  const auto color = find_poly_property<rgba>(m, "color");
  const auto material = find_poly_property<std::string>(m, "material");
  REQUIRE(bool(color));
  std::size_t wrong = 0, grey = 0;
  for (const auto p : polys(m)) {
    const bool is_grey = material[p] == "material_1";
    grey += is_grey;
    wrong += color[p] != (is_grey ? rgba{0.4f, 0.4f, 0.4f} : rgba{}) || (!is_grey && material[p] != "material_0");
  }
  CHECK(wrong == 0);
  CHECK(grey > 0);
  CHECK(grey < num_polys(m));
  CHECK(r.notes.empty());
}
