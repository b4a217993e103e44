// Bones and a tube around them: a skeleton becomes a closed surface of quads, which subdivision makes smooth, and each vert of it knows its bone. The picture shows
// the skeleton, its tube, the smooth surface, and the parts of that near each bone.
#include <concino/generate.hpp>
#include <concino/io/skeleton.hpp>
#include <concino/mesh.hpp>
#include <concino/render.hpp>
#include <concino/skeleton.hpp>

#include <fmt/core.h>

#include <cmath>
#include <vector>

namespace cn = concino;

// A figure with a ring as its head: ids, points, radii and neighbours.
constexpr const char* figure =
    "ID Cx Cy Cz RADIUS #NEIGHBORS NEIGHBORS_LIST\n12\n0 0 0 0 0.5 3 1 2 3\n1 -1.5 0 -4 0.3 1 0\n2 1.5 0 -4 0.3 1 0\n3 0 0 3 0.5 4 0 4 5 6\n"
    "4 -3 0 1.5 0.3 1 3\n5 3 0 1.5 0.3 1 3\n6 0 0 4.5 0.35 3 3 7 11\n7 -1 0 5 0.3 2 6 8\n8 -1.2 0 6.2 0.3 2 7 9\n9 0 0 7 0.3 2 8 10\n10 1.2 0 6.2 0.3 2 9 11\n"
    "11 1 0 5 0.3 2 10 6\n";

int main(int argc, char** argv) {
  const cn::skeleton drawn = cn::load_skeleton_text(figure);
  fmt::print("{} leaves, {} joints\n", cn::leaves(drawn).size(), cn::joints(drawn).size());
  for (const auto& b : cn::bones(drawn)) {
    const auto middle = cn::sample(b, 0.5);
    fmt::print("a bone of length {:.3f} from vert {} to vert {}{}; in its middle the radius is {:.3f}\n", cn::length(b), b.verts.front().raw(), b.verts.back().raw(),
               b.is_cycle() ? ", a cycle" : "", middle.radius);
  }

  // Verts at even distances, and a surface of quads around them: its genus is the number of independent cycles.
  const cn::skeleton even = cn::respace(drawn, 0.7);
  const cn::quadmesh quads = cn::tube(even);
  const long euler = static_cast<long>(cn::num_verts(quads)) - static_cast<long>(cn::num_edges(quads)) + static_cast<long>(cn::num_polys(quads));
  fmt::print("respaced: {} verts; the tube has {} quads, and genus {}\n", cn::num_verts(even), cn::num_polys(quads), (2 - euler) / 2);

  // A smooth surface, and the bone that is nearest to each of its verts: labels for colours, or weights for moving it.
  const cn::quadmesh surface = cn::subdivide_catmull_clark(cn::subdivide_catmull_clark(quads));
  const auto all = cn::bones(even);
  const auto nearest = cn::nearest_bone(surface, all);
  for (std::size_t b = 0; b < all.size(); ++b) {
    std::size_t verts = 0;
    for (const auto v : cn::verts(surface)) verts += nearest[v] == b;
    fmt::print("bone {} is the nearest one of {} verts of the smooth surface\n", b, verts);
  }

  // The middle of the longest bone becomes a vert of the skeleton.
  std::size_t longest = 0;
  for (std::size_t b = 0; b < all.size(); ++b)
    if (cn::length(all[b]) > cn::length(all[longest])) longest = b;
  const auto split = cn::split_bone(even, all[longest], 0.5);
  fmt::print("the longest bone is {}; split in its middle, the skeleton has {} verts\n", longest, cn::num_verts(split.result));

  if (argc > 1) {
    std::vector<cn::scene> scenes(4);
    scenes[0].add_graph(drawn, {.color = cn::srgb(0.85f, 0.5f, 0.2f), .radii = drawn.radii()});
    scenes[1].add(quads, {.edges = true});
    scenes[2].add(surface);
    auto color = cn::make_vert_map<cn::rgb>(surface);
    for (const auto v : cn::verts(surface)) color[v] = cn::label_color(nearest[v]);
    scenes[3].add(surface, {.colors = color});
    std::vector<cn::image> pictures;
    for (const auto& s : scenes)
      pictures.push_back(cn::render(s, {.width = 130, .height = 215, .camera = cn::view_options{.towards = {0.3, 1, -0.1}, .up = {0, 0, 1}}, .samples = 4, .ground = false}));
    cn::save_png(cn::make_sheet(pictures, {.columns = 4, .captions = {"bones", "their tube", "smooth", "nearest bones"}}), argv[1]);
  }
}
