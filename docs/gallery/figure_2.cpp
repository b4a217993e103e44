// Figure 2: meshes of the six kinds. The volumes are cut to show the cells inside.   figure_2 picture.png [width] [--pages]
#include "figure.hpp"

#include <concino/generate.hpp>
#include <concino/mesh.hpp>
#include <concino/render.hpp>

#include <type_traits>

namespace cn = concino;

int main(int argc, char** argv) {
  figure f(argc, argv, 3);

  const auto draw = [&](const auto& m, const char* name, const cn::poly_criterion<std::remove_cvref_t<decltype(m)>>& visible = {}) {
    const cn::rgb blue = cn::srgb(0.62f, 0.75f, 0.86f);
    f.add(cn::scene().add(m, {.edges = true, .visible = visible, .color = blue, .inspect = true, .name = name}), name, {.up = {0, 0, 1}});
  };

  const auto triangles = cn::make_torus<cn::trimesh>({.cells = {36, 16}});
  draw(triangles, "triangles");
  draw(cn::make_torus<cn::quadmesh>({.cells = {36, 16}}), "quads");
  draw(cn::dual_mesh(triangles), "polygons");

  const cn::plane cut{{0.4, -1, 0.5}, 0.1};
  draw(cn::make_sphere<cn::tetmesh>({.cells = 6}), "tets", cn::below(cut));
  draw(cn::make_sphere<cn::hexmesh>({.cells = 6}), "hexes", cn::below(cut));
  auto sites = cn::random_points(900, cn::box{{-1, -1, -1}, {1, 1, 1}});
  std::erase_if(sites, [](const cn::vec3& x) { return cn::norm(x) > 0.97; });
  draw(cn::voronoi_polyhedra(sites, cn::icosphere(3)), "polyhedra", cn::below(cut));

  f.save();
}
