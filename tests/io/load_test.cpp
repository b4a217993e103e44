#include <concino/io/load.hpp>

#include <support/kinds.hpp>
#include <support/reading.hpp>
#include <support/formats.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

#include <unistd.h>

using namespace concino;
using namespace concino::testing;

namespace {

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
const std::string tet_and_labels =
    "MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 0 0\n1 0 0 7\n0 1 0 0\n0 0 1 0\nTetrahedra\n1\n1 2 3 4 -3\nEnd\n";
const std::string mixed =
    "MeshVersionFormatted 2\nDimension 3\nVertices 9\n0 0 0 0  1 0 0 0  1 1 0 0  0 1 0 0\n0 0 1 0  1 0 1 0  1 1 1 0  0 1 1 0  0.5 0.5 2 0\n"
    "Hexahedra 1\n1 2 3 4 5 6 7 8 0\nPyramids 1\n5 6 7 8 9 0\nEnd";

template<class M>
M from(const std::string& text, format_id f) {
  return load_text<M>(text, f);
}

static_assert(Loadable<trimesh> && Loadable<polyhedralmesh> && Loadable<surface_arrays> && !Loadable<int> && !Loadable<std::string>);
static_assert(concino::detail::from_surface<trimesh> && !concino::detail::from_cells<trimesh> && !concino::detail::from_polyhedra<trimesh>);
static_assert(!concino::detail::from_surface<tetmesh> && concino::detail::from_cells<tetmesh> && !concino::detail::from_polyhedra<tetmesh>);
static_assert(!concino::detail::from_surface<polyhedralmesh> && !concino::detail::from_cells<polyhedralmesh> && concino::detail::from_polyhedra<polyhedralmesh>);

}  // namespace

TEST_CASE("load: the extension decides, in upper or lower case") {
  const temporary_folder dir;
  for (const std::string name : {"a.obj", "b.OBJ", "c.tar.Obj"}) {
    write_file(dir / name, square + "f 1 2 3\n");
    CHECK(num_polys(load<trimesh>(dir / name)) == 1);
  }
  write_file(dir / "d.txt", square + "f 1 2 3 4\n");
  CHECK_THROWS_WITH_AS(load<polygonmesh>(dir / "d.txt"),
                       ((dir / "d.txt") + ": neither the extension nor the first words are those of a known format; known extensions: " + extensions_of(standard_formats) + "; known first words: " + signatures_of(standard_formats)).c_str(),
                       unsupported);
  CHECK(num_polys(load<polygonmesh>(dir / "d.txt", {.format = file_format::obj})) == 1);
  CHECK_THROWS_AS(load<trimesh>(".obj"), io_error);
  CHECK_THROWS_AS(load<trimesh>(""), io_error);
  CHECK_THROWS_AS(load<trimesh>(dir / "none.obj"), io_error);
  CHECK_THROWS_AS(load_text<trimesh>("", file_format::by_extension), invalid_argument);
}

TEST_CASE("load: reading, mapping and a pipe give the same mesh") {
  const temporary_folder dir;
  const std::string text = square + "f 1 2 3 4\n";
  write_file(dir / "a.obj", text);
  const auto read = load<polygonmesh>(dir / "a.obj"), mapped = load<polygonmesh>(dir / "a.obj", {.map = true});
  int ends[2];
  REQUIRE(::pipe(ends) == 0);
  REQUIRE(::write(ends[1], text.data(), text.size()) == static_cast<::ssize_t>(text.size()));
  ::close(ends[1]);
  const auto piped = load<polygonmesh>("/dev/fd/" + std::to_string(ends[0]), {.format = file_format::obj});
  ::close(ends[0]);
  for (const polygonmesh* m : {&mapped, &piped}) CHECK(listed(*m) == listed(read));
  CHECK_THROWS_AS(load<polygonmesh>("/dev/zero", {.format = file_format::obj}), io_error);
}

TEST_CASE("load: a file that shrinks or grows while it is read is an io_error") {
  const temporary_folder dir;
  const std::string path = dir / "a.obj", text = square + "f 1 2 3 4\n";
  for (const bool grow : {false, true}) {
    write_file(path, text);
    const auto change = [&](double, std::string_view) {
      std::filesystem::resize_file(path, text.size() + 10 * grow);
      return true;
    };
    // Files that are read do not change any more; files that are mapped may.
    CHECK(num_polys(load<polygonmesh>(path, {.progress = change})) == 1);
    write_file(path, text);
    CHECK_THROWS_WITH_AS(load<polygonmesh>(path, {.progress = [&](double done, std::string_view) {
                                                   if (done == 1.0) std::filesystem::resize_file(path, text.size() - 1 + 10 * grow);
                                                   return true;
                                                 }, .map = true}),
                         (path + (grow ? ": grew" : ": shrank") + " while it was read; load it again once it is complete").c_str(), io_error);
  }
}

TEST_CASE("load: parse errors name the path") {
  const temporary_folder dir;
  write_file(dir / "bad.obj", square + "f 1 2 9\n");
  try {
    load<trimesh>(dir / "bad.obj");
    FAIL("no error");
  } catch (const parse_error& e) {
    CHECK(e.file == dir / "bad.obj");
    CHECK(e.line == 5);
    CHECK(e.found == "'9'");
  }
}

TEST_CASE("load: the error names the line of the first poly that the mesh cannot hold") {
  const std::string both = square + "f 1 2 3\nf 1 2 3 4\n";
  CHECK(bad_line<trimesh>(both, file_format::obj) == 6);
  CHECK(bad_line<quadmesh>(both, file_format::obj) == 5);
  CHECK(num_polys(from<polygonmesh>(both, file_format::obj)) == 2);
  CHECK(num_polys(from<polygonmesh>(square + "f 1 2 3\n", file_format::obj)) == 1);

  const std::string surface =
      "MeshVersionFormatted 2\nDimension 3\nVertices 4 0 0 0 0 1 0 0 0 1 1 0 0 0 1 0 0\nQuadrilaterals 1\n1 2 3 4 0\nTriangles 1\n1 2 3 "
      "0\nEnd";
  CHECK(bad_line<trimesh>(surface, file_format::medit) == 5);
  CHECK(bad_line<quadmesh>(surface, file_format::medit) == 7);
  CHECK(num_polys(from<polygonmesh>(surface, file_format::medit)) == 2);

  CHECK(bad_line<tetmesh>(mixed, file_format::medit) == 7);
  CHECK(bad_line<hexmesh>(mixed, file_format::medit) == 9);
  CHECK(bad_line<hexmesh>(tet_and_labels, file_format::medit) == 11);
  const auto all = from<polyhedralmesh>(mixed, file_format::medit);
  CHECK(num_polys(all) == 2);
  CHECK(num_faces(all) == 10);

  const std::string hedra = "4 4 1\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 1 3 2\n3 1 2 4\n3 2 3 4\n3 1 4 3\n4 1 2 3 4\n";
  CHECK(num_polys(from<tetmesh>(hedra, file_format::hedra)) == 1);
  CHECK(bad_line<hexmesh>(hedra, file_format::hedra) == 10);
}

TEST_CASE("load: a polyhedralmesh can hold any volume") {
  const auto m = from<polyhedralmesh>(tet_and_labels, file_format::medit);
  CHECK(num_polys(m) == 1);
  CHECK(num_faces(m) == 4);
  for (const auto f : adj_p2f(m, poly_id{0})) CHECK(face_is_outward(m, poly_id{0}, f));
}

TEST_CASE_TEMPLATE("load: throws if a volume is loaded as a surface or the reverse", M, CONCINO_ALL_KINDS) {
  if constexpr (dimension_v<M> == 2) {
    CHECK_THROWS_WITH_AS(from<M>(tet_and_labels, file_format::medit),
                         "text: holds a volume of 1 polyhedra, but a surface mesh was requested; load it as polyhedralmesh or with load_any",
                         unsupported);
    CHECK_THROWS_AS(from<M>(mixed, file_format::medit), unsupported);
    CHECK_THROWS_AS(from<M>("0 0 0", file_format::hedra), unsupported);
  } else {
    CHECK_THROWS_WITH_AS(from<M>(square + "f 1 2 3\n", file_format::obj),
                         "text: holds a surface, but a volume mesh was requested; load it as polygonmesh or with load_any", unsupported);
  }
}

TEST_CASE("load: labels become a property if one is not zero") {
  const auto m = from<tetmesh>(tet_and_labels, file_format::medit);
  const auto v = find_vert_property<int>(m, "label");
  const auto p = find_poly_property<int>(m, "label");
  REQUIRE(bool(v));
  REQUIRE(bool(p));
  CHECK(v[vert_id{0}] == 0);
  CHECK(v[vert_id{1}] == 7);
  CHECK(v[vert_id{3}] == 0);
  CHECK(p[poly_id{0}] == -3);
  CHECK(property_list(from<polyhedralmesh>(mixed, file_format::medit)).empty());
  load_report r;
  load_text<cell_arrays>(tet_and_labels, file_format::medit, {.report = &r});
  CHECK(r.skipped == std::vector<std::string>{"labels of verts", "labels of polys"});
}

TEST_CASE("load: progress ends at 1, and cancelling throws") {
  std::string text = square;
  for (int i = 0; i < 1000; ++i) text += "f 1 2 3\n";
  std::vector<double> told;
  const auto hear = [&](double f, const char*) {
    told.push_back(f);
    return true;
  };
  load_text<trimesh>(text, file_format::obj, {.progress = hear});
  CHECK(told.size() > 50);
  CHECK(std::is_sorted(told.begin(), told.end()));
  CHECK(told.back() == 1);
  CHECK_THROWS_AS(load_text<trimesh>(text, file_format::obj, {.progress = [](double f, const char*) { return f < 0.5; }}), cancelled);
}

TEST_CASE("load: clears the report first") {
  load_report r;
  r.notes = r.skipped = {"old"};
  r.reoriented_polys = 9;
  load_text<trimesh>(square + "f 1 2 3\n", file_format::obj, {.report = &r});
  CHECK(r.notes.empty());
  CHECK(r.skipped.empty());
  CHECK(r.reoriented_polys == 0);
}
