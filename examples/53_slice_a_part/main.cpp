// Slices a part for printing: layers of a closed surface, hatches across them, and the file that a printer reads.
#include <concino/generate.hpp>
#include <concino/geometry.hpp>
#include <concino/io/slices.hpp>
#include <concino/mesh.hpp>
#include <concino/print.hpp>
#include <concino/render/scene.hpp>
#include <concino/render/scene_png.hpp>

#include <fmt/core.h>

#include <cmath>
#include <vector>

namespace cn = concino;

double area_of(const cn::slice_layer& layer) {
  double sum = 0;
  for (std::size_t i = 0; i < layer.outer.size(); ++i) sum += cn::contour_area(layer.outer[i]);
  for (std::size_t i = 0; i < layer.inner.size(); ++i) sum += cn::contour_area(layer.inner[i]);  // clockwise, so they are negative
  return sum;
}

int main(int argc, char** argv) {
  const auto ring = cn::make_torus<cn::trimesh>({.cells = {120, 60}, .radius = 10, .tube_radius = 4});
  const double thickness = 0.25;

  // A layer holds what lies right above its height, so the first one, which touches a circle of verts only, is not lost and the last one is not flat.
  auto part = cn::slice_mesh(ring, cn::heights(ring, thickness));
  double volume = 0;
  for (const auto& layer : part.layers) volume += area_of(layer) * thickness;
  fmt::print("{} layers from z = {} to {}, of volume {:.2f}; the ring has {:.2f}\n", part.layers.size(), part.layers.front().z, part.layers.back().z, volume,
             cn::total_measure(cn::make_torus<cn::hexmesh>({.cells = {120, 60}, .radius = 10, .tube_radius = 4})));

  // Each contour knows the polys of the mesh that it passes.
  const std::size_t middle = part.layers.size() / 2;
  const auto& layer = part.layers[middle];
  fmt::print("layer {}: {} outer and {} inner contours, area {:.2f}\n", middle, layer.outer.size(), layer.inner.size(), area_of(layer));
  const auto passed = part.polys_of(middle, cn::slice_lines_kind::outer, 0);
  double turn = 0;  // along the outer contour: the triangles lean from it by their normals
  for (const auto p : passed) turn = std::max(turn, std::abs(cn::normal(ring, p).z));
  fmt::print("its outer contour passes {} triangles, at most {:.1f} degrees from vertical\n", passed.size(), std::asin(turn) * 180 / M_PI);

  // Hatches are the paths of a laser. Their directions change from layer to layer.
  for (std::size_t i = 0; i < part.layers.size(); ++i) part.layers[i].hatches = cn::hatch(part.layers[i], 1, i % 2 == 0 ? 45 : -45);
  fmt::print("{} hatches fill that layer\n", layer.hatches.points.size() / 2);

  cn::save_slices(part, "ring.cli");
  fmt::print("saved and loaded: {} layers, equal: {}\n", part.layers.size(), cn::load_slices("ring.cli").layers == part.layers);

  // What would lose parts without a word is refused.
  try {
    cn::slice_mesh(cn::make_grid<cn::quadmesh>(), {0.0});
  } catch (const cn::invalid_mesh& refused) {
    fmt::print("{}\n", refused.what());
  }

  // A picture, if the program is given the name of a file: the layers up to the middle, with the hatches of the highest.
  if (argc > 1) {
    cn::scene s;
    const auto add = [&](const cn::slice_lines& lines, double z, const cn::tube_options& look) {
      for (std::size_t i = 0; i < lines.size(); ++i) {
        std::vector<cn::vec3> line;
        for (const auto& x : lines[i]) line.push_back({x[0], x[1], z});
        s.add_lines(line, look);
      }
    };
    for (std::size_t i = 0; i <= middle; ++i) {
      add(part.layers[i].outer, part.layers[i].z, {.radius = 0.1, .color = cn::srgb(0.35f, 0.5f, 0.75f), .closed = true});
      add(part.layers[i].inner, part.layers[i].z, {.radius = 0.1, .color = cn::srgb(0.35f, 0.5f, 0.75f), .closed = true});
    }
    const auto& h = layer.hatches.points;
    for (std::size_t k = 0; k + 1 < h.size(); k += 2)
      s.add_lines(std::vector<cn::vec3>{{h[k][0], h[k][1], layer.z}, {h[k + 1][0], h[k + 1][1], layer.z}}, {.radius = 0.08, .color = cn::srgb(0.85f, 0.35f, 0.1f)});
    cn::save_png(s, argv[1], {.width = 300, .height = 200, .camera = cn::view_options{.towards = {0.3, -1, 0.8}, .up = {0, 0, 1}}, .ground = false});
  }
}
