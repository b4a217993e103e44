// Look inside a volume of polyhedra: the page cuts the cells exactly and draws their cross-sections. What it shows can be computed here as well.
#include <concino/generate.hpp>
#include <concino/geometry.hpp>
#include <concino/level_sets.hpp>
#include <concino/mesh.hpp>
#include <concino/render/scene.hpp>
#include <concino/render/scene_html.hpp>
#include <concino/render/slicing.hpp>

#include <fmt/core.h>

#include <cmath>
#include <string>

namespace cn = concino;

int main(int argc, char** argv) {
  const cn::box cube{{0, 0, 0}, {1, 1, 1}};
  auto m = cn::voronoi_polyhedra(cn::random_points(300, cube), cube, {.relax = 3});

  // A field at the verts, and two properties of the cells: a page has all of them to choose from.
  auto u = cn::vert_property<double>(m, "temperature");
  for (auto v : cn::verts(m)) u[v] = std::sin(6 * cn::point(m, v).x) * cn::point(m, v).y + cn::point(m, v).z;
  auto volume = cn::poly_property<double>(m, "volume");
  auto layer = cn::poly_property<int>(m, "layer");
  for (auto p : cn::polys(m)) volume[p] = cn::measure(m, p), layer[p] = static_cast<int>(4 * cn::centroid(m, p).z);

  cn::scene s;
  s.add(m, {.field = u, .map = cn::colormap::cool_warm, .edges = true, .inspect = true, .name = "cells"});
  cn::save_html(s, argc > 1 ? argv[1] : "cells.html", {.title = "300 cells", .camera = cn::camera::isometric});

  // In the page: under Cuts choose "cut exactly" and move the slider of x to the middle. The same numbers:
  const auto cut = cn::slice(m, cn::plane{{1, 0, 0}, 0.5});
  fmt::print("the cut passes {} cells; its area is {:.6f}\n", cn::num_polys(cut.mesh), cn::total_measure(cut.mesh));
  std::size_t whole = 0;
  const auto visible = cn::visible_polys(m, cn::below('x', 0.5));
  for (auto p : cn::polys(m)) whole += visible[p];
  fmt::print("{} whole cells are below it\n", whole);
}
