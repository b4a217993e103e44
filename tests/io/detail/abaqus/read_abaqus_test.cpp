// Abaqus files: nodes, elements, sets and parts, and every error.
#include <concino/io/abaqus.hpp>
#include <concino/io/detail/abaqus/read_abaqus.hpp>
#include <concino/io/load_any.hpp>
#include <concino/io/save.hpp>
#include <concino/mesh/hexmesh.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/polyhedralmesh.hpp>
#include <concino/mesh/quadmesh.hpp>
#include <concino/mesh/tetmesh.hpp>
#include <concino/mesh/trimesh.hpp>

#include <support/reading.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

namespace {

using list = std::vector<std::string>;

const std::string nodes = "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 1, 1, 0\n4, 0, 1, 0\n5, 0, 0, 1\n6, 1, 0, 1\n7, 1, 1, 1\n8, 0, 1, 1\n9, .5, .5, 2\n10, 2, 0, 0\n11, 2, 0, 1\n";
const std::string two_tets = "*Heading\n a * title\n** a comment\n" + nodes + "* Element , type = c3d4h, elset=\"The Body\"\n30, 1, 2, 3, 6\n** another\n10, 1, 3, 4, 8\n";

template<class M>
M read(const std::string& text, load_report* report = nullptr, bool corners_only = false) {
  return load_text<M>(text, file_format::abaqus, {.report = report, .corners_only = corners_only}, "t.inp");
}
std::string replaced(std::string s, const std::string& what, const std::string& by) { return s.replace(s.find(what), what.size(), by); }
template<class M>
std::vector<int> values(const M& m, const std::string& name) {
  std::vector<int> all;
  const auto p = find_poly_property<int>(m, name);
  for (const auto x : polys(m)) all.push_back(p ? p[x] : -1);
  return all;
}
template<class M>
std::vector<unsigned> members(const M& m, const std::string& name) {
  std::vector<unsigned> all;
  const auto p = find_vert_property<int>(m, name);
  REQUIRE(p);
  for (const auto v : verts(m))
    if (p[v] == 1) all.push_back(v.raw());
  return all;
}
std::string refused(const std::string& text) {
  try {
    read<polyhedralmesh>(text);
  } catch (const unsupported& e) {
    return e.what();
  }
  return "";
}

}  // namespace

TEST_CASE("read_abaqus: keywords in any case and with blanks, comments, numbers in any order") {
  for (const std::string end : {"\n", "\r\n"}) {
    load_report r;
    const auto m = read<tetmesh>(with_line_ends(two_tets, end), &r);
    CHECK(num_verts(m) == 11);
    CHECK(m.points()[8] == vec3{.5, .5, 2});
    CHECK(raw(adj_p2v(m, poly_id{0})) == std::vector<unsigned>{0, 1, 2, 5});
    CHECK(raw(adj_p2v(m, poly_id{1})) == std::vector<unsigned>{0, 2, 3, 7});
    CHECK(values(m, "The Body") == std::vector<int>{1, 1});
    CHECK(r.skipped == list{"*HEADING, 1 time"});
    CHECK(r.reoriented_polys == 0);
  }
  const auto sparse = read<trimesh>("*ELEMENT,\nTYPE=S3,\n ELSET=a\n7,900000000, 1,\n50\n*NODE, NSET=all\n50,0,1D-1\n 900000000 , 1,,\n1,\n");
  CHECK(sparse.points() == std::vector<vec3>{{0, .1, 0}, {1, 0, 0}, {0, 0, 0}});
  CHECK(raw(adj_p2v(sparse, poly_id{0})) == std::vector<unsigned>{1, 2, 0});
  CHECK(members(sparse, "all") == std::vector<unsigned>{0, 1, 2});
  CHECK(values(sparse, "a") == std::vector<int>{1});
  CHECK(num_polys(read<tetmesh>(nodes)) == 0);
  CHECK(num_verts(read<quadmesh>(nodes)) == 11);
}

TEST_CASE("read_abaqus: all shapes, by the types of many elements") {
  const std::string cells = "*ELEMENT, TYPE=C3D8R\n1, 1,2,3,4,5,6,7,8\n*ELEMENT, TYPE=C3D5\n2, 5,6,7,8,9\n*ELEMENT, TYPE=C3D6\n3, 2,10,3,6,11,7\n*ELEMENT, TYPE=DC3D4\n4,10,11,6,9\n";
  load_report r;
  const auto m = read<polyhedralmesh>(nodes + cells, &r);
  CHECK(num_polys(m) == 4);
  std::vector<std::size_t> sizes;
  for (const auto p : polys(m)) sizes.push_back(num_elements(adj_p2f(m, p)));
  CHECK(sizes == std::vector<std::size_t>{6, 5, 5, 4});
  CHECK(r.reoriented_polys == 1);  // the tet
  CHECK(std::holds_alternative<hexmesh>(load_any(([&] {
    static const temporary_folder dir;
    write_file(dir / "x.inp", nodes + "*ELEMENT, TYPE=C3D8IH\n1, 1,2,3,4,5,6,7,8\n");
    return dir / "x.inp";
  })())));
  for (const char* type : {"S3", "S3RS", "STRI3", "STRI35", "CPS3", "CPE3T", "CAX3", "M3D3", "R3D3", "SFM3D3", "DS3", "DC2D3", "cpeg3h"})
    CHECK(num_polys(read<trimesh>(nodes + "*ELEMENT, TYPE=" + type + "\n1, 1,2,3\n2, 1,3,4\n")) == 2);
  for (const char* type : {"S4", "S4R5", "S4RSW", "CPS4R", "CPE4P", "CAX4", "M3D4R", "R3D4", "CPEG4"})
    CHECK(num_polys(read<quadmesh>(nodes + "*ELEMENT, TYPE=" + type + "\n1, 1,2,3,4\n")) == 1);
  for (const char* type : {"SC6R", "COH3D6", "AC3D6"}) CHECK(num_polys(read<polyhedralmesh>(nodes + "*ELEMENT, TYPE=" + type + "\n1, 1,2,3,5,6,7\n")) == 1);
  for (const char* type : {"SC8R", "COH3D8", "CSS8", "Q3D8"}) CHECK(num_polys(read<hexmesh>(nodes + "*ELEMENT, TYPE=" + type + "\n1, 1,2,3,4,5,6,7,8\n")) == 1);
}

TEST_CASE("read_abaqus: elements of second order by their corners, over several lines") {
  std::string text = nodes;
  for (int n = 12; n <= 31; ++n) text += std::to_string(n) + ", 5, 5, " + std::to_string(n) + "\n";
  const std::string ten = text + "*ELEMENT, TYPE=C3D10M\n1, 1,2,3,6, 12,13,14,15,16,17\n";
  CHECK(refused(ten) == "t.inp:33: elements of the type C3D10M have nodes on edges; load with {.corners_only = true} to read only the corners");
  load_report r;
  const auto tet = read<tetmesh>(ten, &r, true);
  CHECK(num_verts(tet) == 25);
  CHECK(r.skipped == list{"6 points, the nodes of 1 elements of second or higher order: only corners were read"});
  const auto hex = read<hexmesh>(text + "*ELEMENT, TYPE=C3D20R\n1, 1,2,3,4,5,6,7,8,\n12,13,14,15,16,17,18\n** a comment\n19,20,21,22,23\n*NSET,NSET=n\n9,31,12\n", &r, true);
  CHECK(raw(adj_p2v(hex, poly_id{0})) == std::vector<unsigned>{0, 1, 2, 3, 4, 5, 6, 7});
  CHECK(num_verts(hex) == 19);
  CHECK(members(hex, "n") == std::vector<unsigned>{8, 18});
  CHECK(num_polys(read<polyhedralmesh>(text + "*ELEMENT, TYPE=C3D15\n1, 1,2,3,5,6,7,\n12,13,14,15,16,17,18,19,20\n", &r, true)) == 1);
  for (const char* type : {"S8R", "S8R5", "CPS8"}) CHECK(num_polys(read<quadmesh>(text + "*ELEMENT, TYPE=" + type + "\n1, 1,2,3,4,12,13,14,15\n", &r, true)) == 1);
  for (const char* type : {"STRI65", "S6", "CPE6M"}) CHECK(num_polys(read<trimesh>(text + "*ELEMENT, TYPE=" + type + "\n1, 1,2,3,12,13,14\n", &r, true)) == 1);
  CHECK(num_polys(read<quadmesh>(text + "*ELEMENT, TYPE=S9R5\n1, 1,2,3,4,12,13,14,15,16\n", &r, true)) == 1);
  CHECK(refused(text + "*ELEMENT, TYPE=C3D27\n1,1\n") == "t.inp:33: elements of the type C3D27 are not read, as their number of nodes is not known");
  CHECK(refused(text + "*ELEMENT, TYPE=C3D15V\n1,1\n") != "");
}

TEST_CASE("read_abaqus: sets overlap, are generated, contain sets, and are added to") {
  load_report r;
  const auto m = read<tetmesh>(two_tets + "*Nset, nset=left\n1, 4, 5,\n 8\n*NSET, NSET=some, GENERATE\n1, 10, 3\n11, 11\n2, 3, 1\n*nset, NSET=LEFT\n2, 77\n"
                                          "*ELSET, ELSET=first\n30\n*ELSET, ELSET=all\nfirst, 10\n*ELSET, ELSET=range, GENERATE\n5, 20\n*NSET, NSET=label\n9\n*NSET, NSET=none\nnothing\n"
                                          "*NSET, NSET=by, ELSET=all\n*SURFACE, NAME=s\nfirst, S1\n*SURFACE, NAME=t\nfirst, S2\n",
                               &r);
  CHECK(members(m, "left") == std::vector<unsigned>{0, 1, 3, 4, 7});
  CHECK(members(m, "some") == std::vector<unsigned>{0, 1, 2, 3, 6, 9, 10});
  CHECK(members(m, "label") == std::vector<unsigned>{8});
  CHECK(members(m, "none").empty());
  CHECK(values(m, "first") == std::vector<int>{1, 0});
  CHECK(values(m, "all") == std::vector<int>{1, 1});
  CHECK(values(m, "range") == std::vector<int>{0, 1});
  CHECK(r.skipped == list{"*HEADING, 1 time", "*NSET with ELSET=, 1 time", "*SURFACE, 2 times", "2 members of sets of nodes, which the mesh does not have"});

  std::string many = "*NODE\n1\n2\n3\n*ELEMENT, TYPE=S3\n1,1,2,3\n";
  for (int i = 1; i < 3000; ++i) many += std::to_string(i + 3) + "\n*NSET,NSET=s" + std::to_string(i) + "\n1\n*NODE\n";
  many.replace(many.find("4\n*NSET"), 1, "*NODE\n4");
  read<trimesh>(many, &r);
  CHECK(r.skipped.back().ends_with(" sets of nodes, as so many would take too much memory"));
}

TEST_CASE("read_abaqus: what is no poly of the mesh is skipped with a word") {
  load_report r;
  const auto m = read<tetmesh>(two_tets + "*ELEMENT, TYPE=B31, ELSET=beams\n40, 1, 2\n41, 2, 3\n*ELEMENT, TYPE=S3\n50, 1, 2, 3\n*ELSET, ELSET=mixed\n10, 40, 50\n*MATERIAL, NAME=steel\n*ELASTIC\n"
                                          "210000., .3\n*NODE OUTPUT\nU\n*NODE\n12, 1, 2, 3, 0, 0, 1\n",
                               &r);
  CHECK(num_polys(m) == 2);
  CHECK(num_verts(m) == 12);
  CHECK(values(m, "mixed") == std::vector<int>{0, 1});
  CHECK(values(m, "beams") == std::vector<int>{0, 0});
  CHECK(r.skipped == list{"*ELASTIC, 1 time", "*HEADING, 1 time", "*MATERIAL, 1 time", "*NODEOUTPUT, 1 time", "the normals of 1 nodes", "2 lines of elements of the type B31",
                          "1 lines of elements of the type S3, which are surfaces, while others of the file are volumes", "2 members of sets of elements, which the mesh does not have"});
  CHECK(num_polys(read<trimesh>(nodes + "*ELEMENT, TYPE=T3D2\n1,1,2\n*ELEMENT, TYPE=S3\n2,1,2,3\n")) == 1);
}

TEST_CASE("read_abaqus: parts, and instances that do not move them") {
  const std::string part = "*Node\n1, 0,0,0\n2, 1,0,0\n3, 0,1,0\n*Element, type=S3\n1, 1,2,3\n*Nset, nset=Set-1\n2\n*End Part\n";
  const std::string parts = "*Part, name=Part-1\n" + part + "*Part, name=Part-2\n" + replaced(part, "0,0,0", "0,0,5");
  const std::string assembly = "*Assembly, name=A\n*Instance, name=I-1, part=Part-1\n*End Instance\n*Instance, name=I-2, part=PART-2\n0., 0, 0\n*End Instance\n"
                               "*Nset, nset=Both, instance=I-1\n1\n*Nset, nset=Both, instance=I-2\n3\n*Elset, elset=E\nI-2.1,\n*Nset, nset=N\nI-2.Set-1\n*End Assembly\n";
  for (const bool assembled : {false, true}) {
    load_report r;
    const auto m = read<trimesh>(parts + (assembled ? assembly : ""), &r);
    CHECK(num_verts(m) == 6);
    CHECK(raw(adj_p2v(m, poly_id{1})) == std::vector<unsigned>{3, 4, 5});
    CHECK(members(m, "Set-1") == std::vector<unsigned>{1});
    CHECK(members(m, "PART-2.Set-1") == std::vector<unsigned>{4});
    CHECK(r.notes.empty());
    CHECK(r.skipped.empty());
    if (!assembled) continue;
    CHECK(members(m, "Both") == std::vector<unsigned>{0, 5});
    CHECK(members(m, "N") == std::vector<unsigned>{4});
    CHECK(values(m, "E") == std::vector<int>{0, 1});
  }
  load_report r;
  read<trimesh>(parts + "*Assembly\n*Instance, name=I, part=Part-1\n*End Instance\n", &r);
  CHECK(r.notes == list{"the part PART-2 has no instance, and is read all the same"});
  // Abaqus/CAE writes the meshes of independent instances into them
  const auto m = read<trimesh>("*Part, name=P\n*End Part\n*Assembly, name=A\n*Instance, name=I, part=P\n" + replaced(part, "*End Part", "*End Instance") + "*Instance, name=J, part=P\n" +
                               replaced(part, "*End Part", "*End Instance"));
  CHECK(num_polys(m) == 2);
  CHECK(members(m, "J.Set-1") == std::vector<unsigned>{4});
  CHECK(refused(parts + replaced(assembly, "0., 0, 0", "0., 0, 1")) == "t.inp:24: *INSTANCE moves the instance I-2 of a part; write the model without it");
  CHECK(refused(parts + replaced(assembly, "part=PART-2", "part=part-1")) == "t.inp:24: *INSTANCE has another instance of the part PART-1, at the same place; write the model without it");
}

TEST_CASE("read_abaqus: keywords that would change the mesh are unsupported by name") {
  for (const char* keyword : {"INCLUDE, INPUT=a.inp", "NGEN", "NFILL", "NCOPY", "NMAP", "ELGEN", "ELCOPY", "SYSTEM"})
    CHECK(refused(two_tets + "*" + keyword + "\n").starts_with("t.inp:20: *" + std::string(keyword).substr(0, std::string(keyword).find(',')) + " is not read"));
  CHECK(refused("*NODE, SYSTEM=C\n1,1,0\n").starts_with("t.inp:1: *NODE has cylindrical or spherical coordinates"));
  CHECK(refused("*NODE, INPUT=nodes.txt\n") == "t.inp:1: *NODE has data in another file (INPUT=); write the model without it");
  CHECK(refused("*NODE, SYSTEM=R\n1\n") == "");
  CHECK_THROWS_AS(read<trimesh>(two_tets), unsupported);
  CHECK_THROWS_AS(read<tetmesh>(nodes + "*ELEMENT, TYPE=S3\n1,1,2,3\n"), unsupported);
  CHECK_THROWS_AS(save_text(trimesh(), file_format::abaqus), unsupported);
}

TEST_CASE("read_abaqus: every error names its line") {
  const auto says = [](const std::string& s) { return complaint<polyhedra_arrays>(s, file_format::abaqus); };
  const auto broken = [&](const std::string& what, const std::string& by) { return says(replaced(two_tets + "*NSET, NSET=a\n1, 2\n", what, by)); };
  CHECK(says("") == "1: a keyword line, which begins with * | an empty file");
  CHECK(says("1, 2\n") == "1: a keyword line, which begins with * | '1,'");
  CHECK(says("*HEADING\n") == "1: a keyword *NODE | the end of the file");
  CHECK(broken("2, 1, 0, 0", "x, 1, 0, 0") == "6: the number of a node | 'x,'");
  CHECK(broken("2, 1, 0, 0", "0, 1, 0, 0") == "6: the number of a node, from 1 | '0,'");
  CHECK(broken("2, 1, 0, 0", "2, 1, 0 0, 0") == "6: the y of a node | '0'");
  CHECK(broken("2, 1, 0, 0", "2, 1, inf, 0") == "6: the y of a node, a finite number | 'inf,'");
  CHECK(broken("2, 1, 0, 0", "1, 1, 0, 0") == "6: a node number that is not used yet | 1");
  CHECK(broken("type = c3d4h, ", "") == "16: the parameter TYPE= of *ELEMENT | a line without it");
  CHECK(broken("10, 1, 3, 4, 8", "10, 1, 3, 4") == "20: node 4 of an element of the type C3D4H | '*NSET,'");
  CHECK(broken("10, 1, 3, 4, 8", "10, 1, 3, 4, 8, 9") == "19: the end of the line after 4 nodes | '9'");
  CHECK(broken("10, 1, 3, 4, 8", "10, 1, 3, 4, 12") == "19: the number of a node of this part | '12'");
  CHECK(broken("10, 1, 3, 4, 8", "10, 1, 3, 4, 4").starts_with("19: different verts in a cell"));
  CHECK(broken("10, 1, 3, 4, 8", "30, 1, 3, 4, 8") == "19: an element number that is not used yet | 30");
  CHECK(broken("10, 1, 3, 4, 8", "-10, 1, 3, 4, 8") == "19: the number of an element, from 1 | '-10,'");
  CHECK(broken("NSET=a", "x=a") == "20: the parameter NSET= of *NSET | a line without it");
  CHECK(broken("NSET=a", "NSET=a, INSTANCE=i") == "20: the name of an instance | i");
  CHECK(broken("NSET=a\n1, 2", "NSET=a, GENERATE\n1, 2, 0") == "21: the step between numbers of a set, from 1 | '0'");
  CHECK(broken("NSET=a\n1, 2", "NSET=a, GENERATE\n1, b") == "21: the last number of a set | 'b'");
  CHECK(says("*PART, NAME=a\n*PART, NAME=A\n") == "2: another name of a part | A twice");
  CHECK(says("*INSTANCE, NAME=a, PART=b\n") == "1: the name of a part | b");
  CHECK_THROWS_AS(load_text<hexmesh>(two_tets, file_format::abaqus), parse_error);
  CHECK_THROWS_AS(load_text<trimesh>(nodes + "*ELEMENT, TYPE=S4\n1,1,2,3,4\n", file_format::abaqus), parse_error);
  CHECK(complaint<surface_arrays>(nodes + "*ELEMENT, TYPE=S4\n1,1,2,3,3\n", file_format::abaqus).starts_with("14: different nodes at the corners of an element"));
  CHECK(num_polys(load_text<trimesh>(nodes + "*ELEMENT, TYPE=S4\n1,1,2,3,3\n", file_format::abaqus, {.repeated_verts = repeated_verts::collapse})) == 1);
}
