// Figure 7: a foam of bars without and with ambient occlusion, which shows what lies in front.   figure_7 picture.png [width]
#include <concino/generate.hpp>
#include <concino/mesh.hpp>
#include <concino/render.hpp>

#include <cstdlib>
#include <string>
#include <vector>

namespace cn = concino;

int main(int argc, char** argv) {
  const std::size_t width = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 1200;

  const cn::box cube{{0, 0, 0}, {1, 1, 1}};
  const auto foam = cn::voronoi_polyhedra(cn::random_points(120, cube), cube);
  cn::scene s;
  s.add_graph(foam, {.radius = 0.018, .color = cn::srgb(0.82f, 0.8f, 0.76f)});

  std::vector<cn::image> pictures;
  for (const int rays : {0, 100})
    pictures.push_back(cn::render(s, {.width = width / 2, .height = width / 2, .occlusion_rays = rays, .ground = rays > 0}));
  const std::vector<std::string> captions{"without occlusion", "with occlusion"};
  if (argc > 1) cn::save_png(cn::make_sheet(pictures, {.columns = 2, .captions = captions}), argv[1]);
}
