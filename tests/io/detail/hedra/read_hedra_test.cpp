#include <concino/io/detail/hedra/read_hedra.hpp>
#include <concino/mesh/hexmesh.hpp>
#include <concino/mesh/tetmesh.hpp>

#include <support/reading.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

namespace {

const std::string points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
const std::string face_rows = "3 1 3 2\n3 1 2 4\n3 2 3 4\n3 1 4 3\n";
const std::string tet = "4 4 1\n" + points + face_rows + "4 1 2 3 4\n";

template<class M = polyhedra_arrays>
M hedra(const std::string& text, const load_options& options = {}) {
  return load_alone<M>(text, file_format::hedra, options, "t.hedra");
}
template<class M = polyhedra_arrays>
std::size_t line(const std::string& text) {
  return bad_line<M>(text, file_format::hedra);
}

}  // namespace

TEST_CASE("read_hedra: reads verts, faces and the signed faces of polyhedra") {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    load_report r;
    const polyhedra_arrays m = hedra(with_line_ends(tet, end), {.report = &r});
    CHECK(m.points.size() == 4);
    CHECK(m.face_offsets == std::vector<std::uint32_t>{0, 3, 6, 9, 12});
    CHECK(raw(m.face_verts) == std::vector<unsigned>{0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2});
    CHECK(raw(m.poly_faces) == std::vector<unsigned>{0, 1, 2, 3});
    CHECK(m.outward == std::vector<std::uint8_t>{1, 1, 1, 1});
    CHECK(r.reoriented_polys == 0);
    CHECK(r.notes.empty());
  }
  CHECK(hedra("0 0 0").num_polys() == 0);
  CHECK(hedra("4 4 0\n" + points + face_rows).num_faces() == 4);
}

TEST_CASE("read_hedra: inconsistent and inverted polyhedra are oriented outward and counted") {
  for (const char* cell : {"4 -1 -2 -3 -4", "4 -1 2 3 4", "4 1 -2 3 -4", "4 -1 -2 -3 4"}) {
    load_report r;
    const auto m = hedra("4 4 1\n" + points + face_rows + cell, {.report = &r});
    CHECK(m.outward == std::vector<std::uint8_t>{1, 1, 1, 1});
    CHECK(r.reoriented_polys == 1);
    CHECK(r.notes == std::vector<std::string>{"1 of 1 polyhedra were wound inconsistently or inside out: their faces were turned outward"});
  }
}

TEST_CASE("read_hedra: errors name the line") {
  CHECK(line("") == 1);
  CHECK(line("OFF") == 1);
  CHECK(line("4 4") == 1);
  CHECK(line("4 -4 1") == 1);
  CHECK(line("2 0 0\n0 0 0\n0 inf 0\n") == 3);
  CHECK(line("2 0 0\n0 0 0\n0 0\n") == 3);
  CHECK(line("4 1 0\n" + points + "2 1 2\n") == 6);
  CHECK(line("4 1 0\n" + points + "3 1 2 2\n") == 6);
  CHECK(line("4 1 0\n" + points + "3 1 2 5\n") == 6);
  CHECK(line("4 1 0\n" + points + "3 0 2 3\n") == 6);
  CHECK(line("4 1 0\n" + points + "1000000000000 1 2 3\n") == 6);
  CHECK(line("4 4 1\n" + points + face_rows + "4 0 1 2 3\n") == 10);
  CHECK(line("4 4 1\n" + points + face_rows + "4 1 2 3 5\n") == 10);
  CHECK(line("4 4 1\n" + points + face_rows + "4 1 2 3 -5\n") == 10);
  CHECK(line("4 4 1\n" + points + face_rows + "4 1 2 3 -3\n") == 10);
  CHECK(line("4 4 1\n" + points + face_rows + "0\n") == 10);
  CHECK(line("4 4 1\n" + points + face_rows + "4 1 2 3\n") == 10);
  CHECK(line("4 4 1\n" + points + face_rows + "4 1 2 3 4\n\n7\n") == 12);
  CHECK(line("1000000000000 1 1\n0 0 0\n") == 2);
  CHECK(line("4 4 0\n\x01\n" + points + face_rows) == 2);  // no comments
  CHECK(complaint<polyhedra_arrays>("4 1 0\n" + points + "4 1 4 2 4\n", file_format::hedra) ==
        "6: different verts at the corners of a face (or set options.repeated_verts) | vert 4 twice");
}

TEST_CASE("read_hedra: a mesh of tets accepts only tets, with faces in any order") {
  load_report r;
  const auto c = hedra<cell_arrays>("4 4 2\n" + points + face_rows + "4 4 2 1 3\n4 1 2 3 4", {.report = &r});
  CHECK(c.arity == 4);
  CHECK(c.num_polys() == 2);
  for (std::size_t p = 0; p < 2; ++p) CHECK(six_times_volume(cell_shape::tet, c.verts.data() + 4 * p, c.points) == 1);
  CHECK(r.skipped == std::vector<std::string>{"the numbering of the faces"});
  CHECK(line<cell_arrays>("5 8 2\n" + points + "1 1 1\n" + face_rows + "4 2 3 4 5\n3 2 3 5\n3 3 4 5\n3 2 5 4\n4 1 2 3 4\n\n3 6 7 \n8\n") ==
        17);
}

TEST_CASE("read_hedra: a mesh of hexes accepts only hexes") {
  const std::string corners = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n";
  const std::string cube = "4 1 4 3 2\n4 5 6 7 8\n4 1 2 6 5\n4 2 3 7 6\n4 3 4 8 7\n4 4 1 5 8\n";
  const auto c = hedra<cell_arrays>("8 6 1\n" + corners + cube + "6 1 2 3 4 5 6\n");
  CHECK(c.arity == 8);
  CHECK(c.num_polys() == 1);
  CHECK(six_times_volume(cell_shape::hex, c.verts.data(), c.points) == doctest::Approx(6));
  CHECK(num_polys(hedra<hexmesh>("8 6 1\n" + corners + cube + "6 1 2 3 4 5 6\n")) == 1);
  CHECK(complaint<tetmesh>("8 6 1\n" + corners + cube + "6 1 2 3 4 5 6\n", file_format::hedra) ==
        "16: a tet (polyhedralmesh and load_any take any polyhedron) | a hex of 6 faces");
  CHECK(complaint<hexmesh>(tet, file_format::hedra) == "10: a hex (polyhedralmesh and load_any take any polyhedron) | a tet of 4 faces");
  const std::string wedge = "3 1 3 2\n3 5 6 7\n4 1 2 6 5\n4 2 3 7 6\n4 3 1 5 7\n";
  CHECK(complaint<cell_arrays>("8 5 1\n" + corners + wedge + "5 1 2 3 4 5\n", file_format::hedra) ==
        "15: a tet (polyhedralmesh and load_any take any polyhedron) | a prism of 5 faces");
  CHECK(complaint<hexmesh>("8 5 1\n" + corners + wedge + "5 1 2 3 4 5\n", file_format::hedra) ==
        "15: a hex (polyhedralmesh and load_any take any polyhedron) | a prism of 5 faces");
  CHECK(complaint<cell_arrays>("8 6 2\n" + corners + cube + "6 1 2 3 4 5 6\n4 1 2 3 4\n", file_format::hedra) ==
        "17: a hex (polyhedralmesh and load_any take any polyhedron) | a polyhedron of 4 faces");
  CHECK(hedra<cell_arrays>("4 4 0\n" + points + face_rows).arity == 4);
  CHECK(num_polys(hedra<hexmesh>("4 4 0\n" + points + face_rows)) == 0);
}

TEST_CASE("read_hedra: throws if a large face belongs to too many polyhedra") {
  const auto crowded = [](int n, int copies) {
    const auto text = [](int i) { return std::to_string(i); };
    std::string s = text(n) + " 1 " + text(copies) + "\n";
    for (int i = 0; i < n; ++i) s += "0 0 0\n";
    s += text(n);
    for (int i = 1; i <= n; ++i) s += " " + text(i);
    s += "\n";
    for (int i = 0; i < copies; ++i) s += "1 1\n";
    return s;
  };
  CHECK(hedra(crowded(1104, 980)).num_polys() == 980);
  CHECK_THROWS_WITH_AS(hedra(crowded(1104, 981)), doctest::Contains("t.hedra: large faces belong to so many polys"), unsupported);
  CHECK_THROWS_AS(hedra<cell_arrays>(crowded(1104, 981)), unsupported);
}

TEST_CASE("read_hedra: accepts many polyhedra with small faces") {
  const int n = 300;
  std::string all = std::to_string(4 * n) + " " + std::to_string(4 * n) + " " + std::to_string(n) + "\n", face_lists, poly_lists;
  for (int i = 0; i < n; ++i) {
    all += points;
    const auto row = [&](int a, int b, int c) {
      return "3 " + std::to_string(4 * i + a) + " " + std::to_string(4 * i + b) + " " + std::to_string(4 * i + c) + "\n";
    };
    face_lists += row(1, 3, 2) + row(1, 2, 4) + row(2, 3, 4) + row(1, 4, 3);
    poly_lists += "4";
    for (int f = 1; f <= 4; ++f) poly_lists += " " + std::to_string(4 * i + f);
    poly_lists += "\n";
  }
  CHECK(hedra(all + face_lists + poly_lists).num_polys() == 300);
}

TEST_CASE("read_hedra: throws if a volume is loaded as a surface") {
  CHECK_THROWS_AS(hedra<surface_arrays>(tet), unsupported);
  CHECK_THROWS_AS(hedra<surface_arrays>("0 0 0"), unsupported);
}
