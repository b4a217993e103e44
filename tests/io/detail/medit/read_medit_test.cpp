#include <concino/io/detail/cells/orient.hpp>
#include <concino/io/detail/medit/read_medit.hpp>
#include <concino/mesh/hexmesh.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/tetmesh.hpp>
#include <concino/mesh/trimesh.hpp>

#include <concino/concepts/end_verts.hpp>

#include <support/poly_volume.hpp>
#include <support/reading.hpp>

#include <doctest/doctest.h>

#include <set>

using namespace concino;
using namespace concino::testing;

namespace {

const std::string head = "MeshVersionFormatted 2\nDimension 3\n";
const std::string points = "Vertices\n4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n";
const std::string one_tet = head + points + "Tetrahedra\n1\n1 2 3 4 0\nEnd\n";
const std::string cube = head + "Vertices 9\n0 0 0 0  1 0 0 0  1 1 0 0  0 1 0 0\n0 0 1 0  1 0 1 0  1 1 1 0  0 1 1 0  0.5 0.5 2 0\n";

template<class M>
M medit(const std::string& text, const load_options& options = {}) {
  return load_alone<M>(text, file_format::medit, options, "t.mesh");
}
template<class M = cell_arrays>
std::size_t line(const std::string& text) {
  return bad_line<M>(text, file_format::medit);
}

}  // namespace

TEST_CASE("read_medit: reads tets, hexes, triangles and quads, with any line ends") {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    const auto tets = medit<cell_arrays>(with_line_ends(one_tet, end));
    CHECK(tets.arity == 4);
    CHECK(tets.points.size() == 4);
    CHECK(raw(tets.verts) == std::vector<unsigned>{0, 1, 2, 3});
  }
  const auto hexes = medit<cell_arrays>(cube + "Hexahedra 1 1 2 3 4 5 6 7 8 0 End");
  CHECK(hexes.arity == 8);
  CHECK(raw(hexes.verts) == std::vector<unsigned>{0, 1, 2, 3, 4, 5, 6, 7});
  const auto triangles = medit<surface_arrays>(head + points + "Triangles 2\n1 2 3 0\n1 2 4 0\nEnd");
  CHECK(triangles.arity == 3);
  CHECK(triangles.num_polys() == 2);
  const auto mixed =
      medit<surface_arrays>(head + points + "Triangles 2\n1 2 3 0\n1 2 4 0\nQuadrilaterals 1\n1 2 3 4 0\nTriangles 1 2 3 4 0 End");
  CHECK(mixed.arity == 0);
  CHECK(mixed.offsets == std::vector<std::uint32_t>{0, 3, 6, 10, 13});
}

TEST_CASE("read_medit: accepts free layout, comments, sections in any order, and dimension 2") {
  const auto t = medit<cell_arrays>(
      "# c\nMeshVersionFormatted # d\n1 Tetrahedra 1 1 2 3 4 7 # e\nCorners 1 1 Dimension\n3 Vertices 4 0 0 0 1 1 0 0 1 0 1 0 1 0 0 1 1 "
      "End rest is not read");
  CHECK(raw(t.verts) == std::vector<unsigned>{0, 1, 2, 3});
  const auto flat = medit<surface_arrays>("MeshVersionFormatted 1 Dimension 2 Triangles 1 1 2 3 0 Vertices 3 0 0 0 1 0 0 0 1 0 End");
  CHECK(flat.points[2] == vec3{0, 1, 0});
  CHECK(flat.num_polys() == 1);
}

TEST_CASE("read_medit: references and marks of a volume become properties of its elements") {
  load_report r;
  const std::string text = head + "NormalAtVertices 2\n1 2 4 1\n" + points +
                           "Edges 3\n1 2 5\n4 2 0\n3 1 0\nTriangles 2\n3 2 1 7\n1 2 4 0\nRidges\n1\n3\nRequiredEdges 1\n2\nCorners 2\n4 1\nRequiredVertices 1\n3\n"
                           "RequiredTriangles 1\n2\nNormals 2\n0 1e-3 2.5E+1\n1 0 0\nTetrahedra 1\n1 2 3 4 0\nTangents 1\n1 0 0\nEnd\n";
  const auto m = load_text<tetmesh>(text, file_format::medit, {.report = &r});
  CHECK(r.skipped == std::vector<std::string>{"section Tangents, 1 rows"});
  CHECK(r.notes.empty());
  const auto at_verts = [&](const char* name) {
    std::vector<int> all;
    for (const auto v : verts(m)) all.push_back(find_vert_property<int>(m, name)[v]);
    return all;
  };
  CHECK(at_verts("corner") == std::vector<int>{1, 0, 0, 1});
  CHECK(at_verts("required") == std::vector<int>{0, 0, 1, 0});
  CHECK(find_vert_property<vec3>(m, "normal")[vert_id{0}] == vec3{1, 0, 0});
  CHECK(find_vert_property<vec3>(m, "normal")[vert_id{1}] == vec3{});
  CHECK(find_vert_property<vec3>(m, "normal")[vert_id{3}] == vec3{0, 1e-3, 25});
  const auto label = find_edge_property<int>(m, "label"), ridge = find_edge_property<int>(m, "ridge"), required = find_edge_property<int>(m, "required");
  CHECK(!find_edge_property<int>(m, "entity"));
  for (const auto e : edges(m)) {
    const auto [a, b] = end_verts(m, e);
    const std::set<unsigned> ends = {a.raw(), b.raw()};
    const auto joins = [&](unsigned x, unsigned y) { return ends == std::set<unsigned>{x, y}; };
    CHECK(label[e] == (joins(0, 1) ? 5 : 0));
    CHECK(ridge[e] == (joins(0, 2) ? 1 : 0));
    CHECK(required[e] == (joins(1, 3) ? 1 : 0));
  }
  const auto face_label = find_face_property<int>(m, "label"), face_required = find_face_property<int>(m, "required");
  for (const auto f : faces(m)) {
    unsigned sum = 0;
    for (const auto v : adj_f2v(m, f)) sum += v.raw();
    CHECK(face_label[f] == (sum == 3 ? 7 : 0));
    CHECK(face_required[f] == (sum == 4 ? 1 : 0));
  }
  CHECK(!find_face_property<int>(m, "entity"));
}

TEST_CASE("read_medit: marks of a surface; several sections of one kind are numbered through") {
  const std::string text = head + points + "Quadrilaterals 1\n1 2 3 4 1\nTriangles 1\n1 2 3 2\nRequiredTriangles 2\n3 1\nRequiredQuadrilaterals 1\n2\nTriangles 2\n1 2 4 3\n1 3 4 4\n"
                                          "Quadrilaterals 1\n4 3 2 1 5\nEdges 1\n1 2 0\nRidges 1\n2\nEdges 1\n2 3 0\nEnd";
  const auto m = load_text<polygonmesh>(text, file_format::medit);
  const auto required = find_poly_property<int>(m, "required"), label = find_poly_property<int>(m, "label");
  const int expected[] = {0, 1, 0, 1, 1};
  for (unsigned p = 0; p < 5; ++p) {
    CHECK(required[poly_id{p}] == expected[p]);
    CHECK(label[poly_id{p}] == static_cast<int>(p) + 1);
  }
  // an edge that is listed without a value
  const auto entity = find_edge_property<int>(m, "entity"), ridge = find_edge_property<int>(m, "ridge");
  int num_entities = 0, num_ridges = 0;
  for (const auto e : edges(m)) num_entities += entity[e], num_ridges += ridge[e];
  CHECK(num_entities == 2);
  CHECK(num_ridges == 1);
}

TEST_CASE("read_medit: elements that the mesh does not have, and normals of no vertex, are reported as skipped") {
  load_report r;
  load_text<tetmesh>(head + points + "Triangles 1\n1 2 3 4\nNormals 1\n0 0 1\nQuadrilaterals 1\n1 2 3 4 5\nTetrahedra 1\n1 2 3 4 0\nEnd", file_format::medit, {.report = &r});
  CHECK(r.skipped == std::vector<std::string>{"section Normals, 1 rows", "values of 1 elements of kind face that the mesh does not have"});
  load_text<trimesh>(head + points + "Triangles 1\n1 2 3 4\nEdges 1\n1 4 1\nEnd", file_format::medit, {.report = &r});
  CHECK(r.skipped == std::vector<std::string>{"values of 1 elements of kind edge that the mesh does not have"});
  medit<cell_arrays>(one_tet.substr(0, one_tet.size() - 4), {.report = &r});
  CHECK(r.notes == std::vector<std::string>{"the file has no End: it may be cut off"});
}

TEST_CASE("read_medit: errors in sections besides polys name the line") {
  const std::string tet = head + points + "Tetrahedra 1\n1 2 3 4 0\n";  // lines 3 to 10
  CHECK(line(tet + "Triangles 1\n1 2 9 0\nEnd") == 12);
  CHECK(line(tet + "Triangles 1\n1 2 2 0\nEnd") == 12);
  CHECK(line(tet + "Edges 1\n1 1 0\nEnd") == 12);
  CHECK(line(tet + "Edges 2\n1 2 0\nEnd") == 13);
  CHECK(line(tet + "Corners\n1\n5\nEnd") == 13);
  CHECK(line(tet + "Edges 1\n1 2 0\nRidges 1\n2\nEnd") == 14);
  CHECK(line(tet + "Ridges 1\n1\nEnd") == 12);
  CHECK(line(tet + "RequiredTriangles 1\n1\nEnd") == 12);
  CHECK(line(tet + "Triangles 1\n1 2 3 0\nRequiredQuadrilaterals 1\n1\nEnd") == 14);
  CHECK(line(tet + "Normals 1\n0 0 1\nNormalAtVertices 1\n1 2\nEnd") == 14);
  CHECK(line(tet + "NormalAtVertices 1\n1 1\nEnd") == 12);
  CHECK(line(tet + "Ridges\nEnd") == 12);
  CHECK(complaint<cell_arrays>(tet + "Ridges 1\n1\nEnd", file_format::medit) == "12: the index of an edge, but there is nothing to refer to | '1'");
}

TEST_CASE("read_medit: cells of different shapes share their common faces") {
  const auto m = medit<polyhedra_arrays>(cube + "Pyramids 1\n5 6 7 8 9 0\nHexahedra 1\n1 2 3 4 5 6 7 8 0\nEnd");
  CHECK(m.num_polys() == 2);
  CHECK(m.num_faces() == 10);
  CHECK(m.poly_offsets == std::vector<std::uint32_t>{0, 5, 11});
  double volume = 0;
  for (std::size_t p = 0; p < 2; ++p) volume += testing::six_times_poly_volume(m, p) / 6;
  CHECK(volume == doctest::Approx(1 + 1.0 / 3));
  const auto two_prisms = medit<polyhedra_arrays>(cube + "Prisms 2\n1 2 3 5 6 7 0\n1 3 4 5 7 8 0\nEnd");
  CHECK(two_prisms.num_faces() == 9);
  CHECK(testing::six_times_poly_volume(two_prisms, 0) + testing::six_times_poly_volume(two_prisms, 1) == doctest::Approx(6));
}

TEST_CASE("read_medit: cells of negative volume are reordered and counted") {
  for (const std::string cells : {"Tetrahedra 2\n1 3 2 5 0\n1 2 3 5 0\n", "Hexahedra 2\n1 4 3 2 5 8 7 6 0\n1 2 3 4 5 6 7 8 0\n",
                                  "Prisms 2\n1 3 2 5 7 6 0\n1 2 3 5 6 7 0\n", "Pyramids 2\n5 8 7 6 9 0\n5 6 7 8 9 0\n"}) {
    load_report r;
    const auto m = medit<polyhedra_arrays>(cube + cells + "End", {.report = &r});
    CHECK_MESSAGE(r.reoriented_polys == 1, cells);
    CHECK(r.notes.size() == 1);
    for (std::size_t p = 0; p < 2; ++p) CHECK(testing::six_times_poly_volume(m, p) > 0);
  }
  load_report r;
  const auto flat = medit<cell_arrays>(cube + "Tetrahedra 1\n1 2 3 4 0\nEnd", {.report = &r});
  CHECK(r.reoriented_polys == 0);
  CHECK(raw(flat.verts) == std::vector<unsigned>{0, 1, 2, 3});
}

TEST_CASE("read_medit: errors name the line") {
  CHECK(line("") == 1);
  CHECK(line("# only\n") == 1);
  CHECK(line("OFF\n1 2 3\n") == 1);
  CHECK(line("MeshVersionFormatted x\n") == 1);
  CHECK(line(head) == 2);
  CHECK(line("MeshVersionFormatted 1\nDimension\n4\n") == 3);
  CHECK(line("MeshVersionFormatted 1\nVertices 0\n") == 2);
  CHECK(line(head + "Vertices 1 0 0 0 0\n\nVertices 1 0 0 0 0\n") == 5);
  CHECK(line(head + "Vertices\n-1\n") == 4);
  CHECK(line(head + "Vertices\n2\n0 0 0 0\n0 0 nan 0\n") == 6);
  CHECK(line(head + "Vertices\n2\n0 0 0 0\n0 0 0\nEnd") == 7);
  CHECK(line(head + "Vertices\n1\n0 0 0 9999999999\n") == 5);
  CHECK(line(head + points + "3\n") == 9);
  CHECK(line(head + points + "Tetrahedra\n1\n1 2 3 5 0\nEnd\n") == 11);
  CHECK(line(head + points + "Tetrahedra\n1\n0 2 3 4 0\nEnd\n") == 11);
  CHECK(line(head + points + "Tetrahedra\n1\n1 2 3 3 0\nEnd\n") == 11);
  CHECK(line(head + points + "Tetrahedra\n1\n1 2") == 11);
  CHECK(line(head + points + "Tetrahedra\n1000000000000000\n1 2 3 4 0\n") == 11);
  CHECK(line(head + "Vertices\n1000000000\n0 0 0 0\n") == 5);
  CHECK(line<surface_arrays>(head + points + "Triangles\n1\n1 2 5 0\nEnd\n") == 11);
}

TEST_CASE("read_medit: the error names the line of the first cell that cell_arrays cannot hold") {
  CHECK(line(cube + "Tetrahedra 1\n1 2 3 6 0\nHexahedra 1\n1 2 3 4 5 6 7 8 0\nEnd") == 9);
  CHECK(line(cube + "Prisms 1\n\n1 2 3 5 6 7 0\nEnd") == 8);
}

TEST_CASE("read_medit: messages name what was expected and what was found") {
  const auto says = [](const std::string& text) { return complaint<cell_arrays>(text, file_format::medit); };
  CHECK(says("MeshVersionFormatted 1\nDimension\n4\n") == "3: the dimension, 2 or 3 | '4'");
  CHECK(says(head + points + "Tetrahedra\n1\n1 3 3 2 0\nEnd\n") == "11: different verts in a cell (or set options.repeated_verts) | vert 3 twice");
  CHECK(says(head + points + "Tetrahedra\n1\n1 2 3 5 0\nEnd\n").starts_with("11: "));
  CHECK(complaint<trimesh>(head + points + "Quadrilaterals\n1\n1 2 3 4 0\nEnd\n", file_format::medit) ==
        "11: a triangle (polygonmesh and load_any take any polygon) | an element of section Quadrilaterals");
  CHECK(complaint<hexmesh>(one_tet, file_format::medit) == "11: a hex (polyhedralmesh and load_any take any cell) | an element of section Tetrahedra");
  CHECK_THROWS_WITH_AS(medit<cell_arrays>(head + points + "Triangles 1\n1 2 3 0\nEnd"),
                       "t.mesh: holds a surface of 1 polygons, but a volume mesh was requested; load it as polygonmesh or with load_any", unsupported);
  // cells are not checked if a surface is loaded
  CHECK_THROWS_AS(medit<surface_arrays>(head + points + "Tetrahedra\n1\n1 2 3 9 0\nEnd\n"), unsupported);
}

TEST_CASE("read_medit: references become labels if one is not zero, up to the ends of their range") {
  const auto label = [](const std::string& number) {
    const auto m = load_text<trimesh>(head + points + "Triangles 1\n1 2 3 " + number + "\nEnd", file_format::medit);
    return find_poly_property<int>(m, "label")[poly_id{0}];
  };
  CHECK(label("-2147483648") == std::numeric_limits<int>::min());
  CHECK(label("2147483647") == std::numeric_limits<int>::max());
  CHECK(line<surface_arrays>(head + points + "Triangles\n1\n1 2 3 -2147483649\nEnd") == 11);
  CHECK(line<surface_arrays>(head + points + "Triangles\n1\n1 2 3 2147483648\nEnd") == 11);
  const auto m = load_text<polygonmesh>(head + points + "Triangles 2\n1 2 3 0\n1 2 4 0\nQuadrilaterals 3\n1 2 3 4 0\n4 3 2 1 5\n1 3 2 4 0\nEnd",
                                        file_format::medit);
  const auto labels = find_poly_property<int>(m, "label");
  const int expected[] = {0, 0, 0, 5, 0};
  for (unsigned p = 0; p < 5; ++p) CHECK(labels[poly_id{p}] == expected[p]);
}

TEST_CASE("read_medit: references written as reals are rounded") {
  const std::string vertices = "Vertices\n4\n0 0 0 0.0\n1 0 0 7.\n0 1 0 -3e0\n0 0 1 +2.000\n";
  load_report r;
  const auto m = load_text<trimesh>(head + vertices + "Triangles 2\n1 2 3 5.0#c\n1 2 4 0.\nEnd", file_format::medit, {.report = &r});
  const int expected[] = {0, 7, -3, 2};
  for (unsigned v = 0; v < 4; ++v) CHECK(find_vert_property<int>(m, "label")[vert_id{v}] == expected[v]);
  CHECK(find_poly_property<int>(m, "label")[poly_id{0}] == 5);
  CHECK(find_poly_property<int>(m, "label")[poly_id{1}] == 0);
  CHECK(r.notes.empty());

  const auto n = load_text<trimesh>(head + points + "Triangles 3\n1 2 3 1.4\n1 2 4 -1.6\n1 3 4 2.0\nEnd", file_format::medit, {.report = &r});
  const int rounded[] = {1, -2, 2};
  for (unsigned p = 0; p < 3; ++p) CHECK(find_poly_property<int>(n, "label")[poly_id{p}] == rounded[p]);
  CHECK(r.notes == std::vector<std::string>{"2 references are not integers and were rounded, the first on line 10"});

  const auto says = [](const std::string& number) {
    return complaint<surface_arrays>(head + points + "Triangles\n1\n1 2 3 " + number + "\nEnd", file_format::medit);
  };
  CHECK(says("2147483648.0") == "11: the reference of an element, an integer of 32 bits | '2147483648.0'");
  CHECK(says("-1e300") == "11: the reference of an element, an integer of 32 bits | '-1e300'");
  CHECK(says("nan").starts_with("11: the reference of an element, an integer"));
  CHECK(says("1e999").starts_with("11: the reference of an element, an integer"));
  CHECK(says("1.0x") == "11: the reference of an element, an integer | '1.0x'");
  CHECK(says("2147483647.0").empty());
}

TEST_CASE("read_medit: sections may be repeated, empty or unknown") {
  load_report r;
  CHECK(medit<cell_arrays>(head + points + "Tetrahedra 1\n1 2 3 4 0\nTetrahedra 2\n1 2 3 4 0\n1 2 3 4 0\nEnd").arity == 4);
  const auto three = medit<polyhedra_arrays>(cube + "Tetrahedra 1\n1 2 3 6 0\nHexahedra 1\n1 2 3 4 5 6 7 8 0\nPrisms 1\n1 2 3 5 6 7 0\nEnd");
  CHECK(three.poly_offsets == std::vector<std::uint32_t>{0, 4, 10, 15});
  CHECK(medit<surface_arrays>(head + points + "Tetrahedra 0\nTriangles 1\n1 2 3 0\nEnd", {.report = &r}).num_polys() == 1);
  CHECK(r.skipped.empty());
  medit<cell_arrays>(head + points + "Triangles 1\n1 2 3 0\nQuadrilaterals 0\nTetrahedra 1\n1 2 3 4 0\nEnd", {.report = &r});
  CHECK(r.skipped == std::vector<std::string>{"face property \"entity\""});
  const std::string long_word(50, 'W');
  medit<cell_arrays>(head + points + long_word + " 2\n1 2\n# Corners\n3 4\nOther -3\nTangents\nEnd\n", {.report = &r});
  CHECK(r.skipped == std::vector<std::string>{"section " + long_word.substr(0, 40) + ", 2 rows", "section Other", "section Tangents"});
  CHECK(r.notes.empty());
  medit<cell_arrays>(head + points + "Tangents 1\n1\n# the end", {.report = &r});
  CHECK(r.notes.size() == 1);
}

TEST_CASE("read_medit: a file without polys loads as any kind; a type of several kinds gets that of the file") {
  CHECK(medit<cell_arrays>(head + points + "End").arity == 4);
  CHECK(num_verts(medit<hexmesh>(head + points + "End")) == 4);
  CHECK(medit<surface_arrays>(head + points + "End").offsets == std::vector<std::uint32_t>{0});
  CHECK(medit<surface_arrays>(head + points + "Triangles 1\n1 2 3 0\nEnd").offsets.empty());
  struct either {
    int dimension;
    std::size_t polys;
    explicit either(surface_arrays&& s) : dimension(2), polys(s.num_polys()) {}
    explicit either(cell_arrays&& c) : dimension(3), polys(c.num_polys()) {}
  };
  const auto tets = load_text<either>(one_tet, file_format::medit), triangles = load_text<either>(head + points + "Triangles 1\n1 2 3 0\nEnd", file_format::medit);
  CHECK(tets.dimension == 3);
  CHECK(tets.polys == 1);
  CHECK(triangles.dimension == 2);
  struct volume {
    bool cells;
    explicit volume(cell_arrays&&) : cells(true) {}
    explicit volume(polyhedra_arrays&&) : cells(false) {}
  };
  const auto is_of_cells = [](const std::string& text) { return load_text<volume>(text, file_format::medit).cells; };
  CHECK(is_of_cells(one_tet));
  CHECK(is_of_cells(cube + "Hexahedra 1\n1 2 3 4 5 6 7 8 0\nEnd"));
  CHECK(!is_of_cells(cube + "Pyramids 1\n5 6 7 8 9 0\nEnd"));
  CHECK(!is_of_cells(cube + "Tetrahedra 1\n1 2 3 6 0\nHexahedra 1\n1 2 3 4 5 6 7 8 0\nEnd"));
  CHECK(triangles.polys == 1);
}

TEST_CASE("read_medit: elements of second and higher order are read by their corners, if the options say so") {
  const std::string nodes = head + "Vertices 11\n0 0 0 1  1 0 0 2  .5 0 0 3  0 1 0 4  0 0 1 5\n.5 .5 0 6  0 .5 0 7  0 0 .5 8  .5 0 .5 9  0 .5 .5 10  7 7 7 "
      "11\n";
  const std::string tet = "TetrahedraP2\n1\n1 2 4 5 3 6 7 8 9 10 42\n", triangle = "TrianglesP2 1 1 2 4 3 6 7 5\n", edge = "EdgesP2 1 1 2 3 9\n";
  const std::string instead = " second-order elements, with nodes on edges; load with {.corners_only = true} to read only the corners";
  const auto says = [](const std::string& text, bool corners_only = false) {
    try {
      load_text<polyhedra_arrays>(text, file_format::medit, {.corners_only = corners_only});
    } catch (const error& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  for (const std::string& text : {nodes + tet + "End", head + tet + nodes.substr(head.size()) + "End"}) {
    CHECK(says(text) == "text: section TetrahedraP2 has 1" + instead);
    load_report r;
    const auto m = load_text<tetmesh>(text, file_format::medit, {.report = &r, .corners_only = true});
    CHECK(num_verts(m) == 5);
    CHECK(raw(adj_p2v(m, poly_id{0})) == std::vector<unsigned>{0, 1, 2, 3});
    CHECK(find_vert_property<int>(m, "label")[vert_id{2}] == 4);
    CHECK(find_vert_property<int>(m, "label")[vert_id{4}] == 11);
    CHECK(find_poly_property<int>(m, "label")[poly_id{0}] == 42);
    CHECK(r.skipped == std::vector<std::string>{"6 points, the nodes of 1 elements of second or higher order: only corners were read"});
  }
  CHECK(says(nodes + triangle + "End") == "text: section TrianglesP2 has 1" + instead);
  CHECK(says(nodes + "HexahedraQ3 1 1 End") == "text: section HexahedraQ3 has 1 higher-order elements, with nodes on edges; load with {.corners_only = "
      "true} to read only the corners");
  // Edges alone are skipped, as before; with the option, all sections give labels to edges and faces.
  load_report r;
  const auto linear = load_text<tetmesh>(nodes + edge + "Tetrahedra 1 1 2 4 5 0 End", file_format::medit, {.report = &r});
  CHECK(num_verts(linear) == 11);
  CHECK(r.skipped == std::vector<std::string>{"section EdgesP2, 1 rows"});
  const auto all = load_text<tetmesh>(nodes + edge + triangle + tet + "Corners 1 3 RequiredTriangles 1 1 End", file_format::medit, {.report = &r,
      .corners_only = true});
  int sum = 0;
  for (const auto e : edges(all)) sum += find_edge_property<int>(all, "label")[e];
  for (const auto f : faces(all)) sum += 100 * find_face_property<int>(all, "label")[f] + 1000 * find_face_property<int>(all, "required")[f];
  CHECK(sum == 9 + 500 + 1000);
  CHECK(r.skipped == std::vector<std::string>{"6 points, the nodes of 3 elements of second or higher order: only corners were read"});
  const auto surface = load_text<trimesh>(nodes + triangle + "End", file_format::medit, {.corners_only = true});
  CHECK(num_polys(surface) == 1);
  CHECK(num_verts(surface) == 8);  // the others belong to no element
  CHECK(says(nodes + "TetrahedraP2Ordering 1 0 0 0 2 " + tet + "End", true) ==
        "text: has elements of second or higher order, and a section that lists the order of their nodes: corners need not come first");
  CHECK(bad_line<cell_arrays>(nodes + "TetrahedraP2 0 End", file_format::medit) == 0);
  CHECK(says(nodes + "TetrahedraP2 1\n1 2 4 5 3 6 7 8 9 99 0 End", true) == "text:7: expected a vertex index from 1 to 11, found '99'");
}

TEST_CASE("read_medit: throws if a volume is loaded as a surface or the reverse") {
  CHECK_THROWS_WITH_AS(medit<surface_arrays>(one_tet),
                       "t.mesh: holds a volume of 1 polyhedra, but a surface mesh was requested; load it as polyhedralmesh or with load_any",
                       unsupported);
  CHECK_THROWS_AS(medit<cell_arrays>(head + points + "Triangles 1\n1 2 3 0\nEnd"), unsupported);
  CHECK_THROWS_AS(medit<surface_arrays>("MeshVersionFormatted 1 Tetrahedra 1 1 2 3 4 0 Dimension 3 " + points + " End"), unsupported);
  CHECK(medit<cell_arrays>(head + points + "End").points.size() == 4);
  CHECK(medit<surface_arrays>(head + points + "End").points.size() == 4);
  CHECK(medit<polyhedra_arrays>(head + points + "End").points.size() == 4);
}
