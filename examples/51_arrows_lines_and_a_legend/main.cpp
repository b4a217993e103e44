// Arrows, lines and a legend: the temperature of a ring that is heated at one point and cooled at another, and how the heat flows, in one picture.
// The picture is small and fast; with the name of a file it is larger.
#include <concino/generate/torus.hpp>
#include <concino/level_sets/isolines.hpp>
#include <concino/lines/integral_line.hpp>
#include <concino/mesh/trimesh.hpp>
#include <concino/operators/gradient.hpp>
#include <concino/render.hpp>

#include <fmt/core.h>

#include <string>
#include <vector>

namespace cn = concino;

int main(int argc, char** argv) {
  const std::string path = argc > 1 ? argv[1] : "ring.png";
  const std::size_t width = argc > 1 ? 400 : 160;
  const auto ring = cn::make_torus<cn::trimesh>({.cells = {60, 30}});
  const auto hot = cn::point(ring, cn::vert_id{478}), cold = cn::point(ring, cn::vert_id{458});
  auto temperature = cn::make_vert_map<double>(ring);
  for (auto v : cn::verts(ring)) {
    const double near_hot = cn::distance(cn::point(ring, v), hot), near_cold = cn::distance(cn::point(ring, v), cold);
    temperature[v] = 100 * near_cold / (near_hot + near_cold);
  }

  // Heat flows against the gradient.
  const auto gradient = cn::gradient(ring, temperature);
  auto flow = cn::make_poly_map<cn::vec3>(ring);
  for (auto p : cn::polys(ring)) flow[p] = -gradient[p];

  cn::scene s;
  s.add(ring, {.field = temperature, .map = cn::colormap::cool_warm});

  // Arrows of one length show the direction, and are drawn where they have room.
  cn::arrow_report arrows;
  s.add_arrows(ring, flow, {.equal_lengths = true, .count = 200, .report = &arrows});
  fmt::print("{} polys: {} arrows, {} without a direction\n", cn::num_polys(ring), arrows.drawn + arrows.thinned, arrows.zero + arrows.not_finite);

  // Lines that follow the flow from around the heater, and lines of equal temperature with its colours. Such results are drawn as they are.
  std::vector<cn::vert_id> starts;
  for (auto v : cn::adj_v2v(ring, cn::vert_id{478})) starts.push_back(v);
  const auto lines = cn::integral_lines(ring, flow, starts);
  s.add_lines(lines, {.radius = 0.012, .color = cn::srgb(1, 1, 1)});
  const auto levels = cn::isolines(ring, temperature, {10, 20, 30, 40, 50, 60, 70, 80, 90});
  std::vector<double> values;
  for (const auto& line : levels) values.push_back(line.value);
  s.add_lines(levels, {.radius = 0.008, .values = values, .map = cn::colormap::viridis});
  fmt::print("{} lines of flow, {} lines of equal temperature\n", lines.size(), levels.size());

  // The two points, with their names above them.
  s.add_points({hot, cold}, {.radius = 0.05, .color = cn::srgb(0.95f, 0.75f, 0.1f)});
  s.add_label(hot + cn::vec3{0, 0, 0.1}, "heater").add_label(cold + cn::vec3{0, 0, 0.1}, "cooler");
  fmt::print("{} things in the scene\n", s.drawables().size());

  const cn::view_options from{.towards = {0.6, -1, 1.1}, .up = {0, 0, 1}};
  cn::save_png(s, path, {.width = width, .height = width * 3 / 4, .camera = from, .samples = 2, .occlusion_rays = 16, .ground = false,
                               .title = "Heat in a ring", .legend = {.title = "temperature", .unit = "\u00b0C"}});
}
