#include <concino/io/detail/iv/read_iv.hpp>
#include <concino/io/iv.hpp>
#include <concino/io/load_any.hpp>
#include <concino/io/save.hpp>

#include <support/reading.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

namespace {

const std::string inventor = "#Inventor V2.1 ascii\n";
const std::string four = "Coordinate3 { point [ 0 0 0, 1 0 0, 1 1 0, 0 1 0 ] }\n";

template<class M = surface_arrays>
M from_iv(const std::string& text, const load_options& options = {}) {
  return load_alone<M>(inventor + text, file_format::iv, options, "t.iv");
}
/// The complaint about the text after the first line.
template<class M = surface_arrays>
std::string iv_complaint(const std::string& text) {
  return complaint<M>(inventor + text, file_format::iv);
}
std::vector<unsigned> iv_verts(const std::string& text) { return raw(from_iv(text).verts); }

using vec_of_strings = std::vector<std::string>;

}  // namespace

TEST_CASE("read_iv: reads Coordinate3 and IndexedFaceSet") {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    load_report r;
    const auto m = load_alone<surface_arrays>(
        with_line_ends(inventor + "# by hand\nSeparator {\n  " + four + "  IndexedFaceSet {\n    coordIndex [ 0, 1, 2, -1,\n      0, 2, 3, -1, ]\n  }\n}\n", end),
        file_format::iv, {.report = &r});
    CHECK(m.points == std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
    CHECK(raw(m.verts) == std::vector<unsigned>{0, 1, 2, 0, 2, 3});
    CHECK(m.arity == 3);
    CHECK(r.skipped.empty());
    CHECK(r.notes.empty());
  }
}

TEST_CASE("read_iv: reads VertexProperty before, inside and after the indices") {
  const std::string property = "VertexProperty { vertex [ 0 0 0, 1 0 0, 1 1 0, 0 1 0 ] }", set = "IndexedFaceSet {", index = "coordIndex [ 0, 1, 2, 3, -1 ]";
  for (const std::string& text : {"Separator { " + property + set + index + "} }", set + "vertexProperty " + property + " " + index + "}",
                                  set + index + " vertexProperty " + property + "}", set + "vertexProperty VertexProperty{vertex[0 0 0,1 0 0,1 1 0,0 1 0]}" + index + "}"}) {
    CAPTURE(text);
    const auto m = from_iv(text);
    CHECK(m.points.size() == 4);
    CHECK(raw(m.verts) == std::vector<unsigned>{0, 1, 2, 3});
    CHECK(m.arity == 4);
  }
  // points of the node itself go before those of the scene
  CHECK(iv_verts(four + set + index + " vertexProperty " + property + "}" + set + index + "}") == std::vector<unsigned>{4, 5, 6, 7, 0, 1, 2, 3});
}

TEST_CASE("read_iv: polygons have any size and the last -1 may be missing") {
  const std::string five = "Coordinate3 { point [ 0 0 0 1 0 0 1 1 0 0 1 0 0 2 0 ] } IndexedFaceSet { coordIndex [";
  const auto m = from_iv(five + "0 1 2 -1 0 1 2 3 -1 0 1 2 4 3 ] }");
  CHECK(m.offsets == std::vector<std::uint32_t>{0, 3, 7, 12});
  CHECK(iv_verts(five + "0,1,2,-1,-1,2,1,0]}") == std::vector<unsigned>{0, 1, 2, 2, 1, 0});
  CHECK(from_iv(five + "] }").num_polys() == 0);
  CHECK(from_iv(five + "] }").points.size() == 5);
  CHECK(num_polys(from_iv<trimesh>(five + "] }")) == 0);
  CHECK(from_iv("Coordinate3 { point 1 2 3 }").points == std::vector<vec3>{{1, 2, 3}});
}

TEST_CASE("read_iv: several shapes are concatenated, and a separator restores the points") {
  const std::string three = "Coordinate3 { point [ 0 0 1, 1 0 1, 1 1 1 ] }", set = "IndexedFaceSet { coordIndex [ 0, 1, 2, -1 ] }";
  CHECK(iv_verts(four + set + three + set) == std::vector<unsigned>{0, 1, 2, 4, 5, 6});
  CHECK(iv_verts(four + "Separator {" + three + set + "}" + set) == std::vector<unsigned>{4, 5, 6, 0, 1, 2});
  CHECK(iv_verts(four + "Group {" + three + set + "}" + set) == std::vector<unsigned>{4, 5, 6, 4, 5, 6});
  CHECK(iv_verts("DEF +0 " + four + three + set + "USE +0 " + set) == std::vector<unsigned>{4, 5, 6, 0, 1, 2});
  CHECK(iv_verts("DEF a " + four + "DEF a " + three + "Coordinate3 { point [] } USE a " + set) == std::vector<unsigned>{4, 5, 6});
  CHECK(iv_verts("DEF a VertexProperty { vertex [ 0 0 1, 1 0 1, 1 1 1 ] } " + four + "IndexedFaceSet { vertexProperty USE a coordIndex [ 2 1 0 ] }" + set) ==
        std::vector<unsigned>{2, 1, 0, 3, 4, 5});
}

TEST_CASE("read_iv: comments and strings hide what they contain") {
  CHECK(iv_verts("# Coordinate3 { point [\nLabel { label \"} IndexedFaceSet { \\\" # [\" }\n" + four +
                 "IndexedFaceSet { # coordIndex [ 3 ]\ncoordIndex [ 0, # 3,\n 1, 2 ] }") == std::vector<unsigned>{0, 1, 2});
}

TEST_CASE("read_iv: material indices of faces become labels") {
  const std::string set = "IndexedFaceSet { coordIndex [ 0, 1, 2, -1, 0, 2, 3, -1 ]";
  const auto labels = [](const std::string& text, load_report& r) {
    const auto m = load_text<trimesh>(inventor + text, file_format::iv, {.report = &r});
    std::vector<int> all;
    if (const auto label = find_poly_property<int>(m, "label"))
      for (const auto p : polys(m)) all.push_back(label[p]);
    return all;
  };
  load_report r;
  CHECK(labels(four + set + "materialIndex [ 7, -3 ] }", r) == std::vector<int>{7, -3});
  CHECK(labels(four + "IndexedFaceSet { materialIndex [ 7 8 ] coordIndex [ 0, 1, 2, -1, 0, 2, 3, -1 ] }", r) == std::vector<int>{7, 8});
  CHECK(labels(four + set + "}" + set + "materialIndex [ 1, 2 ] }" + set + "}", r) == std::vector<int>{0, 0, 1, 2, 0, 0});
  CHECK(r.skipped.empty());
  CHECK(labels(four + set + "materialIndex -1 }", r).empty());
  CHECK(r.skipped.empty());
  for (const std::string bad : {"[ 1 ]", "[ 1, 2, 3, -1, 1, 2, 3, -1 ]", "[ 1, 3000000000 ]"}) {
    CHECK(labels(four + set + "materialIndex " + bad + " }", r).empty());
    CHECK(r.skipped.size() == 1);
    CHECK(r.skipped[0].ends_with(" material indices that are not one for each face"));
  }
}

TEST_CASE("read_iv: what is skipped is reported") {
  load_report r;
  from_iv("Separator { Material { diffuseColor [ 1 0 0 ] } Transform { translation 1 2 3 } Material { } " + four +
              "IndexedLineSet { coordIndex [ 0, 9, -1 ] } DEF m Complexity { } USE m IndexedFaceSet { coordIndex [ 0, 1, 2 ] normalIndex [ 1, 2 ] } }",
          {.report = &r});
  CHECK(r.skipped == vec_of_strings{"2 nodes Material", "1 nodes Transform", "1 nodes IndexedLineSet", "1 nodes Complexity", "1 nodes used again (USE)"});
  std::string many = four;
  for (int i = 0; i < 30; ++i) many += "Node" + std::to_string(i) + " { } ";
  from_iv(many, {.report = &r});
  CHECK(r.skipped.size() == 21);
  CHECK(r.skipped.back() == "10 nodes of other types");
}

TEST_CASE("read_iv: errors name the line") {
  const std::string set = four + "IndexedFaceSet {\n coordIndex [ ";
  CHECK(complaint<surface_arrays>("", file_format::iv) == "1: #Inventor V2.1 ascii | an empty file");
  CHECK(complaint<surface_arrays>("OFF\n", file_format::iv) == "1: #Inventor V2.1 ascii | 'OFF'");
  CHECK(iv_complaint("") == "1: points (Coordinate3 or VertexProperty) | none");
  CHECK(iv_complaint(set + "0, 1, 4, -1 ] }") == "4: the index of a vert from 0 to 3 or -1 | '4,'");
  CHECK(iv_complaint(set + "0, 1, 2,\n -2 ] }") == "5: the index of a vert or -1 | '-2'");
  CHECK(iv_complaint(set + "0, 1,\n -1 ] }") == "4: a face of at least three verts | one of 2");
  CHECK(iv_complaint(set + "0, 1, 2, 1 ] }") == "4: different verts at the corners of a face (or set options.repeated_verts) | vert 1 twice");
  CHECK(iv_complaint(set + "0, 1, 2.5 ] }") == "4: the index of a vert or -1 | '2.5'");
  CHECK(iv_complaint(set + "0, 1, 2") == "4: the index of a vert or -1 or ']' | the end of the file");
  CHECK(iv_complaint(set + "0, 1, 2 ]\n") == "4: '}' | the end of the file");
  CHECK(iv_complaint(four + "a [") == "3: ']' | the end of the file");
  CHECK(iv_complaint(four + "\n}") == "4: a node | '}'");
  CHECK(iv_complaint(four + "a { ]") == "3: '}' | ']'");
  CHECK(iv_complaint(four + "a [ }") == "3: ']' | '}'");
  CHECK(iv_complaint(four + "\n\"a\\\" }") == "4: a string that ends | one without a closing quotation mark");
  CHECK(iv_complaint(four + "\n\"a\\") == "4: a string that ends | one without a closing quotation mark");
  CHECK(iv_complaint("Coordinate3 { point [ 0 0 ] }") == "2: the z of a vert | ']'");
  CHECK(iv_complaint("Coordinate3 { point [ 0 0 nan ] }") == "2: the z of a vert, a finite number | 'nan'");
  CHECK(iv_complaint("Coordinate3 { point [ 0 0x0 0 ] }") == "2: the y of a vert | '0x0'");
  CHECK(iv_complaint("Coordinate3 { point") == "2: the x of a vert | the end of the file");
  CHECK(iv_complaint("Separator { " + four + "} IndexedFaceSet { coordIndex [ 0, 1, 2 ] }") ==
        "3: points (Coordinate3 or VertexProperty) for the indices of IndexedFaceSet | none");
  CHECK(iv_complaint<quadmesh>(set + "0, 1, 2, 3, -1,\n0, 1, 2 ] }") ==
        "5: a quad (polygonmesh and load_any take any polygon) | a polygon of 3 corners");
  CHECK(iv_complaint(std::string(10001, '{')) == "2: at most 10000 nodes inside each other | more");
  CHECK(iv_complaint(four + std::string(10000, '{') + std::string(10000, '}')).empty());
}

TEST_CASE("read_iv: binary files, volumes and writing are unsupported") {
  const temporary_folder dir;
  CHECK_THROWS_WITH_AS(load_text<trimesh>("#Inventor V2.1 binary\n\0\1", file_format::iv),
                       "text: binary Open Inventor files cannot be read; convert it to ASCII, with ivcat of Coin or Open Inventor", unsupported);
  CHECK_THROWS_AS(load_text<cell_arrays>(inventor + four, file_format::iv), unsupported);
  CHECK_THROWS_AS(save(load_text<trimesh>(inventor + four, file_format::iv), dir / "a.iv"), unsupported);
  CHECK_THROWS_AS(save_text(load_text<trimesh>(inventor + four, file_format::iv), file_format::iv), unsupported);
  CHECK(dir.num_files() == 0);
  write_file(dir / "b", inventor + four + "IndexedFaceSet { coordIndex [ 0, 1, 2, 3 ] }");
  CHECK(num_polys(load_iv<quadmesh>(dir / "b")) == 1);
  CHECK(iv_format::has_signature(inventor));
  CHECK(!iv_format::has_signature("# Inventor"));
}
