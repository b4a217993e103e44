// Figure 8: the slices of a T on four columns of supports, which are lines, and thickened by two radii.   figure_8 picture.png [width] [--pages]
#include "figure.hpp"

#include <concino/adapters/clipper.hpp>
#include <concino/mesh.hpp>
#include <concino/print.hpp>
#include <concino/render.hpp>

#include <string>
#include <vector>

namespace cn = concino;

using line = std::vector<cn::slice_point>;

int main(int argc, char** argv) {
  figure f(argc, argv, 2, 1);

  cn::slices t;
  for (int i = 0; i < 60; ++i) {
    cn::slice_layer layer;
    layer.z = 0.1 * i;
    if (i < 48) {
      layer.outer.push_back(line{{1, 0}, {2, 0}, {2, 1}, {1, 1}});
      for (const double x : {-0.8, 0.2, 2.8, 3.8}) {
        layer.open.push_back(line{{x - 0.15, 0.5}, {x + 0.15, 0.5}});
        layer.open.push_back(line{{x, 0.35}, {x, 0.65}});
      }
    } else {
      layer.outer.push_back(line{{-1, 0}, {4, 0}, {4, 1}, {-1, 1}});
    }
    t.layers.push_back(layer);
  }

  for (const char* radius : {"0.03", "0.12"}) {
    const auto printed = cn::slices_to_mesh(t, cn::clipper, {.thicken = std::stod(radius)});
    cn::scene s;
    s.add(printed.mesh, {.labels = cn::find_poly_property<int>(printed.mesh, "kind"), .edges = true, .edge_width = 0.5, .inspect = true});
    const cn::view_options from{.towards = {0.45, -1, 0.35}, .up = {0, 0, 1}};
    f.add(s, std::string("radius ") + radius, {.camera = from, .occlusion_rays = 0, .ground = false});
  }
  f.save();
}
