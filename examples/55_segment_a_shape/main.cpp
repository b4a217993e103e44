// Divide a shape into parts: by clusters and cuts along concave edges, by costs of your own, and by a minimum cut between two places.
#include <concino/convert.hpp>
#include <concino/generate/grid.hpp>
#include <concino/geometry.hpp>
#include <concino/graph/min_cut.hpp>
#include <concino/graph/segment_by_shape.hpp>
#include <concino/mesh.hpp>
#include <concino/render.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <vector>

namespace cn = concino;

/// The surface of a lamp on a table, of unit squares: four legs, a plate, a pole and a shade.
cn::quadmesh make_table() {
  const auto blocks = cn::make_grid<cn::hexmesh>({.cells = {16, 16, 24}, .max = {16, 16, 24}});
  const auto shape = cn::submesh(blocks, [&](cn::poly_id p) {
    const cn::vec3 x = cn::centroid(blocks, p);
    const double r = std::max(std::abs(x.x - 8), std::abs(x.y - 8));
    const bool leg = std::min(std::abs(x.x - 8), std::abs(x.y - 8)) > 5 && x.z < 10;
    return leg || (x.z > 8 && x.z < 10) || (r < 1 && x.z > 10 && x.z < 18) || (r < 4 && x.z > 17);
  });
  const auto solid = cn::convert<cn::hexmesh>(shape);
  return cn::convert<cn::quadmesh>(cn::boundary(solid));
}

template<class Labels>
cn::image draw(const cn::quadmesh& m, const Labels& labels) {
  cn::scene s;
  s.add(m, {.labels = labels, .edges = true, .edge_width = 0.5});
  return cn::render(s, {.width = 220, .height = 280, .camera = cn::view_options{.towards = {0.7, -1, 0.35}, .up = {0, 0, 1}}, .samples = 4, .ground = false});
}

int main(int argc, char** argv) {
  const cn::quadmesh m = make_table();
  std::vector<cn::image> pictures;
  std::vector<std::string> captions;
  const auto show = [&](const auto& label, const std::string& caption) {
    double length = 0, concave = 0;
    for (const auto e : cn::edges(m)) {
      const auto p = cn::adj_e2p(m, e).begin();
      if (label[*p] == label[*std::next(p)]) continue;
      length += cn::edge_length(m, e);
      if (cn::dihedral_angle(m, e) > 3.2) concave += cn::edge_length(m, e);
    }
    fmt::print("{:<22} boundaries of length {:3.0f}, {:3.0f} of them along concave edges\n", caption, length, concave);
    if (argc > 1) pictures.push_back(draw(m, label));
    captions.push_back(caption);
  };
  fmt::print("{} squares\n", cn::num_polys(m));

  // Parts of squares that are near each other: clusters alone, and then cut where boundaries are short and concave.
  const auto near = cn::part_likeness::distance;
  const auto clusters = cn::segment_by_shape(m, {.labels = 7, .likeness = near, .smoothness = 0});
  show(clusters.label, "clusters");
  const auto parts = cn::segment_by_shape(m, {.labels = 7, .likeness = near, .smoothness = 0.3, .concave_cost = 0.05});
  show(parts.label, "cut at concave edges");

  // Costs of your own: what is low, in the middle or high, but with short boundaries.
  const auto cost = [&](cn::poly_id p, int label) { return std::abs(cn::centroid(m, p).z - (4 + 8 * label)); };
  const auto bands = cn::segment_polys(m, cost, {.labels = 3, .smoothness = 4});
  show(bands.label, "three heights");
  fmt::print("the energy was {:.0f} at first, {:.0f} at the end; rounds: {}\n", bands.rounds.front(), bands.energy, bands.rounds.size() - 1);

  // Where would it break if its feet were fixed and the top were pulled? At the thinnest place between them.
  std::vector<cn::poly_id> foot, top;
  for (const auto p : cn::polys(m)) {
    if (cn::centroid(m, p).z == 0) foot.push_back(p);
    if (cn::centroid(m, p).z == 24) top.push_back(p);
  }
  const auto cut = cn::min_cut(m, foot, top, [](auto, auto) { return 1.0; });
  show(cut.on_source_side, "the thinnest place");
  fmt::print("the cut crosses {} edges\n", cut.arcs.size());

  if (argc > 1) cn::save_png(cn::make_sheet(pictures, {.columns = 4, .captions = captions}), argv[1]);
}
