// The program of the paper (see docs/glossary.md): a harmonic function on a mesh, 0 at one vert and 1 at another. The same file is compiled for all six
// mesh types; only MESH_T changes. With the name of a file, the program also draws a picture.
#include <concino/fields.hpp>
#include <concino/io.hpp>
#include <concino/mesh.hpp>
#include <concino/render/scene.hpp>
#include <concino/render/scene_png.hpp>

#include <fmt/core.h>

#include "file_of.hpp"

namespace cn = concino;

int main(int argc, char** argv) {
  const MESH_T m = cn::load<MESH_T>(file_of<MESH_T>);
  const cn::vert_id a{0}, b{cn::num_verts(m) - 1};
  const auto u = cn::harmonic_map(m, {{a, 0.0}, {b, 1.0}});
  for (cn::vert_id v : cn::verts(m))
    if (v.raw() % 7 == 0) fmt::print("u({}) = {:.6f}\n", v.raw(), u[v]);
  if (argc > 1) cn::save_png(cn::scene().add(m, {.field = u, .isobands = 10, .edges = true}), argv[1], {.width = 240, .height = 180});
}
