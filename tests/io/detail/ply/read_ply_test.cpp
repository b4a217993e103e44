#include <concino/io/ply.hpp>

#include <concino/mesh/corner_property.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/property.hpp>
#include <concino/mesh/tetmesh.hpp>
#include <concino/mesh/trimesh.hpp>

#include <support/reading.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace concino;
using namespace concino::testing;

namespace {

const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
const std::string indices = "property list uchar int vertex_indices\n";
const std::string points = "0 0 0\n1 0 0\n1 1 0\n0 1 0.25\n";

/// A text with verts and faces; more lines of the header after each of them.
std::string text(const std::string& faces, unsigned num_faces, const std::string& of_faces = {}, const std::string& more = {}) {
  return "ply\nformat ascii 1.0\nelement vertex 4\n" + xyz + "element face " + std::to_string(num_faces) + '\n' + indices + of_faces + more + "end_header\n" + points + faces;
}
/// Verts only, with more properties.
std::string of_verts(const std::string& properties, const std::string& rows, unsigned n = 1) {
  return "ply\nformat ascii 1.0\nelement vertex " + std::to_string(n) + '\n' + xyz + properties + "end_header\n" + rows;
}

surface_arrays arrays(const std::string& s, load_report* report = nullptr) { return load_alone<surface_arrays>(s, file_format::ply, {.report = report}, "t.ply"); }
polygonmesh mesh(const std::string& s, load_report* report = nullptr) { return load_text<polygonmesh>(s, file_format::ply, {.report = report}, "t.ply"); }
std::string says(const std::string& s) { return complaint<surface_arrays>(s, file_format::ply); }
std::vector<std::string> names(const polygonmesh& m) {
  std::vector<std::string> r;
  for (const property_info& p : property_list(m)) r.push_back(std::string(to_string(p.kind)) + ' ' + p.name);
  return r;
}
using list = std::vector<std::string>;

template<class T>
void put(std::string& s, T x, bool big) {
  char bytes[sizeof x];
  std::memcpy(bytes, &x, sizeof x);
  if (big) std::reverse(bytes, bytes + sizeof x);
  s.append(bytes, sizeof x);
}

/// The square and a triangle, binary; faces have a colour and a list.
std::string binary(bool big, const std::string& end = "\n") {
  std::string s = with_line_ends("ply\nformat binary_" + std::string(big ? "big" : "little") + "_endian 1.0\nelement vertex 4\n" + xyz + "element face 2\nproperty uchar red\n" +
                                     "property uchar green\nproperty uchar blue\n" + indices + "property list uint short marks\nend_header\n", end);
  for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 1.f, 1.f, 0.f, 0.f, 1.f, .25f}) put(s, x, big);
  s += std::string("\xff\x80\0\4", 4);
  for (const std::int32_t v : {0, 1, 2, 3}) put(s, v, big);
  put<std::uint32_t>(s, 2, big), put<std::int16_t>(s, -2, big), put<std::int16_t>(s, 300, big);
  s += std::string("\0\0\1\3", 4);
  for (const std::int32_t v : {2, 1, 0}) put(s, v, big);
  put<std::uint32_t>(s, 0, big);
  return s;
}

}  // namespace

TEST_CASE("read_ply: reads text with any line ends, with comments, and names of types in both forms") {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    load_report r;
    const surface_arrays s = arrays(with_line_ends(text("4 0 1 2 3\n3 2 1 0\n", 2), end), &r);
    CHECK(s.points == std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0.25}});
    CHECK(s.offsets == std::vector<std::uint32_t>{0, 4, 7});
    CHECK(raw(s.verts) == std::vector<unsigned>{0, 1, 2, 3, 2, 1, 0});
    CHECK(r.skipped.empty());
    CHECK(r.notes.empty());
  }
  load_report r;
  const auto m = mesh("ply\ncomment made by hand\nobj_info x\nformat ascii 1.0\ncomment TextureFile a b.png\nelement vertex 3\nproperty float64 x\ncomment\nproperty int16 y\nproperty float32 z\n"
                      "element face 1\nproperty list uint8 uint32 vertex_index\nend_header\n0.1 2 3e-1 1 1 1 2\n-1 0\n3 2\n1 0", &r);
  CHECK(point(m, vert_id{0}) == vec3{0.1, 2, 0.3});
  CHECK(raw(adj_p2v(m, poly_id{0})) == std::vector<unsigned>{2, 1, 0});
  CHECK(r.skipped == list{"the texture file \"a b.png\""});
  CHECK(arrays("ply\nformat ascii 1.0\nelement vertex 0\n" + xyz + "end_header").points.empty());
}

TEST_CASE("read_ply: reads binary files of both byte orders, with any line ends in the header") {
  for (const bool big : {false, true})
    for (const std::string end : {"\n", "\r\n", "\r"}) {
      const auto m = mesh(binary(big, end));
      CHECK(point(m, vert_id{3}) == vec3{0, 1, 0.25});
      CHECK(raw(adj_p2v(m, poly_id{0})) == std::vector<unsigned>{0, 1, 2, 3});
      CHECK(raw(adj_p2v(m, poly_id{1})) == std::vector<unsigned>{2, 1, 0});
      CHECK(find_poly_property<rgba>(m, "color")[poly_id{0}] == rgba{1, static_cast<float>(128 / 255.0), 0, 1});
      CHECK(find_poly_property<std::vector<std::int16_t>>(m, "marks")[poly_id{0}] == std::vector<std::int16_t>{-2, 300});
      CHECK(find_poly_property<std::vector<std::int16_t>>(m, "marks")[poly_id{1}].empty());
    }
  load_report r;
  mesh(binary(true) + "abc", &r);
  CHECK(r.skipped == list{"3 bytes after the last element"});
  mesh(text("", 0) + "7 8", &r);
  CHECK(r.skipped == list{"what follows the last element, from line 14 on"});
  mesh(text("", 0) + std::string("\n\0\0\x1a\n", 5), &r);
  CHECK(r.skipped.empty());
}

TEST_CASE("read_ply: properties of verts keep their names and types, and those with a meaning have the types of other formats") {
  struct row {
    std::string properties, values;
    list found;
  };
  for (const row& r : {row{"property float nx\nproperty float ny\nproperty float nz\n", "0 0 1", {"vert normal"}},
                       {"property float nx\nproperty float ny\n", "0 0", {"vert nx", "vert ny"}},
                       {"property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\n", "1 2 3 4", {"vert color"}},
                       {"property float alpha\nproperty uchar diffuse_red\nproperty uchar diffuse_green\nproperty uchar diffuse_blue\n", "1 2 3 4", {"vert alpha", "vert color"}},
                       {"property float s\nproperty float t\n", "1 2", {"vert texture"}},
                       {"property float u\nproperty float v\n", "1 2", {"vert texture"}},
                       {"property float texture_u\nproperty float texture_v\nproperty int label\n", "1 2 3", {"vert texture", "vert label"}},
                       {"property float a_x\nproperty float a_y\nproperty double b_x\n", "1 2 3", {"vert a", "vert b_x"}},
                       {"property float a_0\nproperty float a_1\nproperty float a_2\n", "1 2 3", {"vert a_0", "vert a_1", "vert a_2"}},
                       {"property list uchar float weights\nproperty char %78\nproperty float a%20b\n", "2 .5 .25 -7 nan", {"vert weights", "vert x", "vert a b"}}}) {
    CAPTURE(r.properties);
    const auto m = mesh(of_verts(r.properties, "1 2 3 " + r.values + '\n'));
    CHECK(names(m) == r.found);
    CHECK(point(m, vert_id{0}) == vec3{1, 2, 3});
    const vert_id v{0};
    if (r.found[0] == "vert normal") CHECK(find_vert_property<vec3>(m, "normal")[v] == vec3{0, 0, 1});
    if (r.found[0] == "vert color")
      CHECK(find_vert_property<rgba>(m, "color")[v] == rgba{static_cast<float>(1 / 255.0), static_cast<float>(2 / 255.0), static_cast<float>(3 / 255.0), static_cast<float>(4 / 255.0)});
    if (r.found[0] == "vert texture") CHECK(find_vert_property<std::array<double, 2>>(m, "texture")[v] == std::array<double, 2>{1, 2});
    if (r.found[0] == "vert a") CHECK(find_vert_property<std::array<float, 2>>(m, "a")[v] == std::array<float, 2>{1, 2});
    if (r.found[0] == "vert weights") CHECK(find_vert_property<std::vector<float>>(m, "weights")[v] == std::vector<float>{0.5f, 0.25f});
    if (r.found.back() == "vert label") CHECK(find_vert_property<int>(m, "label")[v] == 3);
    if (r.found.back() == "vert a b") {
      CHECK(find_vert_property<std::int8_t>(m, "x")[v] == -7);
      CHECK(std::isnan(find_vert_property<float>(m, "a b")[v]));
    }
  }
  const auto six = mesh(of_verts("property int m_0\nproperty int m_1\nproperty int m_2\nproperty int m_3\nproperty int m_4\nproperty int m_5\n", "0 0 0 1 2 3 4 5 6"));
  CHECK(find_vert_property<std::array<int, 6>>(six, "m")[vert_id{0}] == std::array<int, 6>{1, 2, 3, 4, 5, 6});
  const auto three = mesh(of_verts("property double v_x\nproperty double v_y\nproperty double v_z\n", "0 0 0 1 2 3"));
  CHECK(find_vert_property<vec3>(three, "v")[vert_id{0}] == vec3{1, 2, 3});
}

TEST_CASE("read_ply: values of faces, corners and edges, and what is skipped") {
  load_report r;
  auto m = mesh(text("4 0 1 2 3 8 0 0 1 0 1 1 0 1 7\n3 2 1 0 0 8\n", 2, "property list uchar float texcoord\nproperty short kind\n",
                     "element edge 2\nproperty int vertex1\nproperty int vertex2\nproperty uchar sharp\nelement camera 2\nproperty float view\nproperty list char char data\n") +
                    "1 0 1\n1 3 5\n1.5 2 7 8\n2.5 0\n", &r);
  CHECK(find_poly_property<std::int16_t>(m, "kind")[poly_id{1}] == 8);
  const auto texture = find_corner_property<std::array<double, 2>>(m, "texture");
  REQUIRE(static_cast<bool>(texture));
  CHECK(texture[{poly_id{0}, 2}] == std::array<double, 2>{1, 1});
  CHECK(std::isnan(texture[{poly_id{1}, 0}][0]));
  std::size_t sharp = 0;
  for (const auto e : edges(m)) sharp += find_edge_property<std::uint8_t>(m, "sharp")[e];
  CHECK(sharp == 1);
  REQUIRE(r.skipped.size() == 2);
  CHECK(r.skipped[0] == "2 elements \"camera\" with view, data");
  CHECK(r.skipped[1] == "values of 1 elements of kind edge that the mesh does not have");
  mesh(text("3 0 1 2 4 1 2 3 4\n", 1, "property list uchar float texcoord\n", "element edge 1\nproperty int vertex1\nproperty int vertex2\n") + "0 1\n", &r);
  CHECK(r.skipped == list{"1 edges, which have no values", "texture coordinates of 1 faces that have not two for each corner"});
}

TEST_CASE("read_ply: strips of triangles") {
  load_report r;
  const auto s = arrays("ply\nformat ascii 1.0\nelement tristrips 1\nproperty list int int vertex_indices\nelement vertex 5\n" + xyz +
                            "end_header\n10 0 1 2 3 3 4 -1 4 1 0\n" + points + "0 0 1\n", &r);
  CHECK(raw(s.verts) == std::vector<unsigned>{0, 1, 2, 2, 1, 3, 4, 1, 0});
  CHECK(s.arity == 3);
  CHECK(r.notes == list{"the strips were split into 3 triangles"});
}

TEST_CASE("read_ply: every error names its line") {
  const auto header = [](const std::string& lines) { return says("ply\nformat ascii 1.0\n" + lines); };
  CHECK(says("") == "1: ply | an empty file");
  CHECK(says("plyx\n") == "1: ply | 'plyx'");
  CHECK(says("ply x\n") == "1: the end of the line after ply | 'x'");
  CHECK(says("ply\nelement vertex 1\n") == "2: the word format | 'element'");
  CHECK(says("ply\nformat binary 1.0\n") == "2: ascii, binary_little_endian or binary_big_endian | 'binary'");
  CHECK(says("ply\nformat ascii 2.0\n") == "2: the version 1.0 | '2.0'");
  CHECK(header("property int x\n") == "3: element, comment or end_header | 'property'");
  CHECK(header("element vertex -1\n") == "3: the number of elements, not negative | '-1'");
  CHECK(header("element vertex 1\nelement vertex 1\n") == "4: the name of another element | 'vertex'");
  CHECK(header("element vertex 1\nproperty real x\n").starts_with("4: a type of numbers: char, uchar"));
  CHECK(header("element vertex 1\nproperty list float int x\n") == "4: a type of integers, for the length of a list | 'float'");
  CHECK(header("element vertex 1\nproperty int\n") == "4: the name of a property | the end of the line");
  CHECK(header("element vertex 1\nproperty int x y\n") == "4: the end of the line | 'y'");
  CHECK(header("element vertex 1\nproperty int x\n") == "4: element, property, comment or end_header | the end of the file");
  CHECK(header("end_header\n") == "3: an element vertex | none");
  CHECK(header("element vertex 1\nproperty int x\nend_header\n1 2 3 4\n") == "3: properties x, y and z of element vertex | none");
  CHECK(header("element vertex 9\n" + xyz + "end_header\n1 2 3\n") == "3: a count that fits into the file | 9 elements \"vertex\", and 7 bytes");
  CHECK(header("element vertex 4\n" + xyz + "element face 1\nproperty float x\nend_header\n" + points + "3 0 0\n") == "7: a list vertex_indices of integers of element face | none");
  CHECK(header("element vertex 4\n" + xyz + "element edge 1\nproperty int vertex1\nend_header\n" + points + "3 0 0\n").starts_with("7: properties vertex1 and vertex2"));
  const std::size_t second = 15;  // the line of the second face
  const auto face = [&](const std::string& f) { return says(text("3 0 1 2\n" + f, 2)); };
  const auto at = [&](const std::string& what) { return std::to_string(second) + ": " + what; };
  CHECK(face("2 0 1\n") == at("a face of at least three verts | 2"));
  CHECK(face("3 0 1 4\n") == at("the index of a vert from 0 to 3 | 4"));
  CHECK(face("3 0 1 -1\n") == at("the index of a vert from 0 to 3 | -1"));
  CHECK(face("3 0 1 1\n").starts_with(at("different verts at the corners of a face")));
  CHECK(face("3 0 1 x\n") == at("an integer of type int32 | 'x'"));
  CHECK(face("256 0 1 2\n") == at("an integer of type unsigned int8 | '256'"));
  CHECK(face("200 0 1 2\n").starts_with(at("a count that fits into the file")));
  CHECK(face("3 0 1\n") == at("an integer of type int32 | the end of the file"));
  CHECK(complaint<surface_arrays>(of_verts("", "0 inf 0\n"), file_format::ply) == "8: a coordinate of a vert, a finite number | 'inf'");
  CHECK_THROWS_AS(load_text<trimesh>(text("4 0 1 2 3\n", 1), file_format::ply), parse_error);
  CHECK_THROWS_AS(load_text<tetmesh>(text("4 0 1 2 3\n", 1), file_format::ply), unsupported);
  std::string cut = binary(false);
  cut.resize(cut.size() - 5);
  CHECK(says(cut).starts_with("13: a count that fits into the file"));
  cut = binary(false);
  cut.resize(cut.size() - 19);
  CHECK(says(cut) == "13: more numbers | the end of the file at byte " + std::to_string(cut.size()));
}
