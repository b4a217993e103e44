#include <concino/io/detail/vtk_xml/read_vtp.hpp>
#include <concino/io/detail/vtk_xml/read_vtu.hpp>
#include <concino/io/load_any.hpp>

#include <support/poly_volume.hpp>
#include <support/reading.hpp>

#include <doctest/doctest.h>

#include <algorithm>

using namespace concino;
using namespace concino::testing;

namespace {

const std::string cube_points = "0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1 .5 .5 2\n";

std::string vtu_array(const std::string& type, const std::string& name, const std::string& text, const std::string& more = "") {
  return "<DataArray type=\"" + type + "\" Name=\"" + name + "\" " + more + "format=\"ascii\">\n" + text + "\n</DataArray>\n";
}
std::string vtu_cells(const std::string& connectivity, const std::string& offsets, const std::string& types, const std::string& more = "") {
  return "<Cells>\n" + vtu_array("Int64", "connectivity", connectivity) + vtu_array("Int32", "offsets", offsets) + vtu_array("UInt8", "types", types) + more + "</Cells>\n";
}
std::string vtu_piece(unsigned points, unsigned cells, const std::string& content) {
  return "<Piece NumberOfPoints=\"" + std::to_string(points) + "\" NumberOfCells=\"" + std::to_string(cells) + "\">\n" + content + "</Piece>\n";
}
std::string vtu_file(const std::string& pieces, const std::string& attributes = "version=\"1.0\" byte_order=\"LittleEndian\"") {
  return "<?xml version=\"1.0\"?>\n<!-- a <comment> -->\n<VTKFile type=\"UnstructuredGrid\" " + attributes + ">\n<UnstructuredGrid>\n" + pieces + "</UnstructuredGrid>\n</VTKFile>\n";
}
std::string points_of_cube() { return "<Points>\n" + vtu_array("Float64", "Points", cube_points, "NumberOfComponents='3' ") + "</Points>\n"; }
std::string cube_file(const std::string& cells, unsigned n, const std::string& more = "") { return vtu_file(vtu_piece(9, n, points_of_cube() + more + cells)); }

template<class M>
M vtu(const std::string& text, const load_options& options = {}) { return load_alone<M>(text, file_format::vtu, options, "t.vtu"); }

double vtu_volume(const polyhedra_arrays& m) {
  double sum = 0;
  for (std::size_t p = 0; p < m.num_polys(); ++p) sum += testing::six_times_poly_volume(m, p) / 6;
  return sum;
}

std::string base64(const std::string& bytes) {
  std::string s;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = i; k < i + 3; ++k) bits = bits << 8 | (k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0u);
    for (unsigned k = 0; k < 4; ++k) s += i + k <= bytes.size() ? concino::detail::base64_digits[bits >> (18 - 6 * k) & 63] : '=';
  }
  return s;
}
/// Numbers as bytes, in the order of the bytes of the machine, or reversed.
template<class T>
std::string bytes_of(std::initializer_list<T> all, bool reversed = false) {
  std::string s;
  for (const T x : all) {
    std::string one(reinterpret_cast<const char*>(&x), sizeof x);
    if (reversed) std::reverse(one.begin(), one.end());
    s += one;
  }
  return s;
}

}  // namespace

TEST_CASE("read_vtu: cells of all types, also several in a file") {
  const auto m = vtu<polyhedra_arrays>(cube_file(vtu_cells("0 1 3 2 4 5 7 6  4 5 6 7 8", "8 13", "11 14"), 2));
  CHECK(m.num_faces() == 10);
  CHECK(vtu_volume(m) == doctest::Approx(4.0 / 3));
  CHECK(raw(vtu<cell_arrays>(cube_file(vtu_cells("0 1 2 4", "4", "10"), 1)).verts) == std::vector<unsigned>{0, 1, 2, 4});
  CHECK(raw(vtu<surface_arrays>(cube_file(vtu_cells("0 1 2  0 1 2 3  8", "3 7 8", "5 9 1"), 3)).verts) == std::vector<unsigned>{0, 1, 2, 0, 1, 2, 3});
  CHECK(vtu<surface_arrays>(vtu_file("")).num_polys() == 0);
  CHECK(vtu<surface_arrays>(vtu_file("<Piece NumberOfPoints=\"0\" NumberOfCells=\"0\"/>")).num_polys() == 0);
  CHECK(vtu_format::has_signature(vtu_file("")));
  CHECK(!vtp_format::has_signature(vtu_file("")));
  CHECK(!vtu_format::has_signature("<html><VTKFile type=\"UnstructuredGrids\"></html>"));
}

TEST_CASE("read_vtu: polyhedra in both layouts") {
  const std::string old_layout = vtu_array("Int64", "faces", "5 4 4 5 6 7 3 4 5 8 3 5 6 8 3 6 7 8 3 4 7 8") + vtu_array("Int64", "faceoffsets", "-1 22");
  const std::string new_layout = vtu_array("Int64", "face_connectivity", "6 7 8 4 5 6 7 4 5 8 5 6 8 4 7 8") + vtu_array("Int64", "face_offsets", "3 7 10 13 16") +
                                 vtu_array("Int64", "polyhedron_to_faces", "1 2 3 0 4") + vtu_array("Int64", "polyhedron_offsets", "0 5");
  for (const std::string& layout : {old_layout, new_layout}) {
    const auto m = vtu<polyhedra_arrays>(cube_file(vtu_cells("0 1 2 3 4 5 6 7  4 5 6 7 8", "8 13", "12 42", layout), 2));
    CHECK(m.num_polys() == 2);
    CHECK(m.num_faces() == 10);
    CHECK(vtu_volume(m) == doctest::Approx(4.0 / 3));
  }
  // a tet as a polyhedron, as VTK's documentation has it
  const auto tet = vtu<cell_arrays>(cube_file(vtu_cells("0 1 2 4", "4", "42", vtu_array("Int64", "faces", "4  3 0 1 2  3 0 1 4  3 1 2 4  3 0 2 4") + vtu_array("Int64", "faceoffsets", "17")), 1));
  CHECK(tet.num_polys() == 1);
}

TEST_CASE("read_vtu: a program that reads surfaces only takes polyhedra for cells of a volume, whatever their faces are") {
  const std::string of_tet = vtu_array("Int64", "faces", "4  3 0 1 2  3 0 1 4  3 1 2 4  3 0 2 4") + vtu_array("Int64", "faceoffsets", "17");
  const auto says = [](const std::string& text) { return complaint<trimesh>(text, file_format::vtu); };
  const std::string is_volume = "text: holds a volume of ";
  for (const std::string& layout : {of_tet, std::string(), vtu_array("Int64", "faces", "99 -7") + vtu_array("Int64", "faceoffsets", "1000000")}) {
    const std::string one = vtu_cells("0 1 2 4", "4", "42", layout);
    CHECK_THROWS_AS(load_text<trimesh>(cube_file(one, 1), file_format::vtu), unsupported);
    CHECK_THROWS_AS(load_text<polygonmesh>(cube_file(one, 1), file_format::vtu), unsupported);
    // Points of the second piece are at those of the first one, so that the verts of all cells are renumbered.
    const std::string cells = vtu_cells("8 7 6 5  0 1 2", "4 7", "42 5", layout);
    const std::string pieces = vtu_piece(9, 2, points_of_cube() + cells) + vtu_piece(9, 2, points_of_cube() + cells);
    CHECK_THROWS_WITH_AS(load_text<trimesh>(vtu_file(pieces), file_format::vtu), (is_volume + "2 polyhedra, but a surface mesh was requested; load it as polyhedralmesh or with load_any").c_str(), unsupported);
    // A hidden polyhedron is dropped with the faces that were not read.
    const std::string hidden = "<CellData>\n" + vtu_array("UInt8", "vtkGhostType", "32 0") + "</CellData>\n";
    load_report r;
    const auto m = load_text<surface_arrays>(vtu_file(vtu_piece(9, 2, points_of_cube() + cells + hidden)), file_format::vtu, {.report = &r});
    CHECK(raw(m.verts) == std::vector<unsigned>{0, 1, 2});
    CHECK(r.skipped == std::vector<std::string>{"1 ghost cells"});
  }
  CHECK(says(cube_file(vtu_cells("0 1 2 9", "4", "42", of_tet), 1)) == "13: point indices below 9 | 9 in the array \"connectivity\"");
}

TEST_CASE("read_vtu: base64 and appended arrays, in both byte orders and widths of headers, are the same as text") {
  for (const bool reversed : {false, true})
    for (const bool wide : {false, true})
      for (const int form : {0, 1, 2, 3}) {  // base64 in one group, in two, appended base64, appended raw
        std::string appended;
        const auto data = [&](const std::string& bytes) {
          const std::string header = wide ? bytes_of<std::uint64_t>({bytes.size()}, reversed) : bytes_of<std::uint32_t>({static_cast<std::uint32_t>(bytes.size())}, reversed);
          return form == 0 ? base64(header + bytes) : form == 3 ? header + bytes : base64(header) + base64(bytes);
        };
        const auto array = [&](const std::string& type, const std::string& name, const std::string& bytes, const std::string& more = "") {
          std::string s = "<DataArray type=\"" + type + "\" Name=\"" + name + "\" " + more + (form < 2 ? "format=\"binary\">\n " + data(bytes) + "\n</DataArray>\n" : "format=\"appended\" offset=\"" + std::to_string(appended.size()) + "\"/>\n");
          if (form >= 2) appended += data(bytes);
          return s;
        };
        std::string text = "<VTKFile type=\"UnstructuredGrid\" byte_order=\"" + std::string(reversed == (std::endian::native == std::endian::little) ? "BigEndian" : "LittleEndian") + "\"" +
                           (wide ? " header_type=\"UInt64\"" : "") + ">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"4\" NumberOfCells=\"1\">\n<PointData TCoords=\"uv\">" +
                           array("Float32", "uv", bytes_of<float>({0, 0, 1, 0, 0, 1, 0.5f, 0.25f}, reversed), "NumberOfComponents=\"2\" ") + array("UInt16", "a &lt;b&gt;", bytes_of<std::uint16_t>({1, 2, 3, 65535}, reversed)) +
                           "</PointData>\n<Points>" + array("Float32", "", bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0.5f}, reversed), "NumberOfComponents=\"3\" ") + "</Points>\n<Cells>" +
                           array("Int32", "connectivity", bytes_of<std::int32_t>({0, 1, 2, 3}, reversed)) + array("UInt64", "offsets", bytes_of<std::uint64_t>({4}, reversed)) +
                           array("UInt8", "types", bytes_of<std::uint8_t>({10})) + "</Cells>\n</Piece>\n</UnstructuredGrid>\n";
        if (form >= 2) text += std::string("<AppendedData encoding=\"") + (form == 3 ? "raw" : "base64") + "\">\n_" + appended + "\n</AppendedData>\n";
        const tetmesh m = load_text<tetmesh>(text + "</VTKFile>\n", file_format::vtu);
        CHECK(point(m, vert_id{3}) == vec3{0, 0, 0.5});
        CHECK(num_polys(m) == 1);
        CHECK(find_vert_property<std::uint16_t>(m, "a <b>")[vert_id{3}] == 65535);
        CHECK(find_vert_property<std::array<double, 2>>(m, "texture")[vert_id{3}] == std::array<double, 2>{0.5, 0.25});
      }
}

TEST_CASE("read_vtu: cells in VTK's order need no change, also beside polyhedra") {
  const std::string lists = vtu_array("Int64", "faces", "5 4 4 5 6 7 3 5 4 8 3 6 5 8 3 7 6 8 3 4 7 8"), ends = vtu_array("Int64", "faceoffsets", "-1 22");
  const std::string grids[] = {vtu_cells("0 2 1 4 6 5", "6", "13"), vtu_cells("0 2 1 4 6 5  0 2 1 4 6 5", "6 12", "13 13"), vtu_cells("0 2 1 4 6 5  4 5 6 7 8",
      "6 11", "13 42", lists + ends),
                               vtu_cells("0 2 1 4 6 5  0 2 3", "6 9", "13 5"), vtu_cells("0 2 1 4 6 5  0 1 3 2 4 5 7 6", "6 14", "13 11")};
  for (const std::string& cells : grids) {
    CAPTURE(cells);
    load_report r;
    const auto m = vtu<polyhedra_arrays>(cube_file(cells, cells == grids[0] ? 1 : 2), {.report = &r});
    CHECK(r.reoriented_polys == (cells == grids[2] ? 1 : 0));  // the faces of the polyhedron are wound inconsistently
    CHECK(testing::six_times_poly_volume(m, 0) == doctest::Approx(3));
  }
}

TEST_CASE("read_vtu: polyhedra beside other cells, in two pieces") {
  const std::string face_lists = "5 4 4 5 6 7 3 4 5 8 3 5 6 8 3 6 7 8 3 7 4 8  4 3 0 1 2 3 0 1 8 3 1 2 8 3 0 2 8";
  const std::string both = vtu_cells("4 5 6 7 8  0 1 2 3 4 5 6 7  0 1 2 8", "5 13 17", "42 12 42", vtu_array("Int64", "faces", face_lists) + vtu_array("Int64", "faceoffsets", "22 -1 39"));
  const std::string piece = vtu_piece(9, 3, points_of_cube() + both);
  const auto one = vtu<polyhedra_arrays>(vtu_file(piece)), two = vtu<polyhedra_arrays>(vtu_file(piece + piece));
  CHECK(one.poly_offsets == std::vector<std::uint32_t>{0, 5, 11, 15});
  CHECK(two.poly_offsets == std::vector<std::uint32_t>{0, 5, 11, 15, 20, 26, 30});
  CHECK(two.face_verts == one.face_verts);
  std::vector<face_id> twice = one.poly_faces;
  twice.insert(twice.end(), one.poly_faces.begin(), one.poly_faces.end());
  CHECK(two.poly_faces == twice);
}

TEST_CASE("read_vtu: pieces are joined at equal points, and ghost cells dropped") {
  const auto piece = [](const std::string& points, const std::string& cells, const std::string& ghosts, const std::string& values,
      const std::string& heights = "1 2 3 4") {
    return vtu_piece(4, 1, "<Points>\n" + vtu_array("Float32", "Points", points, "NumberOfComponents='3' ") + "</Points>\n" + cells + "<CellData>\n" + vtu_array("UInt8", "vtkGhostType", ghosts) +
                               vtu_array("Int32", "part", values) + "</CellData><PointData>" + vtu_array("Float64", "h", heights) + "</PointData>");
  };
  const std::string cells = vtu_cells("0 1 2 3", "4", "10");
  const std::string of_tet = vtu_array("Int64", "faces", "4  3 0 1 2  3 0 1 3  3 1 2 3  3 0 2 3") + vtu_array("Int64", "faceoffsets", "17");
  load_report r;
  const auto m = load_text<polyhedralmesh>(vtu_file(piece("0 0 0 1 0 0 0 1 0 0 0 1", cells, "0", "5") + piece("1 0 0 0 1 0 0 -0.0 1 1 1 1",
      vtu_cells("0 1 2 3", "4", "42", of_tet), "0", "6", "2 3 4 5") +
                                                    piece("0 0 0 1 0 0 0 1 0 0 0 1", cells, "1", "7")),
                                           file_format::vtu, {.report = &r});
  CHECK(num_verts(m) == 5);
  CHECK(num_polys(m) == 2);
  CHECK(num_faces(m) == 7);
  CHECK(find_poly_property<int>(m, "part")[poly_id{1}] == 6);
  CHECK(find_vert_property<double>(m, "h")[vert_id{4}] == 5);
  CHECK(!find_poly_property<std::uint8_t>(m, "vtkGhostType"));
  REQUIRE(!r.notes.empty());
  CHECK(r.notes.front() == "3 pieces were joined: 7 points at the place of a point of an earlier piece became that point");
  CHECK(r.skipped == std::vector<std::string>{"1 ghost cells"});
}

TEST_CASE("read_vtu: points of pieces stay apart where their values differ, or where a piece has several points") {
  const auto piece = [](const std::string& points, const std::string& heights, const std::string& velocities) {
    return vtu_piece(4, 1, "<Points>\n" + vtu_array("Float32", "Points", points, "NumberOfComponents='3' ") + "</Points>\n" + vtu_cells("0 1 2 3", "4",
        "10") + "<PointData>" +
                               vtu_array("Float32", "h", heights) + vtu_array("Float64", "v", velocities, "NumberOfComponents='3' ") + "</PointData>");
  };
  const std::string one = "0 0 0 1 0 0 0 1 0 0 0 1", other = "1 0 0 0 1 0 0 -0.0 1 1 1 1", no_motion = "0 0 0 0 0 0 0 0 0 0 0 0",
      earlier = " at the place of a point of an earlier piece ";
  const auto load_pieces = [](const std::string& pieces, load_report& r) { return load_text<tetmesh>(vtu_file(pieces), file_format::vtu, {.report = &r}); };
  load_report r;
  // not-a-number is equal to itself, and 0 to -0
  auto m = load_pieces(piece(one, "1 2 nan 4", no_motion) + piece(other, "2 nan 4 5", "-0.0 0 0 0 0 0 0 0 0 0 0 1"), r);
  CHECK(num_verts(m) == 5);
  CHECK(r.notes == std::vector<std::string>{"2 pieces were joined: 3 points" + earlier + "became that point"});
  // one of three points has another value, and another one differs in one component
  m = load_pieces(piece(one, "1 2 3 4", no_motion) + piece(other, "2 7 4 5", "0 0 0 0 0 0 0 1e-300 0 0 0 0"), r);
  CHECK(num_verts(m) == 7);
  std::vector<float> heights;
  for (const auto v : verts(m)) heights.push_back(find_vert_property<float>(m, "h")[v]);
  CHECK(heights == std::vector<float>{1, 2, 3, 4, 7, 4, 5});
  CHECK(raw(adj_p2v(m, poly_id{1})) == std::vector<unsigned>{1, 4, 5, 6});
  CHECK(r.notes == std::vector<std::string>{"2 pieces were joined: 1 points" + earlier + "became that point",
                                            "2 points" + earlier + "stayed apart: they have other values, the first one in \"h\""});
  // the third piece finds its values at the second one
  m = load_pieces(piece(one, "1 2 3 4", no_motion) + piece(other, "9 9 9 9", no_motion) + piece(other, "9 9 9 9", no_motion), r);
  CHECK(num_verts(m) == 8);
  // a crack: one piece has two points at a place
  const std::string cracked = "1 0 0 0 1 0 1 0 0 1 1 1";
  for (const std::string& pieces : {piece(one, "1 2 3 4", no_motion) + piece(cracked, "2 3 2 5", no_motion), piece(cracked, "2 3 2 5", no_motion) + piece(one,
      "1 2 3 4", no_motion)}) {
    m = load_pieces(pieces, r);
    CHECK(num_verts(m) == 7);
    CHECK(r.notes.size() >= 2);
    CHECK(r.notes[0] == "2 pieces were joined: 1 points" + earlier + "became that point");
    const std::size_t others = pieces.find("1 0 0 0 1 0 1") < pieces.find("0 0 0 1 0 0 0") ? 1 : 2;
    CHECK(r.notes[1] == std::to_string(others) + " points" + earlier + "stayed apart: a piece has several points there");
  }
  m = load_pieces(piece(cracked, "2 3 2 5", no_motion) + piece(cracked, "2 3 2 5", no_motion), r);
  CHECK(num_verts(m) == 6);
  m = load_pieces(piece(cracked, "2 3 2 5", no_motion) + piece("5 5 5 6 5 5 5 6 5 5 5 6", "1 1 1 1", no_motion), r);  // the crack is in one piece only
  CHECK(r.notes.front() == "2 pieces were joined: 0 points" + earlier + "became that point");
  CHECK((r.notes.size() == 1 || r.notes[1].find("apart") == std::string::npos));
}

TEST_CASE("read_vtu: arrays become properties; those that cannot are reported") {
  const std::string data = "<FieldData>" + vtu_array("Float64", "TIME", "2.5", "NumberOfTuples=\"1\" ") + vtu_array("Int32", "many", "1 2 3", "NumberOfTuples=\"3\" ") +
                           "<Array type=\"String\" Name=\"s\" format=\"ascii\">65 0</Array></FieldData><CellData>" + vtu_array("Int8", "q", "-7 9") +
                           vtu_array("Float32", "five", "1 2 3 4 5 6 7 8 9 0", "NumberOfComponents=\"5\" ") + "</CellData><PointData Normals=\"n\">" +
                           vtu_array("Float64", "n", "0 0 1 0 0 1 0 0 1 0 0 1 0 0 1 0 0 1 0 0 1 0 0 1 0 0 nan", "NumberOfComponents=\"3\" ") + "</PointData>";
  load_report r;
  const auto m = load_text<hexmesh>(cube_file(vtu_cells("0 1 2 3 4 5 6 7 4 5 6 7", "8 12", "12 9"), 2, data), file_format::vtu, {.report = &r});
  CHECK(find_poly_property<std::int8_t>(m, "q")[poly_id{0}] == -7);
  const auto on_faces = find_face_property<std::int8_t>(m, "q");
  std::size_t nines = 0;
  for (const auto f : faces(m)) nines += on_faces[f] == 9;
  CHECK(nines == 1);
  CHECK(*find_mesh_property<double>(m, "TIME") == 2.5);
  CHECK(find_vert_property<vec3>(m, "normal")[vert_id{0}] == vec3{0, 0, 1});
  CHECK(r.skipped.size() == 3);
}

TEST_CASE("read_vtu: arrays with another number of values than there are elements are skipped with a remark") {
  const std::string cells = vtu_cells("0 1 2 3", "4", "9"), four_bytes = base64(bytes_of<std::uint32_t>({4}) + "abcd");
  const std::string data = "<CellData>" + vtu_array("Int32", "many", "1 2 3") + vtu_array("Int32", "right", "7") +
      "<DataArray type=\"Int8\" Name=\"binary\" format=\"binary\">" + four_bytes +
                           "</DataArray></CellData><PointData>" + vtu_array("Float64", "few", "1 2") + vtu_array("Float64", "v", "1 2 3",
                               "NumberOfComponents=\"3\" ") + "</PointData>";
  load_report r;
  const auto m = load_text<quadmesh>(cube_file(cells, 1, data), file_format::vtu, {.report = &r});
  CHECK(find_poly_property<int>(m, "right")[poly_id{0}] == 7);
  CHECK(property_list(m).size() == 1);
  CHECK(r.skipped == std::vector<std::string>{"array \"many\" of 3 numbers, where 1 cells need 1", "array \"binary\" of 4 numbers, where 1 cells need 1",
                                              "array \"few\" of 2 numbers, where 9 points need 9", "array \"v\" of 3 numbers, where 9 points need 27"});
  const std::string two_pieces = vtu_file(vtu_piece(9, 1, points_of_cube() + cells + "<CellData>" + vtu_array("Int32", "a", "1") + "</CellData>") +
                                          vtu_piece(9, 1, points_of_cube() + cells + "<CellData>" + vtu_array("Int32", "a", "1 2") + "</CellData>"));
  CHECK(property_list(load_text<quadmesh>(two_pieces, file_format::vtu, {.report = &r})).empty());
  CHECK(r.skipped == std::vector<std::string>{"array \"a\" of 2 numbers, where 1 cells need 1"});
  const std::string twice = "<FieldData>" + vtu_array("Float64", "TIME", "1 2", "NumberOfTuples=\"1\" ") + "</FieldData>";
  load_text<quadmesh>(cube_file(cells, 1, twice), file_format::vtu, {.report = &r});
  CHECK(r.skipped == std::vector<std::string>{"array \"TIME\" of 2 numbers, where the mesh needs 1"});
}

TEST_CASE("read_vtu: polygons of .vtp, whatever the format that was asked for") {
  const std::string text = "<VTKFile type=\"PolyData\"><PolyData><Piece NumberOfPoints=\"9\" NumberOfVerts=\"1\" NumberOfLines=\"0\" NumberOfStrips=\"1\" NumberOfPolys=\"2\">" + points_of_cube() +
                           "<Polys>" + vtu_array("Int32", "connectivity", "0 1 2 4 5 6 7") + vtu_array("Int32", "offsets", "3 7") + "</Polys><Verts>" + vtu_array("Int32", "connectivity", "8") +
                           vtu_array("Int32", "offsets", "1") + "</Verts><Strips>" + vtu_array("Int32", "connectivity", "0 1 3 2") + vtu_array("Int32", "offsets", "4") + "</Strips><CellData>" +
                           vtu_array("Int32", "c", "10 20 30 40") + "</CellData></Piece></PolyData></VTKFile>";
  for (const format_id f : {format_id(file_format::vtu), format_id(file_format::vtp)}) {
    load_report r;
    const auto m = load_text<polygonmesh>(text, f, {.report = &r});
    CHECK(num_polys(m) == 4);
    const auto c = find_poly_property<int>(m, "c");  // values are in the order verts, lines, polys, strips
    CHECK((c[poly_id{0}] == 20 && c[poly_id{1}] == 30 && c[poly_id{2}] == 40 && c[poly_id{3}] == 40));
    CHECK(num_elements(adj_p2v(m, poly_id{1})) == 4);
    CHECK(r.skipped == std::vector<std::string>{"1 cells that are verts or lines"});
  }
}

TEST_CASE("read_vtu: errors name the line") {
  const auto says = [](const std::string& text) { return complaint<polyhedra_arrays>(text, file_format::vtu); };
  CHECK(says("") == "1: <VTKFile> | an empty file");
  CHECK(says("<html>\n") == "1: <VTKFile> | '<html>'");
  CHECK(says("<!DOCTYPE a>\n<VTKFile>") == "1: a tag; document types and sections of characters are not supported | '<!DOCTYPE'");
  CHECK(says("<VTKFile type=\"UnstructuredGrid\">\n<UnstructuredGrid>\n") == "2: </UnstructuredGrid> | the end of the file");
  CHECK(says("<VTKFile type=\"UnstructuredGrid\">\n</Piece>\n") == "2: </VTKFile> | </Piece>");
  CHECK(says("<VTKFile type=\"UnstructuredGrid\">\n</VTKFile>\n") == "2: <UnstructuredGrid> or <PolyData> | the end of the file");
  CHECK(says("<VTKFile type=\"UnstructuredGrid\" byte_order=\"Middle\"/>") == "1: byte_order LittleEndian or BigEndian | 'Middle'");
  CHECK(says(vtu_file(vtu_piece(1, 0, ""))) == "5: the array \"Points\" | a piece without it");
  CHECK(says(vtu_file("<Piece NumberOfPoints=\"x\">")) == "5: NumberOfPoints, a number | 'x'");
  CHECK(says(vtu_file(vtu_piece(999999999, 0, points_of_cube()))) == "7: 2999999997 numbers | 58 characters in the array \"Points\"");
  const auto with = [&](const std::string& connectivity, const std::string& offsets, const std::string& types) { return says(cube_file(vtu_cells(connectivity, offsets, types), 1)); };
  CHECK(with("0 1 2 9", "4", "10") == "13: point indices below 9 | 9 in the array \"connectivity\"");
  CHECK(with("0 1 2 -1", "4", "10") == "13: point indices below 9 | -1 in the array \"connectivity\"");
  CHECK(with("0 1 2", "4", "10") == "14: an integer of type int64 | the end of the file");
  CHECK(with("0 1 2 x", "4", "10") == "14: an integer of type int64 | 'x'");
  CHECK(with("0 1 2 4", "-4", "10") == "16: ends that do not decrease | -4 after 0 in the array \"offsets\"");
  CHECK(with("0 1 2 4", "4", "256") == "20: an integer of type unsigned int8 | '256'");
  CHECK(with("0 1 2", "3", "10") == "5: 4 points, for a cell of type 10 | 3 in cell 0 of the piece");
  CHECK(with("0 1 2 2", "4", "10") == "5: different verts in a cell (or set options.repeated_verts) | vert 2 twice in cell 0 of the piece");
  CHECK(with("0 1 2 4", "4", "42") == "5: the array \"faces\" | a piece without it");
  const auto with_faces = [&](const std::string& list, const std::string& ends) {
    return says(cube_file(vtu_cells("0 1 2 4", "4", "42", vtu_array("Int64", "faces", list) + vtu_array("Int64", "faceoffsets", ends)), 1));
  };
  CHECK(says(cube_file(vtu_cells("0 1 2 9", "4", "42", vtu_array("Int64", "faces", "4  3 0 1 2  3 0 1 4  3 1 2 4  3 0 2 4") + vtu_array("Int64", "faceoffsets", "17")), 1)) ==
        "13: point indices below 9 | 9 in the array \"connectivity\"");  // although a polyhedron needs only its faces
  CHECK(with_faces("4  3 0 1 2  3 0 1 4  3 1 2 4  3 0 2 4", "99") == "22: ends of polyhedra that increase to 17 | 99 in the array \"faces\"");
  CHECK(with_faces("4  3 0 1 2  3 0 1 4  3 1 2 4  4 0 2 4", "17") == "22: the number of verts of a face | 4 in the array \"faces\"");
  CHECK(with_faces("4  3 0 1 2  3 0 1 4  3 1 2 4  3 0 2 9", "17") == "22: point indices below 9 | 9 in the array \"faces\"");
  CHECK_THROWS_WITH_AS(load_text<trimesh>("<VTKFile type=\"ImageData\"/>", file_format::vtu), "text: type=\"ImageData\" is not supported; UnstructuredGrid and PolyData are", unsupported);
  CHECK_THROWS_AS(load_text<trimesh>(vtu_file("", "compressor=\"vtkLZ4DataCompressor\""), file_format::vtu), unsupported);
  const std::string quadratic = cube_file(vtu_cells("0 1 2 3 4 5", "6", "22"), 1);
  CHECK_THROWS_WITH_AS(load_text<trimesh>(quadratic, file_format::vtu),
                       "text: the cell at position 0 of the piece on line 5 is a second-order element, of type 22, with nodes on edges; load with "
                           "{.corners_only = true} to read only the corners",
                       unsupported);
  const auto corners = load_text<trimesh>(quadratic, file_format::vtu, {.corners_only = true});
  CHECK(num_polys(corners) == 1);
  CHECK(num_verts(corners) == 6);  // points 6 to 8 belong to no cell
}

TEST_CASE("read_vtu: long arrays are checked as short ones") {
  constexpr unsigned n = 1500;  // more than are converted at a time
  std::string corners, ends, types, points;
  for (unsigned i = 0; i < n; ++i) {
    corners += "0 1 2\n", types += "5 ";
    ends += std::to_string(3 * i + 3) + " ";
    points += std::to_string(i) + " .5 " + std::to_string(i * i) + "\n";
  }
  const auto changed = [](std::string text, const std::string& from, const std::string& to) { return text.replace(text.find(from), from.size(), to); };
  const auto file = [&](const std::string& v, const std::string& e, const std::string& t) {
    return vtu_file(vtu_piece(n, n, "<Points>\n" + vtu_array("Float32", "Points", points, "NumberOfComponents='3' ") + "</Points>\n" +
                                        changed(vtu_cells(v, e, t), "UInt8", "Int16")));
  };
  const auto m = vtu<surface_arrays>(file(corners, ends, types));
  REQUIRE(m.points.size() == n);
  for (unsigned i = 0; i < n; ++i) CHECK((m.points[i] == vec3{double(i), .5, double(i * i)}));
  CHECK(m.verts.size() == 3 * n);
  CHECK(m.arity == 3);
  const auto says = [&](const std::string& v, const std::string& e, const std::string& t) { return complaint<surface_arrays>(file(v, e, t), file_format::vtu); };
  // 3072 = 3 * 1024 is the last number of the first part; 3075 the first one of the second.
  CHECK(says(corners, changed(ends, " 3075 ", " 3071 "), types).ends_with("ends that do not decrease | 3071 after 3072 in the array \"offsets\""));
  CHECK(says(corners, changed(ends, " 3072 ", " 9999999999 "), types).find("9999999999") != std::string::npos);
  CHECK(says(corners, ends, types + "\n").empty());
  CHECK(says(corners, ends, changed(types, "5 5 5 ", "5 -1 5 ")).ends_with("cell types from 0 to 255 | -1 in the array \"types\""));
  CHECK(says(corners, ends, types.substr(0, 2 * n - 4) + "261 5").ends_with("cell types from 0 to 255 | 261 in the array \"types\""));
  CHECK(says(corners.substr(0, corners.size() - 2) + "1500", ends, types).ends_with("point indices below 1500 | 1500 in the array \"connectivity\""));
  CHECK(says(corners.substr(0, corners.size() - 2) + "1", ends, types).find("different points at the corners of a polygon") != std::string::npos);
  CHECK(says(corners, changed(ends, " 30 ", " 31 "), types).find("3 points, for a cell of type 5 | 4") != std::string::npos);
  points.replace(points.rfind(".5"), 2, "nan");
  CHECK(says(corners, ends, types).ends_with("finite coordinates | others at point 1499 in the array \"Points\""));
}

TEST_CASE("read_vtu: quads and pixels") {
  const auto verts_of = [&](const std::string& types, const std::string& corners) { return raw(vtu<surface_arrays>(cube_file(vtu_cells(corners, "4 8", types), 2)).verts); };
  CHECK(verts_of("9 9", "0 1 2 3 4 5 6 7") == std::vector<unsigned>{0, 1, 2, 3, 4, 5, 6, 7});
  CHECK(verts_of("8 8", "0 1 3 2 4 5 7 6") == std::vector<unsigned>{0, 1, 2, 3, 4, 5, 6, 7});
  CHECK(verts_of("9 8", "0 1 2 3 4 5 7 6") == std::vector<unsigned>{0, 1, 2, 3, 4, 5, 6, 7});
  const auto says = [](const std::string& text) { return complaint<surface_arrays>(text, file_format::vtu); };
  CHECK(says(cube_file(vtu_cells("0 1 2 3 4 5 4 7", "4 8", "9 9"), 2)) == "5: different points at the corners of a polygon (or set "
      "options.repeated_verts) | point 4 twice in cell 1 of the piece");
  CHECK(complaint<trimesh>(cube_file(vtu_cells("0 1 2 3 4 5 6 7", "4 8", "9 9"), 2), file_format::vtu).find("a polygon of 4 corners") != std::string::npos);
}

TEST_CASE("read_vtu: sizes in base64 and appended data are compared with the file") {
  const auto piece = [](const std::string& format, const std::string& content) {
    return vtu_file(vtu_piece(1, 0, "<Points>\n<DataArray type=\"Float64\" NumberOfComponents=\"3\" " + format + ">" + content + "</DataArray>\n</Points>\n"));
  };
  const auto says = [](const std::string& text) { return complaint<surface_arrays>(text, file_format::vtu); };
  const std::string origin_bytes(24, '\0');
  CHECK(says(piece("format=\"binary\"", base64(bytes_of<std::uint32_t>({24}) + origin_bytes))).empty());
  CHECK(says(piece("format=\"binary\"", base64(bytes_of<std::uint32_t>({16}) + origin_bytes))) == "7: 3 numbers of 8 bytes | 16 bytes in the array \"\"");
  CHECK(says(piece("format=\"binary\"", base64(bytes_of<std::uint32_t>({4000000000}) + origin_bytes))).starts_with("7: no more bytes than the file has | 4000000000"));
  CHECK(says(piece("format=\"binary\"", base64(bytes_of<std::uint32_t>({24}) + origin_bytes.substr(1)))) == "7: base64 | the end in the array \"\"");
  CHECK(says(piece("format=\"binary\"", base64(bytes_of<std::uint32_t>({24}) + origin_bytes).replace(20, 1, "!"))).starts_with("7: base64 | '!AAA"));
  CHECK(says(piece("format=\"appended\" offset=\"0\"", "")) == "7: an offset into AppendedData | 0 in the array \"\"");
  CHECK(says(piece("format=\"appended\" offset=\"x\"", "")) == "7: offset, a number | 'x'");
  // an array of a property that ends within a number
  const std::string points = "<Points>\n<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0</DataArray>\n</Points>\n";
  const auto column = [&](std::uint32_t size) {
    return vtu_file(vtu_piece(1, 0, points + "<PointData>\n<DataArray type=\"Float64\" Name=\"a\" format=\"binary\">" + base64(bytes_of<std::uint32_t>({size}) + origin_bytes) +
                                        "</DataArray>\n</PointData>\n"));
  };
  CHECK(says(column(8)).empty());
  CHECK(says(column(15)) == "10: numbers of 8 bytes | 15 bytes in the array \"a\"");
}
