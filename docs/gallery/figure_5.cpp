// Figure 5: a shortest path along the edges of general polygons, and geodesic distances by heat.   figure_5 picture.png [width [surface.obj]]
#include <concino/fields.hpp>
#include <concino/generate.hpp>
#include <concino/geometry.hpp>
#include <concino/graph.hpp>
#include <concino/io/load.hpp>
#include <concino/mesh.hpp>
#include <concino/render.hpp>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

namespace cn = concino;

int main(int argc, char** argv) {
  const std::size_t width = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 1200;
  const auto triangles = argc > 3 ? cn::load<cn::trimesh>(argv[3]) : cn::make_torus<cn::trimesh>({.cells = {40, 20}});

  std::vector<cn::image> pictures;
  const auto draw = [&](const cn::scene& s) {
    pictures.push_back(cn::render(s, {.width = width / 2, .height = width * 3 / 8}));
  };

  const auto polygons = cn::dual_mesh(triangles);
  const auto is_left = [&](cn::vert_id v, cn::vert_id w) { return cn::point(polygons, v).x < cn::point(polygons, w).x; };
  const auto all = cn::verts(polygons);
  const cn::vert_id a = *std::min_element(all.begin(), all.end(), is_left), b = *std::max_element(all.begin(), all.end(), is_left);
  const auto path = cn::shortest_path(polygons, a, b);
  cn::scene s;
  s.add(polygons, {.edges = true, .edge_width = 0.6}).add_lines(polygons, path, {.radius = 0.006 * cn::bounding_box(polygons).diagonal()});
  draw(s.add_points({cn::point(polygons, a), cn::point(polygons, b)}));

  const auto distance = cn::heat_geodesics(triangles, cn::vert_id{0});
  draw(cn::scene().add(triangles, {.field = distance, .isobands = 20}));

  const std::vector<std::string> captions{"Dijkstra's path on polygons", "geodesic distances by heat"};
  if (argc > 1) cn::save_png(cn::make_sheet(pictures, {.columns = 2, .captions = captions}), argv[1]);
}
