// What will be printed: the slices of a T on four columns of supports. Files have supports as lines; the material around them is as wide as the beam or the nozzle.
#include <concino/adapters/clipper.hpp>
#include <concino/geometry.hpp>
#include <concino/mesh.hpp>
#include <concino/print.hpp>
#include <concino/render/scene.hpp>
#include <concino/render/scene_png.hpp>
#include <concino/render/sheet.hpp>

#include <fmt/core.h>

#include <string>
#include <vector>

namespace cn = concino;

using line = std::vector<cn::slice_point>;

/// Layer i of the T: a stem, and from layer 48 on the bar on top of it. Each column of supports is a cross of two lines.
cn::slice_layer layer_of_t(int i) {
  cn::slice_layer layer;
  layer.z = 0.1 * i;
  layer.outer.push_back(i < 48 ? line{{1, 0}, {2, 0}, {2, 1}, {1, 1}} : line{{-1, 0}, {4, 0}, {4, 1}, {-1, 1}});
  if (i < 48)
    for (const double x : {-0.8, 0.2, 2.8, 3.8}) {
      layer.open.push_back(line{{x - 0.1, 0.5}, {x + 0.1, 0.5}});
      layer.open.push_back(line{{x, 0.4}, {x, 0.6}});
    }
  return layer;
}

int main(int argc, char** argv) {
  cn::slices t;
  for (int i = 0; i < 60; ++i) t.layers.push_back(layer_of_t(i));

  // Without a radius, lines have no area. The report names each one that was left out.
  const auto bare = cn::slices_to_mesh(t, cn::clipper);
  fmt::print("{} polygons of area {:.3f}; {}, and {} lines more\n", cn::num_polys(bare.mesh), cn::total_measure(bare.mesh), bare.report.notes.front().text(),
             bare.report.notes.size() - 1);

  // With a radius, they are united with each other, and give way to the part.
  std::vector<cn::image> pictures;
  std::vector<std::string> captions;
  for (const double radius : {0.03, 0.12}) {
    const auto thick = cn::slices_to_mesh(t, cn::clipper, {.thicken = radius});
    const auto kind = cn::find_poly_property<int>(thick.mesh, "kind");
    double area[2] = {0, 0};
    for (const auto p : cn::polys(thick.mesh)) area[kind[p]] += cn::area(thick.mesh, p);
    fmt::print("radius {}: {} polygons, part {:.3f}, supports {:.3f}\n", radius, cn::num_polys(thick.mesh), area[0], area[1]);
    if (argc == 1) continue;
    cn::scene s;
    s.add(thick.mesh, {.labels = kind, .edges = true, .edge_width = 0.4});
    pictures.push_back(cn::render(s, {.width = 170, .height = 200, .camera = cn::view_options{.towards = {0.45, -1, 0.35}, .up = {0, 0, 1}}, .ground = false}));
    captions.push_back(fmt::format("radius {}", radius));
  }

  // Tets for a simulation: each layer fills the space up to the next one, and they fit together where layers differ.
  t.layers.erase(t.layers.begin(), t.layers.begin() + 44);
  const auto solid = cn::slices_to_volume(t, cn::clipper, {.last_height = 0.1, .thicken = 0.12});
  fmt::print("the last 16 layers: {} tets of volume {:.3f}, {} inverted\n", cn::num_polys(solid.mesh), cn::total_measure(solid.mesh), solid.inverted.size());

  // A picture, if the program is given the name of a file.
  if (argc > 1) {
    cn::scene s;
    s.add(solid.mesh, {.labels = cn::find_poly_property<int>(solid.mesh, "kind"), .edges = true, .edge_width = 0.4});
    pictures.push_back(cn::render(s, {.width = 170, .height = 200, .camera = cn::view_options{.towards = {0.45, -1, -0.5}, .up = {0, 0, 1}}, .ground = false}));
    captions.push_back("tets of the last 16 layers");
    cn::save_png(cn::make_sheet(pictures, {.columns = 3, .captions = captions}), argv[1]);
  }
}
