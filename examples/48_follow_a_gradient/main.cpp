// A harmonic function from a file to lines for a picture: its extrema, a level set, its gradient, and the lines that follow it, as in section 3 of the paper.
// The same program is built for surfaces and volumes; MESH_T is the kind of mesh.
#include <concino/fields.hpp>
#include <concino/geometry.hpp>
#include <concino/io/load.hpp>
#include <concino/level_sets.hpp>
#include <concino/lines.hpp>
#include <concino/mesh.hpp>
#include <concino/operators.hpp>
#include <concino/render/scene.hpp>
#include <concino/render/scene_png.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace cn = concino;
using mesh = MESH_T;

const char* name_of(cn::line_end end) {
  return end == cn::line_end::boundary ? "at the boundary" : end == cn::line_end::sink ? "at a maximum" : "elsewhere";
}

template<cn::SurfaceMesh M, class U>
void level_set(const M& m, const U& u) {
  const auto lines = cn::isolines(m, u, 0.2);
  fmt::print("u = 0.2 on {} lines, the first of {} points\n", lines.size(), lines.front().points.size());
}
template<cn::VolumeMesh M, class U>
void level_set(const M& m, const U& u) {
  const auto surface = cn::isosurface(m, u, 0.2);
  fmt::print("u = 0.2 on a surface of {} polygons\n", cn::num_polys(surface.mesh));
}

// On a surface, as many lines as have room at a distance. Perpendicular to the gradient they are level lines.
template<cn::SurfaceMesh M, class G>
void cover(const M& m, const G& g) {
  fmt::print("{} lines up, {} level lines\n", cn::evenly_spaced_lines(m, g, {.distance = 0.2}).size(), cn::evenly_spaced_lines(m, cn::rotated(m, g), {.distance = 0.2}).size());
}
template<cn::VolumeMesh M, class G>
void cover(const M&, const G&) {}

int main(int argc, char** argv) {
  const auto m = cn::load<mesh>(cn::dimension_v<mesh> == 2 ? "plate.obj" : "block.mesh");
  const auto box = cn::bounding_box(m);

  // 0 on the sides where x is least and greatest, 1 at the vert nearest to the middle.
  const auto middle = (box.min + box.max) / 2;
  auto high = *cn::verts(m).begin();
  std::vector<std::pair<cn::vert_t<mesh>, double>> fixed;
  for (const auto v : cn::verts(m)) {
    if (cn::distance(cn::point(m, v), middle) < cn::distance(cn::point(m, high), middle)) high = v;
    if (std::abs(cn::point(m, v).x - middle.x) > 0.45 * (box.max.x - box.min.x)) fixed.push_back({v, 0.0});
  }
  fixed.push_back({high, 1.0});
  const auto u = cn::harmonic_map(m, fixed);

  const auto critical = cn::critical_points(m, u);
  fmt::print("{} verts, {} polys; {} minima, {} maximum\n", cn::num_verts(m), cn::num_polys(m), critical.count[0], critical.count[cn::dimension_v<mesh>]);

  level_set(m, u);

  // A vector in each poly, and a line through the centroid of each poly, backward and forward.
  const auto g = cn::gradient(m, u);
  std::map<std::string, int> ends;
  double longest = 0;
  std::size_t points = 0;
  for (const auto& line : cn::integral_lines(m, g, cn::polys(m), {.both_ways = true})) {
    ++ends[name_of(line.stopped_by)];
    longest = std::max(longest, line.length);
    points += line.points.size();
  }
  fmt::print("{} lines with {} points, the longest {:.3f}", cn::num_polys(m), points, longest);
  for (const auto& [where, n] : ends) fmt::print("; {} end {}", n, where);
  fmt::print("\n");

  // A bundle of lines that leave one poly downhill.
  const auto bundle = cn::integral_lines(m, g, cn::starts_around(m, *cn::adj_v2p(m, high).begin()), {.backward = true});
  fmt::print("{} lines leave a poly at the maximum\n", bundle.size());
  cover(m, g);

  // A picture, if the program is given the name of a file: lines from every poly, in the colours of u, in the transparent mesh.
  if (argc > 1) {
    cn::scene s;
    s.add(m, {.field = u, .edges = true, .opacity = 0.3}).add_lines(cn::integral_lines(m, g, cn::polys(m), {.both_ways = true}));
    cn::save_png(s, argv[1], {.width = 420, .height = 290, .up = {0, 0, 1}});
  }
}
