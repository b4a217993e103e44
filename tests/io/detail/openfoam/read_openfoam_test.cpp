// What the reader of polyMesh folders accepts and refuses: layouts of text, binary numbers of all sizes and orders, and errors that name file and line.
#include <concino/io/detail/openfoam/read_openfoam.hpp>

#include <concino/io/load_any.hpp>
#include <concino/io/openfoam.hpp>
#include <concino/io/save.hpp>
#include <concino/mesh.hpp>

#include <support/foam_text.hpp>
#include <support/memory_limit.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <random>

using namespace concino;
using namespace concino::testing;

namespace {

std::string header(const std::string& kind, const std::string& more = "format ascii;") {
  return "FoamFile { version 2.0; class " + kind + "; " + more + " }\n";
}

/// Two tets with a face in common, two patches, one of them empty, and a zone.
const foam_files two_tets = {
    {"points", "/*--- a\n comment ---*/ " + header("vectorField") + "5\n(\n(0 0 0) (1 0 0)(0 1 0)( 0 0\n1 ) // c\n(1 1 1e0)\n)\n// ***\n"},
    {"faces", header("faceList") + "7\n(3(1 2 3) 3(0 2 1) 3(0 1 3)\n3(1 4 3)\n3(0 3 2)3(1 2 4)\n3(2 3 4)\n)\n"},
    {"owner", header("labelList", "note \"a ; b } /* c\"; format ascii; location \"constant/polyMesh\";") + "7(0 0 0 1 0 1 1)"},
    {"neighbour", header("labelList") + "1{1}\n"},
    {"boundary", header("polyBoundaryMesh") + "3(wall{type wall; inGroups 1(wall); nFaces 2; startFace 1;}\n none { type patch; startFace 3; nFaces 0; }\n"
                 "out { type\tpatch; // c\n extra { a  1 ;\n b \"x  /y\"; } nFaces 4; startFace 3; })"},
    {"cellZones", header("regIOobject") + "1(metal{type cellZone; cellLabels List<label> 1(1);})"}};

foam_files with(const std::string& name, const std::string& text, foam_files files = two_tets) {
  for (auto& f : files)
    if (f.first == name) f.second = text;
  return files;
}
foam_files replaced(const std::string& name, const std::string& from, const std::string& to, foam_files files = two_tets) {
  for (auto& f : files)
    if (f.first == name) {
      REQUIRE(f.second.find(from) != std::string::npos);
      f.second.replace(f.second.find(from), from.size(), to);
    }
  return files;
}

template<class M = polyhedralmesh>
M read(const foam_files& files, const load_options& options = {}) {
  return load_text<M>(joined_foam_files(files), foam_text_format{}, options, "case");
}
std::string message_of(const foam_files& files, const load_options& options = {}) {
  try {
    read(files, options);
  } catch (const error& e) {
    return e.what();
  }
  return "no error";
}

template<class T>
std::string bytes(T x, bool swapped) {
  std::string s(sizeof x, ' ');
  std::memcpy(s.data(), &x, sizeof x);
  if (swapped) std::reverse(s.begin(), s.end());
  return s;
}

/// The two tets in binary, with numbers of any size and order.
template<class Label, class Scalar>
foam_files binary_tets(bool swapped, bool compact = true) {
  const bool msb = swapped == (std::endian::native == std::endian::little);
  const std::string how = "format binary; arch \"" + std::string(msb ? "MSB" : "LSB") + ";label=" + std::to_string(8 * sizeof(Label)) + ";scalar=" + std::to_string(8 * sizeof(Scalar)) + "\";";
  const auto labels = [&](const std::vector<int>& all) {
    std::string s = std::to_string(all.size()) + "\n";
    if (!all.empty()) s += "(";
    for (const int i : all) s += bytes(static_cast<Label>(i), swapped);
    return s + (all.empty() ? "" : ")");
  };
  std::string points;
  for (const double x : {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1}) points += bytes(static_cast<Scalar>(x), swapped);
  const std::vector<int> corners = {1, 2, 3, 0, 2, 1, 0, 1, 3, 1, 4, 3, 0, 3, 2, 1, 2, 4, 2, 3, 4};
  std::string listed = "7\n(";
  for (std::size_t f = 0; f < 21; f += 3) listed += "\n" + labels({corners[f], corners[f + 1], corners[f + 2]});
  foam_files files = two_tets;
  files[0].second = header("vectorField", how) + "5\n(" + points + ")\n";
  files[1].second = compact ? header("faceCompactList", how) + labels({0, 3, 6, 9, 12, 15, 18, 21}) + "\n" + labels(corners) : header("faceList", how) + listed + "\n)\n";
  files[2].second = header("labelList", how) + labels({0, 0, 0, 1, 0, 1, 1});
  files[3].second = header("labelList", how) + labels({1});
  files[5].second = header("regIOobject", how) + "1\n(\nmetal\n{ type cellZone;\ncellLabels List<label> \n" + labels({1}) + ";\n}\n)\n";
  return files;
}

}  // namespace

TEST_CASE("openfoam: points, faces, cells, patches and zones in any layout") {
  load_report r;
  const auto m = read(two_tets, {.report = &r});
  CHECK(num_verts(m) == 5);
  CHECK(num_faces(m) == 7);
  CHECK(num_polys(m) == 2);
  CHECK(point(m, vert_id{4}) == vec3{1, 1, 1});
  CHECK(r.reoriented_polys == 0);
  CHECK(r.skipped.empty());
  CHECK(r.notes.empty());
  const auto label = find_face_property<int>(m, "label");
  std::vector<int> labels;
  for (const face_id f : faces(m)) labels.push_back(label[f]);
  CHECK(labels == std::vector<int>{0, 1, 1, 3, 3, 3, 3});
  CHECK(find_poly_property<int>(m, "label")[poly_id{0}] == 0);
  CHECK(find_poly_property<int>(m, "label")[poly_id{1}] == 1);
  const label_names expected{{{element_kind::face, 1, "wall", {"type wall;", "inGroups 1(wall);"}},
                              {element_kind::face, 2, "none", {"type patch;"}},
                              {element_kind::face, 3, "out", {"type patch;", "extra { a 1; b \"x  /y\"; }"}},
                              {element_kind::poly, 1, "metal", {"type cellZone;"}}}};
  CHECK(*find_mesh_property<label_names>(m, "label_names") == expected);
  // a neighbour list padded with -1, as before version 1.5
  const auto padded = read(replaced("neighbour", "1{1}", "7(1 -1 -1 -1 -1 -1 -1)"));
  CHECK(save_text(padded, foam_text_format{}) == save_text(m, foam_text_format{}));
}

TEST_CASE("openfoam: binary numbers of 32 and 64 bits in both orders read as the text does") {
  const std::string expected = save_text(read(two_tets), foam_text_format{});
  for (const bool swapped : {false, true})
    for (const bool compact : {false, true}) {
      CHECK(save_text(read(binary_tets<std::int32_t, double>(swapped, compact)), foam_text_format{}) == expected);
      CHECK(save_text(read(binary_tets<std::int64_t, double>(swapped, compact)), foam_text_format{}) == expected);
      CHECK(save_text(read(binary_tets<std::int32_t, float>(swapped, compact)), foam_text_format{}) == expected);
      CHECK(save_text(read(binary_tets<std::int64_t, float>(swapped, compact)), foam_text_format{}) == expected);
    }
  const auto m = read(two_tets);
  CHECK(save_text(load_text<polyhedralmesh>(save_text(m, foam_text_format{}, {.binary = true}), foam_text_format{}), foam_text_format{}) == expected);
}

TEST_CASE("openfoam: tets and hexes alone are read as such, with the labels of their faces") {
  const auto tets = read<tetmesh>(two_tets);
  CHECK(num_polys(tets) == 2);
  const auto label = find_face_property<int>(tets, "label");
  std::vector<int> labels;
  for (const face_id f : faces(tets)) labels.push_back(label[f]);
  std::sort(labels.begin(), labels.end());
  CHECK(labels == std::vector<int>{0, 1, 1, 3, 3, 3, 3});
  CHECK(find_poly_property<int>(tets, "label")[poly_id{1}] == 1);
  CHECK_THROWS_WITH_AS(read<hexmesh>(two_tets), "case/owner:1: expected a hex (polyhedralmesh and load_any take any polyhedron), found cell 0, a tet of 4 faces", parse_error);
  CHECK_THROWS_WITH_AS(read<trimesh>(two_tets), doctest::Contains("holds a volume"), unsupported);
  // two faces with the same points, of different cells: only polyhedra keep them apart
  const std::string split = header("labelList") + "8(0 0 0 1 0 1 1 1)";
  const foam_files apart = with("boundary", header("x") + "1(all { nFaces 8; startFace 0; })",
                                with("neighbour", header("labelList") + "0()", with("owner", split, replaced("faces", "7\n(", "8\n(", replaced("faces", "3(2 3 4)", "3(2 3 4) 3(3 2 1)")))));
  const auto separate = read(apart);
  CHECK(num_faces(separate) == 8);
  CHECK(find_face_property<int>(separate, "label")[face_id{7}] == 1);
  load_report r;
  CHECK(num_faces(read<tetmesh>(apart, {.report = &r})) == 7);
  CHECK(std::find(r.skipped.begin(), r.skipped.end(), "1 faces with the points of another face, which become one") != r.skipped.end());
}

TEST_CASE("openfoam: errors name the file and the line, and what is wrong there") {
  struct sample {
    const char *file, *from, *to, *message;
  };
  const sample samples[] = {
      {"points", "FoamFile", "5", "case/points:2: expected the header FoamFile { ... }, found '5'"},
      {"points", "5\n(", "6\n(", "case/points:8: expected the '(' of a point, found ')'"},
      {"points", "5\n(", "4\n(", "case/points:7: expected the ')' after the last point, found '(1'"},
      {"points", "1e0", "nan", "case/points:7: expected a coordinate, a finite number, found 'nan)'"},
      {"points", "1e0", "x", "case/points:7: expected a coordinate, found 'x)'"},
      {"points", "// ***", "3", "case/points:9: expected the end of the file after the list, found '3'"},
      {"points", "5\n(", "4294967295\n(", "case/points:3: expected a number of entries, at most 4294967294, found 4294967295"},
      {"points", "5\n(", "400000000\n(", "case/points:3: expected a number of entries that fits into the file, found 400000000 entries, and 58 bytes"},
      {"points", "5\n(", "-5\n(", "case/points:3: expected the number of points, found '-5'"},
      {"points", "ascii", "utf8", "case/points:2: expected the format ascii or binary, found 'utf8'"},
      {"points", "format", "arch \"LSB;label=16\"; format", "case/points:2: expected label=32 or label=64, found 'arch'"},
      {"points", "/ ", "", "case/points:1: expected a comment that ends in */, found the end of the file"},
      {"faces", "faceList", "labelList", "case/faces:1: expected the class faceList or faceCompactList, found 'labelList'"},
      {"faces", "3(1 2 3)", "3(1 2 5)", "case/faces:3: expected the number of a point, below 5, found 5"},
      {"faces", "3(1 2 3)", "3(1 2 -1)", "case/faces:3: expected the number of a point, below 5, found -1"},
      {"faces", "3(1 2 3)", "2(1 2)", "case/faces:3: expected a face of at least three points, found one of 2"},
      {"faces", "3(1 2 3)", "3{1}", "case/faces:3: expected different points at the corners of a face (or set options.repeated_verts), found point 1 twice"},
      {"faces", "3(1 2 3)", "4(1 2 3)", "case/faces:3: expected the number of points of a face, found ')'"},
      {"owner", "7(0", "6(0", "case/owner:2: expected the ')' after the last entry of a list, found '1)'"},
      {"owner", "7(0 0", "6(0", "case/owner:2: expected the owner of each of the 7 faces, found 6 owners"},
      {"owner", "7(0", "8(0 0", "case/owner:2: expected a number of entries, at most 7, found 8"},
      {"owner", "7(0", "7(-1", "case/owner:2: expected the number of a cell, found -1"},
      {"owner", "7(0 0 0", "7(0 0 14", "case/owner:2: expected the number of a cell that has a face, from 0 to 13, found 14"},
      {"owner", "7(0 0 0", "7(0 0 13", "case/neighbour:2: expected an owner or neighbour that is cell 2, as there is a cell 13, found none"},
      {"neighbour", "1{1}", "1(0)", "case/neighbour:2: expected a cell that is not the owner of the face, found 0"},
      {"neighbour", "1{1}", "3(1 -1 1)", "case/neighbour:2: expected -1 for all faces after the first one with -1, found 1"},
      {"boundary", "startFace 1", "startFace 0", "case/boundary:2: expected a patch of faces from 1 to below 7, found 'wall' of 2 faces from 0 on"},
      {"boundary", "nFaces 4", "nFaces 5", "case/boundary:4: expected a patch of faces from 1 to below 7, found 'out' of 5 faces from 3 on"},
      {"boundary", "nFaces 4", "nFaces 9000000000000000", "case/boundary:4: expected a patch of faces from 1 to below 7, found 'out' of 9000000000000000 faces from 3 on"},
      {"boundary", "startFace 1", "startFace 2", "case/boundary:4: expected a patch of faces that no other has, found 'out', with face 3"},
      {"boundary", "nFaces 2; ", "", "case/boundary:2: expected a patch with nFaces and startFace, found 'wall'"},
      {"boundary", "nFaces 2; ", "nFaces two; ", "case/boundary:2: expected a number of faces, found 'two;'"},
      {"boundary", "3(wall", "4(wall", "case/boundary:6: expected the name of an entry, found ')'"},
      {"boundary", "1(wall);", "1(wall;", "case/boundary:6: expected a ';' at the end of the entry, found ')'"},
      {"boundary", "\"x  /y\"", "\"x  /y", "case/boundary:6: expected a string that ends on its line, found '\"x'"},
      {"cellZones", "1(1)", "1(2)", "case/cellZones:2: expected the number of a cell, below 2, found 2"},
      {"cellZones", "1(1)", "3(0 1 0)", "case/cellZones:2: expected a number of entries, at most 2, found 3"},
  };
  for (const sample& s : samples) {
    CAPTURE(s.to);
    CHECK(message_of(replaced(s.file, s.from, s.to)) == s.message);
  }
  CHECK(message_of(replaced("boundary", "type wall", "#include \"x\"")) == "case/boundary: line 2 has the directive #include; directives are not evaluated, write what it stands for");
  CHECK(message_of(replaced("faces", "faceList", "decomposedBlockData")) == "case/faces: holds the parts of several processors; put them together with reconstructParMesh");
  CHECK(message_of(replaced("boundary", "format ascii", "format binary", replaced("boundary", "1(wall)", "List<vector> 1(...)"))) ==
        "case/boundary: line 2 has a list of binary numbers in a dictionary; convert the case to text with foamFormatConvert");
  const foam_files binary = binary_tets<std::int32_t, double>(false);
  CHECK(message_of(replaced("owner", "\n7\n", "\n6\n", binary)) == "case/owner:3: expected the ')' of a binary list, found another value at byte 116");
  CHECK(message_of(with("owner", binary[2].second.substr(0, binary[2].second.size() - 2), binary)) ==
        "case/owner:3: expected a list that ends before the file, found 7 numbers of 32 bits, and 27 bytes at byte 92");
  CHECK(message_of(replaced("faces", "\n21\n", "\n20\n", binary)) == "case/faces:4: expected as many corners as the faces have, 21, found 20");
}

TEST_CASE("openfoam: what is skipped is reported") {
  load_report r;
  foam_files files = with("cellZones", header("regIOobject") + "3(a{type cellZone; cellLabels 2(0 1);} b{cellLabels List<label> 1(1); flag on;} c{type cellZone;})");
  files.emplace_back("faceZones", header("regIOobject") + "1(z{})");
  files.emplace_back("pointZones", header("regIOobject") + "0()");
  files = replaced("boundary", "nFaces 4", "nFaces 3", files);
  const auto m = read(files, {.report = &r});
  CHECK(r.skipped == std::vector<std::string>{"the zone c, which lists no cellLabels",
                                              "1 entries of cellZones: these cells are in several zones, and have the label of the first", "the zones of faceZones"});
  CHECK(r.notes == std::vector<std::string>{"1 boundary faces belong to no patch"});
  CHECK(find_poly_property<int>(m, "label")[poly_id{1}] == 1);
  // faces that point the wrong way
  const auto turned = read(replaced("faces", "3(0 2 1)", "3(0 1 2)"), {.report = &r});
  CHECK(r.reoriented_polys == 1);
  CHECK(face_is_outward(turned, poly_id{0}, face_id{0}));
  CHECK(!face_is_outward(turned, poly_id{0}, face_id{1}));
}

TEST_CASE("openfoam: faces with a point twice follow the option") {
  foam_files files = replaced("faces", "3(0 2 1)", "4(0 2 2 1)");
  for (const auto policy : {repeated_verts::collapse, repeated_verts::skip}) {
    load_report r;
    const auto m = read(files, {.report = &r, .repeated_verts = policy});
    CHECK(num_polys(m) == (policy == repeated_verts::skip ? 1 : 2));
    const auto label = find_face_property<int>(m, "label");
    int sum = 0;
    for (const face_id f : faces(m)) sum += label[f];
    CHECK(sum >= 3 * 3);  // the patch `out` of the second cell at least
    CHECK(find_poly_property<int>(m, "label")[poly_id{policy == repeated_verts::skip ? 0u : 1u}] == 1);
  }
}

TEST_CASE("openfoam: a folder that is cut off or changed anywhere is read or refused by a typed error of that file") {
  const memory_limit one_gib(std::size_t{1} << 30);
  std::mt19937 random(7);
  std::size_t num_read = 0, num_refused = 0;
  const auto try_it = [&](const foam_files& files, const std::string& file) {
    try {
      load_text<polyhedralmesh>(joined_foam_files(files), foam_text_format{}, {}, "case");
      ++num_read;
    } catch (const parse_error& e) {
      ++num_refused;
      CHECK(e.line >= 1);
      // what contradicts another file is found in the later one
      if (file == "boundary" || file == "cellZones") CHECK(std::string(e.what()).starts_with("case/" + file));
    } catch (const unsupported&) {
      ++num_refused;
    } catch (const invalid_mesh&) {
      ++num_refused;
    }
  };
  const foam_files all[] = {two_tets, binary_tets<std::int32_t, double>(false), binary_tets<std::int64_t, float>(true), split_foam_files(save_text(read(two_tets), foam_text_format{}))};
  for (const foam_files& files : all)
    for (std::size_t k = 0; k < files.size(); ++k) {
      for (std::size_t n = 0; n < files[k].second.size(); ++n) try_it(with(files[k].first, files[k].second.substr(0, n), files), files[k].first);
      for (std::size_t i = 0; i < 400; ++i) {
        std::string text = files[k].second;
        for (std::size_t changes = 1 + random() % 3; changes > 0; --changes) text[random() % text.size()] = random() % 4 ? "0123456789(){};/* -"[random() % 19] : static_cast<char>(random());
        try_it(with(files[k].first, text, files), files[k].first);
      }
    }
  CHECK(num_read > 100);
  CHECK(num_refused > 1000);
  CHECK(!one_gib.was_exceeded());
}
