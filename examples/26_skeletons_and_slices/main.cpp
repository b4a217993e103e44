// Files that hold no mesh: a curve skeleton, a graph with radii on which all graph algorithms run; and the slices of a part, for printing it.
#include <concino/graph.hpp>
#include <concino/io/skeleton.hpp>
#include <concino/io/slices.hpp>
#include <concino/render/scene.hpp>
#include <concino/render/scene_png.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace cn = concino;

// A small tree: trunk, two branches, and a node without edges. Ids are any integers; each node lists its neighbours.
constexpr const char* tree =
    "ID Cx Cy Cz RADIUS #NEIGHBORS NEIGHBORS_LIST\n6\n10 0 0 0 2 1 20\n20 0 0 10 1.5 3 10 30 40\n30 -6 0 18 0.5 1 20\n40 3 0 14 1 2 20 50\n50 3 4 20 0.25 1 40\n99 9 9 9 1 0\n";

/// The outline of the tree at a height: a polygon around each edge that crosses it.
cn::slice_layer layer_of(const cn::skeleton& k, double z) {
  cn::slice_layer layer;
  layer.z = z;
  for (const cn::edge_id e : cn::edges(k)) {
    auto [a, b] = k.end_verts(e);
    if (cn::point(k, a).z > cn::point(k, b).z) std::swap(a, b);
    const cn::vec3 low = cn::point(k, a), high = cn::point(k, b);
    if (z < low.z || z >= high.z) continue;
    const double t = (z - low.z) / (high.z - low.z), radius = (1 - t) * k.radius(a) + t * k.radius(b);
    const cn::vec3 centre = (1 - t) * low + t * high;
    std::vector<cn::slice_point> contour;
    for (int i = 0; i < 12; ++i) contour.push_back({centre.x + radius * std::cos(i * M_PI / 6), centre.y + radius * std::sin(i * M_PI / 6)});
    layer.outer.push_back(contour, 7);
  }
  return layer;
}

int main(int argc, char** argv) {
  cn::load_report report;
  const cn::skeleton k = cn::load_skeleton_text(tree, {.report = &report});
  for (const auto& note : report.notes) fmt::print("note: {}\n", note);
  fmt::print("{} verts, {} edges, {} components\n", cn::num_verts(k), cn::num_edges(k), cn::connected_components(k).count);

  const cn::vert_id root{0};
  const auto distance = cn::dijkstra(k, root);
  cn::vert_id tip = root;
  for (const auto v : cn::verts(k))
    if (std::isfinite(distance[v]) && distance[v] > distance[tip]) tip = v;
  fmt::print("the farthest tip is vert {}, at {:.3f}, where the radius is {}\n", tip.raw(), distance[tip], k.radius(tip));

  cn::slices part;
  part.labels = {{7, "tree"}};
  for (int i = 0; i < 20; ++i) part.layers.push_back(layer_of(k, i + 0.5));
  cn::save_slices(part, "tree.cli");
  const cn::slices read = cn::load_slices("tree.cli");
  fmt::print("{} layers of {}, equal to those written: {}\n", read.layers.size(), read.label_of(7), read.layers == part.layers);
  for (const std::size_t i : {0u, 12u, 19u})
    fmt::print("z = {}: {} contours, {} points\n", read.layers[i].z, read.layers[i].outer.size(), read.layers[i].outer.points.size());

  cn::save_slices(part, "tree_binary.cli", {.binary = true});  // floats: about 7 digits
  double error = 0;
  const cn::slices rounded = cn::load_slices("tree_binary.cli");
  for (std::size_t i = 0; i < 24; ++i)
    error = std::max(error, std::abs(rounded.layers[12].outer.points[i][0] - part.layers[12].outer.points[i][0]));
  fmt::print("binary files round by up to {:.0e} mm\n", error);
  try {
    cn::save_slices(part, "tree_binary.cli", {.binary = true, .strict = true});
  } catch (const cn::unsupported& refused) {
    fmt::print("{}\n", refused.what());
  }

  // A picture, if the program is given the name of a file: the skeleton with its radii, and the slices beside it.
  if (argc > 1) {
    cn::scene s;
    std::vector<double> radii;
    for (const auto v : cn::verts(k)) radii.push_back(k.radius(v));
    s.add_graph(k, {.color = cn::srgb(0.80f, 0.80f, 0.82f), .radii = radii});
    for (const auto& layer : part.layers)
      for (std::size_t i = 0; i < layer.outer.size(); ++i) {
        std::vector<cn::vec3> line;
        for (const auto& x : layer.outer[i]) line.push_back({x[0] + 16, x[1], layer.z});
        s.add_lines(line, {.radius = 0.08, .closed = true});
      }
    cn::save_png(s, argv[1], {.width = 380, .height = 320, .up = {0, 0, 1}});
  }
}
