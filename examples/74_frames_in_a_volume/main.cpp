// Frames in volumes: at each vert three perpendicular vectors, as smooth as they can be, one of them normal to the boundary. Hexes along them would be like
// cubes. A box has its axes everywhere. In a cylinder and in a ball the frames turn around singular lines, where three hexes meet instead of four.
#include <concino/directions.hpp>
#include <concino/generate.hpp>
#include <concino/geometry.hpp>
#include <concino/graph.hpp>
#include <concino/mesh.hpp>
#include <concino/render.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace cn = concino;

/// Says what the singular lines of frames are, and returns them.
template<class M>
auto report(const char* what, const M& m, const cn::frame_field_result<M>& frames) {
  const auto singular = cn::singular_edges(frames);
  int ends = 0;
  double index = 0;
  for (std::size_t i = 0; i < singular.faces.size(); ++i)
    if (cn::is_boundary(m, singular.faces[i])) ++ends, index += (4 - singular.valences[i]) / 4.0;
  fmt::print("{}: {} cells; energy {:.1f}{}; {} faces are crossed by singular lines, in {} part{}, with {} ends on the boundary, of index {:g} together\n", what,
             cn::num_polys(m), frames.energy, frames.has_converged ? "" : ", not converged", singular.faces.size(),
             cn::connected_components(singular.lines).count, cn::connected_components(singular.lines).count == 1 ? "" : "s", ends, index);
  return singular;
}

/// Short lines along the vectors of the frames of some verts.
template<class M, class Keep>
void add_frames(cn::scene& s, const M& m, const cn::frame_field_result<M>& frames, double length, const Keep& keep) {
  for (const std::size_t k : {0u, 1u, 2u}) {
    std::vector<std::vector<cn::vec3>> lines;
    for (const auto v : cn::verts(m))
      if (const cn::vec3 x = cn::point(m, v), d = length * frames.verts[v][k]; keep(x)) lines.push_back({x - d, x + d});
    s.add_lines(lines, {.radius = 0.1 * length, .color = cn::srgb(0.25f, 0.45f, 0.7f)});
  }
}

int main(int argc, char** argv) {
  const auto box = cn::make_box<cn::hexmesh>({.cells = {4, 4, 4}});
  report("box of hexes", box, cn::frame_field(box));

  const auto cylinder = cn::make_cylinder<cn::tetmesh>({.cells = {24, 8}, .height = 1.5});
  const auto in_cylinder = cn::frame_field(cylinder);
  const auto four = report("cylinder of tets", cylinder, in_cylinder);

  const auto ball = cn::make_sphere<cn::polyhedralmesh>({.cells = 6});
  const auto in_ball = cn::frame_field(ball);
  const auto twelve = report("ball of polyhedra", ball, in_ball);

  double worst = 0;  // the first vector is the normal, where the boundary is smooth
  for (const auto v : cn::verts(ball))
    if (cn::is_boundary(ball, v)) worst = std::max(worst, cn::distance(in_ball.verts[v][0], cn::vert_normal(ball, v)));
  fmt::print("on the boundary of the ball the frames are {}\n", worst < 1e-8 ? "aligned to the normals" : "not aligned");

  if (argc > 1) {
    std::vector<cn::scene> scenes(2);
    scenes[0].add(cylinder, {.opacity = 0.15});
    scenes[0].add_graph(four.lines, {.radius = 0.025});
    add_frames(scenes[0], cylinder, in_cylinder, 0.07, [](const cn::vec3& x) { return std::abs(x.z - 1.5) < 1e-9; });
    scenes[1].add(ball, {.opacity = 0.15});
    scenes[1].add_graph(twelve.lines, {.radius = 0.025});
    std::vector<cn::image> pictures;
    for (const auto& s : scenes)
      pictures.push_back(cn::render(s, {.width = 170, .height = 170, .camera = cn::view_options{.towards = {0.4, 1, -0.7}, .up = {0, 0, 1}}, .samples = 4, .ground = false}));
    cn::save_png(cn::make_sheet(pictures, {.columns = 2, .captions = {"a cylinder", "a ball"}}), argv[1]);
  }
}
