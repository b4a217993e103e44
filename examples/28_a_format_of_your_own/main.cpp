// Add a file format of your own: one struct states its name and what it can hold, and converts between text and flat arrays. Nothing is registered, and no
// file of the library changes. A call that gets the struct knows the format, and only formats that a call names are compiled.
#include <concino/io.hpp>
#include <concino/io/cell_builder.hpp>
#include <concino/mesh.hpp>

#include <fmt/core.h>

#include <variant>
#include <vector>

namespace cn = concino;

/// Triangles: the numbers of verts and triangles, the points, then three verts per triangle, numbered from 1. A # starts a comment.
struct triangle_list {
  static constexpr std::string_view name = "triangles", extensions[] = {".tri"};
  static constexpr bool holds_surfaces = true, holds_volumes = false;

  static void read(const cn::read_context& in, cn::file_contents& out) {
    cn::token_cursor words = in.words('#');
    const auto points = words.next_count("the number of verts", 6), triangles = words.next_count("the number of triangles", 6);
    for (std::uint64_t v = 0; v < points; ++v) out.surface.points.push_back({words.next_real("x"), words.next_real("y"), words.next_real("z")});
    for (std::uint64_t k = 0; k < 3 * triangles; ++k) out.surface.verts.push_back(cn::vert_id{words.next_index(points, "a vert")});
    out.surface.arity = 3;
  }
  static void write(cn::write_context& context, cn::flat_mesh& m) {
    if (m.poly_verts.arity != 3) context.throw_cannot_hold(".tri", {"polygons of other sizes"}, ".off");
    context.out << m.points.size() << ' ' << m.num_polys << '\n';
    for (const cn::vec3& p : m.points) context.out << p.x << ' ' << p.y << ' ' << p.z << '\n';
    for (std::size_t k = 0; k < m.poly_verts.values.size(); ++k) context.out << m.poly_verts.values[k].raw() + 1 << (k % 3 == 2 ? '\n' : ' ');
  }
};

/// Tets and hexes: the numbers of verts and cells, the points, then for each cell the number of its verts and these, numbered from 1. cell_builder
/// checks the cells, puts them into the standard order, and merges their common faces. It takes prisms, pyramids and polyhedra as well.
struct cell_list {
  static constexpr std::string_view name = "cells", extensions[] = {".cells"};
  static constexpr bool holds_surfaces = false, holds_volumes = true, is_read_only = true;

  static void read(const cn::read_context& in, cn::volume_contents& out) {
    cn::token_cursor words = in.words('#');
    const auto verts = words.next_count("the number of verts", 6), cells = words.next_count("the number of cells", 10);
    std::vector<cn::vec3> points;
    for (std::uint64_t v = 0; v < verts; ++v) points.push_back({words.next_real("x"), words.next_real("y"), words.next_real("z")});
    cn::cell_builder builder(in, points, 1);
    for (std::uint64_t c = 0; c < cells; ++c) {
      words.skip();
      const char* const position = words.at;
      const auto n = words.next_integer("the number of verts of a cell");
      if (n != 4 && n != 8) words.fail(position, "a cell of 4 or 8 verts");
      cn::vert_id v[8];
      for (std::int64_t k = 0; k < n; ++k) v[k] = cn::vert_id{words.next_index(verts, "a vert")};
      if (!builder.add_cell(n == 4 ? cn::cell_shape::tet : cn::cell_shape::hex, v)) words.fail(position, {builder.expected}, {builder.found});
    }
    builder.finish(out);
  }
};

int main() {
  // Your format and those of the library: the extension selects one. As with all formats, the file appears only when it is complete.
  constexpr auto formats = cn::standard_formats + triangle_list{};
  const cn::polygonmesh roof({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 1}}, {{0, 1, 2}, {0, 2, 3}});
  cn::save(roof, "roof.tri", formats);
  fmt::print("{}", cn::file_text("roof.tri").text());
  cn::save(cn::load<cn::trimesh>("roof.tri", formats), "roof.obj", formats);
  const auto any = cn::load_any("roof.obj", formats);
  fmt::print("roof.obj: {} polys\n", std::visit([](const auto& m) { return cn::num_polys(m); }, any));

  // Your format alone, which needs no file name; and one of the library's.
  fmt::print("text: {}", cn::save_text(cn::load_text<cn::trimesh>("3 1  0 0 0  1 0 0  0 0.5 0  1 2 3", triangle_list{}), triangle_list{}));
  fmt::print("load_obj: {} verts\n", cn::num_verts(cn::load_obj<cn::trimesh>("roof.obj")));

  // A volume: two tets, one of them inside out.
  cn::load_report report;
  const auto tets = cn::load_text<cn::polyhedralmesh>("5 2  0 0 0  1 0 0  0 1 0  0 0 1  0 0 -1  4 1 2 3 4  4 1 2 3 5", cell_list{}, {.report = &report});
  fmt::print("cells: {} polys, {} faces; {}\n", cn::num_polys(tets), cn::num_faces(tets), report.notes[0]);

  // Errors name the line. A mesh that the format cannot hold is refused: no file is created or changed.
  try {
    cn::load_text<cn::trimesh>("3 1\n0 0 0\n1 0 0\n0 1 0\n1 2 4\n", triangle_list{});
  } catch (const cn::parse_error& e) {
    fmt::print("{}\n", e.what());
  }
  try {
    cn::save(cn::tetmesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}), "tet.tri", formats);
  } catch (const cn::unsupported& e) {
    fmt::print("{}\n", e.what());
  }
}
