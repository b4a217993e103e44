// Figure 4: a function and its gradient in each poly, and four bundles of lines that follow it.   figure_4 picture.png [width]
#include <concino/generate.hpp>
#include <concino/geometry.hpp>
#include <concino/lines.hpp>
#include <concino/mesh.hpp>
#include <concino/operators.hpp>
#include <concino/render.hpp>

#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

namespace cn = concino;

int main(int argc, char** argv) {
  const std::size_t width = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 1200;

  const cn::box square{{0, 0, 0}, {1, 1, 0}};
  const auto m = cn::voronoi_polygons(cn::random_points(900, square), square, {.relax = 3});
  auto u = cn::make_vert_map<double>(m);
  for (const auto v : cn::verts(m)) u[v] = std::cos(6 * cn::point(m, v).x) * std::cos(6 * cn::point(m, v).y);
  const auto g = cn::gradient(m, u);

  std::vector<cn::image> pictures;
  const auto draw = [&](const cn::scene& s) {
    pictures.push_back(cn::render(s, {.width = width / 2, .height = width / 2, .camera = cn::camera::from_front, .ground = false}));
  };
  draw(cn::scene().add(m, {.field = u, .edges = true, .edge_width = 0.6}).add_arrows(m, g, {.count = 450}));

  // From around the points where the function rises fastest in four directions.
  cn::scene s;
  s.add(m, {.field = u, .map = cn::colormap::hsv});
  const auto tree = cn::bounding_tree(m);
  for (const cn::vec3& at : {cn::vec3{0.45, 0.45, 0}, {0.59, 0.45, 0}, {0.45, 0.59, 0}, {0.59, 0.59, 0}})
    s.add_lines(cn::integral_lines(m, g, cn::starts_around(m, tree.closest(at).poly, 0.9), {.both_ways = true}),
                {.radius = 0.003, .color = cn::srgb(1, 1, 1)});
  draw(s);

  const std::vector<std::string> captions{"a function and its gradient", "four bundles of integral lines"};
  if (argc > 1) cn::save_png(cn::make_sheet(pictures, {.columns = 2, .captions = captions}), argv[1]);
}
