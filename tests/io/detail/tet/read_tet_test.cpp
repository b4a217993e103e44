#include <concino/io/detail/tet/read_tet.hpp>
#include <concino/io/save.hpp>
#include <concino/io/tet.hpp>
#include <concino/mesh/hexmesh.hpp>
#include <concino/mesh/polyhedralmesh.hpp>
#include <concino/mesh/tetmesh.hpp>

#include <support/corpus.hpp>
#include <support/kinds.hpp>
#include <support/poly_volume.hpp>
#include <support/reading.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

namespace {

const std::string tet_points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
const std::string box_points = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n.5 .5 2\n2 0 0\n2 0 1\n";

template<class M = cell_arrays>
M from_tet(const std::string& text, const load_options& options = {}) {
  return load_alone<M>(text, file_format::tet, options, "t.tet");
}
template<class M = polyhedra_arrays>
std::string tet_complaint(const std::string& text) {
  return complaint<M>(text, file_format::tet);
}

}  // namespace

TEST_CASE("read_tet: reads vertices and tets, with their numbers on one line or two") {
  for (const std::string header : {"4 vertices\n1 tets\n", "4 vertices 1 tets\n", "4 vertices\n1 cells\n", "# made by hand\n4 vertices # four\n1 tets\n"})
    for (const std::string end : {"\n", "\r\n", "\r"}) {
      load_report r;
      const auto m = from_tet(with_line_ends(header + tet_points + "4 0 1 2 3\n", end), {.report = &r});
      CHECK(m.points == std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
      CHECK(raw(m.verts) == std::vector<unsigned>{0, 1, 2, 3});
      CHECK(m.arity == 4);
      CHECK(r.reoriented_polys == 0);
      CHECK(r.notes.empty());
      CHECK(r.skipped.empty());
    }
  CHECK(from_tet("0 vertices 0 tets").num_polys() == 0);
  CHECK(from_tet("4 vertices 0 tets " + tet_points).points.size() == 4);
}

TEST_CASE("read_tet: negative volumes are reoriented and counted") {
  load_report r;
  const auto m = from_tet("4 vertices\n2 tets\n" + tet_points + "4 0 3 2 1\n4 0 1 2 3\n", {.report = &r});
  for (std::size_t p = 0; p < 2; ++p) CHECK(six_times_volume(cell_shape::tet, m.verts.data() + 4 * p, m.points) == 1);
  CHECK(r.reoriented_polys == 1);
  CHECK(r.notes == std::vector<std::string>{"1 of 2 cells had a negative volume: their verts were put into the standard order"});
}

TEST_CASE("read_tet: reads hexes in geogram's order, prisms, pyramids and connectors") {
  const std::string cells = "8 0 1 2 3 4 5 6 7\n5 4 5 7 6 8\n6 1 9 3 5 10 7\n4 5 10 7 8\n";
  for (const std::string& text : {"11 vertices\n4 cells\n" + box_points + cells, "11 vertices\n5 cells\n" + box_points + "\n" + cells + "# C 4 5 7 6\n",
                                 "11 vertices\n4 cells\n" + box_points + "# C 4 5 7 6\n# no cell\n" + cells}) {
    load_report r;
    const auto m = from_tet<polyhedra_arrays>(text, {.report = &r});
    CHECK(m.num_polys() == 4);
    CHECK(r.reoriented_polys == 0);
    CHECK(r.notes.empty());
    CHECK(r.skipped == (text.find("# C") == text.npos ? std::vector<std::string>{} : std::vector<std::string>{"1 connectors between cells (# C)"}));
    CHECK(testing::six_times_poly_volume(m, 0) == 6);
    CHECK(testing::six_times_poly_volume(m, 1) == 2);
    CHECK(testing::six_times_poly_volume(m, 2) == 3);
    CHECK(testing::six_times_poly_volume(m, 3) > 0);
    CHECK(m.num_faces() == 6 + 4 + 4 + 2);
  }
}

TEST_CASE("read_tet: hexes in the standard order are recognised by their volume") {
  load_report r;
  const auto m = from_tet("11 vertices\n1 cells\n" + box_points + "8 0 1 3 2 4 5 7 6\n", {.report = &r});
  CHECK(raw(m.verts) == std::vector<unsigned>{0, 1, 3, 2, 4, 5, 7, 6});
  CHECK(r.notes == std::vector<std::string>{"the hexes list their verts around two opposite faces, not in geogram's order"});
  CHECK(raw(from_tet("11 vertices\n1 cells\n" + box_points + "8 0 1 2 3 4 5 6 7\n").verts) == std::vector<unsigned>{0, 1, 3, 2, 4, 5, 7, 6});
  // flat: both volumes are 0
  CHECK(raw(from_tet("8 vertices\n1 cells\n0 0 0 1 0 0 2 0 0 3 0 0 4 0 0 5 0 0 6 0 0 7 0 0\n8 0 1 2 3 4 5 6 7\n").verts) ==
        std::vector<unsigned>{0, 1, 3, 2, 4, 5, 7, 6});
}

TEST_CASE("read_tet: errors name the line") {
  const std::string two = "4 vertices\n2 tets\n" + tet_points + "4 0 1 2 3\n";
  CHECK(tet_complaint("") == "1: the number of vertices and the word 'vertices' | an empty file");
  CHECK(tet_complaint("OFF") == "1: the number of vertices | 'OFF'");
  CHECK(tet_complaint("4 verts\n") == "1: the word 'vertices' | 'verts'");
  CHECK(tet_complaint("4 vertices\n1 hexes\n") == "2: the word 'tets' or 'cells' | 'hexes'");
  CHECK(tet_complaint("4 vertices\n-1 tets\n") == "2: the number of cells | '-1'");
  CHECK(tet_complaint("2 vertices 1 tets\n0 0 0\n0 nan 0\n") == "3: the y of a vertex, a finite number | 'nan'");
  CHECK(tet_complaint("2 vertices 1 tets\n0 0 0\n0 0\n") == "3: the z of a vertex | the end of the file");
  CHECK(tet_complaint(two + "4 0 1 2 4\n") == "8: a vertex index from 0 to 3 | '4'");
  CHECK(tet_complaint(two + "7 0 1 2 3\n") == "8: the number of vertices of a cell: 4, 5, 6 or 8 | '7'");
  CHECK(tet_complaint(two + "4 0 1 2\n") == "8: a vertex index from 0 to 3 | the end of the file");
  CHECK(tet_complaint(two + "4 0 1 2 1\n") == "8: different verts in a cell (or set options.repeated_verts) | vert 1 twice");
  CHECK(tet_complaint(two + "\n# C 0 1 2 3\n# C 0 1 2 3\n") == "10: 2 cells | 1 cells and 2 connectors");
  CHECK(tet_complaint(two) == "7: 2 cells | 1 cells and 0 connectors");
  CHECK(tet_complaint(two + "4 0 1 2 3\n\n4 0 1 2 3\n") == "10: the end of the file after the last cell | '4'");
  CHECK(tet_complaint<hexmesh>(two + "4 0 1 2 3\n") == "7: a hex (polyhedralmesh and load_any take any cell) | a tet of 4 faces");
  CHECK(tet_complaint("1000000000000 vertices 3 cells\n0 0 0\n") == "2: the x of a vertex | the end of the file");
  CHECK_THROWS_AS(from_tet<surface_arrays>(two), unsupported);
}

TEST_CASE_TEMPLATE("read_tet: what save writes is read as the same mesh, and written as the same bytes", M, tetmesh, hexmesh) {
  const temporary_folder dir;
  for (const M& m : {grid<M>(1), grid<M>(3), M()}) {
    const std::string text = save_text(m, file_format::tet);
    load_report r;
    const M again = load_text<M>(text, file_format::tet, {.report = &r});
    CHECK(r.reoriented_polys == 0);
    CHECK(r.notes.empty());
    REQUIRE(num_polys(again) == num_polys(m));
    for (const auto p : polys(m)) CHECK(raw(adj_p2v(m, p)) == raw(adj_p2v(again, p)));
    for (const auto v : verts(m)) CHECK(point(m, v) == point(again, v));
    CHECK(save_text(again, file_format::tet) == text);
    CHECK(save_text(load_text<polyhedralmesh>(text, file_format::tet), file_format::tet).size() == text.size());
    save_tet(m, dir / "a");
    CHECK(read_file(dir / "a") == text);
    CHECK(num_polys(load_tet<polyhedralmesh>(dir / "a")) == num_polys(m));
  }
  CHECK(save_text(grid<M>(1), file_format::tet).starts_with(arity_v<M> == 4 ? "8 vertices\n6 tets\n" : "8 vertices\n1 cells\n"));
}

TEST_CASE("read_tet: mixed cells are written in order; general polyhedra are refused") {
  const std::string text = "11 vertices\n4 cells\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n0.5 0.5 2\n2 0 0\n2 0 1\n8 0 1 2 3 4 5 6 7\n5 4 5 7 6 8\n6 1 9 3 5 10 7\n4 5 10 7 8\n";
  const auto m = load_text<polyhedralmesh>(text, file_format::tet);
  save_report r;
  const std::string once = save_text(m, file_format::tet, {.report = &r});
  CHECK(r.notes.empty());
  CHECK(r.lost.empty());
  const auto again = load_text<polyhedralmesh>(once, file_format::tet);
  CHECK(num_faces(again) == num_faces(m));
  CHECK(save_text(again, file_format::tet) == once);
  CHECK_THROWS_WITH_AS(save_text(grid<polyhedralmesh>(1), file_format::tet),
                       "text: .tet cannot hold poly 0, a polyhedron of 10 faces that is not a tet, hex, prism or pyramid; save it as .hedra", unsupported);
}

TEST_CASE("read_tet: corpus meshes are the same after saving and loading") {
  for (const char* name : {"tet/quarter_crown.mesh", "hex/hole.mesh", "hex/hollow_sphere.mesh", "fields/kuhn_6.mesh"}) {
    const auto file = corpus(name);
    if (file.empty()) return skip("no corpus");
    CAPTURE(name);
    const auto m = load<cell_arrays>(file);
    const std::string text = m.arity == 4 ? save_text(tetmesh(cell_arrays(m)), file_format::tet) : save_text(hexmesh(cell_arrays(m)), file_format::tet);
    load_report r;
    const auto again = load_text<cell_arrays>(text, file_format::tet, {.report = &r});
    CHECK(again.points == m.points);
    CHECK(again.verts == m.verts);
    CHECK(r.reoriented_polys == 0);
    CHECK(r.notes.empty());
  }
}

TEST_CASE("read_tet: hexes that look like hexes in another order are the same after saving and loading") {
  const std::string cube = "MeshVersionFormatted 2 Dimension 3 Vertices 8 0 0 0 0 1 0 0 0 1 1 0 0 0 1 0 0 0 1 1 0 1 0 1 0 1 1 1 0 5 1 1 0 ";
  const auto m = load_text<cell_arrays>(cube + "Hexahedra 1 1 2 3 4 5 6 7 8 0 End", file_format::medit);
  const std::string once = save_text(hexmesh(cell_arrays(m)), file_format::tet);
  CHECK(once.find("# hexes in the order of voxels\n8 ") != std::string::npos);
  load_report r;
  CHECK(load_text<cell_arrays>(once, file_format::tet, {.report = &r}).verts == m.verts);
  CHECK(r.notes.empty());
  CHECK(r.skipped.empty());
}

TEST_CASE("read_tet: cells that share faces are written in the same order again") {
  const std::string points = "9 vertices\n3 cells\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n0.5 0.5 2\n";
  const auto m = load_text<polyhedralmesh>(points + "8 0 1 2 3 4 5 6 7\n5 7 6 4 5 8\n6 1 5 0 3 7 2\n", file_format::tet);
  for (const format_id f : {format_id(file_format::tet), format_id(file_format::medit)}) {
    const std::string once = save_text(m, f);
    CHECK(save_text(load_text<polyhedralmesh>(once, f), f) == once);
  }
}
