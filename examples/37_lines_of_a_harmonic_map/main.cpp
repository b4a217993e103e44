// Iso-lines: where a function on a surface has a value. They come joined to polylines, which know where they cross the edges of the mesh. Here: the lines of a
// harmonic map on a ring, their lengths, the area between them, and a line as edges. On a ring the map is a logarithm, so the results can be checked.
#include <concino/convert.hpp>
#include <concino/fields.hpp>
#include <concino/generate.hpp>
#include <concino/geometry.hpp>
#include <concino/level_sets.hpp>
#include <concino/mesh.hpp>
#include <concino/render/scene.hpp>
#include <concino/render/scene_png.hpp>

#include <fmt/core.h>

#include <cmath>
#include <utility>
#include <vector>

namespace cn = concino;

int main(int argc, char** argv) {
  // A flat ring of quads between the radii 1 and 4: a grid, rolled up.
  const unsigned around = 96, across = 24;
  cn::surface_arrays a;
  a.arity = 4;
  for (unsigned j = 0; j <= across; ++j)
    for (unsigned i = 0; i < around; ++i) {
      const double angle = 2 * 3.141592653589793 * i / around, radius = 1 + 3.0 * j / across;
      a.points.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
    }
  const auto vert = [&](unsigned i, unsigned j) { return cn::vert_id{j * around + i % around}; };
  for (unsigned j = 0; j < across; ++j)
    for (unsigned i = 0; i < around; ++i) a.verts.insert(a.verts.end(), {vert(i, j), vert(i, j + 1), vert(i + 1, j + 1), vert(i + 1, j)});
  const cn::quadmesh m(a);

  // 0 on the inner boundary, 1 on the outer one, harmonic between.
  std::vector<std::pair<cn::vert_id, double>> fixed;
  for (unsigned i = 0; i < around; ++i) fixed.push_back({vert(i, 0), 0}), fixed.push_back({vert(i, across), 1});
  const auto u = cn::harmonic_map(m, fixed);

  for (const auto& line : cn::isolines(m, u, {0.25, 0.5, 0.75})) {
    double length = 0;
    for (std::size_t i = 0; i < line.points.size(); ++i) length += cn::distance(line.points[i], line.points[(i + 1) % line.points.size()]);
    const double radius = std::pow(4, line.value);  // u = log(radius) / log(4)
    fmt::print("u = {:.2f}: {} points, {}, length {:.3f}; a circle has {:.3f}\n", line.value, line.points.size(), line.closed ? "closed" : "open", length,
               2 * 3.141592653589793 * radius);
  }

  // Areas between the lines, without making the parts.
  const auto areas = cn::measure_between(m, u, {0.0, 0.25, 0.5, 0.75, 1.0});
  for (std::size_t k = 0; k < areas.size(); ++k) {
    const double inner = std::pow(4, 0.25 * static_cast<double>(k)), outer = std::pow(4, 0.25 * static_cast<double>(k + 1));
    fmt::print("between {:.2f} and {:.2f}: area {:.3f}; a ring has {:.3f}\n", 0.25 * static_cast<double>(k), 0.25 * static_cast<double>(k + 1), areas[k],
               3.141592653589793 * (outer * outer - inner * inner));
  }

  // A point of a line lies on an edge of the mesh: values there are interpolated from its ends.
  const auto lines = cn::isolines(m, u, 0.5);
  const auto& on_edge = lines.front().edge_points.front();
  const auto [from, to] = cn::end_verts(m, on_edge.edge);
  fmt::print("the first point is at {:.3f} of the edge between verts {} and {}, where u is {:.3f} and {:.3f}\n", on_edge.parameter, from.raw(), to.raw(), u[from], u[to]);

  // A line can become edges of a mesh that has room for the parts of its polys: of triangles or of general polygons.
  auto polygons = cn::convert<cn::polygonmesh>(m);
  auto w = cn::make_vert_map<double>(polygons);
  for (const auto v : cn::verts(m)) w[v] = u[v];
  const auto line = cn::isolines(polygons, w, 0.6).front();
  const auto cut = cn::embed_path(polygons, line.places, {.closed = line.closed});
  fmt::print("as edges of polygons: {} edges, {} new verts, {} polys instead of {}\n", cut.edges.size(), cut.new_verts.size(), cn::num_polys(polygons), cn::num_polys(m));

  // A picture, if the program is given the name of a file.
  if (argc > 1) {
    cn::scene s;
    s.add(m, {.field = u, .edges = true}).add_lines(cn::isolines(m, u, {0.25, 0.5, 0.75}), {.radius = 0.04});
    cn::save_png(s, argv[1], {.width = 420, .height = 290, .camera = cn::view_options{.towards = {0, -1, 1}, .up = {0, 0, 1}}, .up = {0, 0, 1}, .legend = {.title = "u"}});
  }
}
