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

constexpr auto known = standard_formats + soup_format{};
const std::string one = "0 0 0  1 0 0  0 1 0 # one\n";
const trimesh triangle({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
const tetmesh tet({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}});

struct nameless {};
static_assert(Format<obj_format> && Format<off_format> && Format<medit_format> && Format<hedra_format> && Format<hybrid_format> && Format<soup_format> && Format<both_format>);
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
  save_hybrid(tet, dir / "c");
  CHECK(num_polys(load_hybrid<tetmesh>(dir / "c")) == 1);
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
                       ((dir / "text") + ": the extension is not that of a known format; known extensions: " + extensions_of(known)).c_str(), unsupported);
  CHECK_THROWS_WITH_AS(load<trimesh>(dir / "text", {.format = soup_format{}}),
                       ((dir / "text") + ": the format soup is not among those of this call: " + names_of(standard_formats)).c_str(), unsupported);
  CHECK_THROWS_AS(load<trimesh>(dir / "a.obj", format_list{soup_format{}}), unsupported);
  CHECK_THROWS_AS(save(triangle, dir / "a.obj", format_list<>{}), unsupported);
}

TEST_CASE("format: throws if it cannot hold the mesh or be written in binary") {
  const temporary_folder dir;
  CHECK_THROWS_WITH_AS(save_text(tet, soup_format{}), "text: .soup cannot hold volumes; save it as .mesh or .hedra", unsupported);
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
