#include <concino/io/detail/vtk/read_vtk.hpp>
#include <concino/io/load_any.hpp>

#include <support/poly_volume.hpp>
#include <support/reading.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace concino;
using namespace concino::testing;

namespace {

const std::string vtk_head = "# vtk DataFile Version 3.0\ntitle\nASCII\nDATASET UNSTRUCTURED_GRID\n";
/// The unit cube, and an apex above it.
const std::string vtk_points = "POINTS 9 double\n0 0 0 1 0 0 1 1 0 0 1 0\n0 0 1 1 0 1 1 1 1 0 1 1\n.5 .5 2\n";

/// A number as the bytes of a binary file.
template<class T>
std::string big_endian(T x) {
  std::string s(reinterpret_cast<const char*>(&x), sizeof x);
  std::reverse(s.begin(), s.end());
  return s;
}
template<class T>
std::string big_endian_list(std::initializer_list<T> all) {
  std::string s;
  for (const T x : all) s += big_endian(x);
  return s;
}

std::string repeated(const std::string& text, int n) {
  std::string s;
  for (int i = 0; i < n; ++i) s += text;
  return s;
}

template<class M>
M vtk(const std::string& text, const load_options& options = {}) { return load_alone<M>(text, file_format::vtk, options, "t.vtk"); }

/// The points as .vtk, with cells in rows.
std::string vtk_grid_of(const std::string& cells, const std::string& types, const std::string& data = "") {
  std::size_t rows = 0, numbers = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    rows += cells[i] == '\n';
    numbers += cells[i] > ' ' && (i + 1 == cells.size() || cells[i + 1] <= ' ');
  }
  return vtk_head + vtk_points + "CELLS " + std::to_string(rows) + ' ' + std::to_string(numbers) + '\n' + cells + "CELL_TYPES " + std::to_string(rows) + '\n' + types + '\n' + data;
}

double vtk_volume(const polyhedra_arrays& m) {
  double sum = 0;
  for (std::size_t p = 0; p < m.num_polys(); ++p) sum += testing::six_times_poly_volume(m, p) / 6;
  return sum;
}

const std::string pyramid_as_polyhedron = "22 5 4 4 5 6 7 3 4 5 8 3 5 6 8 3 6 7 8 3 4 7 8\n";

}  // namespace

TEST_CASE("read_vtk: cells of every linear type, with any line ends") {
  for (const std::string end : {"\n", "\r\n"}) {
    const std::string text = with_line_ends(vtk_grid_of("4 0 1 3 4\n5 4 5 6 7 8\n", "10\n14"), end);
    const auto m = vtk<polyhedra_arrays>(text);
    CHECK(m.num_polys() == 2);
    CHECK(vtk_volume(m) == doctest::Approx(1.0 / 6 + 1.0 / 3));
  }
  const auto hex = vtk<cell_arrays>(vtk_grid_of("8 0 1 2 3 4 5 6 7\n", "12"));
  CHECK(raw(hex.verts) == std::vector<unsigned>{0, 1, 2, 3, 4, 5, 6, 7});
  CHECK(raw(vtk<cell_arrays>(vtk_grid_of("8 0 1 3 2 4 5 7 6\n", "11")).verts) == raw(hex.verts));  // a voxel
  load_report r;
  const auto wedges = vtk<polyhedra_arrays>(vtk_grid_of("6 0 2 1 4 6 5\n6 0 2 3 4 6 7\n", "13 13"), {.report = &r});  // VTK's order, and mirrored
  CHECK(vtk_volume(wedges) == doctest::Approx(1));
  CHECK(r.reoriented_polys == 1);
  CHECK(r.notes == std::vector<std::string>{"1 of 2 cells had a negative volume: their verts were put into the standard order"});
  CHECK(wedges.num_faces() == 9);
  const auto two = vtk<polyhedra_arrays>(vtk_grid_of(pyramid_as_polyhedron + "8 0 1 2 3 4 5 6 7\n", "42\n12"));
  CHECK(two.num_polys() == 2);
  CHECK(two.num_faces() == 10);
  CHECK(vtk_volume(two) == doctest::Approx(4.0 / 3));
  // prisms over a pentagon and a hexagon
  const std::string corners[] = {"0 0 0  2 0 0  3 1 0  1 2 0  -1 1 0", "0 0 0  2 0 0  3 1 0  2 2 0  0 2 0  -1 1 0"};
  for (unsigned n : {5u, 6u}) {
    std::string points = corners[n - 5], lifted = points, ids;
    for (std::size_t i = 0; i < lifted.size(); ++i)
      if (lifted[i] == '0' && (i + 2 >= lifted.size() || lifted.substr(i + 1, 2) == "  ")) lifted[i] = '1';
    for (unsigned i = 0; i < 2 * n; ++i) ids += ' ' + std::to_string(i);
    const auto prism = vtk<polyhedra_arrays>(vtk_head + "POINTS " + std::to_string(2 * n) + " float " + points + ' ' + lifted + "\nCELLS 1 " + std::to_string(2 * n + 1) + '\n' +
                                             std::to_string(2 * n) + ids + "\nCELL_TYPES 1 " + (n == 5 ? "15" : "16"), {.report = &r});
    CHECK(r.reoriented_polys == 0);
    CHECK(r.notes.empty());
    CHECK(prism.num_faces() == n + 2);
    CHECK(vtk_volume(prism) == doctest::Approx(n == 5 ? 5 : 6));
  }
}

TEST_CASE("read_vtk: cells in VTK's order need no change, alone and beside others") {
  const std::string wedge = "6 0 2 1 4 6 5\n", mirrored = "6 0 1 2 4 5 6\n";  // the base of a wedge is counter-clockwise seen from outside
  const std::pair<std::string, std::string> grids[] = {{wedge, "13"},
                                                       {wedge + wedge, "13 13"},
                                                       {wedge + "5 4 5 6 7 8\n", "13 14"},
                                                       {wedge + pyramid_as_polyhedron, "13 42"},
                                                       {wedge + "4 0 2 3 4\n", "13 10"},
                                                       {wedge + "3 0 2 3\n", "13 5"},
                                                       {"8 0 1 3 2 4 5 7 6\n" + wedge, "11 13"}};
  for (const auto& grid : grids) {  // the faces of the polyhedron are wound inconsistently
    const std::string &cells = grid.first, &types = grid.second;
    CAPTURE(types);
    load_report r;
    const auto m = vtk<polyhedra_arrays>(vtk_grid_of(cells, types), {.report = &r});
    CHECK(r.reoriented_polys == (types == "13 42" ? 1 : 0));
    const std::size_t at = types == "11 13" ? 1 : 0;
    CHECK(testing::six_times_poly_volume(m, at) == doctest::Approx(3));
    vtk<polyhedra_arrays>(vtk_grid_of(mirrored, "13"), {.report = &r});
    CHECK(r.reoriented_polys == 1);
  }
  CHECK(complaint<polyhedra_arrays>(vtk_grid_of("6 0 2 1 4 6 6\n", "13"), file_format::vtk) == "10: different verts in a cell (or set options.repeated_verts) | vert 6 twice");
  CHECK(complaint<polyhedra_arrays>(vtk_grid_of("5 0 2 1 4 6\n", "13"), file_format::vtk) == "10: 6 points, for a cell of type 13 | 5");
  CHECK(complaint<polyhedra_arrays>(vtk_grid_of("7 0 1 3 2 4 5 6\n", "11"), file_format::vtk) == "10: 8 points, for a cell of type 11 | 7");
}

TEST_CASE("read_vtk: polygons of every type make a surface") {
  const auto m = vtk<surface_arrays>(vtk_grid_of("3 0 1 2\n4 0 1 3 2\n5 4 5 6 7 8\n4 0 1 2 3\n5 0 1 3 2 4\n1 7\n2 0 1\n", "5 8 7 9 6 1 3"));
  CHECK(m.num_polys() == 7);
  CHECK(raw(m.verts) == std::vector<unsigned>{0, 1, 2, 0, 1, 2, 3, 4, 5, 6, 7, 8, 0, 1, 2, 3, 0, 1, 3, 3, 1, 2, 3, 2, 4});
  load_report r;
  CHECK(vtk<surface_arrays>(vtk_grid_of("3 0 1 2\n1 7\n2 0 1\n", "5 1 3"), {.report = &r}).arity == 3);
  CHECK(r.skipped == std::vector<std::string>{"2 cells that are verts or lines"});
  const std::string poly = "# vtk DataFile Version 3.0\n\nASCII\nDATASET POLYDATA\n" + vtk_points;
  const auto p = vtk<surface_arrays>(poly + "TRIANGLE_STRIPS 1 5\n4 0 1 3 2\nVERTICES 1 2\n1 0\nPOLYGONS 2 9\n3 0 1 2\n4 4 5 6 7\nLINES 1 3\n2 0 1\n", {.report = &r});
  CHECK(raw(p.verts) == std::vector<unsigned>{0, 1, 2, 4, 5, 6, 7, 0, 1, 3, 3, 1, 2});
  CHECK(r.skipped == std::vector<std::string>{"2 cells that are verts or lines"});
  const auto m51 = vtk<surface_arrays>(poly + "POLYGONS 3 7\nOFFSETS vtktypeint64\n0 3 7\nCONNECTIVITY vtktypeint64\n0 1 2 4 5 6 7\n");
  CHECK(raw(m51.verts) == std::vector<unsigned>{0, 1, 2, 4, 5, 6, 7});
  CHECK(vtk<surface_arrays>(vtk_head).num_polys() == 0);
  CHECK(num_verts(load_text<tetmesh>(vtk_head + "POINTS 0 float\nCELLS 0 0\nCELL_TYPES 0\n", file_format::vtk)) == 0);
}

TEST_CASE("read_vtk: binary files, in both layouts, hold the same as text") {
  const std::string head = "# vtk DataFile Version 5.1\ntitle\nBINARY\nDATASET UNSTRUCTURED_GRID\n";
  std::string points;
  for (const double x : {0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 0.1}) points += big_endian(x);
  const std::string rows = big_endian_list<std::int32_t>({4, 0, 1, 2, 3}), types = big_endian<std::int32_t>(10);
  const std::string old_text = head + "POINTS 4 double\n" + points + "\nCELLS 1 5\n" + rows + "\nCELL_TYPES 1\n" + types + '\n';
  const std::string new_text = head + "METADATA\nINFORMATION 1\nNAME a LOCATION b\nDATA 1\n\nPOINTS 4 double\n" + points + "\nCELLS 2 4\nOFFSETS vtktypeint64\n" +
                               big_endian_list<std::int64_t>({0, 4}) + "\nCONNECTIVITY vtktypeint64\n" + big_endian_list<std::int64_t>({0, 1, 2, 3}) + "\nCELL_TYPES 1\n" + types;
  for (const std::string& text : {old_text, new_text}) {
    const auto m = vtk<cell_arrays>(text);
    CHECK(raw(m.verts) == std::vector<unsigned>{0, 1, 2, 3});
    CHECK(m.points[3] == vec3{0, 0, 0.1});
  }
  const std::string data = "\nPOINT_DATA 4\nSCALARS s short 2\nLOOKUP_TABLE default\n" + big_endian_list<std::int16_t>({1, -2, 3, 4, 5, 6, 7, 8}) + "\nFIELD f 3\nflags 1 4 bit\n" + '\x50' +
                           "\nnames 1 4 string\n\xC1" "a\xC0\xC2" "bc\x80\x03" "abc\nMETADATA\nX\n\nids 1 4 vtkIdType\n" + big_endian_list<std::int32_t>({9, 8, 7, 6}) +
                           "\nCOLOR_SCALARS c 3\n" + std::string("\xff\0\0\0\xff\0\0\0\xff\0\0\0", 12) + "\nCELL_DATA 1\nNORMALS n float\n" + big_endian_list<float>({0, 0, 1}) + "\n";
  load_report r;
  const auto m = load_text<tetmesh>(old_text + data, file_format::vtk, {.report = &r});
  CHECK(find_vert_property<std::array<std::int16_t, 2>>(m, "s")[vert_id{0}] == std::array<std::int16_t, 2>{1, -2});
  const auto flags = find_vert_property<bool>(m, "flags");
  CHECK((!flags[vert_id{0}] && flags[vert_id{1}] && !flags[vert_id{2}] && flags[vert_id{3}]));
  CHECK(find_vert_property<int>(m, "ids")[vert_id{3}] == 6);
  CHECK(find_vert_property<rgba>(m, "color")[vert_id{1}] == rgba{0, 1, 0, 1});
  CHECK(find_poly_property<vec3>(m, "normal")[poly_id{0}] == vec3{0, 0, 1});
  CHECK(r.skipped == std::vector<std::string>{"array \"names\" of texts"});
  CHECK(r.notes.size() == 2);
}

TEST_CASE("read_vtk: arrays become properties of verts, polys, faces and the mesh") {
  const std::string data =
      "FIELD FieldData 2\nTIME 1 1 double\n2.5\nmany 1 2 int 1 2\nCELL_DATA 3\nSCALARS part unsigned_char\nLOOKUP_TABLE default\n7 8 9\nTENSORS t float\n1 2 3 4 5 6 7 8 9 0 0 0 0 0 0 0 0 0 "
      "1 1 1 1 1 1 1 1 1\nPOINT_DATA 9\nVECTORS v double\n0 0 1e-300 1 2 nan 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 -inf 5 6\nTEXTURE_COORDINATES tc 2 float\n"
      "0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0.5 0.25\nLOOKUP_TABLE t 1\n0 0 0 1\nSCALARS big unsigned_long 1\n0 0 0 0 0 0 0 0 18446744073709551615\nFIELD f 2\na%20b 1 9 long\n"
      "-9223372036854775808 0 0 0 0 0 0 0 1\nfive 5 9 float\n" +
      repeated("1 ", 45) +
      "\nMETADATA\nINFORMATION 0\n\nCOLOR_SCALARS c 4\n" + repeated("0 0.5 1 0.25 ", 9);
  load_report r;
  const auto m = load_text<hexmesh>(vtk_grid_of("4 4 5 6 7\n8 0 1 2 3 4 5 6 7\n1 8\n", "9 12 1", data), file_format::vtk, {.report = &r});
  CHECK(find_poly_property<std::uint8_t>(m, "part")[poly_id{0}] == 8);
  const auto on_faces = find_face_property<std::uint8_t>(m, "part");
  std::size_t sevens = 0;
  for (const auto f : faces(m)) sevens += on_faces[f] == 7 ? 1 : on_faces[f] ? 100 : 0;
  CHECK(sevens == 1);
  CHECK(find_face_property<std::array<float, 9>>(m, "t"));
  CHECK(*find_mesh_property<double>(m, "TIME") == 2.5);
  const auto v = find_vert_property<vec3>(m, "v");
  CHECK(v[vert_id{0}].z == 1e-300);
  CHECK(std::isnan(v[vert_id{1}].z));
  CHECK(v[vert_id{8}].x == -std::numeric_limits<double>::infinity());
  CHECK(find_vert_property<std::array<double, 2>>(m, "texture")[vert_id{8}] == std::array<double, 2>{0.5, 0.25});
  CHECK(find_vert_property<std::uint64_t>(m, "big")[vert_id{8}] == ~std::uint64_t{0});
  CHECK(find_vert_property<std::int64_t>(m, "a b")[vert_id{0}] == std::numeric_limits<std::int64_t>::min());
  CHECK(find_vert_property<rgba>(m, "color")[vert_id{5}] == rgba{0, 0.5f, 1, 0.25f});
  CHECK(r.skipped == std::vector<std::string>{
                         "array \"many\" of 2 values of 1 numbers: properties have one value for each element, of 1, 2, 3, 4, 6 or 9 numbers",
                         "array \"five\" of 9 values of 5 numbers: properties have one value for each element, of 1, 2, 3, 4, 6 or 9 numbers", "1 lookup tables of colours",
                         "1 cells that are verts or lines"});
}

TEST_CASE("read_vtk: elements of second and higher order are read by their corners, if the options say so") {
  load_report r;
  const auto grid = [&](const std::string& points, const std::string& cell, int type, const std::string& data = "") {
    const auto count = [](const std::string& words) { return static_cast<std::size_t>(std::count(words.begin(), words.end(), ' ')); };
    return vtk_head + "POINTS " + std::to_string((count(points) + 1) / 3) + " double\n" + points + "\nCELLS 1 " + std::to_string(count(cell) + 1) + "\n" +
        cell + "\nCELL_TYPES 1\n" + std::to_string(type) + "\n" + data;
  };
  // The middle of an edge is point 2, before corners, so that these are renumbered; point 10 belongs to no cell.
  const std::string tet = "0 0 0 1 0 0 .5 0 0 0 1 0 0 0 1 .5 .5 0 0 .5 0 0 0 .5 .5 0 .5 0 .5 .5 7 7 7";
  const std::string values = "POINT_DATA 11\nSCALARS h int\nLOOKUP_TABLE default\n0 1 2 3 4 5 6 7 8 9 10\nCELL_DATA 1\nSCALARS part int\nLOOKUP_TABLE "
      "default\n42\n";
  for (const int type : {24, 71, 78}) {
    const std::string text = grid(tet, "10 0 1 3 4 2 5 6 7 8 9", type, values);
    const std::string complaint = core::joined({"text: the cell at line 8 is a ", type == 24 ? "second-order" : "higher-order", " element, of type ", type,
                                                ", with nodes on edges; load with {.corners_only = true} to read only the corners"});
    CHECK_THROWS_WITH_AS(load_text<tetmesh>(text, file_format::vtk), complaint.c_str(), unsupported);
    const auto m = load_text<tetmesh>(text, file_format::vtk, {.report = &r, .corners_only = true});
    CHECK(num_verts(m) == 5);
    CHECK(raw(adj_p2v(m, poly_id{0})) == std::vector<unsigned>{0, 1, 2, 3});
    CHECK(find_vert_property<int>(m, "h")[vert_id{2}] == 3);
    CHECK(find_vert_property<int>(m, "h")[vert_id{4}] == 10);
    CHECK(find_poly_property<int>(m, "part")[poly_id{0}] == 42);
    CHECK(r.reoriented_polys == 0);
    CHECK(r.skipped == std::vector<std::string>{"6 points, the nodes of 1 elements of second or higher order: only corners were read"});
  }
  // The base of quadratic wedges is reversed, as that of wedges; those of Lagrange and Bezier are in the standard order.
  const std::string wedge = "0 0 0 0 1 0 1 0 0 0 0 1 0 1 1 1 0 1 0 .5 0 .5 .5 0 .5 0 0 0 .5 1 .5 .5 1 .5 0 1", mid_edges = " 6 7 8 9 10 11";
  for (const int type : {31, 73, 80}) {
    const auto m = vtk<polyhedra_arrays>(grid(wedge, (type == 31 ? "12 0 1 2 3 4 5" : "12 0 2 1 3 5 4") + mid_edges, type), {.report = &r,
        .corners_only = true});
    CHECK(m.points.size() == 6);
    CHECK(vtk_volume(m) == doctest::Approx(0.5));
    CHECK(r.notes.empty());
  }
  // A node of one cell that is the corner of another stays. Quadratic edges are skipped with or without the option.
  const std::string both = vtk_grid_of("6 0 1 2 4 5 6\n3 4 5 8\n3 0 1 4\n", "22 5 21");
  const auto s = vtk<surface_arrays>(both, {.report = &r, .corners_only = true});
  CHECK(raw(s.verts) == std::vector<unsigned>{0, 1, 2, 4, 5, 7});
  CHECK(s.points.size() == 8);
  CHECK(r.skipped == std::vector<std::string>{"1 cells that are verts or lines", "1 points, the nodes of 1 elements of second or higher order: only corners "
      "were read"});
  CHECK(vtk<surface_arrays>(vtk_grid_of("3 0 1 4\n3 0 1 2\n", "21 5")).verts.size() == 3);
  CHECK(vtk<surface_arrays>(vtk_grid_of("3 0 1 4\n", "21")).verts.empty());
  CHECK(vtk<surface_arrays>(vtk_grid_of("8 0 1 2 3 4 5 6 7\n", "36"), {.corners_only = true}).arity == 4);
  const auto says = [](const std::string& cells, const char* type) {
    try {
      load_text<surface_arrays>(vtk_grid_of(cells, type), file_format::vtk, {.corners_only = true});
    } catch (const parse_error& e) {
      return e.expected + " | " + e.found;
    }
    return std::string();
  };
  CHECK(says("7 0 1 2 3 4 5 6\n", "36") == "an even number of points, for a cell of type 36 | 7");
  CHECK(says("5 0 1 2 3 4\n", "22") == "6 points, for a cell of type 22 | 5");
  CHECK(says("2 0 1\n", "69") == "at least 3 points, for a cell of type 69 | 2");
  CHECK(says("6 0 1 2 3 4 9\n", "22") == "a point index below 9 | 9");
}

TEST_CASE("read_vtk: arrays with another number of values than there are elements are skipped with a remark") {
  const std::string data = "CELL_DATA 3\nSCALARS part int\nLOOKUP_TABLE default\n1 2 3\nCOLOR_SCALARS c 3\n0 0 0 0.5 0 0 1 nan inf\nNORMALS n float\n0 0 1 "
      "0 0 1 0 0 1\n"
                           "FIELD f 3\nthree 1 3 double\n7 8 9\none 1 1 double\n1.5\nnames 1 3 string\na\nb\nc\n"
                           "POINT_DATA 9\nSCALARS h int\nLOOKUP_TABLE default\n0 1 2 3 4 5 6 7 8\nFIELD f 1\ntwo 2 8 int\n0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0\n"
                               "CELL_DATA 1\nSCALARS late int\nLOOKUP_TABLE default\n5\n";
  load_report r;
  const auto m = load_text<hexmesh>(vtk_grid_of("8 0 1 2 3 4 5 6 7\n", "12", data), file_format::vtk, {.report = &r});
  CHECK(find_poly_property<double>(m, "one")[poly_id{0}] == 1.5);
  CHECK(find_poly_property<int>(m, "late")[poly_id{0}] == 5);
  CHECK(find_vert_property<int>(m, "h")[vert_id{8}] == 8);
  CHECK(property_list(m).size() == 3);
  const std::string need = " values, where 1 cells need one each";
  CHECK(r.skipped == std::vector<std::string>{"array \"part\" of 3" + need, "array \"c\" of 3" + need, "array \"normal\" of 3" + need,
      "array \"three\" of 3" + need, "array \"names\" of texts",
                                              "array \"two\" of 8 values, where 9 points need one each"});
  CHECK(complaint<cell_arrays>(vtk_grid_of("8 0 1 2 3 4 5 6 7\n", "12", "CELL_DATA 300\nSCALARS a int\nLOOKUP_TABLE default\n1 2 3\n"), file_format::vtk) ==
        "14: a count that fits into the file | 300 int numbers, and 7 bytes");
}

TEST_CASE("read_vtk: errors name the line") {
  const auto says = [](const std::string& text) { return complaint<polyhedra_arrays>(text, file_format::vtk); };
  CHECK(says("") == "1: # vtk DataFile Version | an empty file");
  CHECK(says("OFF\n") == "1: # vtk DataFile Version | 'OFF'");
  CHECK(says("# vtk DataFile Version 3.0\nt\nBOTH\n") == "3: ASCII or BINARY | 'BOTH'");
  CHECK(says("# vtk DataFile Version 3.0\nt\nASCII\nPOINTS\n") == "4: DATASET | 'POINTS'");
  CHECK(says(vtk_head + "POINTS 2 double\n0 0 0\n0 x 0\n") == "7: a number | 'x'");
  CHECK(says(vtk_head + "POINTS 2 double\n0 0 0\n0 nan 0\n") == "7: the coordinates of a point, finite numbers | '0'");
  CHECK(says(vtk_head + "POINTS 2 real\n") == "5: a type of numbers, such as double or int | 'real'");
  CHECK(says(vtk_head + "POINTS 99999999999 double\n0 0 0\n") == "5: a count that fits into the file | 99999999999 double numbers, and 7 bytes");
  CHECK(says(vtk_head + "POINTS 3000 double\n0 0 0\n") == "5: a count that fits into the file | 9000 double numbers, and 7 bytes");
  CHECK(says(vtk_grid_of("4 0 1 2 9\n", "10")) == "10: a point index below 9 | 9");
  CHECK(says(vtk_grid_of("8 0 1 2 3 4 5 6 7\n4 0 1 2\n", "12 10")) == "11: cells of 13 numbers | a cell of 4 where 3 are left");
  CHECK(says(vtk_grid_of("8 0 1 2 3 4 5 6 7\n3 0 1 2\n", "12 10")) == "11: 4 points, for a cell of type 10 | 3");
  CHECK(says(vtk_grid_of("4 0 1 2 2\n", "10")) == "10: different verts in a cell (or set options.repeated_verts) | vert 2 twice");
  CHECK(says(vtk_grid_of("4 0 1 2 4\n", "10 12")) == "12: a section, such as POINTS, CELLS, POINT_DATA or SCALARS | '12'");
  CHECK(says(vtk_grid_of("4 0 1 2 4\n", "")) == "11: an integer of type int32 | the end of the file");
  CHECK(says(vtk_head + vtk_points + "CELLS 1 5\n4 0 1 2 4\n") == "10: a section CELL_TYPES | the end of the file");
  CHECK(says(vtk_head + vtk_points + "CELLS 1 5\n4 0 1 2 -4\n") == "10: an index of a point | -4");
  CHECK(says(vtk_grid_of("9 2 3 0 1 2 4 0 1 2\n", "42")) == "10: the verts of 2 faces of a polyhedron | a list that ends in face 1");
  CHECK(says(vtk_grid_of("10 2 3 0 1 2 3 0 1 2 7\n", "42")) == "10: the end of the polyhedron after 2 faces | 1 more numbers");
  CHECK(says(vtk_grid_of("9 2 3 0 1 2 3 2 1 0\n", "42")) == "10: different faces in a polyhedron | two with the same verts");
  CHECK(says(vtk_head + vtk_points + "CELL_DATA 1\nCELLS 1 5\n4 0 1 2 4\nCELL_TYPES 1\n10\n") == "10: one section CELLS, before CELL_DATA | 'CELLS'");
  CHECK(says(vtk_grid_of("8 0 1 2 3 4 5 6 7\n", "12", "CELL_DATA 1\nSCALARS a int\nLOOKUP_TABLE default\n3000000000\n")) == "16: an integer of type int32 | '3000000000'");
  CHECK(complaint<trimesh>(vtk_grid_of("3 0 1 2\n4 0 1 2 3\n", "5 9"), file_format::vtk) == "11: a triangle (polygonmesh and load_any take any polygon) | a polygon of 4 corners");
  CHECK(complaint<tetmesh>(vtk_grid_of("4 0 1 2 4\n8 0 1 2 3 4 5 6 7\n", "10 12"), file_format::vtk) == "11: a tet (polyhedralmesh and load_any take any cell) | a hex of 6 faces");
  const std::string offsets = vtk_head + vtk_points + "CELLS 2 4\nOFFSETS vtktypeint64\n0 4\nCONNECTIVITY vtktypeint64\n0 1 2 4\nCELL_TYPES 1\n10";
  CHECK(says(offsets).empty());
  CHECK(says(std::string(offsets).replace(offsets.find("0 4\n"), 3, "0 5")) == "11: offsets that increase to 4 | 5");
  CHECK(says(std::string(offsets).replace(offsets.find("0 1 2 4\n"), 7, "0 1\n2 9")) == "13: a point index below 9 | 9");
  CHECK_THROWS_WITH_AS(load_text<polyhedralmesh>(vtk_grid_of("8 0 1 2 3 4 5 6 7\n", "24"), file_format::vtk),
                       "text: the cell at line 10 is a second-order element, of type 24, with nodes on edges; load with {.corners_only = true} to read only "
                           "the corners", unsupported);
  CHECK_THROWS_WITH_AS(load_text<polyhedralmesh>(vtk_grid_of("8 0 1 2 3 4 5 6 7\n", "41"), file_format::vtk),
                       "text: the cell at line 10 has type 41; types from 17 on are not supported, except 42 and elements of second and higher order",
                           unsupported);
  CHECK_THROWS_WITH_AS(load_text<polyhedralmesh>("# vtk DataFile Version 3.0\nt\nASCII\nDATASET STRUCTURED_POINTS\n", file_format::vtk),
                       "text: DATASET 'STRUCTURED_POINTS' is not supported; UNSTRUCTURED_GRID and POLYDATA are", unsupported);
  CHECK_THROWS_AS(load_text<trimesh>(vtk_grid_of("8 0 1 2 3 4 5 6 7\n", "12"), file_format::vtk), unsupported);
  CHECK_THROWS_AS(load_text<hexmesh>(vtk_grid_of("3 0 1 2\n", "5"), file_format::vtk), unsupported);
}

TEST_CASE("read_vtk: errors in binary files name the byte") {
  const std::string head = "# vtk DataFile Version 3.0\ntitle\nBINARY\nDATASET UNSTRUCTURED_GRID\nPOINTS 3 float\n";
  const std::string points = big_endian_list<float>({0, 0, 0, 1, 0, 0, 0, 1, 0});
  const std::string cells = "\nCELLS 1 4\n" + big_endian_list<std::int32_t>({3, 0, 1, 3}) + "\nCELL_TYPES 1\n" + big_endian<std::int32_t>(5);
  const auto says = [](const std::string& text) { return complaint<surface_arrays>(text, file_format::vtk); };
  CHECK(says(head + points + cells) == "3: a point index below 3 | 3 at byte " + std::to_string(head.size() + points.size() + 11));
  CHECK(says(head + points.substr(1)) == "3: a count that fits into the file | 9 float numbers, and 35 bytes at byte " + std::to_string(head.size() - 15));
  CHECK(says(head + big_endian_list<float>({0, 0, 0, 1, 0, 0, 0, std::numeric_limits<float>::infinity(), 0})).starts_with("3: the coordinates of a point, finite numbers | "));
  const std::size_t first = head.size() + points.size() + std::string("\nCELLS 1 4\n").size();
  const auto row = [&](const char* n, std::initializer_list<std::int32_t> numbers) { return says(head + points + "\nCELLS " + n + " 4\n" + big_endian_list(numbers)); };
  CHECK(row("1", {3, 0, 1, -3}) == "3: an index of a point | -3 at byte " + std::to_string(first + 12));
  CHECK(row("1", {-3, 0, 1, 2}) == "3: an index of a point | -3 at byte " + std::to_string(first));
  CHECK(row("1", {4, 0, 1, 2}) == "3: cells of 4 numbers | a cell of 4 where 3 are left at byte " + std::to_string(first));
  CHECK(row("1", {2, 0, 1, 2}) == "3: cells of 4 numbers | 1 cells of 3 at byte " + std::to_string(first));
  CHECK(row("2", {3, 0, 1, 2}) == "3: cells of 4 numbers | 2 cells of more at byte " + std::to_string(first + 16));
}
