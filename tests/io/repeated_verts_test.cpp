// load_options::repeated_verts: polys with a vert twice, from every format.
#include <concino/io.hpp>
#include <concino/mesh.hpp>
#include <concino/validate/check_laws.hpp>

#include <support/temporary.hpp>

#include <doctest/doctest.h>

#include <string>
#include <string_view>
#include <vector>

using namespace concino;

namespace {

const std::string two_hexes = "0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1 2 0 0 2 0 1\n";  // the second one is collapsed to a prism
const std::string collapsed_hex = "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 10 double\n" + two_hexes +
                                  "CELLS 2 18\n8 0 1 2 3 4 5 6 7\n8 1 8 2 2 5 9 6 6\nCELL_TYPES 2\n12\n12\nCELL_DATA 2\nSCALARS q int\nLOOKUP_TABLE "
                                      "default\n3\n4\n";
const std::string one_bad_face = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\ng a\nf 1 3 2\ng b\nf 1 1 2\ng c\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
const std::string bridged_hole = "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 1 1 0\nv 3 1 0\nv 3 3 0\nv 1 3 0\nf 1 2 3 4 1 5 8 7 6 5\n";

bool mentions(const std::vector<std::string>& remarks, std::string_view words) {
  for (const std::string& r : remarks)
    if (r.find(words) != r.npos) return true;
  return false;
}

double volume_of(const polyhedralmesh& m) {
  double sum = 0;
  for (const poly_id p : polys(m))
    for (const face_id f : adj_p2f(m, p)) {
      std::vector<vec3> x;
      for (const vert_id v : adj_f2v(m, f)) x.push_back(point(m, v));
      const double one = six_times_volume_under(x.size(), [&](std::size_t i) -> const vec3& { return x[i]; }, {}) / 6;
      sum += face_is_outward(m, p, f) ? one : -one;
    }
  return sum;
}
double area_of(const polygonmesh& m) {
  vec3 sum;
  for (const poly_id p : polys(m)) {
    std::vector<vec3> x;
    for (const vert_id v : adj_p2v(m, p)) x.push_back(point(m, v));
    for (std::size_t i = 1; i + 1 < x.size(); ++i) sum = sum + cross(x[i] - x[0], x[i + 1] - x[0]);
  }
  return norm(sum) / 2;
}

/// The message of loading a text with default options; empty if there is none.
template<class M>
std::string complaint_of(const std::string& text, format_id f) {
  try {
    load_text<M>(text, f);
  } catch (const parse_error& e) {
    return e.what();
  }
  return {};
}

/// Saves and loads a volume of which hex 1 is collapsed to a prism, in a format that is made from it.
struct volume_file {
  format_id format;
  std::string text;
};
std::vector<volume_file> volumes_with_collapsed_hex() {
  const std::string hedra_faces = "4 1 4 3 2\n4 5 6 7 8\n4 1 2 6 5\n4 2 3 7 6\n4 3 4 8 7\n4 4 1 5 8\n4 2 3 3 9\n4 6 10 7 7\n4 2 9 10 6\n4 9 3 7 10\n4 "
      "3 3 7 7\n";
  const auto minus_one = [](std::string rows) {
    for (std::size_t i = 0; i < rows.size(); ++i) {  // the first number of each row is its length
      if (rows[i] != ' ') continue;
      if (rows.compare(i + 1, 2, "10") == 0) rows.replace(i + 1, 2, "9");
      else --rows[i + 1];
    }
    return rows;
  };
  const std::string list = "0 1 2 3 4 5 6 7 1 8 2 2 5 9 6 6";
  std::string medit = "MeshVersionFormatted 2 Dimension 3 Vertices 10\n";
  for (std::size_t i = 0, n = 0; i < two_hexes.size(); ++i) {
    n += two_hexes[i] == ' ' || two_hexes[i] == '\n';
    medit += two_hexes[i];
    if ((two_hexes[i] == ' ' || two_hexes[i] == '\n') && n % 3 == 0) medit += "0 ";
  }
  const auto array = [](const char* name, const std::string& numbers, const char* more = "") {
    return std::string("<DataArray type=\"") + (*more ? "Float64" : "Int64") + "\" Name=\"" + name + "\" format=\"ascii\"" + more + ">" + numbers +
        "</DataArray>";
  };
  return {{file_format::vtk, collapsed_hex},
          {file_format::medit, medit + "Hexahedra 2 1 2 3 4 5 6 7 8 0 2 9 3 3 6 10 7 7 0 End"},
          {file_format::tet, "10 vertices\n2 cells\n" + two_hexes + "8 0 1 3 2 4 5 7 6\n8 1 8 2 2 5 9 6 6\n"},
          {file_format::hedra, "10 11 2\n" + two_hexes + hedra_faces + "6 1 2 3 4 5 6\n6 -4 7 8 9 10 11\n"},
          {file_format::hybrid, "10 11 6\n" + two_hexes + minus_one(hedra_faces) + "6 0 1 2 3 4 5\n6 1 1 1 1 1 1\n6 3 6 7 8 9 10\n6 0 1 1 1 1 1\n1\n0\n"},
          {file_format::vtu, "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid><Piece NumberOfPoints=\"10\" NumberOfCells=\"2\"><Points>" +
                                 array("P", two_hexes, " NumberOfComponents=\"3\"") + "</Points><Cells>" + array("connectivity", list) +
                                     array("offsets", "8 16") +
                                 array("types", "12 12") + "</Cells></Piece></UnstructuredGrid></VTKFile>"}};
}

}  // namespace

TEST_CASE("repeated_verts: refused by default, with the place and the option") {
  CHECK(complaint_of<polygonmesh>(one_bad_face, file_format::obj) ==
        "text:8: expected different verts at the corners of a face (or set options.repeated_verts), found vert 1 twice");
  for (const volume_file& f : volumes_with_collapsed_hex()) {
    CAPTURE(f.format.name());
    CHECK(complaint_of<polyhedralmesh>(f.text, f.format).find("options.repeated_verts") != std::string::npos);
  }
}

TEST_CASE("repeated_verts: a collapsed hex becomes a prism, or is skipped, in every format of volumes") {
  for (const volume_file& f : volumes_with_collapsed_hex()) {
    CAPTURE(f.format.name());
    load_report r;
    const auto m = load_text<polyhedralmesh>(f.text, f.format, {.report = &r, .repeated_verts = repeated_verts::collapse});
    CHECK(num_polys(m) == 2);
    CHECK(num_faces(m) == 10);
    CHECK(volume_of(m) == doctest::Approx(1.5));
    CHECK(check_laws(m).empty());
    CHECK(mentions(r.notes, "1 polys with a vert twice were collapsed, the first is poly 1 of the file"));
    const auto one = load_text<hexmesh>(f.text, f.format, {.report = &r, .repeated_verts = repeated_verts::skip});
    CHECK(num_polys(one) == 1);
    CHECK(mentions(r.skipped, "1 polys with a vert twice, the first is poly 1 of the file"));
    CHECK(num_faces(load_text<polyhedralmesh>(f.text, f.format, {.repeated_verts = repeated_verts::skip})) == 6);
    CHECK_THROWS_AS(load_text<hexmesh>(f.text, f.format, {.repeated_verts = repeated_verts::collapse}), parse_error);
  }
}

TEST_CASE("repeated_verts: hexes collapsed to tets, pyramids and nothing") {
  const auto vtk = [](const std::string& cell) {
    return "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 10 double\n" + two_hexes + "CELLS 1 9\n8 " + cell + "\nCELL_TYPES 1\n12\n";
  };
  const load_options collapse{.repeated_verts = repeated_verts::collapse};
  const auto tet = load_text<tetmesh>(vtk("0 1 2 2 4 4 4 4"), file_format::vtk, collapse);
  CHECK(num_polys(tet) == 1);
  const auto pyramid = load_text<polyhedralmesh>(vtk("0 1 2 3 4 4 4 4"), file_format::vtk, collapse);
  CHECK(num_faces(pyramid) == 5);
  CHECK(volume_of(pyramid) == doctest::Approx(1.0 / 3));
  load_report r;
  CHECK(num_polys(load_text<polyhedralmesh>(vtk("0 1 2 3 0 1 2 3"), file_format::vtk, {.report = &r, .repeated_verts = repeated_verts::collapse})) == 0);
  CHECK(mentions(r.skipped, "1 polys with a vert twice that have no area or volume left"));
  const auto edge = load_text<polyhedralmesh>(vtk("0 1 2 3 4 5 6 3"), file_format::vtk, collapse);  // three quads become triangles
  CHECK(num_faces(edge) == 6);
  CHECK(check_laws(edge).empty());
}

TEST_CASE("repeated_verts: values follow the cells") {
  const auto m = load_text<polyhedralmesh>(collapsed_hex, file_format::vtk, {.repeated_verts = repeated_verts::collapse});
  CHECK(find_poly_property<int>(m, "q")[poly_id{1}] == 4);
  std::string first_bad = collapsed_hex;
  first_bad.replace(first_bad.find("8 0 1 2 3 4"), 11, "8 0 1 2 2 4");
  const auto none = load_text<polyhedralmesh>(first_bad, file_format::vtk, {.repeated_verts = repeated_verts::skip});
  CHECK(num_polys(none) == 0);
  std::string other = collapsed_hex;
  other.replace(other.find("8 0 1 2 3 4 5 6 7\n8 1 8 2 2 5 9 6 6"), 35, "8 1 8 2 2 5 9 6 6\n8 0 1 2 3 4 5 6 7");
  const auto last = load_text<polyhedralmesh>(other, file_format::vtk, {.repeated_verts = repeated_verts::skip});
  REQUIRE(num_polys(last) == 1);
  CHECK(find_poly_property<int>(last, "q")[poly_id{0}] == 4);
}

TEST_CASE("repeated_verts: polys of surfaces are skipped with a remark that names the line, and their values with them") {
  load_report r;
  for (const repeated_verts what : {repeated_verts::skip, repeated_verts::collapse}) {  // nothing is left of f 1 1 2
    const auto m = load_text<trimesh>(one_bad_face, file_format::obj, {.report = &r, .repeated_verts = what});
    REQUIRE(num_polys(m) == 4);
    const auto group = find_poly_property<std::string>(m, "group");
    CHECK(group[poly_id{0}] == "a");
    CHECK(group[poly_id{1}] == "c");
    CHECK(group[poly_id{3}] == "c");
    CHECK(find_poly_property<int>(m, "label")[poly_id{1}] == 3);
    CHECK(mentions(what == repeated_verts::skip ? r.skipped : r.notes, "the first is poly 1 of the file, on line 8"));
  }
  CHECK(mentions(r.skipped, "no area or volume left"));
}

TEST_CASE("repeated_verts: a quad with two equal corners is a triangle, in every format of surfaces") {
  const std::string points = "0 0 0 1 0 0 1 1 0 0 1 0 ";
  const std::string vtk = "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n" + points + "\nCELLS 2 10\n4 0 1 2 2\n4 "
      "0 2 3 3\nCELL_TYPES 2\n9\n9\n";
  const volume_file files[] = {{file_format::vtk, vtk},
                               {file_format::obj, "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 3\nf 1 3 4 4\n"},
                               {file_format::off, "OFF\n4 2 0\n" + points + "\n4 0 1 2 2\n4 0 2 3 3\n"},
                               {file_format::iv, "#Inventor V2.1 ascii\nSeparator { Coordinate3 { point [ 0 0 0, 1 0 0, 1 1 0, 0 1 0 ] } "
                                   "IndexedFaceSet { coordIndex [ 0, 1, 2, 2, -1, 0, 2, 3, 3, -1 ] } }\n"},
                               {file_format::medit, "MeshVersionFormatted 2 Dimension 3 Vertices 4 0 0 0 0 1 0 0 0 1 1 0 0 0 1 0 0 Quadrilaterals 2 1 "
                                   "2 3 3 5 1 3 4 4 6 End"}};
  for (const volume_file& f : files) {
    CAPTURE(f.format.name());
    CHECK(!complaint_of<polygonmesh>(f.text, f.format).empty());
    const auto m = load_text<trimesh>(f.text, f.format, {.repeated_verts = repeated_verts::collapse});
    CHECK(num_polys(m) == 2);
    CHECK(area_of(load_text<polygonmesh>(f.text, f.format, {.repeated_verts = repeated_verts::collapse})) == doctest::Approx(1));
    CHECK(num_polys(load_text<quadmesh>(f.text, f.format, {.repeated_verts = repeated_verts::skip})) == 0);
    CHECK_THROWS_AS(load_text<quadmesh>(f.text, f.format, {.repeated_verts = repeated_verts::collapse}), parse_error);
  }
  const auto m = load_text<trimesh>(files[4].text, file_format::medit, {.repeated_verts = repeated_verts::collapse});
  CHECK(find_poly_property<int>(m, "label")[poly_id{1}] == 6);
}

TEST_CASE("repeated_verts: a polygon with a bridge to its hole is cut into triangles, which have its values") {
  load_report r;
  const auto m = load_text<polygonmesh>("g ring\n" + bridged_hole + "g other\nf 5 6 7 8\n", file_format::obj, {.report = &r, .repeated_verts =
      repeated_verts::collapse});
  CHECK(area_of(m) == doctest::Approx(16));
  CHECK(num_polys(m) == 9);
  CHECK(check_laws(m).empty());
  CHECK(mentions(r.notes, "1 polygons that pass a vert twice were cut into triangles"));
  const auto group = find_poly_property<std::string>(m, "group");
  CHECK(group[poly_id{7}] == "ring");
  CHECK(group[poly_id{8}] == "other");
  const auto t = load_text<trimesh>(bridged_hole, file_format::obj, {.repeated_verts = repeated_verts::collapse});
  CHECK(num_polys(t) == 8);
}

TEST_CASE("repeated_verts: values of corners follow") {
  const std::string text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt .5 1\nvt 0 1\nf 1/1 2/2 3/3 3/4\nf 1/1 3/3 4/5\n";
  const auto m = load_text<trimesh>(text, file_format::obj, {.repeated_verts = repeated_verts::collapse});
  const std::string saved = save_text(m, file_format::obj);
  CHECK(saved.find("f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n") != std::string::npos);
}

TEST_CASE("repeated_verts: load_any and the functions of one format take the option") {
  const testing::temporary_folder folder;
  const std::string path = folder / "a.vtk", obj = folder / "b.obj";
  testing::write_file(path, collapsed_hex);
  testing::write_file(obj, one_bad_face);
  CHECK(num_polys(std::get<polyhedralmesh>(load_any(path, {.repeated_verts = repeated_verts::collapse}))) == 2);
  CHECK(num_polys(std::get<hexmesh>(load_any(path, {.repeated_verts = repeated_verts::skip}))) == 1);
  CHECK(num_polys(load_vtk<hexmesh>(path, {.repeated_verts = repeated_verts::skip})) == 1);
  CHECK(num_polys(load<hexmesh>(path, {.repeated_verts = repeated_verts::skip})) == 1);
  CHECK(num_polys(std::get<trimesh>(load_any(obj, {.repeated_verts = repeated_verts::skip}))) == 4);
}
