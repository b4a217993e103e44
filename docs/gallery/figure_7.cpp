// Figure 7: a foam of bars without and with ambient occlusion, which shows what lies in front.   figure_7 picture.png [width] [--pages]
#include "figure.hpp"

#include <concino/generate.hpp>
#include <concino/mesh.hpp>
#include <concino/render.hpp>

namespace cn = concino;

int main(int argc, char** argv) {
  figure f(argc, argv, 2, 1);

  const cn::box cube{{0, 0, 0}, {1, 1, 1}};
  const auto foam = cn::voronoi_polyhedra(cn::random_points(120, cube), cube);
  cn::scene s;
  s.add_graph(foam, {.radius = 0.018, .color = cn::srgb(0.82f, 0.8f, 0.76f)});

  f.add(s, "without occlusion", {.occlusion_rays = 0, .ground = false});
  f.add(s, "with occlusion", {.occlusion_rays = 100});
  f.save();
}
