// Meshes in pieces: .pvtu files and the .vtu files that they name.
#include <concino/io/pvtu.hpp>
#include <concino/io/save.hpp>
#include <concino/io/vtu.hpp>
#include <concino/mesh/property.hpp>

#include <support/corpus_meshes.hpp>
#include <support/kinds.hpp>
#include <support/same_mesh.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

/// Two grids and an isolated vert, with properties of all kinds that the format holds.
template<class M>
M mesh_with_values() {
  M m(two_grids_arrays<M>(2));
  auto height = vert_property<double>(m, "height");
  for (const auto v : verts(m)) height[v] = point(m, v).x + 10 * point(m, v).z;
  auto label = poly_property<int>(m, "label");
  for (const auto p : polys(m)) label[p] = static_cast<int>(index_of(m, p)) * 3 - 5;
  *mesh_property<double>(m, "time") = 0.25;
  if constexpr (dimension_v<M> == 3) {
    auto patch = face_property<int>(m, "patch");
    for (const auto f : faces(m)) patch[f] = num_elements(adj_f2p(m, f)) == 1 && point(m, *adj_f2v(m, f).begin()).z == 0 ? 1 + static_cast<int>(index_of(m, f)) : 0;
  }
  return m;
}

/// Each poly as its sorted verts, then the values of faces by their verts: readers number faces anew.
template<class M>
std::vector<std::vector<std::size_t>> connectivity(const M& m) {
  std::vector<std::vector<std::size_t>> all;
  const auto sorted = [&](const auto& around) {
    std::vector<std::size_t> r;
    for (const auto v : around) r.push_back(index_of(m, v));
    std::sort(r.begin(), r.end());
    return r;
  };
  for (const auto p : polys(m)) all.push_back(sorted(adj_p2v(m, p)));
  if constexpr (dimension_v<M> == 3) {
    std::vector<std::vector<std::size_t>> of_faces;
    const auto patch = find_face_property<int>(m, "patch");
    for (const auto f : faces(m)) {
      of_faces.push_back(sorted(adj_f2v(m, f)));
      of_faces.back().push_back(patch ? static_cast<std::size_t>(patch[f]) : 0);
    }
    std::sort(of_faces.begin(), of_faces.end());
    all.insert(all.end(), of_faces.begin(), of_faces.end());
  }
  return all;
}

template<class M>
std::string properties_as_bytes(const M& m) {
  std::map<std::string, std::string> all;
  for (const property_info& p : property_list(m))
    if (p.name != "global_id" && p.kind != element_kind::face) all[p.name] = bytes_of_property(m, p);
  std::string r;
  for (const auto& [name, bytes] : all) r += name + ":" + bytes + "|";
  return r;
}

template<class M>
void check_same(const M& m, const M& expected) {
  REQUIRE(num_verts(m) == num_verts(expected));
  REQUIRE(num_polys(m) == num_polys(expected));
  auto w = verts(expected).begin();
  std::size_t num_different = 0;
  for (const auto v : verts(m)) {
    num_different += !(point(m, v) == point(expected, *w));
    ++w;
  }
  CHECK(num_different == 0);
  CHECK(connectivity(m) == connectivity(expected));
  CHECK(properties_as_bytes(m) == properties_as_bytes(expected));
}

std::map<std::string, std::string> files_in(const std::string& folder) {
  std::map<std::string, std::string> all;
  for (const auto& f : std::filesystem::directory_iterator(folder)) all[f.path().filename().string()] = read_file(f.path().string());
  return all;
}

/// Four points of a square cut into two triangles, one in each piece.
std::string triangle_file(const std::string& points, const std::string& point_data, const std::string& cells = "0 1 2", const std::string& cell_data = "") {
  const auto n = std::to_string(std::count(cells.begin(), cells.end(), ' ') / 3 + 1);
  std::string ends, types;
  for (int k = 1; k <= std::stoi(n); ++k) ends += std::to_string(3 * k) + " ", types += "5 ";
  return "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid>\n<Piece NumberOfPoints=\"" + std::to_string((std::count(points.begin(), points.end(), ' ') + 1) / 3) +
         "\" NumberOfCells=\"" + n + "\">" + point_data + cell_data + "<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">" + points +
         "</DataArray></Points><Cells><DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">" + cells +
         "</DataArray><DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">" + ends + "</DataArray><DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">" + types +
         "</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>\n";
}
std::string array(const char* type, const char* name, const std::string& values) {
  return std::string("<DataArray type=\"") + type + "\" Name=\"" + name + "\" format=\"ascii\">" + values + "</DataArray>";
}
std::string ids_of_points(const std::string& ids) { return "<PointData GlobalIds=\"id\">" + array("Int32", "id", ids) + "</PointData>"; }
std::string master(const std::string& pieces, const std::string& arrays = "") {
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"PUnstructuredGrid\">\n<PUnstructuredGrid>\n" + arrays + pieces + "</PUnstructuredGrid>\n</VTKFile>\n";
}
std::string piece(const std::string& source) { return "<Piece Source=\"" + source + "\"/>\n"; }
const std::string point_ids = "<PPointData GlobalIds=\"id\">\n<PDataArray type=\"Int32\" Name=\"id\"/>\n</PPointData>\n";

/// The two pieces with these files, and what loading them says.
std::string outcome(const std::string& text, const std::string& first, const std::string& second) {
  const temporary_folder folder;
  write_file(folder / "m.pvtu", text);
  write_file(folder / "a.vtu", first);
  write_file(folder / "b.vtu", second);
  try {
    const auto m = load_pvtu<polygonmesh>(folder / "m.pvtu");
    return std::to_string(num_verts(m)) + " verts, " + std::to_string(num_polys(m)) + " polys";
  } catch (const error& e) {
    std::string what = e.what();
    for (std::size_t at; (at = what.find(folder.path())) != what.npos;) what.erase(at, folder.path().size() + 1);
    return what;
  }
}

const std::string low = "0 0 0 1 0 0 0 1 0", high = "1 0 0 1 1 0 0 1 0", both = piece("a.vtu") + piece("b.vtu");

}  // namespace

TEST_CASE_TEMPLATE("pvtu: the parts of a mesh are joined to the same mesh", M, CONCINO_ALL_KINDS) {
  const M m = mesh_with_values<M>();
  for (const unsigned n : {1u, 2u, 5u}) {
    for (const bool binary : {false, true}) {
      CAPTURE(n);
      const temporary_folder folder, again;
      auto part = make_poly_map<unsigned>(m);
      for (const auto p : polys(m)) part[p] = static_cast<unsigned>(index_of(m, p) * 7 / 3 % n);
      if (n == 5) for (const auto p : polys(m)) part[p] += part[p] >= 2;  // part 2 has no polys
      save_report report;
      save_pvtu(m, folder / "m.pvtu", part, {.report = &report, .binary = binary, .strict = true});
      CHECK(report.lost.empty());
      CHECK(folder.num_files() == n + 1 + (n == 5));
      load_report loaded;
      const M back = load_pvtu<M>(folder / "m.pvtu", {.report = &loaded});
      CHECK(loaded.skipped.empty());
      check_same(back, m);
      save_pvtu(back, again / "m.pvtu", part, {.binary = binary});
      CHECK(files_in(again.path()) == files_in(folder.path()));
      save_pvtu(m, folder / "m.pvtu", part, {.binary = binary});
      CHECK(files_in(again.path()) == files_in(folder.path()));
    }
  }
}

TEST_CASE("pvtu: load finds the format by the extension and by the first words") {
  const auto m = mesh_with_values<polygonmesh>();
  const temporary_folder folder;
  save_pvtu(m, folder / "m.pvtu", make_poly_map<int>(m, 0));
  check_same(load_pvtu<polygonmesh>(folder / "m.pvtu"), m);
  std::filesystem::copy_file(folder / "m.pvtu", folder / "m.xml");
  CHECK(num_polys(load_pvtu<polygonmesh>(folder / "m.xml")) == num_polys(m));
  CHECK(pvtu_format::has_signature(read_file(folder / "m.pvtu")));
  CHECK(!pvtu_format::has_signature(read_file(folder / "m_0.vtu")));
  CHECK_THROWS_AS(load_text<polygonmesh>(read_file(folder / "m.pvtu"), file_format::pvtu), unsupported);
  CHECK(num_polys(load_text<polygonmesh>(master(""), file_format::pvtu)) == 0);
  std::filesystem::create_directory(folder / "links");
  std::filesystem::create_symlink("../m.pvtu", folder / "links/m.pvtu");
  CHECK(num_polys(load_pvtu<polygonmesh>(folder / "links/m.pvtu")) == num_polys(m));
}

TEST_CASE("pvtu: points are united by their numbers, or by their places") {
  CHECK(outcome(master(both), triangle_file(low, ""), triangle_file(high, "")) == "4 verts, 2 polys");
  CHECK(outcome(master(both, point_ids), triangle_file(low, ids_of_points("7 2 5")), triangle_file(high, ids_of_points("2 9 5"))) == "4 verts, 2 polys");
  CHECK(outcome(master(both, point_ids), triangle_file(low, ids_of_points("7 2 5")), triangle_file(high, ids_of_points("3 9 4"))) == "6 verts, 2 polys");
  CHECK(outcome(master(both, point_ids), triangle_file(low, ids_of_points("7 2 5")), triangle_file(high, ids_of_points("2 5 9"))) ==
        "b.vtu:2: expected the point of number 5 in the array \"id\" where the piece a.vtu has it, found another place, of point 1 of the piece");
  // a crack: the first piece has two points at one place, and numbers tell them apart
  const std::string crack = "0 0 0 1 0 0 0 1 0 1 0 0 0 1 0 1 1 0";
  CHECK(outcome(master(both), triangle_file(crack, "", "0 1 2 3 5 4"), triangle_file(low, "")) == "8 verts, 3 polys");
  CHECK(outcome(master(both, point_ids), triangle_file(crack, ids_of_points("0 1 2 3 4 5"), "0 1 2 3 5 4"), triangle_file(high, ids_of_points("3 6 4"))) ==
        "7 verts, 3 polys");
}

TEST_CASE("pvtu: what is wrong in a file or in one of its pieces") {
  const std::string a = triangle_file(low, ""), b = triangle_file(high, "");
  CHECK(outcome(master(piece("a.vtu") + piece("c.vtu")), a, b) == "c.vtu: cannot be opened: No such file or directory; it is the piece that m.pvtu names on line 5");
  CHECK(outcome(master(piece("a.vtu") + piece("a.vtu")), a, b) == "m.pvtu:5: expected another piece than on line 4, found 'a.vtu' again");
  for (const std::string path : {"/tmp/a.vtu", "../a.vtu", "x/../../a.vtu", "C:\\a.vtu", ""})
    CHECK(outcome(master(piece(path)), a, b).starts_with("m.pvtu:4: expected Source, the path of a piece in the folder of this file or below it, found '"));
  const std::string values = "<PCellData>\n<PDataArray type=\"Float64\" Name=\"x\"/>\n</PCellData>\n",
                    x = "<CellData>" + array("Float64", "x", "0.5") + "</CellData>", y = "<CellData>" + array("Float32", "x", "0.5") + "</CellData>";
  CHECK(outcome(master(both, values), triangle_file(low, "", "0 1 2", x), triangle_file(high, "", "0 1 2", x)) == "4 verts, 2 polys");
  CHECK(outcome(master(both, values), triangle_file(low, "", "0 1 2", x), b) ==
        "m.pvtu:5: expected an array that all pieces have for their cells, found \"x\", which b.vtu lacks");
  CHECK(outcome(master(both, values), triangle_file(low, "", "0 1 2", y), b) ==
        "m.pvtu:5: expected an array that all pieces have for their cells, found \"x\", which a.vtu has with another type");
  CHECK(outcome(master(both), triangle_file(low, "", "0 1 2", x), b) == "4 verts, 2 polys");  // no array of all pieces
  const std::string cell_ids = "<PCellData GlobalIds=\"c\"/>\n", same = "<CellData>" + array("Int32", "c", "4") + "</CellData>";
  CHECK(outcome(master(both, cell_ids), triangle_file(low, "", "0 1 2", same), triangle_file(high, "", "0 1 2", same)) ==
        "b.vtu:2: expected cells of different numbers in the array \"c\", but for ghosts, found 4, which a.vtu has, too");
  CHECK(outcome(master(both), a, triangle_file(high, "", "0 1 3")).starts_with("b.vtu:2: expected point indices below 3, found 3"));
  CHECK(outcome(master(both), a, triangle_file(high, "", "0 1 1")) ==
        "b.vtu:2: expected different points at the corners of a polygon (or set options.repeated_verts), found point 3 twice in cell 0 of the piece");
  CHECK(outcome(master(both), a, master("")) == "b.vtu: type=\"PUnstructuredGrid\" is not supported; UnstructuredGrid and PolyData are");
  CHECK(outcome(a, a, b) == "m.pvtu: type=\"UnstructuredGrid\" is not supported; PUnstructuredGrid is");
  CHECK(outcome("<VTKFile type=\"PUnstructuredGrid\">\n</VTKFile>", a, b) == "m.pvtu:2: expected <PUnstructuredGrid>, found the end of the file");
  CHECK(outcome("<VTKFile type=\"PUnstructuredGrid\">\n" + piece("a.vtu"), a, b) == "m.pvtu:2: expected <PUnstructuredGrid> before a piece, found '<Piece'");
  CHECK(outcome(master(both).substr(0, 90), a, b) == "m.pvtu:4: expected > at the end of a tag, found the end of the file");
}

TEST_CASE("pvtu: ghosts are dropped, and empty pieces may lack arrays") {
  const std::string four = "0 0 0 1 0 0 0 1 0 1 1 0", x = array("Float64", "x", "1 2");
  const auto with_ghosts = [&](const std::string& ghosts) {
    return triangle_file(four, "", "0 1 2 1 3 2", "<CellData>" + array("UInt8", "vtkGhostType", ghosts) + x + "</CellData>");
  };
  const std::string named = "<PCellData>\n<PDataArray type=\"UInt8\" Name=\"vtkGhostType\"/>\n<PDataArray type=\"Float64\" Name=\"x\"/>\n</PCellData>\n";
  CHECK(outcome(master(both, named), with_ghosts("0 1"), with_ghosts("1 0")) == "4 verts, 2 polys");
  const std::string empty = "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid><Piece NumberOfPoints=\"0\" NumberOfCells=\"0\"/></UnstructuredGrid></VTKFile>";
  CHECK(outcome(master(both, named), empty, with_ghosts("0 0")) == "4 verts, 2 polys");
  CHECK(outcome(master(both, named), with_ghosts("0 0"), empty) == "4 verts, 2 polys");
  CHECK(outcome(master(both, named), empty, empty) == "0 verts, 0 polys");
  CHECK(outcome(master(both, named), with_ghosts("0 1"), triangle_file(four, "", "0 1 2 1 2 2", "<CellData>" + array("UInt8", "vtkGhostType", "1 0") + x + "</CellData>")) ==
        "b.vtu:2: expected different points at the corners of a polygon (or set options.repeated_verts), found point 2 twice in cell 0 of the piece, not counting ghosts");
}

TEST_CASE("pvtu: pieces that were saved one by one, as parallel programs do") {
  const temporary_folder folder;
  std::filesystem::create_directory(folder / "pieces");
  const auto save_piece = [&](int k, std::initializer_list<std::int64_t> ids, std::vector<std::uint8_t> ghosts, double x, const std::string& path) {
    // a strip of quads: piece k owns the quad between x and x + 1
    surface_arrays s;
    s.arity = 4;
    for (std::size_t i = 0; i < ids.size() / 2; ++i) s.points.push_back({x + static_cast<double>(i), 0, 0}), s.points.push_back({x + static_cast<double>(i), 1, 0});
    for (unsigned i = 0; i < ghosts.size(); ++i)
      for (const unsigned v : {2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1}) s.verts.push_back(vert_id{v});
    quadmesh m(std::move(s));
    auto id = vert_property<std::int64_t>(m, "global_id");
    auto of_polys = poly_property<std::int64_t>(m, "global_id");
    auto owner = poly_property<int>(m, "owner");
    auto ghost = poly_property<std::uint8_t>(m, "vtkGhostType");
    auto i = ids.begin();
    for (const auto v : verts(m)) id[v] = *i++;
    for (const auto p : polys(m)) {
      ghost[p] = ghosts[index_of(m, p)];
      owner[p] = ghost[p] ? 1 - k : k;
      of_polys[p] = 10 - owner[p];  // the polys of the second piece come first
    }
    save_vtu(m, folder / path, {.binary = k == 1});
  };
  save_piece(0, {0, 1, 2, 3, 4, 5}, {0, 1}, 0, "pieces/a.vtu");
  save_piece(1, {0, 1, 2, 3, 4, 5}, {1, 0}, 0, "pieces/b.vtu");
  save_vtu(quadmesh(), folder / "empty.vtu");
  const std::vector<std::string> pieces{"empty.vtu", "pieces/a.vtu", "pieces/b.vtu"};
  save_pvtu(pieces, folder / "m.pvtu");
  const std::string text = read_file(folder / "m.pvtu");
  CHECK(text.find("GhostLevel=\"1\"") != text.npos);
  CHECK(text.find("<PPointData GlobalIds=\"global_id\">\n<PDataArray type=\"Int64\" Name=\"global_id\"/>") != text.npos);
  save_pvtu(pieces, folder / "m.pvtu");
  CHECK(read_file(folder / "m.pvtu") == text);
  const auto m = load_pvtu<quadmesh>(folder / "m.pvtu");
  CHECK(num_verts(m) == 6);
  CHECK(num_polys(m) == 2);
  const auto owner = find_poly_property<int>(m, "owner");
  for (const auto p : polys(m)) CHECK(owner[p] == 1 - static_cast<int>(index_of(m, p)));
  CHECK(!find_poly_property<std::uint8_t>(m, "vtkGhostType"));

  save_vtu(quadmesh(grid_arrays<quadmesh>(1)), folder / "bare.vtu");
  write_file(folder / "no.vtu", "no XML");
  const auto says = [&](std::vector<std::string> names) {
    try {
      save_pvtu(names, folder / "m.pvtu");
      return std::string();
    } catch (const error& e) {
      std::string what = e.what();
      for (std::size_t at; (at = what.find(folder.path())) != what.npos;) what.erase(at, folder.path().size() + 1);
      return what;
    }
  };
  CHECK(says({"pieces/a.vtu", "bare.vtu"}) == "save_pvtu: the pieces need the same arrays: pieces/a.vtu has \"global_id\", bare.vtu has not, or has it with another type");
  CHECK(says({"bare.vtu", "bare.vtu"}) == "save_pvtu: the piece 'bare.vtu' is named twice");
  CHECK(says({"../bare.vtu"}) == "save_pvtu: '../bare.vtu' is not the path of a piece from the folder of the .pvtu file");
  CHECK(says({"none.vtu"}) == "none.vtu: cannot be opened: No such file or directory");
  CHECK(says({"no.vtu"}) == "no.vtu:1: expected <VTKFile>, found the end of the file");
  CHECK(read_file(folder / "m.pvtu") == text);
  CHECK(says({}).empty());
  CHECK(num_polys(load_pvtu<quadmesh>(folder / "m.pvtu")) == 0);
}

TEST_CASE("pvtu: what fails leaves all files as they were") {
  auto m = mesh_with_values<polygonmesh>();
  const temporary_folder folder;
  auto part = make_poly_map<int>(m, 0);
  part[*polys(m).begin()] = 1;
  save_pvtu(m, folder / "m.pvtu", part);
  const auto before = files_in(folder.path());
  const auto check = [&](const auto& save_it, const std::string& message) {
    std::string what;
    try {
      save_it();
    } catch (const error& e) {
      what = e.what();
    }
    CHECK(what.find(message) != what.npos);
    CAPTURE(what);
    CHECK(files_in(folder.path()) == before);
  };
  int calls = 0;
  const auto stop = [&](double, const char*) { return ++calls < 2; };
  check([&] { save_pvtu(m, folder / "m.pvtu", part, {.progress = stop}); }, "stopped by the progress callback");
  check([&] { save_pvtu(m, folder / "m.pvtu", part, {.as_boundary = true}); }, "saves the parts of a mesh, and no boundary");
  poly_property<std::string>(m, "name");
  check([&] { save_pvtu(m, folder / "m.pvtu", part, {.strict = true}); }, "poly property \"name\": .pvtu cannot store it");
  part[*polys(m).begin()] = -3;
  check([&] { save_pvtu(m, folder / "m.pvtu", part); }, "save_pvtu: poly 0 is in part -3; parts are numbers from 0 to 65535");
  part[*polys(m).begin()] = 65536;
  check([&] { save_pvtu(m, folder / "m.pvtu", part); }, "is in part 65536");
  part[*polys(m).begin()] = 0;
  vert_property<std::int64_t>(m, "global_id");
  check([&] { save_pvtu(m, folder / "m.pvtu", part); }, "the vert property \"global_id\" has to give different integers");
  check([&] { save(m, folder / "m.pvtu"); }, ".pvtu can be read, but not written");
  check([&] { save_pvtu(m, folder / "none/none/m.pvtu", make_poly_map<int>(m, -1)); }, "is in part -1");
}

TEST_CASE("pvtu: the progress of all pieces is one") {
  auto m = mesh_with_values<trimesh>();
  const temporary_folder folder;
  auto part = make_poly_map<int>(m);
  for (const auto p : polys(m)) part[p] = static_cast<int>(index_of(m, p) % 3);
  double last = 0;
  bool rises = true;
  const auto watch = [&](double x, const char*) {
    rises = rises && x >= last;
    last = x;
    return true;
  };
  for (const bool binary : {false, true}) {
    last = 0;
    save_pvtu(m, folder / "m.pvtu", part, {.progress = watch, .binary = binary});
    CHECK(rises);
    CHECK(last == 1);
  }
  last = 0;
  load_pvtu<trimesh>(folder / "m.pvtu", {.progress = watch});
  CHECK(rises);
  CHECK(last == 1);
}

TEST_CASE("pvtu: the pieces of all files of the corpus are what a .vtu file has") {
  const temporary_folder folder;
  for_each_small_corpus_mesh([&]<class M>(const M& m) {
    auto part = make_poly_map<int>(m);
    for (const auto p : polys(m)) part[p] = static_cast<int>(4 * index_of(m, p) / (poly_index_bound(m) + 1));
    save_vtu(m, folder / "m.vtu", {.binary = true});
    save_pvtu(m, folder / "m.pvtu", part, {.binary = true});
    check_same(load_pvtu<M>(folder / "m.pvtu"), load_vtu<M>(folder / "m.vtu"));
  });
}
