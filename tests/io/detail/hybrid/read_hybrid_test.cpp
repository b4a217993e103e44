#include <concino/io/detail/hybrid/read_hybrid.hpp>
#include <concino/io/hybrid.hpp>
#include <concino/io/save.hpp>
#include <concino/mesh/hexmesh.hpp>
#include <concino/mesh/polyhedralmesh.hpp>
#include <concino/mesh/tetmesh.hpp>

#include <support/corpus.hpp>
#include <support/kinds.hpp>
#include <support/reading.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

namespace {

const std::string hybrid_points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
const std::string hybrid_faces = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
const std::string hybrid_tet = "4 4 3\n" + hybrid_points + hybrid_faces + "4 0 1 2 3\n4 1 1 1 1\n0\n";
const std::string hybrid_hex =
    "8 6 3\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
    "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 3 2 6 7\n4 3 0 4 7\n6 0 1 2 3 4 5\n6 1 1 1 1 0 1\n";

template<class M = polyhedra_arrays>
M hybrid(const std::string& text, const load_options& options = {}) {
  return load_alone<M>(text, file_format::hybrid, options, "t.hybrid");
}
template<class M = polyhedra_arrays>
std::size_t hybrid_line(const std::string& text) {
  return bad_line<M>(text, file_format::hybrid);
}

}  // namespace

TEST_CASE("read_hybrid: reads verts, faces, and the faces and flags of polyhedra") {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    load_report r;
    const polyhedra_arrays m = hybrid(with_line_ends(hybrid_tet, end), {.report = &r});
    CHECK(m.points.size() == 4);
    CHECK(m.face_offsets == std::vector<std::uint32_t>{0, 3, 6, 9, 12});
    CHECK(raw(m.face_verts) == std::vector<unsigned>{0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2});
    CHECK(raw(m.poly_faces) == std::vector<unsigned>{0, 1, 2, 3});
    CHECK(m.poly_offsets == std::vector<std::uint32_t>{0, 4});
    CHECK(m.outward == std::vector<std::uint8_t>{1, 1, 1, 1});
    CHECK(r.reoriented_polys == 0);
    CHECK(r.notes.empty());
    CHECK(r.skipped.empty());
  }
  CHECK(hybrid("0 0 0").num_polys() == 0);
  CHECK(hybrid("4 4 0\n" + hybrid_points + hybrid_faces).num_faces() == 4);
  CHECK(hybrid(hybrid_hex + "1\n").outward == std::vector<std::uint8_t>{1, 1, 1, 1, 0, 1});
}

TEST_CASE("read_hybrid: inconsistent and inverted polyhedra are oriented outward and counted") {
  for (const char* flags : {"4 0 0 0 0", "4 0 1 1 1", "4 1 0 1 0", "4 0 0 0 1"}) {
    load_report r;
    const auto m = hybrid("4 4 3\n" + hybrid_points + hybrid_faces + "4 0 1 2 3\n" + flags + "\n0", {.report = &r});
    CHECK(m.outward == std::vector<std::uint8_t>{1, 1, 1, 1});
    CHECK(r.reoriented_polys == 1);
    CHECK(r.notes == std::vector<std::string>{"1 of 1 polyhedra were wound inconsistently or inside out: their faces were turned outward"});
  }
}

TEST_CASE("read_hybrid: reports marks of hexes that differ from the faces") {
  const std::string wrong = "the marks of 1 polyhedra that are hexes without a mark, or marked without being hexes";
  for (const bool right : {true, false}) {
    load_report r;
    hybrid(hybrid_hex + (right ? "1" : "0"), {.report = &r});
    CHECK(r.skipped == (right ? std::vector<std::string>{} : std::vector{wrong}));
    hybrid(hybrid_tet.substr(0, hybrid_tet.size() - 2) + (right ? "0\n" : "1\n"), {.report = &r});
    CHECK(r.skipped == (right ? std::vector<std::string>{} : std::vector{wrong}));
    CHECK(r.notes.empty());
  }
  load_report r;
  CHECK(hybrid(hybrid_hex, {.report = &r}).num_polys() == 1);
  CHECK(r.skipped.empty());
  CHECK(r.notes == std::vector<std::string>{"the file does not mark its hexes: it may be cut off"});
}

TEST_CASE("read_hybrid: errors name the line") {
  const std::string begin = "4 4 3\n" + hybrid_points + hybrid_faces;
  CHECK(hybrid_line("") == 1);
  CHECK(hybrid_line("OFF") == 1);
  CHECK(hybrid_line("4 4") == 1);
  CHECK(hybrid_line("4 4 -3") == 1);
  CHECK(hybrid_line("2 0 0\n0 0 0\n0 inf 0\n") == 3);
  CHECK(hybrid_line("4 1 0\n" + hybrid_points + "2 0 1\n") == 6);
  CHECK(hybrid_line("4 1 0\n" + hybrid_points + "3 0 1 4\n") == 6);
  CHECK(hybrid_line("4 1 0\n" + hybrid_points + "3 0 -1 2\n") == 6);
  CHECK(hybrid_line("4 1 0\n" + hybrid_points + "1000000000000 0 1 2\n") == 6);
  CHECK(hybrid_line(begin + "0\n") == 10);
  CHECK(hybrid_line(begin + "4 0 1 2 4\n") == 10);
  CHECK(hybrid_line(begin + "4 0 1 2 2\n") == 10);
  CHECK(hybrid_line(begin + "4 0 1 2 3\n3 1 1 1\n") == 11);
  CHECK(hybrid_line(begin + "4 0 1 2 3\n4 1 1 2 1\n") == 11);
  CHECK(hybrid_line(begin + "4 0 1 2 3\n4 1 1 1\n") == 11);
  CHECK(hybrid_line(begin + "4 0 1 2 3\n4 1 1 1 1\n2\n") == 12);
  CHECK(hybrid_line(hybrid_tet + "\n0\n") == 14);
  CHECK(hybrid_line("1000000000002 1 1\n0 0 0\n") == 1);
  CHECK(hybrid_line("1000000000002 1 3\n0 0 0\n") == 2);
  CHECK(complaint<polyhedra_arrays>("4 4 4\n", file_format::hybrid) == "1: three times the number of polyhedra | '4'");
  CHECK(complaint<polyhedra_arrays>("4 1 0\n" + hybrid_points + "3 1 3 1\n", file_format::hybrid) ==
        "6: different verts at the corners of a face (or set options.repeated_verts) | vert 1 twice");
  CHECK(complaint<polyhedra_arrays>("0 1 0\n3 1 3 1\n", file_format::hybrid) == "2: a vert index, but there is nothing to refer to | '1'");
  CHECK(complaint<polyhedra_arrays>(begin + "4 0 1 2 3\n3 1 1 1\n", file_format::hybrid) ==
        "11: one flag for each face of a polyhedron, 4 in number | 3");
}

TEST_CASE("read_hybrid: tets and hexes are read from their faces, other kinds are refused") {
  CHECK(num_polys(hybrid<tetmesh>(hybrid_tet)) == 1);
  CHECK(num_polys(hybrid<hexmesh>(hybrid_hex + "1")) == 1);
  CHECK(complaint<hexmesh>(hybrid_tet, file_format::hybrid) == "10: a hex (polyhedralmesh and load_any take any polyhedron) | a tet of 4 faces");
  const std::string two = "4 4 6\n" + hybrid_points + hybrid_faces + "4 0 1 2 3\n4 1 1 1 1\n\n3 0 1 2\n3 1 1 1\n0 0\n";
  CHECK(complaint<tetmesh>(two, file_format::hybrid) == "13: a tet (polyhedralmesh and load_any take any polyhedron) | a polyhedron of 3 faces");
  CHECK_THROWS_AS(hybrid<surface_arrays>(hybrid_tet), unsupported);
}

TEST_CASE_TEMPLATE("read_hybrid: what save writes is read as the same mesh, and written as the same bytes", M, tetmesh, hexmesh, polyhedralmesh) {
  const temporary_folder dir;
  for (const M& m : {grid<M>(1), grid<M>(3), M()}) {
    const std::string text = save_text(m, file_format::hybrid);
    load_report r;
    const auto again = load_text<polyhedralmesh>(text, file_format::hybrid, {.report = &r});
    CHECK(r.reoriented_polys == 0);
    CHECK(r.notes.empty());
    CHECK(r.skipped.empty());
    CHECK(num_faces(again) == num_faces(m));
    CHECK(num_polys(again) == num_polys(m));
    CHECK(save_text(again, file_format::hybrid) == text);
    save_hybrid(m, dir / "a");
    CHECK(read_file(dir / "a") == text);
    CHECK(num_polys(load_hybrid<M>(dir / "a")) == num_polys(m));
  }
  CHECK(save_text(grid<hexmesh>(2), file_format::hybrid).ends_with("\n1\n1\n1\n1\n1\n1\n1\n1\n"));
  CHECK(save_text(grid<tetmesh>(1), file_format::hybrid).ends_with("\n0\n0\n0\n0\n0\n0\n"));
}

TEST_CASE("read_hybrid: a corpus file is the same mesh as in .hedra, and written as the same bytes again") {
  CONCINO_CORPUS_OR_SKIP(file, "polyhedral/voronoi_cube_250.hybrid");
  CONCINO_CORPUS_OR_SKIP(same, "polyhedral/voronoi_cube_250.hedra");
  load_report r;
  const auto m = load<polyhedralmesh>(file, {.report = &r});
  CHECK(r.reoriented_polys == 0);
  CHECK(r.notes == std::vector<std::string>{"the file does not mark its hexes: it may be cut off"});
  CHECK(r.skipped.empty());
  CHECK(save_text(m, file_format::hedra) == save_text(load<polyhedralmesh>(same), file_format::hedra));
  const std::string text = save_text(m, file_format::hybrid);
  CHECK(save_text(load_text<polyhedralmesh>(text, file_format::hybrid), file_format::hybrid) == text);
}
