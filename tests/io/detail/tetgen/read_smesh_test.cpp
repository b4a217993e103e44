// TetGen's surfaces, .smesh and .poly: what is read and written, and every error.
#include <concino/io/detail/tetgen/read_smesh.hpp>
#include <concino/io/detail/tetgen/write_smesh.hpp>
#include <concino/io/load_any.hpp>
#include <concino/io/save.hpp>
#include <concino/io/smesh.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/quadmesh.hpp>
#include <concino/mesh/tetmesh.hpp>
#include <concino/mesh/trimesh.hpp>

#include <support/reading.hpp>
#include <support/same_mesh.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

namespace {

using list = std::vector<std::string>;

const std::string points = "6 3 1 1\n1 0 0 0 .5 1\n2 1 0 0 0 2\n3 1 1 0 0 3\n4 0 1 0 0 4\n5 0 0 1 0 5\n6 2 2 2 7 6\n";
const std::string smesh = "# a tent\n" + points + "3 1\n4 1 2\n 3 4 -7 # the floor\n3 1 2 5 8\n3 4 1 5\n1\n1 .5 .5 .1\n1\n1 .2 .2 .2 5 0.1\n";
const std::string poly = points + "3 1\n1 0 -7\n4 1 2 3 4\n2 0 8\n3 1 2 5\n3 4 1 5\n2 0 9\n3 3 2 5\n2 3 5\n0\n";

surface_arrays read_smesh(const std::string& s, load_report* report = nullptr) { return load_alone<surface_arrays>(s, file_format::smesh, {.report = report}); }
std::string replaced(std::string s, const std::string& what, const std::string& by) { return s.replace(s.find(what), what.size(), by); }

}  // namespace

TEST_CASE("read_smesh: points, facets of one polygon, markers and attributes") {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    load_report r;
    const auto m = load_text<polygonmesh>(with_line_ends(smesh, end), file_format::smesh, {.report = &r});
    CHECK(m.points() == std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {2, 2, 2}});
    CHECK(raw(adj_p2v(m, poly_id{0})) == std::vector<unsigned>{0, 1, 2, 3});
    CHECK(raw(adj_p2v(m, poly_id{2})) == std::vector<unsigned>{3, 0, 4});
    const auto label = find_poly_property<int>(m, "label");
    CHECK(std::vector<int>{label[poly_id{0}], label[poly_id{1}], label[poly_id{2}]} == std::vector<int>{-7, 8, 0});
    CHECK(find_vert_property<int>(m, "label")[vert_id{4}] == 5);
    CHECK(find_vert_property<double>(m, "attribute_1")[vert_id{5}] == 7);
    CHECK(r.skipped == list{"1 points in holes", "1 points in regions"});
  }
  load_report r;
  const auto few = read_smesh("4\n0 0 0 0\n1 1 0 0\n2 0 1 0\n3 0 0 1\n3\n3 0 1 2\n2 0 3\n1 3\n", &r);
  CHECK(raw(few.verts) == std::vector<unsigned>{0, 1, 2});
  CHECK(r.skipped == list{"2 points and segments in facets"});
  CHECK(read_smesh("0 3 0 0\n0 0\n0\n").num_polys() == 0);
  CHECK(read_smesh("1 3\n0 0 0 0\n0\n").points.size() == 1);
  CHECK_THROWS_AS(load_text<trimesh>(smesh, file_format::smesh), parse_error);
  CHECK_THROWS_AS(load_text<quadmesh>(smesh, file_format::smesh), parse_error);
}

TEST_CASE("read_smesh: points in x.node") {
  const temporary_folder dir;
  write_file(dir / "x.node", points);
  write_file(dir / "x.smesh", "0 3 0 0\n1\n3 1 2 5\n0\n");
  write_file(dir / "x.poly", "0 3 0 0\n1\n1\n3 1 2 5\n0\n");
  for (const char* name : {"x.smesh", "x.poly"}) {
    const auto m = load<trimesh>(dir / name);
    CHECK(num_verts(m) == 6);
    CHECK(raw(adj_p2v(m, poly_id{0})) == std::vector<unsigned>{0, 1, 4});
    CHECK(find_vert_property<int>(m, "label")[vert_id{4}] == 5);
  }
  CHECK(std::holds_alternative<trimesh>(load_any(dir / "x.poly")));
  write_file(dir / "x.node", replaced(points, "5 0 0 1", "7 0 0 1"));
  CHECK_THROWS_AS(load<trimesh>(dir / "x.poly"), parse_error);
  std::filesystem::remove(dir / "x.node");
  CHECK_THROWS_WITH_AS(load<trimesh>(dir / "x.smesh"),
                       (dir / "x.smesh" + ": lists no points; those of its facets are expected in " + dir.path() + "/x.node, which does not exist").c_str(), io_error);
  CHECK_THROWS_AS(load_text<trimesh>(read_file(dir / "x.smesh"), file_format::smesh), unsupported);
}

TEST_CASE("read_poly: several polygons of a facet are several polys, and holes are unsupported") {
  load_report r;
  const auto m = load_text<polygonmesh>(poly, file_format::poly, {.report = &r});
  CHECK(num_polys(m) == 4);
  const auto label = find_poly_property<int>(m, "label");
  CHECK(std::vector<int>{label[poly_id{0}], label[poly_id{1}], label[poly_id{2}], label[poly_id{3}]} == std::vector<int>{-7, 8, 8, 9});
  CHECK(r.skipped == list{"1 points and segments in facets"});
  CHECK(r.notes == list{"1 facets have several polygons: each is a poly, even if one lies in another"});
  CHECK_THROWS_WITH_AS(load_text<polygonmesh>(replaced(poly, "2 0 8", "2 1 8"), file_format::poly, {}, "t"),
                       "t:11: facet 1 has holes, which no polygon holds; cut it into polygons without holes", unsupported);
}

TEST_CASE("read_smesh, read_poly: every error names its line") {
  const auto broken = [](const std::string& what, const std::string& by) { return complaint<surface_arrays>(replaced(smesh, what, by), file_format::smesh); };
  CHECK(complaint<surface_arrays>("", file_format::smesh) == "1: the number of points | an empty file");
  CHECK(complaint<surface_arrays>("1\n0 0 0 0\n", file_format::smesh) == "2: the number of facets | the end of the file");
  CHECK(broken("6 3 1 1", "7 3 1 1") == "9: the number of the point, 7 | '3'");
  CHECK(broken("3 1\n4", "4 1\n4") == "15: a marker, an integer | '.5'");
  CHECK(broken("3 1\n4", "3 2\n4") == "9: the number of markers, 0 or 1 | '2'");
  CHECK(broken("3 1\n4", "-3 1\n4") == "9: the number of facets | '-3'");
  CHECK(broken("4 1 2\n", "0 1 2\n") == "10: at least one corner of a polygon | '0'");
  CHECK(broken("4 1 2\n", "4000000000 1 2\n") == "11: the number of a point from 1 to 6 | '-7'");
  CHECK(broken("4 1 2\n", "4 1 7\n") == "10: the number of a point from 1 to 6 | '7'");
  CHECK(broken("4 1 2\n", "4 1 3\n").starts_with("10: different points at the corners of a polygon"));
  CHECK(broken("-7", "-7.5") == "11: a marker, an integer | '-7.5'");
  CHECK(broken(" 5 0.1\n", " 5 0.1\n2") == "18: the end of the file after the regions | '2'");
  CHECK(broken("1\n1 .5 .5 .1\n1\n1 .2 .2 .2 5 0.1\n", "2\n1 .5 .5 .1\n") == "15: a point in a hole or region | the end of the file");
  const auto damaged = [](const std::string& what, const std::string& by) { return complaint<surface_arrays>(replaced(poly, what, by), file_format::poly); };
  CHECK(damaged("1 0 -7", "0 0 -7") == "9: at least one polygon of a facet | '0'");
  CHECK(damaged("2 0 9", "3 0 9") == "17: at least one corner of a polygon | '0'");
  CHECK(damaged("1 0 -7", "1 x -7") == "9: the number of holes of a facet | 'x'");
  CHECK_THROWS_AS(load_text<trimesh>(replaced(smesh, "6 3", "6 2"), file_format::smesh), unsupported);
}

TEST_CASE_TEMPLATE("write_smesh: loading gives the same mesh, and the second save the same text", M, trimesh, polygonmesh) {
  M m = load_text<M>("6 3 2 1\n0 0 0 0 1 2 3\n1 1 0 0 1 2 4\n2 1 1 .1 1 2 5\n3 0 1 0 1e-300 2 6\n4 0 0 1 1 2 7\n5 9 9 9 0 0 0\n2 1\n3 0 1 2 -1\n3 0 2 3 4\n0\n0\n", file_format::smesh);
  save_report r;
  for (const format_id f : {format_id(file_format::smesh), format_id(file_format::poly)}) {
    const std::string text = save_text(m, f, {.report = &r, .strict = true});
    const M back = load_text<M>(text, f);
    CHECK((record_of(back) == record_of(m)));
    CHECK(save_text(back, f) == text);
    CHECK(num_polys(load_text<M>(save_text(M(), f), f)) == 0);
  }
  CHECK(save_text(m, file_format::poly).ends_with("2 1\n1 0 -1\n3 0 1 2\n1 0 4\n3 0 2 3\n0\n0\n"));
  const temporary_folder dir;
  save_poly(m, dir / "a");
  save_smesh(m, dir / "b");
  CHECK((record_of(load_poly<M>(dir / "a")) == record_of(load_smesh<M>(dir / "b"))));
  edge_property<int>(m, "label");
  save_text(m, file_format::smesh, {.report = &r});
  CHECK(r.lost == list{"edge property \"label\": .smesh cannot store it"});
  CHECK_THROWS_AS(save_text(tetmesh(), file_format::smesh), unsupported);
}
