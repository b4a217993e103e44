// Figure 5: a shortest path along the edges of general polygons, and geodesic distances by heat.   figure_5 picture.png [width [surface.obj]] [--pages]
#include "figure.hpp"

#include <concino/fields.hpp>
#include <concino/generate.hpp>
#include <concino/geometry.hpp>
#include <concino/graph.hpp>
#include <concino/io/load.hpp>
#include <concino/mesh.hpp>
#include <concino/render.hpp>

#include <algorithm>

namespace cn = concino;

int main(int argc, char** argv) {
  figure f(argc, argv, 2);
  const auto triangles = !f.surface().empty() ? cn::load<cn::trimesh>(f.surface()) : cn::make_torus<cn::trimesh>({.cells = {40, 20}});

  const auto polygons = cn::dual_mesh(triangles);
  const auto is_left = [&](cn::vert_id v, cn::vert_id w) { return cn::point(polygons, v).x < cn::point(polygons, w).x; };
  const auto all = cn::verts(polygons);
  const cn::vert_id a = *std::min_element(all.begin(), all.end(), is_left), b = *std::max_element(all.begin(), all.end(), is_left);
  const auto path = cn::shortest_path(polygons, a, b);
  cn::scene s;
  s.add(polygons, {.edges = true, .edge_width = 0.6, .inspect = true}).add_lines(polygons, path, {.radius = 0.006 * cn::bounding_box(polygons).diagonal()});
  f.add(s.add_points({cn::point(polygons, a), cn::point(polygons, b)}), "Dijkstra's path on polygons");

  const auto distance = cn::heat_geodesics(triangles, cn::vert_id{0});
  f.add(cn::scene().add(triangles, {.field = distance, .isobands = 20, .inspect = true}), "geodesic distances by heat");

  f.save();
}
