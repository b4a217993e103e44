#include <concino/io/format.hpp>

#include <concino/io.hpp>
#include <concino/mesh.hpp>

#include <support/formats.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

#include <limits>

using namespace concino;
using namespace concino::testing;

namespace {

/// A format that stores triangles as nine numbers each.
struct soup_format {
  static constexpr std::string_view name = "soup";
  static constexpr std::string_view extensions[] = {".soup", ".tris"};
  static constexpr bool holds_surfaces = true, holds_volumes = false;
  static void read(const read_context& in, file_contents& out) {
    out.surface.arity = 3;
    token_cursor words = in.words('#');
    for (words.skip(); !words.at_end(); words.skip()) {
      out.surface.verts.push_back(vert_id{out.surface.points.size()});
      const double x = words.next_real("x"), y = words.next_real("y");
      out.surface.points.push_back({x, y, words.next_real("z")});
    }
  }
  static void write(write_context& out, flat_mesh& m) {
    for (std::size_t p = 0; p < m.num_polys; ++p, out.report_progress())
      for (const vert_id v : m.poly_verts[p]) out.out << m.points[v.raw()].x << ' ' << m.points[v.raw()].y << ' ' << m.points[v.raw()].z << '\n';
  }
};

/// A format for surfaces and volumes, whose first word is the dimension. Its reader only fills volume_contents. It has offsets, though sizes are equal.
struct both_format {
  static constexpr const char* name = "both";
  static constexpr std::array<const char*, 1> extensions = {".soup"};
  static constexpr bool holds_surfaces = true, holds_volumes = true, has_binary = true;
  static bool has_signature(std::string_view text) { return text.starts_with("both"); }
  static void read(const read_context& in, volume_contents& out) {
    token_cursor words = in.words();
    words.word();
    const auto dimension = words.next_integer("2 or 3");
    const std::vector<vec3> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    if (dimension == 3) {
      out.filled = arrays_kind::cells;
      out.cells = {points, {vert_id{0}, vert_id{1}, vert_id{2}, vert_id{3}}, 4};
    } else {
      out.surface = {points, {0, 3, 6}, {vert_id{0}, vert_id{1}, vert_id{2}, vert_id{1}, vert_id{3}, vert_id{2}}, 0};
    }
    in.report->notes.push_back("both");
  }
  static void write(write_context& out, flat_mesh& m) {
    out.out << "both " << m.dimension << (out.options.binary ? " binary" : "") << '\n';
    if (m.dimension == 3) out.throw_cannot_hold(".soup", {"volumes yet"}, ".mesh");
  }
};

/// A format with properties of every kind. Its text is not read.
struct column_format {
  static constexpr std::string_view name = "columns";
  static constexpr std::string_view extensions[] = {".columns"};
  static constexpr bool holds_surfaces = true, holds_volumes = true;
  static void read(const read_context& in, volume_contents& out) {
    const std::vector<vec3> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
    const auto ids = [](std::initializer_list<unsigned> all) {
      std::vector<vert_id> r;
      for (const unsigned i : all) r.push_back(vert_id{i});
      return r;
    };
    if (in.text.ends_with('2')) {
      out.surface = {points, {0, 3, 7}, ids({0, 1, 2, 1, 4, 3, 2}), 0};
      double* const u = out.add_property<double>(element_kind::corner, "u", 7);
      for (int i = 0; i < 7; ++i) u[i] = i;
      return;
    }
    out.filled = arrays_kind::cells;
    out.cells = {points, ids({0, 1, 2, 3, 1, 2, 3, 4}), 4};
    double* const height = out.add_property<double>(element_kind::vert, "height", 5);
    for (int i = 0; i < 5; ++i) height[i] = i + 0.5;
    out.add_property<int>(element_kind::vert, "height", 5);
    std::array<float, 2>* const pair = out.add_property<std::array<float, 2>>(element_kind::poly, "pair", 2);
    pair[1] = {5, 6};
    *out.add_property<int>(element_kind::mesh, "step", 1) = 7;
    out.faces.verts = ids({2, 1, 0, 3, 1, 2, 0, 1, 4});
    out.faces.offsets = {0, 3, 6, 9};
    int* const label = out.add_property<int>(element_kind::face, "label", 3);
    label[0] = 11, label[1] = 12, label[2] = 13;
    out.edges.verts = ids({4, 1});
    out.edges.end_element();
    *out.add_property<int>(element_kind::edge, "sharp", 1) = 1;
  }
  static void write(write_context& out, flat_mesh& m) {
    for (const flat_property& p : m.property_list()) {
      out.declare_stored(p.kind, p.name, *p.type);
      const std::size_t n = p.kind == element_kind::mesh ? 1 : p.kind == element_kind::vert ? m.points.size() - 1 : p.kind == element_kind::face ? m.polyhedra().face_verts.size() : m.num_polys;
      out.out << to_string(p.kind) << ' ' << p.name << ' ' << n;
      if (const auto d = p.as<double>()) out.out << " d" << d[n - 1];
      if (const auto i = p.as<int>(); i && p.kind == element_kind::mesh) out.out << " i" << i[0];
      out.out << '\n';
    }
  }
};

/// A format that is only read: lines of three numbers, the verts.
struct points_format {
  static constexpr std::string_view name = "points";
  static constexpr std::string_view extensions[] = {".points"};
  static constexpr bool holds_surfaces = true, holds_volumes = false, is_read_only = true;
  static void read(const read_context& in, file_contents& out) {
    token_cursor words = in.words();
    for (words.skip(); !words.at_end(); words.skip()) {
      const double x = words.next_real("x"), y = words.next_real("y");
      out.surface.points.push_back({x, y, words.next_real("z")});
    }
    out.surface.arity = 3;
  }
};

/// A format that is only written: the number of polys.
struct count_format {
  static constexpr std::string_view name = "count";
  static constexpr std::string_view extensions[] = {".count"};
  static constexpr bool holds_surfaces = true, holds_volumes = false, is_write_only = true;
  static void write(write_context& out, flat_mesh& m) { out.out << m.num_polys << '\n'; }
};

constexpr auto known = standard_formats + soup_format{};
const std::string one = "0 0 0  1 0 0  0 1 0 # one\n";
const trimesh triangle({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
const tetmesh tet({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}});

struct nameless {};
static_assert(Format<obj_format> && Format<off_format> && Format<medit_format> && Format<hedra_format> && Format<hybrid_format> && Format<iv_format> && Format<tet_format> && Format<soup_format> && Format<both_format>);
struct without_writer : points_format {
  static constexpr bool is_read_only = false;
};
static_assert(Format<points_format> && !Format<without_writer>);
struct without_reader : count_format {
  static constexpr bool is_write_only = false;
};
static_assert(Format<count_format> && !Format<without_reader>);
static_assert(!Format<nameless> && !Format<int> && !Format<load_options> && !Format<format_id>);
static_assert(Formats<soup_format> && Formats<std::remove_const_t<decltype(known)>> && !Formats<nameless> && !Formats<load_options>);
static_assert(format_id(soup_format{}) != file_format::obj && format_id(file_format::obj) == format_id(obj_format{}) && format_id() == file_format::by_extension);
static_assert(known.ids().size() == standard_formats.ids().size() + 1 && known.ids().back().name() == "soup");

}  // namespace

TEST_CASE("format: a format argument takes precedence over the extension") {
  const temporary_folder dir;
  for (const std::string name : {"a.soup", "b.obj", "c"}) {
    write_file(dir / name, one);
    CHECK(num_polys(load<trimesh>(dir / name, soup_format{})) == 1);
    CHECK(load_any(dir / name, soup_format{}).index() == 0);
    save(triangle, dir / name, soup_format{});
    CHECK(read_file(dir / name) == "0 0 0\n1 0 0\n0 1 0\n");
  }
  CHECK(num_polys(load_text<trimesh>(one, soup_format{})) == 1);
  CHECK(save_text(triangle, soup_format{}) == "0 0 0\n1 0 0\n0 1 0\n");
  save_off(triangle, dir / "c");
  CHECK(read_file(dir / "c").starts_with("OFF"));
  CHECK(num_polys(load_off<trimesh>(dir / "c")) == 1);
  save_obj(triangle, dir / "c");
  CHECK(num_polys(load_obj<trimesh>(dir / "c")) == 1);
  save_medit(tet, dir / "c");
  CHECK(num_polys(load_medit<tetmesh>(dir / "c")) == 1);
  save_tet(tet, dir / "c");
  CHECK(num_polys(load_tet<tetmesh>(dir / "c")) == 1);
  save_hybrid(tet, dir / "c");
  CHECK(num_polys(load_hybrid<tetmesh>(dir / "c")) == 1);
  save_vtu(tet, dir / "c");
  CHECK(num_polys(load_vtu<tetmesh>(dir / "c")) == 1);
  save_vtp(triangle, dir / "c", {.binary = true});
  CHECK(num_polys(load_vtp<trimesh>(dir / "c")) == 1);
  save_ply(triangle, dir / "c", {.binary = true});
  CHECK(num_polys(load_ply<trimesh>(dir / "c")) == 1);
  save_stl(triangle, dir / "c", {.binary = true});
  CHECK(num_polys(load_stl<trimesh>(dir / "c")) == 1);
  save_ovm(tet, dir / "c");
  CHECK(num_polys(load_ovm<tetmesh>(dir / "c")) == 1);
  save_gmsh(tet, dir / "c", {.binary = true});
  CHECK(num_polys(load_gmsh<tetmesh>(dir / "c")) == 1);
  save_smesh(triangle, dir / "c");
  CHECK(num_polys(load_smesh<trimesh>(dir / "c")) == 1);
  save_poly(triangle, dir / "c");
  CHECK(num_polys(load_poly<trimesh>(dir / "c")) == 1);
  save_ele(tet, dir / "c");  // and c.node
  CHECK(num_polys(load_ele<tetmesh>(dir / "c")) == 1);
  save_vtk(tet, dir / "c");
  CHECK(num_polys(load_vtk<tetmesh>(dir / "c")) == 1);
  save_hedra(tet, dir / "c");
  CHECK(num_polys(load_hedra<tetmesh>(dir / "c")) == 1);
}

TEST_CASE("format: the extension or the options choose from a list") {
  const temporary_folder dir;
  for (const std::string name : {"a.soup", "b.TRIS"}) {
    save(triangle, dir / name, known);
    CHECK(num_polys(load<trimesh>(dir / name, known)) == 1);
  }
  save(triangle, dir / "a.obj", known);
  CHECK(num_polys(load<trimesh>(dir / "a.obj", known)) == 1);
  write_file(dir / "text", one);
  CHECK(num_polys(load<trimesh>(dir / "text", known, {.format = soup_format{}})) == 1);
  CHECK(num_polys(load_text<trimesh>(one, known, {.format = soup_format{}})) == 1);
  CHECK(save_text(triangle, known, {.format = file_format::off}).starts_with("OFF"));
  CHECK_THROWS_AS(load_text<trimesh>(one, known), invalid_argument);
  CHECK_THROWS_AS(save_text(triangle, known), invalid_argument);
  CHECK_THROWS_WITH_AS(load<trimesh>(dir / "text", known),
                       ((dir / "text") + ": neither the extension nor the first words are those of a known format; known extensions: " + extensions_of(known) + "; known first words: " + signatures_of(known)).c_str(), unsupported);
  CHECK_THROWS_WITH_AS(load<trimesh>(dir / "text", {.format = soup_format{}}),
                       ((dir / "text") + ": the format soup is not among those of this call: " + names_of(standard_formats)).c_str(), unsupported);
  CHECK_THROWS_AS(load<trimesh>(dir / "a.obj", format_list{soup_format{}}), unsupported);
  CHECK_THROWS_AS(save(triangle, dir / "a.obj", format_list<>{}), unsupported);
}

TEST_CASE("format: throws if it cannot hold the mesh or be written in binary") {
  const temporary_folder dir;
  CHECK_THROWS_WITH_AS(save_text(tet, soup_format{}), "text: .soup cannot hold volumes, unless options.as_boundary is set; save it as .mesh or .hedra", unsupported);
  CHECK_THROWS_WITH_AS(save_text(triangle, soup_format{}, {.binary = true}), "text: .soup cannot be written in binary; use binary = false", unsupported);
  CHECK_THROWS_AS(load_text<tetmesh>(one, soup_format{}), unsupported);
  CHECK_THROWS_AS(load_text<quadmesh>(one, soup_format{}), invalid_mesh);
  CHECK_THROWS_WITH_AS(load_text<trimesh>("0 0 x", soup_format{}), "text:1: expected z, found 'x'", parse_error);
  CHECK_THROWS_AS(load_text<trimesh>("0 0 0", soup_format{}), invalid_mesh);
  trimesh m = triangle;
  vert_property<int>(m, "n");
  save_report r;
  save_text(m, soup_format{}, {.report = &r});
  CHECK(r.lost == std::vector<std::string>{"vert property \"n\": .soup cannot store it"});
  set_point(m, vert_id{1}, vec3{0, std::numeric_limits<double>::infinity(), 0});
  save(triangle, dir / "f", soup_format{});
  CHECK_THROWS_WITH_AS(save(m, dir / "f", soup_format{}),
                       ((dir / "f") + ": vert 1 has a coordinate that is not a finite number; no file can hold it").c_str(), invalid_mesh);
  CHECK(read_file(dir / "f") == "0 0 0\n1 0 0\n0 1 0\n");
  CHECK(dir.num_files() == 1);
}

TEST_CASE("format: a format that is only read is not offered to save") {
  const temporary_folder dir;
  write_file(dir / "a.points", "0 0 0 1 0 0");
  constexpr auto some = format_list{soup_format{}, points_format{}};
  CHECK(num_verts(load<trimesh>(dir / "a.points", some)) == 2);
  const std::string where = (dir / "a.points") + ": .points can be read, but not written";
  CHECK_THROWS_WITH_AS(save(triangle, dir / "a.points", some), (where + "; formats that can be written: .soup").c_str(), unsupported);
  CHECK_THROWS_WITH_AS(save(triangle, dir / "a.points", points_format{}), where.c_str(), unsupported);
  CHECK_THROWS_WITH_AS(save(tet, dir / "b.obj", some, {.format = points_format{}}), ((dir / "b.obj") + ": .points can be read, but not written; formats that can be written: .soup").c_str(), unsupported);
  CHECK_THROWS_WITH_AS(save_text(triangle, points_format{}), ".points can be read, but not written", unsupported);
  CHECK(read_file(dir / "a.points") == "0 0 0 1 0 0");
  CHECK(dir.num_files() == 1);
  CHECK_THROWS_WITH_AS(save(triangle, dir / "a.iv"), doctest::Contains("a.iv: .iv can be read, but not written; formats that can be written: .obj, .off, "), unsupported);
}

TEST_CASE("format: a format can be written only") {
  const temporary_folder dir;
  save(triangle, dir / "a.count", known + count_format{});
  CHECK(read_file(dir / "a.count") == "1\n");
  CHECK(save_text(triangle, count_format{}) == "1\n");
  CHECK_THROWS_WITH_AS(load<trimesh>(dir / "a.count", known + count_format{}), doctest::Contains("a.count: .count can be written, but not read; formats that can be read: .obj, .off, "), unsupported);
  CHECK_THROWS_WITH_AS(load<trimesh>(dir / "a.count", count_format{}), ((dir / "a.count") + ": .count can be written, but not read").c_str(), unsupported);
  CHECK_THROWS_WITH_AS(load_text<trimesh>("1", count_format{}), "text: .count can be written, but not read", unsupported);
  CHECK_THROWS_WITH_AS(load_text<polyhedralmesh>("", file_format::gltf), "text: .glb can be written, but not read", unsupported);
  CHECK_THROWS_WITH_AS(load_text<trimesh>("", format_id(file_format::gltf)), doctest::Contains("text: .glb can be written, but not read; formats that can be read: .obj, "), unsupported);
  save(triangle, dir / "a.glb");
  CHECK_THROWS_AS(load<tetmesh>(dir / "a.glb"), unsupported);
  CHECK_THROWS_AS(load_any(dir / "a.glb"), unsupported);
  save(triangle, dir / "b.glb", {.format = file_format::off});
  load_report report;
  CHECK(num_polys(load<trimesh>(dir / "b.glb", {.report = &report})) == 1);  // it begins like another format
  CHECK(report.notes.size() == 1);
}

TEST_CASE("format: a reader of volumes can return surfaces") {
  load_report r;
  CHECK(num_polys(load_text<trimesh>("both 2", both_format{}, {.report = &r})) == 2);
  CHECK(r.notes.size() == 1);
  CHECK(num_polys(load_text<tetmesh>("both 3", both_format{})) == 1);
  CHECK(num_polys(load_text<polyhedralmesh>("both 3", both_format{})) == 1);
  CHECK_THROWS_WITH_AS(load_text<trimesh>("both 3", both_format{}),
                       "text: holds a volume of 1 polyhedra, but a surface mesh was requested; load it as polyhedralmesh or with load_any", unsupported);
  CHECK_THROWS_WITH_AS(load_text<tetmesh>("both 2", both_format{}),
                       "text: holds a surface of 2 polygons, but a volume mesh was requested; load it as polygonmesh or with load_any", unsupported);
  CHECK(save_text(triangle, both_format{}, {.binary = true}) == "both 2 binary\n");
  CHECK_THROWS_WITH_AS(save_text(tet, both_format{}), "text: .soup cannot hold volumes yet; save it as .mesh", unsupported);
}

TEST_CASE("format: among formats with the same extension the signature decides, then the order") {
  const temporary_folder dir;
  constexpr auto first = known + both_format{};
  constexpr auto second = format_list{both_format{}, soup_format{}};
  write_file(dir / "one.soup", one);
  write_file(dir / "two.soup", "both 2");
  CHECK(num_polys(load<trimesh>(dir / "one.soup", first)) == 1);
  CHECK(num_polys(load<trimesh>(dir / "two.soup", first)) == 2);
  CHECK(num_polys(load<trimesh>(dir / "one.soup", second)) == 1);
  CHECK(num_polys(load<trimesh>(dir / "two.soup", second)) == 2);
  CHECK(load_any(dir / "two.soup", second).index() == 0);  // the sizes are equal, so the mesh has an arity
  save(triangle, dir / "three.soup", first);
  CHECK(read_file(dir / "three.soup") == "both 2\n");
  save(triangle, dir / "three.soup", second);
  CHECK(read_file(dir / "three.soup").starts_with("0 0 0"));
  CHECK(medit_format::has_signature("# a comment\n MeshVersionFormatted 2"));
  CHECK(!medit_format::has_signature("MeshVersionUnformatted 2"));
  CHECK(!medit_format::has_signature(""));
}

TEST_CASE("format: a signature decides against the extension, and the report says so") {
  const temporary_folder dir;
  const std::string off = "# a comment\nCOFF\n3 1 0\n0 0 0 1 1 1 1\n1 0 0 1 1 1 1\n0 1 0 1 1 1 1\n3 0 1 2\n";
  for (const std::string name : {"a.obj", "a.mesh", "a.soup", "a.unknown", "a"}) {
    write_file(dir / name, off);
    load_report r;
    CHECK(num_polys(load<trimesh>(dir / name, known, {.report = &r})) == 1);
    REQUIRE(!r.notes.empty());
    CHECK(r.notes.back() == "the extension is not .off, but the text begins like a file of that format, off, and was read as one");
  }
  load_report r;
  write_file(dir / "a.off", off);
  load<trimesh>(dir / "a.off", {.report = &r});
  for (const std::string& note : r.notes) CHECK(note.find("extension") == std::string::npos);
  write_file(dir / "b.off", off.substr(17));  // without its first word it is still an .off file
  CHECK(num_polys(load<trimesh>(dir / "b.off")) == 1);
  // a format that the caller names is not changed
  CHECK_THROWS_AS(load_medit<trimesh>(dir / "a.mesh"), parse_error);
  CHECK_THROWS_AS(load<trimesh>(dir / "a.mesh", {.format = file_format::medit}), parse_error);
  for (const std::string word : {"OFF", "STCN4nOFF 3", "NOFF\n", "NCOFF", "OFF4 4 0"}) CHECK(off_format::has_signature(word));
  for (const std::string word : {"", "OFFS", "off", "NCNOFF", "3 1 0", "#OFF"}) CHECK(!off_format::has_signature(word));
}

TEST_CASE("format: strict writers throw if anything would be lost, before they touch the file") {
  const temporary_folder dir;
  trimesh m = triangle;
  save(m, dir / "a.obj", {.strict = true});
  const std::string before = read_file(dir / "a.obj");
  vert_property<int>(m, "n");
  CHECK_THROWS_WITH_AS(save(m, dir / "a.obj", {.strict = true}),
                       ((dir / "a.obj") + ": the file would lose something, and options.strict is set: vert property \"n\": .obj cannot store it").c_str(), unsupported);
  CHECK(read_file(dir / "a.obj") == before);
  CHECK_THROWS_AS(save(m, dir / "b.obj", {.strict = true}), unsupported);
  CHECK(dir.num_files() == 1);
  CHECK_THROWS_AS(save_text(m, soup_format{}, {.strict = true}), unsupported);
  CHECK(save_text(triangle, soup_format{}, {.strict = true}) == "0 0 0\n1 0 0\n0 1 0\n");
  save_report r;
  save(m, dir / "a.obj", {.report = &r});
  CHECK(r.lost.size() == 1);
}

TEST_CASE("format: readers and writers of properties of any name and type") {
  load_report r;
  const tetmesh m = load_text<tetmesh>("columns", column_format{}, {.report = &r});
  CHECK(find_vert_property<double>(m, "height")[vert_id{3}] == 3.5);
  CHECK(find_poly_property<std::array<float, 2>>(m, "pair")[poly_id{1}] == std::array<float, 2>{5, 6});
  CHECK(*find_mesh_property<int>(m, "step") == 7);
  const auto label = find_face_property<int>(m, "label");
  std::vector<int> labels;
  for (const auto f : faces(m))
    if (label[f] != 0) labels.push_back(label[f]);
  std::sort(labels.begin(), labels.end());
  CHECK(labels == std::vector<int>{11, 12});
  for (const auto f : faces(m)) {
    std::size_t num_incident = 0;
    for (const auto p : adj_f2p(m, f)) num_incident += p == p;
    if (label[f] == 12) CHECK(num_incident == 2);  // the face 1 2 3, listed as 3 1 2
  }
  const auto sharp = find_edge_property<int>(m, "sharp");
  std::size_t num_sharp = 0;
  for (const auto e : edges(m)) num_sharp += sharp[e] == 1;
  CHECK(num_sharp == 1);
  CHECK(r.skipped == std::vector<std::string>{"values of 1 elements of kind face that the mesh does not have"});
  CHECK(r.notes == std::vector<std::string>{"another vert property \"height\" in the file is the property \"height_2\""});
  CHECK(save_text(m, column_format{}) == "vert height 4 d3.5\nvert height_2 4\npoly pair 2\nface label 7\nmesh step 1 i7\n");
  const auto bare = load_text<cell_arrays>("columns", column_format{}, {.report = &r});
  CHECK(bare.num_polys() == 2);
  CHECK(r.skipped.size() == 6);
  CHECK(r.skipped[0] == "vert property \"height\"");
}

TEST_CASE("format: values of corners follow the verts of the polys") {
  const polygonmesh m = load_text<polygonmesh>("columns 2", column_format{});
  const auto u = find_corner_property<double>(m, "u");
  std::vector<double> values;
  for (const auto p : polys(m))
    for (const double x : u.of(p)) values.push_back(x);
  CHECK(values == std::vector<double>{0, 1, 2, 3, 4, 5, 6});
}
