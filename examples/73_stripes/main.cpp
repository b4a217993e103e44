// Stripes at even distances on surfaces, across a field of directions. Seven circles fit exactly around the tube of a torus. Along the torus the way is shorter
// inside than outside, and stripes are closer there. On a sphere the field turns around four points, where stripes meet.
#include <concino/directions.hpp>
#include <concino/generate.hpp>
#include <concino/mesh.hpp>
#include <concino/render.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace cn = concino;

/// A field of vectors on a torus with radii 1 and 0.4: around its tube, or along the circle in its middle.
auto field_on_torus(const cn::quadmesh& m, bool around_tube) {
  cn::direction_field_options<cn::quadmesh> options{.symmetry = 1};
  for (const auto v : cn::verts(m)) {
    const cn::vec3 x = cn::point(m, v);
    const double r = std::hypot(x.x, x.y);
    const cn::vec3 along{-x.y, x.x, 0}, around = (r - 1) * cn::vec3{0, 0, 1} - x.z / r * cn::vec3{x.x, x.y, 0};
    options.hard.push_back({v, around_tube ? around : along});
  }
  return cn::direction_field(m, options);
}

int main(int argc, char** argv) {
  const std::size_t around = 60, tube = 30;
  const auto torus = cn::make_torus<cn::quadmesh>({.cells = {around, tube}});
  const double frequency = 7 / (tube * 2 * 0.4 * std::sin(3.14159265358979 / tube));  // 7 stripes for the length of the polygons that are around the tube

  const auto circles = cn::stripes(torus, field_on_torus(torus, true), frequency);
  fmt::print("around the tube: {} singular polys, {} circles\n", circles.singular.size(), cn::stripe_lines(circles).size() / around);

  const auto spokes = cn::stripes(torus, field_on_torus(torus, false), frequency);
  fmt::print("along the torus: {} singular polys, {} stripes\n", spokes.singular.size(), cn::stripe_lines(spokes).size() / tube);

  const auto sphere = cn::make_sphere<cn::polygonmesh>({.cells = 16});
  const auto field = cn::direction_field(sphere, {.symmetry = 2});
  const auto lines = cn::stripes(sphere, field, 4);
  const auto turns = std::count_if(lines.singular.begin(), lines.singular.end(), [](const auto& s) { return s.field_turns; });
  fmt::print("on a sphere: the field turns by half around {} polys\n", turns);

  if (argc > 1) {
    std::vector<cn::image> pictures;
    const auto draw = [&](const auto& m, const auto& stripes, double size) {
      auto color = cn::make_poly_map<cn::rgb>(m, cn::srgb(0.9f, 0.87f, 0.8f));
      for (const auto& s : stripes.singular) color[s.poly] = cn::srgb(0.95f, 0.6f, 0.25f);
      cn::scene scene;
      scene.add(m, {.colors = color});
      scene.add_lines(cn::stripe_lines(stripes), {.radius = 0.012 * size, .color = cn::srgb(0.15f, 0.3f, 0.55f)});
      pictures.push_back(cn::render(scene, {.width = 140, .height = 120, .camera = cn::view_options{.towards = {0.3, 1, -0.9}, .up = {0, 0, 1}}, .samples = 4, .ground = false}));
    };
    draw(torus, circles, 1), draw(torus, spokes, 1), draw(sphere, lines, 1);
    cn::save_png(cn::make_sheet(pictures, {.columns = 3, .captions = {"around the tube", "along the torus", "on a sphere"}}), argv[1]);
  }
}
