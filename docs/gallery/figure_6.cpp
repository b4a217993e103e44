// Figure 6: textures show how two coordinates are distorted: squares, lines, and a picture.   figure_6 picture.png [width] [--pages]
#include "figure.hpp"

#include <concino/fields.hpp>
#include <concino/generate.hpp>
#include <concino/mesh.hpp>
#include <concino/render.hpp>

#include <array>
#include <cmath>

namespace cn = concino;

int main(int argc, char** argv) {
  figure f(argc, argv, 3);

  // A hill, and two coordinates of each vert: those of the logarithmic map at the top, which keeps the distances from there.
  auto m = cn::make_grid<cn::trimesh>({.cells = {40, 40}, .max = {2, 2, 1}});
  for (const auto v : cn::verts(m)) {
    cn::vec3 x = cn::point(m, v);
    x.z = 0.9 * std::exp(-4 * (std::pow(x.x - 1, 2) + std::pow(x.y - 1, 2)));
    cn::set_point(m, v, x);
  }
  const auto log = cn::log_map(m, cn::vert_id{20 * 41 + 20});
  auto uv = cn::make_vert_map<std::array<double, 2>>(m);
  for (const auto v : cn::verts(m)) {
    const double r = log.distance[v] / 2.5;
    uv[v] = {0.5 + r * log.direction[v].x, 0.5 + r * log.direction[v].y};
  }

  cn::scene flower;
  flower.add(cn::make_torus<cn::quadmesh>({.cells = {40, 20}}), {.edges = true, .color = cn::srgb(0.9f, 0.4f, 0.3f)});
  const auto picture = cn::render(flower, {.width = f.width() / 3, .height = f.width() / 3, .camera = cn::view_options{.towards = {0, 0, 1}, .margin = 0}, .ground = false});

  const auto draw = [&](const char* caption, const cn::texture& texture) {
    cn::scene s;
    s.add(m, {.color = cn::srgb(0.95f, 0.95f, 0.95f), .texture = texture, .texture_coordinates = uv, .inspect = true});
    f.add(s, caption, {.up = {0, 0, 1}});
  };
  draw("squares", cn::texture::checkerboard(16));
  draw("lines of equal coordinates", cn::texture::isolines(20, cn::srgb(0.7f, 0.1f, 0.1f)));
  draw("a picture", cn::texture::from(picture));
  f.save();
}
