// A picture in five lines: a mesh, a function on it, and a scene with both, saved as a PNG file. No display is needed, and no other library.
#include <concino/fields/harmonic_map.hpp>
#include <concino/generate/torus.hpp>
#include <concino/mesh.hpp>
#include <concino/render/scene.hpp>
#include <concino/render/scene_png.hpp>

#include <fmt/core.h>

#include <filesystem>
#include <string>

namespace cn = concino;

int main(int argc, char** argv) {
  const std::string path = argc > 1 ? argv[1] : "a.png";
  const unsigned width = argc > 1 ? 400 : 80;  // larger if there is a name

  const auto m = cn::make_torus<cn::quadmesh>({.cells = {40, 20}});
  const auto u = cn::harmonic_map(m, {{cn::vert_id{0}, 0.0}, {cn::vert_id{410}, 1.0}});
  cn::scene s;
  s.add(m, {.field = u, .isobands = 12, .edges = true});
  cn::save_png(s, path, {.width = width, .height = width * 3 / 4, .up = {0, 0, 1}, .title = "A harmonic map", .legend = {.title = "u"}});

  fmt::print("a picture of {} quads: {}\n", cn::num_polys(m), std::filesystem::file_size(path) > 1000 ? "written" : "empty");
}
