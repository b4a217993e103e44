// Figure 9: a harmonic function on general polygons, its extrema, an iso-line in red, and close up its gradient.   figure_9 picture.png [width [surface.obj]] [--pages]
#include "figure.hpp"

#include <concino/fields.hpp>
#include <concino/generate.hpp>
#include <concino/geometry.hpp>
#include <concino/io/load.hpp>
#include <concino/level_sets.hpp>
#include <concino/mesh.hpp>
#include <concino/operators.hpp>
#include <concino/render.hpp>

#include <algorithm>

namespace cn = concino;

int main(int argc, char** argv) {
  figure f(argc, argv, 2, 1);
  const auto m = cn::dual_mesh(!f.surface().empty() ? cn::load<cn::trimesh>(f.surface()) : cn::make_torus<cn::trimesh>({.cells = {40, 20}}));

  // From the lowest vert to the highest one.
  const auto is_lower = [&](cn::vert_id v, cn::vert_id w) { return cn::point(m, v).y < cn::point(m, w).y; };
  const auto all = cn::verts(m);
  const cn::vert_id low = *std::min_element(all.begin(), all.end(), is_lower), high = *std::max_element(all.begin(), all.end(), is_lower);
  const auto u = cn::harmonic_map(m, {{low, 0.0}, {high, 1.0}});

  cn::scene s;
  s.add(m, {.field = u, .isobands = 12, .edges = true, .edge_width = 0.4, .inspect = true});
  const auto line = cn::isolines(m, u, 0.5);
  const double size = cn::bounding_box(m).diagonal();
  s.add_lines(line, {.radius = 0.006 * size}).add_points({cn::point(m, low), cn::point(m, high)}, {.radius = 0.015 * size});
  f.add(s, "a harmonic function");

  s.add_arrows(m, cn::gradient(m, u), {.equal_lengths = true, .count = 0});
  const cn::vec3 at = line.front().points.front();
  const cn::vec3 away = at - cn::bounding_box(m).centre();
  const auto close = cn::perspective_camera(at + 0.6 * size / cn::norm(away) * away, at, {0, 1, 0}, 20);
  f.add(s, "its normalised gradient", {.camera = close, .ground = false});

  f.save();
}
