// The mountains of a function: which of its many hills and valleys are large, and how they lie. A landscape of three hills is roughened; the small ones are
// removed again. Then the shape of a torus is read off a function on it.
#include <concino/fields.hpp>
#include <concino/generate.hpp>
#include <concino/mesh.hpp>
#include <concino/render/scene.hpp>
#include <concino/render/scene_png.hpp>

#include <fmt/core.h>

#include <cmath>
#include <vector>

namespace cn = concino;

int main(int argc, char** argv) {
  const auto m = cn::make_grid<cn::quadmesh>({.cells = {60, 60}});
  auto u = cn::make_vert_map<double>(m);
  const auto hill = [](const cn::vec3& x, const cn::vec3& top, double height) { return height * std::exp(-40 * cn::dot(x - top, x - top)); };
  for (const auto v : cn::verts(m)) {
    const cn::vec3 x = cn::to_vec3(cn::point(m, v));
    u[v] = hill(x, {0.25, 0.3, 0}, 1) + hill(x, {0.7, 0.25, 0}, 0.8) + hill(x, {0.55, 0.75, 0}, 0.6) + 0.01 * std::sin(97 * x.x) * std::sin(89 * x.y);
  }

  // Minima, saddles and maxima. Their alternating sum is the Euler characteristic, 1 of a square, however rough the function is.
  const auto critical = cn::critical_points(m, u);
  fmt::print("{} minima - {} saddles + {} maxima = {}\n", critical.count[0], critical.count[1], critical.count[2],
             static_cast<int>(critical.count[0]) - static_cast<int>(critical.count[1]) + static_cast<int>(critical.count[2]));

  // A hill of large persistence is high above the pass to a higher one.
  const auto pairs = cn::persistence(m, u);
  fmt::print("the most persistent of {} maxima:\n", pairs.maxima.size());
  for (std::size_t k = 0; k < 4; ++k) {
    const auto& p = pairs.maxima[k];
    const auto x = cn::point(m, p.extremum);
    fmt::print("  height {:.2f} at ({:.2f}, {:.2f}), ", u[p.extremum], x[0], x[1]);
    if (p.saddle) fmt::print("{:.2f} above its pass\n", p.persistence);
    else fmt::print("the highest of all\n");
  }

  // Without the small ones, each vert belongs to one of three hills.
  const auto smooth = cn::simplified(m, u, {.maxima_below = 0.1});
  const auto regions = cn::regions_of_maxima(m, smooth);
  auto change = cn::make_vert_map<double>(m), share = change;
  for (const auto v : cn::verts(m)) {
    change[v] = u[v] - smooth[v];
    share[v] = regions[v] == 0 ? 1 : 0;
  }
  fmt::print("simplified: {} hills, lowered by at most {:.3f}; the highest has {:.0f} percent of the area\n", regions.extrema.size(), cn::statistics(m, change).max,
             100 * cn::statistics(m, share).mean);

  // The contour tree says how the level sets of that function join: a branch for each of three hills, and one that joins two of them.
  const auto valleys_gone = cn::simplified(m, smooth, {.minima_below = 0.1});
  const auto tree = cn::contour_tree(m, valleys_gone);
  std::size_t long_arcs = 0;
  for (const auto& a : tree.arcs) long_arcs += valleys_gone[tree.nodes[a.upper]] - valleys_gone[tree.nodes[a.lower]] > 0.1;
  fmt::print("contour tree: {} arcs higher than 0.1 of {}\n", long_arcs, tree.arcs.size());

  // A torus on its side: the Reeb graph has a loop, and the harmonic fields of its triangles have dimension 2.
  const auto torus = cn::make_torus<cn::trimesh>({.cells = {30, 12}});
  auto height = cn::make_vert_map<double>(torus);
  for (const auto v : cn::verts(torus)) height[v] = cn::dot(cn::to_vec3(cn::point(torus, v)), {1, 0.01, 0.003});
  const auto graph = cn::reeb_graph(torus, height);
  for (const auto& a : graph.arcs) fmt::print("arc from {} to {} with {} verts\n", a.lower, a.upper, graph.verts_of(a).size());
  const auto parts = cn::hodge_decomposition(torus, cn::make_poly_map<cn::vec3>(torus, cn::vec3{0, 0, 1}));
  fmt::print("loops: {}, dimension of the harmonic fields: {}\n", graph.arcs.size() - graph.nodes.size() + 1, parts.harmonic_dimension);

  // A picture, if the program is given the name of a file: the simplified function as a landscape, with balls on its hills.
  if (argc > 1) {
    auto lifted = cn::make_vert_map<cn::vec3>(m);
    for (const auto v : cn::verts(m)) lifted[v] = cn::to_vec3(cn::point(m, v)) + cn::vec3{0, 0, 0.4 * valleys_gone[v]};
    std::vector<cn::vec3> tops;
    for (const auto v : regions.extrema) tops.push_back(lifted[v]);
    cn::scene s;
    s.add(cn::with_points(m, lifted), {.field = valleys_gone, .isobands = 12}).add_points(tops, {.radius = 0.015});
    cn::save_png(s, argv[1], {.width = 420, .height = 290, .up = {0, 0, 1}, .legend = {.title = "u"}});
  }
}
