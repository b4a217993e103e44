// From a hex mesh to its blocks, and a sheet of hexes that is taken out and put back. The picture shows a ball of hexes with its seven blocks, one of its
// sheets, the mesh without it, and a layer of hexes that is inserted around the rest.
#include <concino/edit.hpp>
#include <concino/generate.hpp>
#include <concino/layout.hpp>
#include <concino/mesh.hpp>
#include <concino/quality.hpp>
#include <concino/render.hpp>

#include <fmt/core.h>

#include <vector>

namespace cn = concino;

void say(const char* what, const cn::hexmesh& m) {
  fmt::print("{}: {} hexes, worst scaled Jacobian {:.3f}\n", what, cn::num_polys(m), cn::worst(m, cn::metric::scaled_jacobian).value);
}

int main(int argc, char** argv) {
  const auto ball = cn::make_sphere<cn::hexmesh>({.cells = 4});
  say("a ball", ball);

  // Where other than four hexes meet at an edge, the mesh is not like a grid. Faces that go straight on from there divide it into grids.
  fmt::print("{} singular edges, {} singular verts\n", cn::singular_edges(ball).size(), cn::singular_verts(ball).size());
  const auto layout = cn::coarse_layout(ball);
  for (const auto& b : layout.sizes) fmt::print("a block of {} x {} x {} hexes\n", b.size[0], b.size[1], b.size[2]);
  fmt::print("as a mesh of their own: {} hexes, {} verts\n", cn::num_polys(*layout.blocks), cn::num_verts(*layout.blocks));

  // Each corner knows its place in the grid of its block, for coordinates of textures or for structured solvers.
  const auto at = layout.position[{cn::poly_id{0}, 6}];
  fmt::print("corner 6 of the first hex: block {}, ({}, {}, {})\n", layout.block[cn::poly_id{0}], at[0], at[1], at[2]);

  // A sheet: the hexes between edges that are parallel to one another. Here are all of them, by their sizes.
  const auto sheets = cn::sheets(ball);
  for (const auto& s : sheets)
    fmt::print("a sheet of {} hexes{}{}\n", s.polys.size(), s.is_closed ? ", closed" : "", s.crosses_itself ? ", crosses itself" : "");

  // A sheet is taken out, unless that would change the topology, or make a hex worse than is asked for.
  cn::hexmesh m = ball;
  const auto sheet = cn::sheet_of(m, sheets[3].edges[0]);
  const auto refused = cn::can_collapse_sheet(m, sheet, {.keep = {cn::min_quality(0.9, cn::metric::scaled_jacobian)}});
  fmt::print("with scaled Jacobians of 0.9: {}\n", refused ? "allowed" : refused.why);
  const auto back = cn::collapse_sheet(m, sheet, {.keep = {cn::min_quality(0.1, cn::metric::scaled_jacobian)}});
  say("without the sheet", m);
  const cn::hexmesh coarser = m;

  // The faces to which it collapsed are where it is put back.
  cn::insert_sheet(m, back.faces);
  say("with it again", m);
  fmt::print("{} blocks, {} sheets\n", cn::coarse_layout(m).num_blocks, cn::sheets(m).size());

  // A layer of hexes along the boundary is a sheet as well, around all hexes.
  cn::hexmesh layered = coarser;
  const std::vector<cn::poly_id> all(cn::polys(layered).begin(), cn::polys(layered).end());
  const auto layer = cn::pillow(layered, all, {.thickness = 0.25});
  say("with a layer along the boundary", layered);

  if (argc > 1) {
    const auto open = [](const auto& mesh, const auto& label) {
      cn::scene s;
      s.add(mesh, {.labels = label, .edges = true, .visible = cn::below('x', 0) || cn::above('y', 0) || cn::below('z', 0)});
      return cn::render(s, {.width = 250, .height = 250, .camera = cn::view_options{.towards = {1, -0.8, 0.9}, .up = {0, 0, 1}}, .samples = 4, .ground = false});
    };
    auto block = cn::make_poly_map<int>(ball), in_sheet = cn::make_poly_map<int>(ball), none = cn::make_poly_map<int>(coarser), in_layer = cn::make_poly_map<int>(layered);
    for (const auto p : cn::polys(ball)) block[p] = static_cast<int>(layout.block[p]);
    for (const auto p : sheet.polys) in_sheet[p] = 1;
    for (const auto p : layer.polys) in_layer[p] = 1;
    const std::vector<cn::image> pictures{open(ball, block), open(ball, in_sheet), open(coarser, none), open(layered, in_layer)};
    cn::save_png(cn::make_sheet(pictures, {.columns = 4, .captions = {"blocks", "a sheet", "without it", "with a layer"}}), argv[1]);
  }
}
