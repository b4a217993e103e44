// A web page for a colleague: one file that any browser opens from disk. She turns the mesh, changes colours, and picks verts to read their values.
#include <concino/fields.hpp>
#include <concino/generate.hpp>
#include <concino/graph.hpp>
#include <concino/mesh.hpp>
#include <concino/render/scene.hpp>
#include <concino/render/scene_html.hpp>

#include <fmt/core.h>

#include <filesystem>
#include <string>
#include <vector>

namespace cn = concino;

int main(int argc, char** argv) {
  auto m = cn::make_torus<cn::trimesh>({.cells = {60, 30}, .radius = 1, .tube_radius = 0.4});
  std::vector<cn::vert_t<cn::trimesh>> all;
  for (auto v : cn::verts(m)) all.push_back(v);

  // What the page tells about a vert: all named properties, next to the field that gives the colours.
  const auto from = all.front(), to = all[all.size() / 2 + 15];
  const auto distance = cn::heat_geodesics(m, from);
  auto step = cn::vert_property<int>(m, "edges from the start");
  const auto steps = cn::bfs(m, from);
  for (auto v : all) step[v] = steps[v];
  const auto path = cn::shortest_path(m, from, to);

  // The scene is the one of a picture. `inspect` keeps the elements, so that the page can pick and cut.
  cn::scene s;
  s.add(m, {.field = distance, .isobands = 12, .inspect = true, .name = "ring"});
  s.add_lines(m, path, {.color = cn::srgb(0.8f, 0.1f, 0.1f)}).last().name = "shortest path along edges";
  s.add_label(cn::to_vec3(cn::point(m, from)), "start");

  const std::string file = argc > 1 ? argv[1] : "ring.html";
  cn::save_html(s, file, {.title = "Distances on a ring"});
  fmt::print("{} objects in one file of {} kB\n", s.drawables().size(), std::filesystem::file_size(file) > 100000 ? "more than 100" : "few");
}
