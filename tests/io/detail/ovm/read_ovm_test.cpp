#include <concino/io/detail/ovm/read_ovm.hpp>

#include <concino/geometry/measure.hpp>
#include <concino/io/hedra.hpp>
#include <concino/io/ovm.hpp>
#include <concino/io/save.hpp>
#include <concino/mesh/hexmesh.hpp>
#include <concino/mesh/polyhedralmesh.hpp>
#include <concino/mesh/property.hpp>
#include <concino/mesh/tetmesh.hpp>

#include <support/corpus.hpp>
#include <support/kinds.hpp>
#include <support/reading.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <set>

using namespace concino;
using namespace concino::testing;

namespace {

using list = std::vector<std::string>;

const std::string points = "OVM ASCII\nVertices\n4\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
const std::string edge_rows = "Edges\n6\n0 1\n1 2\n2 0\n0 3\n1 3\n2 3\n";
const std::string face_rows = "Faces\n4\n3 5 3 1\n3 0 8 7\n3 2 10 9\n3 6 11 4\n";
const std::string before = points + edge_rows + face_rows;
const std::string tet = before + "Polyhedra\n1\n4 0 2 4 6\n";

template<class M = polyhedra_arrays>
M ovm(const std::string& text, const load_options& options = {}) {
  return load_alone<M>(text, file_format::ovm, options, "t.ovm");
}
template<class M = polyhedra_arrays>
std::string says(const std::string& text) {
  return complaint<M>(text, file_format::ovm);
}
std::string with(std::string text, const std::string& what, const std::string& by) { return text.replace(text.find(what), what.size(), by); }

}  // namespace

TEST_CASE("read_ovm: reads verts, edges, faces of half-edges and polyhedra of half-faces") {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    load_report r;
    const polyhedra_arrays m = ovm(with_line_ends("# made by hand\n" + with(tet, "Edges", "# the edges\nEDGES"), end), {.report = &r});
    CHECK(m.points.size() == 4);
    CHECK(m.face_offsets == std::vector<std::uint32_t>{0, 3, 6, 9, 12});
    CHECK(raw(m.face_verts) == std::vector<unsigned>{0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2});
    CHECK(raw(m.poly_faces) == std::vector<unsigned>{0, 1, 2, 3});
    CHECK(m.outward == std::vector<std::uint8_t>{1, 1, 1, 1});
    CHECK(r.reoriented_polys == 0);
    CHECK(r.notes.empty());
    CHECK(r.skipped.empty());
  }
  load_report r;
  ovm(with(tet, "OVM ASCII\n", ""), {.report = &r});
  CHECK(r.notes == list{"the first line, OVM ASCII, is missing"});
  ovm(with(tet, "OVM ASCII\n", "ovm\n"), {.report = &r});
  CHECK(r.notes == list{"the word ASCII is missing in the first line"});
  CHECK(ovm("OVM ASCII Vertices 0 Edges 0 Faces 0 Polyhedra 0").num_polys() == 0);
  ovm(with(points, "4\n", "5\n") + "1 1 1\n" + with(edge_rows, "6\n", "7\n") + "3 4\n" + face_rows + "Polyhedra 0", {.report = &r});
  CHECK(r.skipped == list{"1 edges of no face"});
  CHECK(num_polys(ovm<tetmesh>(tet)) == 1);
  CHECK_THROWS_AS(ovm<surface_arrays>(tet), unsupported);
  CHECK(says<hexmesh>(tet) == "24: a hex (polyhedralmesh and load_any take any polyhedron) | a tet of 4 faces");
}

TEST_CASE("read_ovm: either orientation of cells is read, and turned outward") {
  for (const char* cell : {"4 1 3 5 7", "4 0 3 4 6", "4 1 2 5 7"}) {
    load_report r;
    const auto m = ovm(before + "Polyhedra\n1\n" + cell, {.report = &r});
    CHECK(m.outward == std::vector<std::uint8_t>{1, 1, 1, 1});
    CHECK(r.reoriented_polys == 1);
    CHECK(r.notes == list{"1 of 1 polyhedra were wound inconsistently or inside out: their faces were turned outward"});
  }
}

TEST_CASE("read_ovm: errors name the line, what was expected and what was found") {
  CHECK(says("") == "1: OVM ASCII | an empty file");
  CHECK(says("OFF\n") == "1: OVM ASCII | 'OFF'");
  CHECK(says("OVMB\n\x01") == "1: OVM ASCII | 'OVMB'");
  CHECK_THROWS_WITH_AS(load_text<polyhedralmesh>("OVM BINARY\n", file_format::ovm), "text:1: OVM BINARY has never been defined; convert it to OVM ASCII", unsupported);
  CHECK(says("OVM ASCII\nEdges") == "2: Vertices | 'Edges'");
  CHECK(says(points) == "7: Edges | the end of the file");
  CHECK(says(points + edge_rows) == "15: Faces | the end of the file");
  CHECK(says(before) == "21: Polyhedra | the end of the file");
  CHECK(says(with(tet, "0 3\n", "0 4\n")) == "13: a vert index from 0 to 3 | '4'");
  CHECK(says(with(tet, "3 5 3 1", "3 12 3 1")) == "18: the index of a half-edge from 0 to 11 | '12'");
  CHECK(says(with(tet, "3 5 3 1", "3 5 2 1")) == "18: a half-edge from vert 2, where the one before it ends | one from vert 1");
  CHECK(says(with(tet, "3 0 8 7", "3 0 8 11")) == "19: a half-edge to vert 0, where the first one of the face begins | one to vert 2");
  CHECK(says(with(tet, "3 0 8 7", "2 0 1")) == "19: a face of at least three verts | one of 2");
  CHECK(says(with(tet, "3 0 8 7", "4 0 1 0 1")).starts_with("19: different verts at the corners of a face"));
  CHECK(says(with(tet, "4 0 2 4 6", "4 0 2 4 8")) == "24: the index of a half-face from 0 to 7 | '8'");
  CHECK(says(with(tet, "4 0 2 4 6", "4 0 2 4 5")) == "24: different faces in a polyhedron | face 2 twice");
  CHECK(says(with(tet, "4 0 2 4 6", "0")) == "24: a polyhedron of at least one face | one without faces");
  CHECK(says(with(tet, "1 0 0", "1 0 inf")) == "5: the z of a vert, a finite number | 'inf'");
  CHECK(says("OVM ASCII Vertices 4000000000") == "1: the x of a vert | the end of the file");
  CHECK(says(points + "Edges 99999999999999\n").starts_with("8: "));
  CHECK(says(tet + "7") == "25: a property (VProp, EProp, HEProp, FProp, HFProp, CProp or MProp), or the end of the file | '7'");
  for (std::size_t n = 0; n < tet.size() - 1; ++n) CHECK_THROWS_AS(load_text<polyhedralmesh>(tet.substr(0, n), file_format::ovm), parse_error);
  CHECK(ovm(tet + std::string("\n\0\x1a", 3)).num_polys() == 1);
}

TEST_CASE("read_ovm: properties of every type") {
  load_report r;
  const auto m = load_text<polyhedralmesh>(
      tet + "VProp int \"label\"\n1\n-2\n3\n2147483647\nVPROP STRING \"a \"name\"\"\n0:\n3:a b\n5:\n#:\"\n\n1:x\n# a comment\nEProp double \"length\"\n0 1 2\n3 4 5\n"
            "FProp vec3d \"normal\"\n0 0 -1\n0 -1 0\n1 1 1\n-1 0 0\nCProp vec4f \"color\"\n1 0.5 0 1\nMProp ulong \"total\"\n18446744073709551615\n"
            "CProp bool \"b\"\n1\nCProp char \"c\"\n#\nCProp uchar \"u\"\n\xff\nCProp short \"s\"\n-7\nCProp uint \"ui\"\n4294967295\nCProp long \"l\"\n-9\n"
            "CProp float \"f\"\nnan\nCProp vec2i \"v\"\n1 2\nCProp vector_double \"vd\"\n2\n0.5\n1.5\n",
      file_format::ovm, {.report = &r});
  CHECK(r.skipped.empty());
  CHECK(find_vert_property<int>(m, "label")[vert_id{3}] == 2147483647);
  CHECK(find_vert_property<std::string>(m, "a \"name\"")[vert_id{2}] == "\n#:\"\n");
  const auto length = find_edge_property<double>(m, "length");
  for (const auto e : edges(m)) {
    const auto v = adj_e2v(m, e);
    const std::set<unsigned> ends{v[0].raw(), v[1].raw()};
    const std::set<unsigned> all[] = {{0, 1}, {1, 2}, {0, 2}, {0, 3}, {1, 3}, {2, 3}};
    CHECK(ends == all[static_cast<int>(length[e])]);
  }
  CHECK(find_face_property<vec3>(m, "normal")[face_id{2}] == vec3{1, 1, 1});
  const poly_id p{0};
  CHECK(find_poly_property<rgba>(m, "color")[p] == rgba{1, 0.5f, 0, 1});
  CHECK(*find_mesh_property<std::uint64_t>(m, "total") == ~std::uint64_t{0});
  CHECK(find_poly_property<bool>(m, "b")[p]);
  CHECK(find_poly_property<std::int8_t>(m, "c")[p] == '#');
  CHECK(find_poly_property<std::uint8_t>(m, "u")[p] == 255);
  CHECK(find_poly_property<std::int16_t>(m, "s")[p] == -7);
  CHECK(find_poly_property<unsigned>(m, "ui")[p] == 4294967295u);
  CHECK(find_poly_property<std::int64_t>(m, "l")[p] == -9);
  CHECK(std::isnan(find_poly_property<float>(m, "f")[p]));
  CHECK(find_poly_property<std::array<int, 2>>(m, "v")[p] == std::array{1, 2});
  CHECK(find_poly_property<std::vector<double>>(m, "vd")[p] == std::vector{0.5, 1.5});
}

TEST_CASE("read_ovm: properties that no mesh has are skipped with a word") {
  load_report r;
  const auto m = load_text<polyhedralmesh>(tet + "HEProp vec2d \"uv\"\n1 1 1 1 1 1 1 1 1 1 1 1\n1 1 1 1 1 1 1 1 1 1 1 1\nHFProp string \"s\"\n1:a\n1:b\n1:c\n1:d\n0:\n0:\n0:\n8:CProp  x\n"
                                                 "VProp vector_vh \"w\"\n1\n3\n0\n0\n0\nCProp int \"x\"\n5\nMProp map_heh_int \"y\"\n0\n",
                                           file_format::ovm, {.report = &r});
  CHECK(r.skipped == list{"half-edge property \"uv\"", "half-face property \"s\"", "vert property \"w\" of the type vector_vh, which no property has",
                          "mesh property \"y\" of the type map_heh_int, which no property has"});
  CHECK(find_poly_property<int>(m, "x")[poly_id{0}] == 5);
}

TEST_CASE("read_ovm: errors in properties") {
  CHECK(says(tet + "VProp\n") == "25: the type of the property | the end of the line");
  CHECK(says(tet + "VProp int\n") == "25: the name of the property in quotes | the end of the line");
  CHECK(says(tet + "VProp int \"a\n") == "25: the name of the property in quotes | '\"a'");
  CHECK(says(tet + "VProp int \"a\"\n1 2 3 x\n") == "26: an integer of type int32 | 'x'");
  CHECK(says(tet + "VProp int \"a\"\n1 2 3") == "25: a value for each of 4 elements | only 6 bytes to the end of the file");
  CHECK(says(tet + "VProp int \"a\"\n1 2 34") == "26: an integer of type int32 | the end of the file");
  CHECK(says(tet + "CProp bool \"a\"\n2\n") == "26: 0 or 1 | '2'");
  CHECK(says(tet + "CProp short \"a\"\n40000\n") == "26: an integer of type int16 | '40000'");
  CHECK(says(tet + "CProp string \"a\"\n9:abc\n") == "26: a string that fits into the file | one of 9 bytes");
  CHECK(says(tet + "CProp string \"a\"\n-1:abc\n") == "26: the length of a string and a colon | '-1:abc'");
  CHECK(says(tet + "CProp string \"a\"\nabc\n") == "26: the length of a string and a colon | 'abc'");
  CHECK(says(tet + "CProp vector_double \"a\"\n99999999\n") != "");
  CHECK(says(tet + "CProp char \"a\"\n \n") != "");
}

TEST_CASE("read_ovm: values of polys, faces and edges follow polys with a vert twice") {
  load_report r;
  const std::string two = with(with(with(tet, "Edges\n6", "Edges\n7"), "2 3\n", "2 3\n3 3\n"), "Faces\n4", "Faces\n5");
  const std::string text = with(two, "3 6 11 4\n", "3 6 11 4\n4 6 12 11 4\n") + "CProp int \"x\"\n5\nFProp int \"y\"\n1 2 3 4 5\nEProp int \"z\"\n1 2 3 4 5 6 7\n";
  const auto m = load_text<polyhedralmesh>(text, file_format::ovm, {.report = &r, .repeated_verts = repeated_verts::collapse});
  CHECK(num_polys(m) == 1);
  CHECK(find_poly_property<int>(m, "x")[poly_id{0}] == 5);
  CHECK(find_face_property<int>(m, "y")[face_id{1}] == 2);
}

TEST_CASE("write_ovm: what is read is written, and the second save is the first") {
  const std::string all = tet + "VProp int \"label\"\n1\n-2\n3\n4\nVProp string \"s\"\n0:\n3:a b\n2:\n#\n1:x\nEProp double \"length\"\n1.5\n2.5\n3.5\n4.5\n5.5\n6.5\n"
                                "FProp vec3d \"normal\"\n0 0 -1\n0 -1 0\n1 1 1\n-1 0 0\nCProp vec4f \"color\"\n1 0.5 0 1\nCProp bool \"b\"\n1\nCProp char \"c\"\n#\n"
                                "CProp vector_double \"vd\"\n2\n0.5\n1.5\nMProp ulong \"total\"\n18446744073709551615\n";
  save_report r;
  const auto m = load_text<polyhedralmesh>(all, file_format::ovm);
  const std::string first = save_text(m, file_format::ovm, {.report = &r});
  CHECK(r.lost.empty());
  CHECK(first == with(with(with(with(all, edge_rows, "Edges\n6\n0 2\n2 1\n1 0\n1 3\n3 0\n2 3\n"), "3 5 3 1\n3 0 8 7\n3 2 10 9\n3 6 11 4", "3 0 2 4\n3 5 6 8\n3 3 10 7\n3 9 11 1"),
                           "4 0 2 4 6", "4 0 2 4 6"),
                      "1.5\n2.5\n3.5\n4.5\n5.5\n6.5", "3.5\n2.5\n1.5\n5.5\n4.5\n6.5"));
  CHECK(save_text(load_text<polyhedralmesh>(first, file_format::ovm), file_format::ovm) == first);
  CHECK(save_text(polyhedralmesh(), file_format::ovm) == "OVM ASCII\nVertices\n0\nEdges\n0\nFaces\n0\nPolyhedra\n0\n");
  CHECK_THROWS_AS(save_text(grid<trimesh>(1), file_format::ovm), unsupported);
}

TEST_CASE_TEMPLATE("write_ovm: every kind of volume comes back", M, tetmesh, hexmesh, polyhedralmesh) {
  const M m = grid<M>(2);
  const std::string text = save_text(m, file_format::ovm, {.binary = false, .strict = true});
  const M back = load_text<M>(text, file_format::ovm);
  CHECK(back.points() == m.points());
  CHECK(num_edges(back) == num_edges(m));
  CHECK(num_faces(back) == num_faces(m));
  CHECK(num_polys(back) == num_polys(m));
  CHECK(total_measure(back) == doctest::Approx(total_measure(m)));
  CHECK(save_text(back, file_format::ovm) == text);
  CHECK_THROWS_AS(save_text(m, file_format::ovm, {.binary = true}), unsupported);
}

TEST_CASE("write_ovm: faces with the same verts keep their values") {
  polyhedra_arrays a = load_text<polyhedra_arrays>(with(with(tet, "Faces\n4", "Faces\n6"), "3 6 11 4\n", "3 6 11 4\n3 5 3 1\n3 1 5 3\n"), file_format::ovm);
  polyhedralmesh m(std::move(a));
  REQUIRE(num_faces(m) == 6);
  for (const auto f : faces(m)) face_property<int>(m, "n")[f] = static_cast<int>(f.raw()) + 1;
  const std::string text = save_text(m, file_format::ovm);
  CHECK(text.ends_with("FProp int \"n\"\n1\n2\n3\n4\n5\n6\n"));
  CHECK(save_text(load_text<polyhedralmesh>(text, file_format::ovm), file_format::ovm) == text);
}

TEST_CASE("write_ovm: what the format does not hold is lost with a word") {
  auto m = load_text<polyhedralmesh>(tet, file_format::ovm);
  poly_property<std::int8_t>(m, "blank")[poly_id{0}] = ' ';
  poly_property<std::uint16_t>(m, "ushort");
  poly_property<std::array<double, 9>>(m, "matrix");
  poly_property<int>(m, "line\nend");
  poly_property<int>(m, "quote\"");
  poly_property<double>(m, "nan")[poly_id{0}] = std::nan("");
  poly_property<rgba>(m, "tint");
  save_report r;
  const std::string text = save_text(m, file_format::ovm, {.report = &r});
  CHECK(text == save_text(load_text<polyhedralmesh>(tet, file_format::ovm), file_format::ovm) + "CProp double \"nan\"\n0\nCProp vec4f \"tint\"\n1 1 1 1\n");
  CHECK(r.lost == list{"poly property \"blank\": .ovm cannot store it", "poly property \"ushort\": .ovm cannot store it", "poly property \"matrix\": .ovm cannot store it",
                       "poly property \"line\nend\": .ovm cannot store it", "poly property \"quote\"\": .ovm cannot store it",
                       "1 numbers of colours and other properties that are not finite: written as 0"});
}

TEST_CASE("read_ovm: files of the corpus") {
  CONCINO_CORPUS_OR_SKIP(cube, "polyhedral/cube_with_props.ovm");
  CONCINO_CORPUS_OR_SKIP(cylinder, "polyhedral/cylinder_hex.ovm");
  CONCINO_CORPUS_OR_SKIP(voronoi, "polyhedral/voronoi_cube_250.ovm");
  CONCINO_CORPUS_OR_SKIP(hedra, "polyhedral/voronoi_cube_250.hedra");
  load_report r;
  const auto c = load<polyhedralmesh>(cube, {.report = &r});
  CHECK(total_measure(c) == doctest::Approx(8));
  CHECK(r.reoriented_polys == 0);
  CHECK(r.skipped == list{"half-face property \"HalfFace Constraints\""});
  CHECK(find_vert_property<float>(c, "Vertex Weights")[vert_id{1}] == 6.334f);
  CHECK(find_face_property<bool>(c, "Face Selection")[face_id{1}]);
  CHECK(num_polys(load<hexmesh>(cube)) == 1);

  const auto h = load<hexmesh>(cylinder, {.report = &r});
  CHECK(num_verts(h) == 399);
  CHECK(num_edges(h) == 1070);
  CHECK(num_faces(h) == 960);
  CHECK(num_polys(h) == 288);
  CHECK(r.reoriented_polys == 288);
  CHECK(total_measure(load<polyhedralmesh>(cylinder)) == doctest::Approx(8.485).epsilon(1e-4));

  const auto v = load_ovm<polyhedralmesh>(voronoi, {.report = &r});
  CHECK(r.reoriented_polys == 0);
  CHECK(num_edges(v) == 2990);
  CHECK(save_text(v, file_format::hedra) == save_text(load_hedra<polyhedralmesh>(hedra), file_format::hedra));
  CHECK(total_measure(v) == doctest::Approx(1));
}
