// Files as other programs write them, with habits that their formats do not mention.
#include <concino/io/load_any.hpp>
#include <concino/io/save.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/polyhedralmesh.hpp>
#include <concino/mesh/tetmesh.hpp>

#include <doctest/doctest.h>

#include <bit>
#include <string>
#include <string_view>
#include <vector>

using namespace concino;

namespace {

const std::string off_points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n", off_faces = "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

bool mentions(const std::vector<std::string>& remarks, std::string_view words) {
  for (const std::string& r : remarks)
    if (r.find(words) != r.npos) return true;
  return false;
}

/// A property of verts; fails the test if there is none.
template<class T>
std::vector<T> values_of_verts(const polygonmesh& m, const char* name) {
  std::vector<T> r;
  if (const auto map = find_vert_property<T>(m, name))
    for (const vert_id v : verts(m)) r.push_back(map[v]);
  CHECK(!r.empty());
  return r;
}

std::string little_endian(std::initializer_list<std::uint32_t> words) {
  std::string r;
  for (const std::uint32_t w : words)
    for (int shift = 0; shift < 32; shift += 8) r += static_cast<char>(w >> shift & 255);
  return r;
}

std::string grid_of_one_tet(const std::string& point_data, const std::string& cell_data) {
  return "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid><Piece NumberOfPoints=\"4\" NumberOfCells=\"1\"><PointData>" + point_data +
      "</PointData><CellData>" +
         cell_data +
         "</CellData><Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 0 1 0 0 0 1</DataArray></Points><Cells>"
         "<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">0 1 2 3</DataArray><DataArray type=\"Int64\" Name=\"offsets\" "
             "format=\"ascii\">4</DataArray>"
         "<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">10</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>";
}
std::string array(const char* type, const char* name, const char* numbers) {
  return std::string("<DataArray type=\"") + type + "\" Name=\"" + name + "\" format=\"ascii\">" + numbers + "</DataArray>";
}

}  // namespace

TEST_CASE("foreign writers: OFF with the counts in the first word") {
  for (const std::string word : {"OFF4 4 0", "OFF4 4 6", "OFF4\n4 0"}) {
    const auto m = load_text<polygonmesh>(word + "\n" + off_points + off_faces, file_format::off);
    CHECK(num_verts(m) == 4);
    CHECK(num_polys(m) == 4);
  }
  CHECK(off_format::has_signature("OFF4 4 0"));
  CHECK(off_format::has_signature("NCOFF"));
  CHECK(!off_format::has_signature("OFFER"));
  CHECK_THROWS_AS(load_text<polygonmesh>("OFFER 4 4\n", file_format::off), parse_error);
}

TEST_CASE("foreign writers: NCOFF is CNOFF") {
  std::string rows;
  for (const char* const p : {"0 0 0", "1 0 0", "0 1 0", "0 0 1"}) rows += std::string(p) + " 0 0 1 255 0 0 255\n";
  const auto m = load_text<polygonmesh>("NCOFF\n4 4 0\n" + rows + off_faces, file_format::off);
  CHECK(values_of_verts<rgba>(m, "color")[0] == rgba{1, 0, 0});
  CHECK(values_of_verts<vec3>(m, "normal")[3] == vec3{0, 0, 1});
}

TEST_CASE("foreign writers: binary OFF that is little-endian and has no numbers of colours, as pmp writes it") {
  const std::uint32_t one = std::bit_cast<std::uint32_t>(1.0f);
  const std::string file = "OFF BINARY\n" + little_endian({4, 4, 0, 0, 0, 0, one, 0, 0, 0, one, 0, 0, 0, one, 3, 0, 2, 1, 3, 0, 1, 3, 3, 0, 3, 2, 3, 1, 2, 3});
  load_report r;
  const auto m = load_text<polygonmesh>(file, file_format::off, {.report = &r});
  CHECK(num_polys(m) == 4);
  CHECK(point(m, vert_id{3}) == vec3{0, 0, 1});
  CHECK(mentions(r.notes, "little-endian"));
  CHECK(r.notes.size() == 2);
  CHECK_THROWS_AS(load_text<polygonmesh>(file.substr(0, file.size() - 4), file_format::off), parse_error);
}

TEST_CASE("foreign writers: 0 for no texture coordinate or normal in OBJ") {
  load_report r;
  const auto m = load_text<polygonmesh>("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0.5\nf 1/0/0 3/1 2//0\n", file_format::obj, {.report = &r});
  CHECK(num_polys(m) == 1);
  CHECK(r.notes == std::vector<std::string>{"3 indices of texture coordinates or normals are 0: the corners have none"});
  CHECK(save_text(m, file_format::obj).find("f 1 3/1 2\n") != std::string::npos);
  CHECK_THROWS_AS(load_text<polygonmesh>("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", file_format::obj), parse_error);
}

TEST_CASE("foreign writers: colours in OBJ that are no numbers, or from 0 to 255") {
  load_report r;
  const std::string face = "f 1 2 3\n";
  const auto m = load_text<polygonmesh>("v 0 0 0 nan nan nan\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\n" + face, file_format::obj, {.report = &r});
  CHECK(values_of_verts<rgba>(m, "color") == std::vector<rgba>{{1, 1, 1}, {0, 1, 0}, {0, 0, 1}});
  CHECK(r.skipped == std::vector<std::string>{"1 colours of verts with a number that is not finite"});
  const auto bytes = load_text<polygonmesh>("v 0 0 0 255 0 0\nv 1 0 0\nv 0 1 0 0 51 255\n" + face, file_format::obj, {.report = &r});
  CHECK(values_of_verts<rgba>(bytes, "color") == std::vector<rgba>{{1, 0, 0}, {1, 1, 1}, {0, 0.2f, 1}});
  CHECK(mentions(r.notes, "from 0 to 255"));
  CHECK_THROWS_AS(load_text<polygonmesh>("v 0 0 0 a b c\n", file_format::obj), parse_error);
}

TEST_CASE("foreign writers: colours above 1 that are no bytes are kept, and are written to OBJ so that they read back") {
  auto m = load_text<polygonmesh>("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", file_format::obj);
  vert_property<rgba>(m, "color")[vert_id{1}] = {2, 4, 1};
  const std::string first = save_text(m, file_format::obj, {.strict = true});
  const auto back = load_text<polygonmesh>(first, file_format::obj);
  CHECK(values_of_verts<rgba>(back, "color")[1] == rgba{2, 4, 1});
  CHECK(save_text(back, file_format::obj) == first);
  const std::string face = "v 1 0 0\nv 0 1 0\nf 1 2 3\n";
  CHECK(values_of_verts<rgba>(load_text<polygonmesh>("v 0 0 0 1.5 0 255\n" + face, file_format::obj), "color")[0] == rgba{1.5f, 0, 255});
  CHECK(values_of_verts<rgba>(load_text<polygonmesh>("v 0 0 0 256 0 0\n" + face, file_format::obj), "color")[0] == rgba{256, 0, 0});
}

TEST_CASE("foreign writers: an array of bits in VTU is skipped with a remark") {
  load_report r;
  const auto m = load_text<polyhedralmesh>(grid_of_one_tet("", array("Bit", "mask", "1")), file_format::vtu, {.report = &r});
  CHECK(num_polys(m) == 1);
  CHECK(r.skipped == std::vector<std::string>{"array \"mask\" of bits"});
}

TEST_CASE("foreign writers: a second array of one name is read under another name") {
  load_report r;
  const std::string values = array("Float32", "dup", "0 1 2 3") + array("Int32", "dup", "4 5 6 7") + array("Int32", "dup_2", "8 9 9 9") +
      array("Int8", "dup", "1 2 3 4");
  const auto m = load_text<polyhedralmesh>(grid_of_one_tet(values, ""), file_format::vtu, {.report = &r});
  const auto dup = find_vert_property<float>(m, "dup");
  const auto second = find_vert_property<std::int32_t>(m, "dup_2"), other = find_vert_property<std::int32_t>(m, "dup_2_2");
  REQUIRE(dup);
  REQUIRE(second);
  REQUIRE(other);
  CHECK(dup[vert_id{3}] == 3);
  CHECK(second[vert_id{3}] == 7);
  CHECK(other[vert_id{0}] == 8);
  CHECK(find_vert_property<std::int8_t>(m, "dup_3"));
  CHECK(mentions(r.notes, "another array \"dup\" is the property \"dup_2\""));

  const std::string vtk = "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 3 double\n0 0 0 1 0 0 0 1 0\nPOLYGONS 1 4\n3 0 1 2\nCELL_DATA 1\n"
                          "SCALARS a double\nLOOKUP_TABLE default\n1.5\nSCALARS a int\nLOOKUP_TABLE default\n2\n";
  const auto s = load_text<polygonmesh>(vtk, file_format::vtk, {.report = &r});
  REQUIRE(find_poly_property<int>(s, "a_2"));
  CHECK(find_poly_property<int>(s, "a_2")[poly_id{0}] == 2);
  CHECK(mentions(r.notes, "another poly property \"a\" in the file is the property \"a_2\""));
}

TEST_CASE("foreign writers: MEDIT with Fortran's numbers, and Ctrl-Z or NUL behind the last line") {
  const std::string head = "MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0.0D+00 0 0 0\n1.0D+00 0 0 0\n0 10.0d-1 0 0\n0 0 1.D0 0\nTetrahedra\n"
      "1\n1 2 3 4 7\n";
  for (const std::string_view tail : {std::string_view("End\n"), std::string_view("End\n\x1a"), std::string_view("End\x1a"),
      std::string_view("\x1a\r\n"), std::string_view("End\n\0\0\0\0", 8)}) {
    const auto m = load_text<tetmesh>(head + std::string(tail), file_format::medit);
    CHECK(num_polys(m) == 1);
    CHECK(point(m, vert_id{2}) == vec3{0, 1, 0});
    CHECK(point(m, vert_id{3}) == vec3{0, 0, 1});
  }
  const std::string pad("\n\0\x1a\n", 4);
  CHECK(num_polys(load_text<polygonmesh>("OFF\n4 4 0\n" + off_points + off_faces + pad, file_format::off)) == 4);
  CHECK(num_polys(load_text<polygonmesh>("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3" + pad, file_format::obj)) == 1);
  CHECK(num_polys(load_text<tetmesh>("4 vertices\n1 tets\n" + off_points + "4 0 1 2 3" + pad, file_format::tet)) == 1);
  CHECK(num_polys(load_text<tetmesh>("4 4 1\n" + off_points + "3 1 3 2\n3 1 2 4\n3 2 3 4\n3 1 4 3\n4 1 2 3 4" + pad, file_format::hedra)) == 1);
  CHECK(num_polys(load_text<polygonmesh>("# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 3 double\n0 0 0 1 0 0 0 1 0\nPOLYGONS 1 4\n3 "
      "0 1 2" + pad, file_format::vtk)) == 1);
}

TEST_CASE("foreign writers: a tetmesh saved to .hedra, loaded and saved again gives the same bytes") {
  const std::string five = "MeshVersionFormatted 2 Dimension 3 Vertices 8 0 0 0 0 1 0 0 0 1 1 0 0 0 1 0 0 0 0 1 0 1 0 1 0 1 1 1 0 0 1 1 0 "
                           "Tetrahedra 5 1 2 3 6 0 3 8 6 7 0 1 3 4 8 0 1 6 8 5 0 1 3 8 6 0 End";
  for (const format_id f : {format_id(file_format::hedra), format_id(file_format::hybrid)}) {
    const std::string first = save_text(load_text<tetmesh>(five, file_format::medit), f);
    CHECK(save_text(load_text<tetmesh>(first, f), f) == first);
    const auto cells = load_text<polyhedralmesh>(five, file_format::medit);
    CHECK(save_text(load_text<polyhedralmesh>(save_text(cells, f), f), f) == save_text(cells, f));
  }
}
