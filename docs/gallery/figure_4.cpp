// Figure 4: a function and its gradient in each poly, and four bundles of lines that follow it.   figure_4 picture.png [width] [--pages]
#include "figure.hpp"

#include <concino/generate.hpp>
#include <concino/geometry.hpp>
#include <concino/lines.hpp>
#include <concino/mesh.hpp>
#include <concino/operators.hpp>
#include <concino/render.hpp>

#include <cmath>

namespace cn = concino;

int main(int argc, char** argv) {
  figure f(argc, argv, 2, 1);

  const cn::box square{{0, 0, 0}, {1, 1, 0}};
  const auto m = cn::voronoi_polygons(cn::random_points(900, square), square, {.relax = 3});
  auto u = cn::make_vert_map<double>(m);
  for (const auto v : cn::verts(m)) u[v] = std::cos(6 * cn::point(m, v).x) * std::cos(6 * cn::point(m, v).y);
  const auto g = cn::gradient(m, u);

  const cn::render_options from_front{.camera = cn::camera::from_front, .ground = false};
  f.add(cn::scene().add(m, {.field = u, .edges = true, .edge_width = 0.6, .inspect = true}).add_arrows(m, g, {.count = 450}),
        "a function and its gradient", from_front);

  // From around the points where the function rises fastest in four directions.
  cn::scene s;
  s.add(m, {.field = u, .map = cn::colormap::hsv, .inspect = true});
  const auto tree = cn::bounding_tree(m);
  for (const cn::vec3& at : {cn::vec3{0.45, 0.45, 0}, {0.59, 0.45, 0}, {0.45, 0.59, 0}, {0.59, 0.59, 0}})
    s.add_lines(cn::integral_lines(m, g, cn::starts_around(m, tree.closest(at).poly, 0.9), {.both_ways = true}),
                {.radius = 0.003, .color = cn::srgb(1, 1, 1)});
  f.add(s, "four bundles of integral lines", from_front);

  f.save();
}
