// Figure 2: meshes of the six kinds. The volumes are cut to show the cells inside.   figure_2 picture.png [width]
#include <concino/generate.hpp>
#include <concino/mesh.hpp>
#include <concino/render.hpp>

#include <cstdlib>
#include <string>
#include <type_traits>
#include <vector>

namespace cn = concino;

int main(int argc, char** argv) {
  const std::size_t width = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 1200;

  std::vector<cn::image> pictures;
  const auto draw = [&](const auto& m, const cn::mesh_look<std::remove_cvref_t<decltype(m)>>& look) {
    cn::scene s;
    s.add(m, look);
    pictures.push_back(cn::render(s, {.width = width / 3, .height = width / 4, .up = {0, 0, 1}}));
  };
  const cn::rgb blue = cn::srgb(0.62f, 0.75f, 0.86f);

  const auto triangles = cn::make_torus<cn::trimesh>({.cells = {36, 16}});
  draw(triangles, {.edges = true, .color = blue});
  draw(cn::make_torus<cn::quadmesh>({.cells = {36, 16}}), {.edges = true, .color = blue});
  draw(cn::dual_mesh(triangles), {.edges = true, .color = blue});

  const cn::plane cut{{0.4, -1, 0.5}, 0.1};
  draw(cn::make_sphere<cn::tetmesh>({.cells = 6}), {.edges = true, .visible = cn::below(cut), .color = blue});
  draw(cn::make_sphere<cn::hexmesh>({.cells = 6}), {.edges = true, .visible = cn::below(cut), .color = blue});
  auto sites = cn::random_points(900, cn::box{{-1, -1, -1}, {1, 1, 1}});
  std::erase_if(sites, [](const cn::vec3& x) { return cn::norm(x) > 0.97; });
  draw(cn::voronoi_polyhedra(sites, cn::icosphere(3)),
       {.edges = true, .visible = cn::below(cut), .color = blue});

  const std::vector<std::string> names{"triangles", "quads", "polygons", "tets", "hexes", "polyhedra"};
  if (argc > 1) cn::save_png(cn::make_sheet(pictures, {.columns = 3, .captions = names}), argv[1]);
}
