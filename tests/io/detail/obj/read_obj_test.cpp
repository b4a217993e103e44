#include <concino/io/detail/obj/read_obj.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/trimesh.hpp>

#include <support/reading.hpp>

#include <doctest/doctest.h>

#include <clocale>

using namespace concino;
using namespace concino::testing;

namespace {

const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
const std::string tet = points + "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
const std::vector<unsigned> tet_verts = {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2};

std::size_t line(const std::string& text) { return bad_line<surface_arrays>(text, file_format::obj); }

}  // namespace

TEST_CASE("read_obj: reads points and polys, with any line ends") {
  for (const std::string end : {"\n", "\r\n", "\r"})
    for (const std::string& last : {end, std::string()}) {
      const std::string text = with_line_ends(tet, end);
      const surface_arrays s = obj(text.substr(0, text.size() - end.size()) + last);
      CHECK(s.points.size() == 4);
      CHECK(s.points[3] == vec3{0, 0, 1});
      CHECK(s.arity == 3);
      CHECK(s.offsets.empty());
      CHECK(raw(s.verts) == tet_verts);
    }
}

TEST_CASE("read_obj: stores offsets only if polys have different sizes") {
  const surface_arrays quads = obj(points + "f 1 2 3 4\nf 4 3 2 1\n");
  CHECK(quads.arity == 4);
  CHECK(quads.num_polys() == 2);
  const surface_arrays mixed = obj(points + "f 1 2 3\nf 2 3 4\nf 1 2 3 4\nf 1 2 4\n");
  CHECK(mixed.arity == 0);
  CHECK(mixed.offsets == std::vector<std::uint32_t>{0, 3, 6, 10, 13});
  CHECK(mixed.num_polys() == 4);
  const surface_arrays none = obj(points);
  CHECK(none.points.size() == 4);
  CHECK(none.num_polys() == 0);
}

TEST_CASE("read_obj: indices count from the start or the end, and may precede their verts") {
  CHECK(raw(obj(points + "f -4 -2 -3\nv 9 9 9\nf -5 -2 5\n").verts) == std::vector<unsigned>{0, 2, 1, 0, 3, 4});
  CHECK(raw(obj("f 1 2 3\n" + points).verts) == std::vector<unsigned>{0, 1, 2});
  CHECK(line("v 0 0 0\nf -1 1 2\n") == 2);
  CHECK(line("# forward\nf 1 2 5\nf 1 2 3\n" + points) == 2);
  CHECK(line("f 1 2 -1\n" + points) == 1);
  CHECK(line(points + "f 1 2 0\n") == 5);
  CHECK(line(points + "f 1 2 3\n\nf 1 2 5\nf 1 2 6\n") == 7);
  CHECK(line(points + "f 1 2 -5\n") == 5);
  CHECK(line(points + "f 1 2 99999999999999999999\n") == 5);
  CHECK(line(points + "f 1 2 4294967297\n") == 5);
}

TEST_CASE("read_obj: indices of texture coordinates and normals are accepted and checked") {
  const std::string attributes = points + "vt 0 0\nvt 1 0\nvn 0 0 1\n";
  CHECK(raw(obj(attributes + "f 1/1 2/2 3/-1\nf 1//1 2//-1 3//1\nf 1/2/1 2/1/1 4/1/1\nf 1/ 2/ 3/\nf 1// 2/1/ 3\n").verts) ==
        std::vector<unsigned>{0, 1, 2, 0, 1, 2, 0, 1, 3, 0, 1, 2, 0, 1, 2});
  CHECK(raw(obj("f 1/2/1 2/1/1 4/1/1\n" + attributes).verts) == std::vector<unsigned>{0, 1, 3});
  CHECK(raw(obj(attributes + "f 1/0 2//0 3/0/0\n").verts) == std::vector<unsigned>{0, 1, 2});
  for (const std::string bad : {"f 1/3 2/1 3/1", "f 1//2 2 3", "f 1/-3 2 3", "f 1/x 2 3", "f 1/1/1/1 2 3", "f 1 2 3x", "f 1 2 3.0"})
    CHECK_MESSAGE(line(attributes + bad) == 8, bad);
}

TEST_CASE("read_obj: accepts blanks, comments and continued lines") {
  const surface_arrays s =
      obj("   # leading\n\n\tv\t0 0   0   # tail\nv 1 0 0\n#v 5 5 5\n  v 0 1 0 \nv 0 0 1 1.0\ng\no name\ns off\nf 1 3 \\\n2 # c\nf 1 2 "
          "\\\r\n 4\\\n\n# ends \\\nf 2 3 4#\n");
  CHECK(s.points.size() == 4);
  CHECK(raw(s.verts) == std::vector<unsigned>{0, 2, 1, 0, 1, 3, 1, 2, 3});
  CHECK(line(points + "f 1 2 \\\n 9\n") == 6);
  CHECK(line(points + "f 1 2 \\3\n") == 5);
}

TEST_CASE("read_obj: a vert needs three finite numbers") {
  for (const std::string bad :
       {"v 1 0", "v", "v 1 O 0", "v nan 0 0", "v 0 inf 0", "v 0 0 -inf", "v 1e999 0 0", "v 1,0 0 0", "v 0 0 0 x", "v 0 0 0 1 nan"})
    CHECK_MESSAGE(line("v 0 0 0\n" + bad + "\nv 0 1 0\n") == 2, bad);
  CHECK(obj("v 0 0 0 0.5 0.5 0.5\nv 1e-400 -0 +1\n").points[1] == vec3{0, 0, 1});
}

TEST_CASE("read_obj: a poly needs at least three verts, all different") {
  CHECK(line(points + "f\n") == 5);
  CHECK(line(points + "f 1 2\n") == 5);
  CHECK(line(points + "f 1 2 2\n") == 5);
  CHECK(line(points + "f 1 2 3\nf 1 2 3 -4\n") == 6);
  std::string many, ring = "f";
  for (int i = 1; i <= 100; ++i) {
    many += "v " + std::to_string(i) + " 0 0\n";
    ring += " " + std::to_string(i);
  }
  CHECK(obj(many + ring).num_polys() == 1);
  CHECK(line(many + ring + " 50") == 101);
}

TEST_CASE("read_obj: a text that is not OBJ is an error, not an empty mesh") {
  CHECK(line("") == 1);
  CHECK(line(" \n\t\r\n") == 1);
  CHECK(line("OFF\n3 1 3\n0 0 0\n") == 2);
  CHECK(line("solid cube\nfacet normal\nendsolid\n") == 3);
  CHECK(line(std::string("v 0 0 0\n\x00\x01\x02\n", 12)) == 2);
  CHECK(obj("# nothing\n").points.empty());
}

TEST_CASE("read_obj: the report counts what the mesh cannot store") {
  load_report r;
  obj(tet + "vt 0 0\nvt 1 0\nvn 0 0 1\nl 1 2\np 1\nusemtl red\nmtllib x.mtl\ng a\ng b\ng c\ns 1\nvp 0 0\nv 0 0 0 1\n", {.report = &r});
  CHECK(r.skipped == std::vector<std::string>{"2 texture coordinates (vt) that no corner has", "1 normals (vn) that no corner has",
                                              "1 weights of verts, or other numbers after x y z that are not r g b",
                                              "2 points and lines (p, l)", "1 smoothing groups (s)",
                                              "1 lines with other keywords, the first 'vp' on line 20"});
  CHECK(r.notes == std::vector<std::string>{"material library 'x.mtl': not read, as text has no folder"});
  obj(tet, {.report = &r});
  CHECK(r.skipped.empty());
}

TEST_CASE("read_obj: reads colours of verts; verts without one are white") {
  const auto m = load_text<trimesh>("v 0 0 0\nv 1 0 0 0.5 0.25 1\nv 0 1 0 1.0\nv 0 0 1 # c\nf 1 2 3\n", file_format::obj);
  const auto color = find_vert_property<rgba>(m, "color");
  REQUIRE(bool(color));
  CHECK(color[vert_id{0}] == rgba{});
  CHECK(color[vert_id{1}] == rgba{0.5f, 0.25f, 1});
  CHECK(color[vert_id{2}] == rgba{});
  CHECK(color[vert_id{3}] == rgba{});
  load_report r;
  obj("v 0 0 0 1 1 1\nv 0 0 0 1 1\nv 0 0 0 1 1 1 1\n", {.report = &r});
  CHECK(r.skipped == std::vector<std::string>{"2 weights of verts, or other numbers after x y z that are not r g b", "colours of verts"});
  CHECK(property_list(load_text<trimesh>(tet, file_format::obj)).empty());
}

TEST_CASE("read_obj: groups, objects and materials apply to the polys up to the next") {
  const auto m =
      load_text<trimesh>(points +
                             "f 1 2 3\ng left # c\no C# 1\nf 1 2 3\nusemtl a\tb \ng  left side\\\n 2 #c\nf 1 2 4\ng\nf 2 3 4\ng left\nf 1 "
                             "3 4\ng unused\n",
                         file_format::obj);
  const auto group = find_poly_property<std::string>(m, "group"), object = find_poly_property<std::string>(m, "object"),
             material = find_poly_property<std::string>(m, "material");
  const auto label = find_poly_property<int>(m, "label");
  const std::string groups[] = {"", "left", "left side  2", "", "left"}, objects[] = {"", "C# 1", "C# 1", "C# 1", "C# 1"},
                    materials[] = {"", "", "a\tb", "a\tb", "a\tb"};
  const int labels[] = {0, 1, 2, 0, 1};
  for (unsigned p = 0; p < 5; ++p) {
    CHECK(group[poly_id{p}] == groups[p]);
    CHECK(object[poly_id{p}] == objects[p]);
    CHECK(material[poly_id{p}] == materials[p]);
    CHECK(label[poly_id{p}] == labels[p]);
  }
  CHECK(property_list(load_text<trimesh>(tet + "g\no \ng after\nusemtl last\n", file_format::obj)).empty());
  load_report r;
  obj(points + "g a\no b\nusemtl c\nf 1 2 3\n", {.report = &r});
  CHECK(r.skipped == std::vector<std::string>{"labels of polys", "names of objects", "names of groups", "names of materials"});
}

TEST_CASE("read_obj: labels number groups, else objects; a group named label_5 has the label 5") {
  const auto labels = [](const trimesh& m) {
    std::vector<int> all;
    for (const auto p : polys(m)) all.push_back(find_poly_property<int>(m, "label")[p]);
    return all;
  };
  const auto read = [](const std::string& text) { return load_text<trimesh>(points + text, file_format::obj); };
  const trimesh objects = read("o a\nf 1 2 3\no b\nf 1 2 4\no a\nf 1 3 4\n");
  CHECK(labels(objects) == std::vector<int>{1, 2, 1});
  CHECK(property_list(objects).size() == 2);
  const trimesh numbers = read("g label_-5\nf 1 2 3\ng label_0\nf 1 2 4\ng\nf 1 3 4\n");
  CHECK(labels(numbers) == std::vector<int>{-5, 0, 0});
  CHECK(property_list(numbers).size() == 1);
  const trimesh mixed = read("g label_5\nf 1 2 3\ng a\nf 1 2 4\n");
  CHECK(labels(mixed) == std::vector<int>{1, 2});
  CHECK(property_list(mixed).size() == 2);
  // the verts that face 1 names come later, so the file is read twice
  CHECK(labels(load_text<trimesh>("g a\nf 1 2 3\ng b\nf 1 2 3\n" + points, file_format::obj)) == std::vector<int>{1, 2});
}

TEST_CASE("read_obj: a backslash at the end of a line joins lines, except in comments") {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    const surface_arrays s =
        obj(with_line_ends("v\\\n0 0 0\nv 1 \\\n2\\\n 3\nv 0 1 0\\\n\nl 1\\\n2\nl 12\\\n3\nusemtl a\\\nb\nf\\\n1 2 3\n# c\\\nf 3 2 1\n", end));
    CHECK(s.points.size() == 3);
    CHECK(s.points[1] == vec3{1, 2, 3});
    CHECK(raw(s.verts) == std::vector<unsigned>{0, 1, 2, 2, 1, 0});
    CHECK(obj("v 0 0 0\\" + end).points.size() == 1);
  }
  CHECK(line("v 0 0 0\\") == 1);
  CHECK(line("v") == 1);
  CHECK(line(points + "f") == 5);
  CHECK(obj(points + "v 0 0 9 # c\nf 1 2 3/").points.size() == 5);
  // a backslash within a skipped line does not join lines
  CHECK(raw(obj(points + "l 1\\2 \\ 3\nf 1 2 3\n").verts) == std::vector<unsigned>{0, 1, 2});
  for (const std::string last : {"s 1", "g", "g a", "l 1 2\\"}) CHECK(obj(points + "f 1 2 3\n" + last).num_polys() == 1);
}

TEST_CASE("read_obj: messages name what was expected and what was found") {
  const auto says = [](const std::string& text) { return complaint<surface_arrays>(text, file_format::obj); };
  const std::string range = ", or from -1 (the last one read) back to the first";
  CHECK(says(points + "f 1 2 0\n") == "5: the index of a vert from 1 to 4" + range + " | '0'");
  CHECK(says(points + "f 1 2 9\nv 0 0 0\n") == "5: the index of a vert from 1 to 5" + range + " | '9'");
  CHECK(says("f 0 1 2\n" + points) == "1: the index of a vert from 1 to 0" + range + " | '0'");
  CHECK(line(points + "f 1 2 3 4\nf 1 2 9\n") == 6);
  CHECK(line(points + "vt 0 0\nf 1/-1 2/-1 3/-1\nf 1 2 9\n") == 7);
  CHECK(line(points + "vn 0 0\nf 1//-1 2//-1 3//-1\nf 1 2 9\n") == 7);
  CHECK(says(points + "f 1 3 3 2\n") == "5: different verts at the corners of a face (or set options.repeated_verts) | vert 3 twice");
  CHECK(says(points + "f 1 2\n") == "5: a face of at least three corners | one of 2");
  CHECK(complaint<trimesh>(points + "f 1 2 3 4\n", file_format::obj) ==
        "5: a triangle (polygonmesh and load_any take any polygon) | a polygon of 4 corners");
  const std::string long_word(50, 'w');
  CHECK(says(long_word + "\n") == "1: verts (v x y z) | none, and 1 lines that are not of an OBJ file, the first '" + long_word.substr(0, 40) + "'");
  CHECK(line(points + "g! x\n") == 5);
}

TEST_CASE("read_obj: the report counts each skipped line once") {
  load_report r;
  obj(points + "f 1 2 3\nl 1 2\n", {.report = &r});
  CHECK(r.skipped == std::vector<std::string>{"1 points and lines (p, l)"});
  obj("s 1\n", {.report = &r});
  CHECK(r.skipped == std::vector<std::string>{"1 smoothing groups (s)"});
  obj(points + "shadow_obj x\nk2 y\ns#off\nv 0 0 0 1 2 3 4 5\nf 1 2 3\n", {.report = &r});
  CHECK(r.skipped == std::vector<std::string>{"1 weights of verts, or other numbers after x y z that are not r g b", "1 smoothing groups (s)",
                                              "2 lines with other keywords, the first 'shadow_obj' on line 5"});
  CHECK(obj(points).offsets == std::vector<std::uint32_t>{0});
  CHECK(obj(points).arity == 0);
  CHECK(num_verts(load_text<trimesh>(points, file_format::obj)) == 4);
}

TEST_CASE("read_obj: groups are numbered in order of appearance, also with polygons of different sizes") {
  const auto labels = [](const std::string& text) {
    const auto m = load_text<polygonmesh>(points + text, file_format::obj);
    std::vector<int> all;
    if (const auto label = find_poly_property<int>(m, "label"))
      for (const auto p : polys(m)) all.push_back(label[p]);
    return all;
  };
  CHECK(labels("g a\nf 1 2 3\ng b\nf 1 2 3 4\ng c\nf 1 2 4\ng a\nf 2 3 4\n") == std::vector<int>{1, 2, 3, 1});
  CHECK(labels("g a\nf 1 2 3 4\ng b\nf 1 2 3\ng c\nf 1 2 4\ng d\nf 2 3 4\n") == std::vector<int>{1, 2, 3, 4});
  CHECK(labels("g # nothing\nf 1 2 3\n").empty());
  CHECK(labels("o label_5\nf 1 2 3\n") == std::vector<int>{1});
  CHECK(labels("g label_7\nf 1 2 3\n") == std::vector<int>{7});
}

TEST_CASE("read_obj: numbers do not depend on the locale") {
  const char* const set = std::setlocale(LC_ALL, "de_DE.UTF-8");
  CHECK(obj("v 1.5 -2.25 1e-3\n").points[0] == vec3{1.5, -2.25, 0.001});
  if (set) std::setlocale(LC_ALL, "C");
}

TEST_CASE("read_obj: names longer than 1,000 bytes are truncated; labels distinguish them by their full length") {
  const std::string a(1000, 'a');
  load_report r;
  const auto m = load_text<polygonmesh>("v 0 0 0\nv 1 0 0\nv 0 1 0\ng " + a + "\nf 1 2 3\ng " + a + "b\nf 1 2 3\ng " + a + "c\nf 1 2 3\n",
                                        file_format::obj, {.report = &r});
  for (unsigned p = 0; p < 3; ++p) {
    CHECK(find_poly_property<std::string>(m, "group")[poly_id{p}] == a);
    CHECK(find_poly_property<int>(m, "label")[poly_id{p}] == static_cast<int>(p + 1));
  }
  CHECK(r.notes == std::vector<std::string>{"names longer than 1000 bytes were truncated, as every poly has a copy of its name"});
  load_text<polygonmesh>("v 0 0 0\nv 1 0 0\nv 0 1 0\no " + a + "\nf 1 2 3\n", file_format::obj, {.report = &r});
  CHECK(r.notes.empty());
}
