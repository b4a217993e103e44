// Take an OpenFOAM case, solve on its mesh, and write it back. Patches are labels of faces and cellZones labels of polys, with names: boundary values are
// prescribed by the name of a patch. The picture shows the patches, the temperature, and the cells of the new zone.
#include <concino/fields.hpp>
#include <concino/generate.hpp>
#include <concino/geometry.hpp>
#include <concino/io.hpp>
#include <concino/mesh.hpp>
#include <concino/render.hpp>

#include <fmt/core.h>

#include <cmath>
#include <vector>

namespace cn = concino;
using kind = cn::element_kind;

int main(int argc, char** argv) {
  // A case, as a mesher might leave it: a duct of polyhedral cells with three patches. The folder is created.
  const cn::box duct{{0, 0, 0}, {3, 1, 1}};
  {
    auto cells = cn::voronoi_polyhedra(cn::random_points(600, duct), duct, {.relax = 3});
    auto patch = cn::face_property<int>(cells, "label");
    for (auto f : cn::faces(cells)) {
      if (!cn::is_boundary(cells, f)) continue;
      const auto c = cn::centroid(cells, f);
      patch[f] = c.x < 1e-9 ? 1 : c.z > 1 - 1e-9 && std::abs(c.x - 2) < 0.4 ? 2 : 3;
    }
    *cn::mesh_property<cn::label_names>(cells, "label_names") = {
        {{kind::face, 1, "inlet", {"type patch;"}}, {kind::face, 2, "cooler", {"type wall;", "inGroups 1(wall);"}}, {kind::face, 3, "walls", {"type wall;"}}}};
    cn::save(cells, "case/constant/polyMesh", {.binary = true});
  }

  // The path is that of the case or of the folder. Cells and points keep their numbers; faces come in the order of OpenFOAM.
  auto m = cn::load<cn::polyhedralmesh>("case");
  auto& names = *cn::mesh_property<cn::label_names>(m, "label_names");
  const auto patch = cn::find_face_property<int>(m, "label");
  fmt::print("{} points, {} cells, {} faces\n", cn::num_verts(m), cn::num_polys(m), cn::num_faces(m));
  for (const auto& n : names.names) {
    std::size_t count = 0;
    for (auto f : cn::faces(m)) count += patch[f] == n.label;
    fmt::print("patch {}, {} {} faces\n", n.name, n.lines[0], count);
  }

  // Heat conduction in a steady state: 400 K at the inlet, 300 K at the cooler, and no flow through all other walls.
  std::vector<std::pair<cn::vert_id, double>> fixed;
  for (const auto& [name, kelvin] : {std::pair{"inlet", 400.0}, std::pair{"cooler", 300.0}})
    for (auto f : cn::faces(m))
      if (patch[f] == names.find(kind::face, name)->label)
        for (auto v : cn::adj_f2v(m, f)) fixed.emplace_back(v, kelvin);
  const auto solution = cn::harmonic_map(m, fixed);
  auto temperature = cn::vert_property<double>(m, "temperature");
  for (auto v : cn::verts(m)) temperature[v] = solution[v];

  // Cells above 370 K become a cellZone.
  auto zone = cn::poly_property<int>(m, "label");
  double volume = 0;
  for (auto p : cn::polys(m)) {
    double mean = 0;
    std::size_t n = 0;
    for (auto v : cn::adj_p2v(m, p)) mean += temperature[v], ++n;
    if (mean / static_cast<double>(n) > 370) zone[p] = 1, volume += cn::measure(m, p);
  }
  names.names.push_back({kind::poly, 1, "warm"});
  fmt::print("cells above 370 K have the volume {:.3f} of 3\n", volume);

  // Back to the case, and with the field to a program that draws it. A polyMesh holds no fields; the report says so.
  cn::save_report report;
  cn::save(m, "case/constant/polyMesh", {.report = &report});
  for (const auto& lost : report.lost) fmt::print("{}\n", lost);
  cn::save(m, "temperature.vtu", {.report = &report});
  const auto again = cn::load<cn::polyhedralmesh>("case/constant/polyMesh");
  std::size_t warm = 0;
  for (auto p : cn::polys(again)) warm += cn::find_poly_property<int>(again, "label")[p] == 1;
  fmt::print("zone {} has {} cells\n", cn::find_mesh_property<cn::label_names>(again, "label_names")->names.back().name, warm);

  if (argc > 1) {
    auto color = cn::make_face_map<cn::rgb>(m);
    for (auto f : cn::faces(m)) color[f] = cn::label_color(static_cast<std::size_t>(patch[f]));
    std::vector<cn::scene> scenes(3);
    scenes[0].add(m, {.colors = color, .edges = true});
    scenes[1].add(m, {.field = temperature, .map = cn::colormap::cool_warm, .edges = true, .visible = !cn::below('y', 0.5)});
    scenes[2].add(m, {.edges = true, .visible = cn::labeled(zone, {1})}).add(m, {.opacity = 0.15});
    std::vector<cn::image> pictures;
    for (const auto& s : scenes)
      pictures.push_back(cn::render(s, {.width = 260, .height = 170, .camera = cn::view_options{.towards = {-0.5, -1, 0.8}, .up = {0, 0, 1}}, .samples = 4, .ground = false}));
    cn::save_png(cn::make_sheet(pictures, {.columns = 3, .captions = {"patches", "temperature", "the zone above 370 K"}}), argv[1]);
  }
}
