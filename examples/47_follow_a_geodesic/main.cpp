// Geodesics, the straight lines of a surface. A logarithmic map says in which direction and how far away every vert is; a geodesic in that direction arrives
// there. Vectors are carried over the surface without turning, and a path along edges is made straight.
#include <concino/fields.hpp>
#include <concino/generate.hpp>
#include <concino/graph.hpp>
#include <concino/lines.hpp>
#include <concino/mesh.hpp>
#include <concino/render/scene.hpp>
#include <concino/render/scene_png.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>

namespace cn = concino;

int main(int argc, char** argv) {
  const auto m = cn::make_torus<cn::trimesh>({.cells = {48, 24}});
  const cn::vert_id start{0};

  // To each vert in a straight line: by the logarithmic map, then straight ahead.
  const auto log = cn::log_map(m, start);
  const auto trace = cn::prepare_trace_geodesic(m);
  double missed = 0;
  int near = 0;
  for (const auto v : cn::verts(m)) {
    if (v == start || log.distance[v] > 0.5) continue;
    const auto line = trace.trace_from(start, log.direction[v], log.distance[v]);
    missed = std::max(missed, cn::distance(line.points.back().position, cn::point(m, v)));
    ++near;
  }
  fmt::print("{} verts are near; straight lines miss them by less than a tenth of an edge: {}\n", near, missed < 0.1 * 0.11 ? "yes" : "no");

  // Once around, and why a line ends.
  const auto around = trace.trace_from(start, cn::tangent_vector{1, 0.2}, 20);
  fmt::print("a line of length {:.0f} has {} points and ends at its length: {}\n", around.length, around.points.size(),
             around.stopped_by == cn::line_end::max_length ? "yes" : "no");
  const auto sheet = cn::make_grid<cn::quadmesh>({.cells = {5, 5}});
  const auto out = cn::trace_geodesic(sheet, cn::vert_id{0}, {2, 1, 0}, 20);
  fmt::print("a line over a unit square leaves it after {:.3f} at the boundary: {}\n", out.length, out.stopped_by == cn::line_end::boundary ? "yes" : "no");

  // Carried vectors keep their length; the nearest source counts.
  const auto carried = cn::parallel_transport(m, {{start, {1, 0}}});
  double longest = 0, shortest = 1e9;
  for (const auto v : cn::verts(m)) {
    longest = std::max(longest, cn::norm(carried[v]));
    shortest = std::min(shortest, cn::norm(carried[v]));
  }
  fmt::print("carried vectors have lengths from {:.3f} to {:.3f}\n", shortest, longest);

  // A path along edges, the same made straight, and the shortest of all.
  const cn::vert_id end{500};
  const auto path = cn::shortest_path(m, start, end);
  double along_edges = 0;
  for (std::size_t i = 1; i < path.size(); ++i) along_edges += cn::distance(cn::point(m, path[i - 1]), cn::point(m, path[i]));
  const auto straight = cn::straighten(m, path);
  const double least = cn::exact_geodesics(m, start)[end];
  fmt::print("along edges {:.3f}, straight {:.3f}, the shortest {:.3f}\n", along_edges, straight.length, least);

  // The point amid some others.
  const cn::vec3 middle = cn::karcher_mean(sheet, {cn::vert_id{0}, cn::vert_id{5}, cn::vert_id{35}}).position;
  fmt::print("the mean of three corners of the square is ({:.3f}, {:.3f})\n", middle.x, middle.y);

  // A picture, if the program is given the name of a file: the long geodesic in red, the path along edges in black, and the path made straight in blue.
  if (argc > 1) {
    cn::scene s;
    s.add(m, {.edges = true}).add_lines(around.points).add_lines(m, path, {.color = cn::srgb(0, 0, 0)}).add_lines(straight.points, {.color = cn::srgb(0.1f, 0.3f, 0.9f)});
    cn::save_png(s, argv[1], {.width = 380, .height = 260, .camera = cn::view_options{.towards = {0, -1, 1}, .up = {0, 0, 1}}, .up = {0, 0, 1}});
  }
}
