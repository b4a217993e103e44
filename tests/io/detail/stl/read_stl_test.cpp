#include <concino/io/detail/stl/read_stl.hpp>

#include <concino/io/save.hpp>
#include <concino/io/stl.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/property.hpp>
#include <concino/mesh/trimesh.hpp>

#include <support/corpus.hpp>
#include <support/kinds.hpp>
#include <support/reading.hpp>

#include <doctest/doctest.h>

#include <cstring>
#include <limits>

using namespace concino;
using namespace concino::testing;

namespace {

using list = std::vector<std::string>;

std::string facet(const std::string& a, const std::string& b, const std::string& c) {
  return "facet normal 0 0 1\n outer loop\n  vertex " + a + "\n  vertex " + b + "\n  vertex " + c + "\n endloop\nendfacet\n";
}
const std::string square = facet("0 0 0", "1 0 0", "1 1 0") + facet("-0 0 0", "1 1 0", "0 1 0");

/// The same square, binary; the second triangle has an attribute.
std::string binary(const std::string& title = "binary") {
  std::string s = title + std::string(80 - title.size(), ' ') + std::string("\2\0\0\0", 4);
  const auto put = [&](std::initializer_list<float> all) {
    for (const float x : all) {
      std::uint32_t bits;
      std::memcpy(&bits, &x, 4);
      for (int i = 0; i < 4; ++i, bits >>= 8) s += static_cast<char>(bits & 255);
    }
  };
  put({0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 1, 0});
  s += std::string("\0\0", 2);
  put({0, 0, 1, -0.f, 0, 0, 1, 1, 0, 0, 1, 0});
  return s + std::string("\x34\x12", 2);
}

surface_arrays arrays(const std::string& s, load_report* report = nullptr) { return load_alone<surface_arrays>(s, file_format::stl, {.report = report}, "t.stl"); }
trimesh mesh(const std::string& s, load_report* report = nullptr) { return load_text<trimesh>(s, file_format::stl, {.report = report}, "t.stl"); }
std::string says(const std::string& s) { return complaint<surface_arrays>(s, file_format::stl); }

}  // namespace

TEST_CASE("read_stl: text with any line ends, and equal points are one vert") {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    load_report r;
    const surface_arrays s = arrays(with_line_ends("solid a b \n" + square + "endsolid a b\n", end), &r);
    CHECK(s.points == std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
    CHECK(raw(s.verts) == std::vector<unsigned>{0, 1, 2, 0, 2, 3});
    CHECK(s.arity == 3);
    CHECK(r.skipped == list{"names of objects"});  // as arrays have no properties
  }
  CHECK(arrays("SOLID\nFACET NORMAL -nan(ind) 0 0 OUTER LOOP VERTEX 0 0 0 VERTEX 1 0 0 VERTEX 0 1 0 ENDLOOP ENDFACET ENDSOLID").num_polys() == 1);
  CHECK(arrays("solid\nendsolid").num_polys() == 0);
  load_report r;
  const auto m = mesh("solid\n" + facet("0 0 0", "1 0 0", "0 1 0") + "endsolid\nsolid cube 1\n" + facet("1 0 0", "0 0 0", "0 0 1") + "endsolid cube 1\nrest\n", &r);
  CHECK(find_poly_property<std::string>(m, "object")[poly_id{0}].empty());
  CHECK(find_poly_property<std::string>(m, "object")[poly_id{1}] == "cube 1");
  CHECK(r.skipped == list{"what follows the last endsolid, from line 19 on"});
}

TEST_CASE("read_stl: binary, even if it begins with solid; attributes are kept") {
  for (const std::string title : {"binary", "solid but binary"}) {
    load_report r;
    const auto m = mesh(binary(title), &r);
    CHECK(num_verts(m) == 4);
    CHECK(raw(adj_p2v(m, poly_id{1})) == std::vector<unsigned>{0, 2, 3});
    CHECK(find_poly_property<std::uint16_t>(m, "attribute")[poly_id{0}] == 0);
    CHECK(find_poly_property<std::uint16_t>(m, "attribute")[poly_id{1}] == 0x1234);
    CHECK(r.skipped.empty());
    CHECK(stl_format::has_signature(binary(title)));
  }
  load_report r;
  mesh(binary("COLOR=abcd") + "12", &r);
  CHECK(r.skipped == list{"2 bytes after the last triangle", "the colour in the first 80 bytes"});
  CHECK(!stl_format::has_signature("solids are not"));
}

TEST_CASE("read_stl: every error names its line, or the byte") {
  const auto broken = [](const std::string& what, const std::string& by) {
    std::string s = "solid\n" + square + "endsolid\n";
    return says(s.replace(s.find(what), what.size(), by));
  };
  CHECK(says("") == "1: solid | an empty file");
  CHECK(broken("facet", "face") == "2: facet or endsolid | 'face'");
  CHECK(broken("normal", "vector") == "2: normal | 'vector'");
  CHECK(broken("outer", "inner") == "3: outer | 'inner'");
  CHECK(broken("loop", "lap") == "3: loop | 'lap'");
  CHECK(broken("vertex 1", "vert 1") == "5: vertex | 'vert'");
  CHECK(broken("1 1 0", "1 1") == "7: the z of a vertex | 'endloop'");
  CHECK(broken("1 1 0", "1 1 inf") == "6: the z of a vertex, a finite number | 'inf'");
  CHECK(broken("endloop", "vertex") == "7: endloop | 'vertex'");
  CHECK(broken("endfacet", "end") == "8: endfacet | 'end'");
  CHECK(broken("vertex 1 0 0", "vertex 0 0 0").starts_with("3: different points at the corners of a triangle"));
  CHECK(broken("endsolid\n", "") == "15: facet or endsolid | the end of the file");
  const std::string whole = binary();
  CHECK(says(whole.substr(0, 50)) == "1: solid, or 80 bytes and the number of triangles | the end of the file at byte 50");
  CHECK(says(binary("solid").substr(0, 150)) == "1: a number of triangles that fits into the file, 50 bytes each | 2 triangles at byte 80");
  CHECK(says(whole.substr(0, 150)) == "1: a number of triangles that fits into the file, 50 bytes each | 2 triangles at byte 80");
  std::string infinite = whole;
  infinite[84 + 12 + 2] = '\x80', infinite[84 + 12 + 3] = '\x7f';
  CHECK(says(infinite) == "1: a finite coordinate | another number at byte 96");
  CHECK_THROWS_AS(load_text<quadmesh>(whole, file_format::stl), parse_error);
}

TEST_CASE_TEMPLATE("write_stl: loading gives the same triangles, and the second save is the first", M, trimesh, polygonmesh) {
  M m = load_text<M>("solid\n" + square + facet("1 1 0", "1 0 0", "0.1 0 1e-300") + "endsolid", file_format::stl);
  const auto object = poly_property<std::string>(m, "object");
  object[poly_id{1}] = object[poly_id{2}] = "a part";
  save_report r;
  const std::string text = save_text(m, file_format::stl, {.report = &r});
  CHECK(r.lost.empty());
  CHECK(text.starts_with("solid \nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nendloop\nendfacet\nendsolid \nsolid a part\n"));
  const M back = load_text<M>(text, file_format::stl);
  CHECK(back.points() == m.points());
  for (const auto p : polys(m)) {
    CHECK(raw(adj_p2v(back, p)) == raw(adj_p2v(m, p)));
    CHECK(find_poly_property<std::string>(back, "object")[p] == object[p]);
  }
  CHECK(save_text(back, file_format::stl) == text);

  poly_property<std::uint16_t>(m, "attribute")[poly_id{2}] = 513;
  const std::string bytes = save_text(m, file_format::stl, {.report = &r, .binary = true});
  CHECK(bytes.size() == 84 + 3 * 50);
  CHECK(bytes.ends_with("\1\2"));
  CHECK(r.lost == list{"binary .stl holds floats: coordinates were rounded to 32 bits", "poly property \"object\": .stl cannot store it"});
  const M again = load_text<M>(bytes, file_format::stl);
  CHECK(find_poly_property<std::uint16_t>(again, "attribute")[poly_id{2}] == 513);
  CHECK(save_text(again, file_format::stl, {.binary = true}) == bytes);
  CHECK(save_text(M(), file_format::stl) == "solid \nendsolid \n");
}

TEST_CASE("write_stl: verts at 0 and at -0 are one vert, and the second save is the first") {
  const trimesh m({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0., 0, -0.}, {0, 0, 1}}, {{0, 1, 2}, {2, 4, 3}});
  for (const bool binary : {false, true}) {
    const std::string first = save_text(m, file_format::stl, {.binary = binary});
    const auto back = load_text<trimesh>(first, file_format::stl);
    CHECK(num_verts(back) == 4);
    CHECK(save_text(back, file_format::stl, {.binary = binary}) == first);
  }
}

TEST_CASE("write_stl: what STL does not hold is lost with a word, or refused") {
  save_report r;
  const polygonmesh loose({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}, {1, 0, 0}}, {{0, 1, 2}, {0, 4, 2}});
  save_text(loose, file_format::stl, {.report = &r});
  CHECK(r.lost == list{"1 verts of no poly: .stl lists the corners of triangles only", "1 verts at the point of another one: readers of .stl unite them"});
  const polygonmesh quad({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}});
  CHECK_THROWS_WITH_AS(save_text(quad, file_format::stl),
                       "text: .stl cannot hold poly 0 of 4 corners, unless options.as_triangles is set; save it as .ply or .obj", unsupported);
  CHECK(num_polys(load_text<trimesh>(save_text(quad, file_format::stl, {.report = &r, .as_triangles = true}), file_format::stl)) == 2);
  CHECK(r.lost == list{"1 polygons were cut into triangles"});
  const trimesh flat({{0, 0, 0}, {1, 0, 0}, {1 + 1e-12, 0, 0}}, {{0, 1, 2}});
  CHECK_NOTHROW(save_text(flat, file_format::stl));
  CHECK_THROWS_WITH_AS(save_text(flat, file_format::stl, {.binary = true}),
                       "text: binary .stl cannot hold poly 0, which has two corners at the same point once they are rounded to floats; save it as .ply or .obj", unsupported);
  const trimesh large({{0, 0, 0}, {1e300, 0, 0}, {0, 1e300, 0}}, {{0, 1, 2}});
  CHECK(save_text(large, file_format::stl).find("normal 0 0 1\n") != std::string::npos);
  CHECK_THROWS_AS(save_text(large, file_format::stl, {.binary = true}), unsupported);
  CHECK_THROWS_AS(save_text(grid<tetmesh>(1), file_format::stl), unsupported);
}

TEST_CASE("read_stl: files of the corpus") {
  CONCINO_CORPUS_OR_SKIP(text, "tri/box_ascii.stl");
  CONCINO_CORPUS_OR_SKIP(bytes, "tri/icosahedron_binary.stl");
  CHECK(num_verts(load_stl<trimesh>(text)) == 8);
  CHECK(num_polys(load_stl<trimesh>(bytes)) == 20);
  CHECK(num_verts(load_stl<trimesh>(bytes)) == 12);
}
