// Find where a solid breaks, as a minimum cut. A bar of tets with a notch is pulled at both ends. Its tets are the nodes of a Boost graph; each face between
// two tets is an arc, with its area as capacity. The maximum flow from end to end is the smallest area that separates the ends: the minimum cut.
#include <concino/geometry.hpp>
#include <concino/graph/boost.hpp>
#include <concino/mesh.hpp>

#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <fmt/core.h>

#include <utility>
#include <vector>

namespace cn = concino;

/// A bar of 8 x 3 x 3 cubes without those of the notch. Each cube is cut into six tets around a diagonal.
cn::tetmesh notched_bar() {
  std::vector<cn::vec3> points;
  std::vector<std::vector<int>> tets;
  for (int k = 0; k <= 3; ++k)
    for (int j = 0; j <= 3; ++j)
      for (int i = 0; i <= 8; ++i) points.push_back({i, j, k});
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 8; ++i) {
        if (i == 5 && k > 0) continue;  // the notch: one layer of cubes is left
        const int a = (k * 4 + j) * 9 + i, x = 1, y = 9, z = 36;
        for (const auto& [s, t] : {std::pair{x, y}, {y, z}, {z, x}}) {
          tets.push_back({a, a + s, a + s + t, a + x + y + z});
          tets.push_back({a, a + s + t, a + t, a + x + y + z});
        }
      }
  return cn::tetmesh(points, tets);
}

int main() {
  const cn::tetmesh bar = notched_bar();
  const auto at = [&](cn::poly_id p) { return cn::centroid(bar, p).x; };
  // The capacity between two tets: the area of their common face, or unlimited within the ends, where the bar is fixed.
  const auto strength = [&](cn::poly_id p, cn::poly_id q) {
    if ((at(p) < 1 && at(q) < 1) || (at(p) > 7 && at(q) > 7)) return 1e6;
    for (cn::face_id f : cn::adj_p2f(bar, p))
      for (cn::poly_id other : cn::adj_f2p(bar, f))
        if (other == q) return cn::area(bar, f);
    return 0.0;
  };

  const auto g = cn::directed(cn::dual(bar));
  const auto index = get(boost::vertex_index, g);
  const auto capacity = cn::boost_edge_map<double>(g, strength);
  const auto residual = cn::boost_edge_map<double>(g);
  auto side = cn::make_poly_map<boost::default_color_type>(bar);
  const cn::poly_id left{0}, right{cn::num_polys(bar) - 1};
  const auto reverse = get(boost::edge_reverse, g);
  const double flow = boost::boykov_kolmogorov_max_flow(g, capacity, residual, reverse, cn::boost_map(side), index, left, right);

  std::size_t kept = 0;
  double cut = 0;
  for (cn::poly_id p : cn::polys(bar)) kept += side[p] == side[left];
  for (auto [a, last] = edges(g); a != last; ++a)
    if (side[source(*a, g)] == side[left] && side[target(*a, g)] != side[left]) cut += capacity[*a];
  fmt::print("{} tets, {} faces between them\n", cn::num_polys(bar), num_edges(g) / 2);
  fmt::print("the bar breaks along an area of {:.3f}: the flow is {:.3f}\n", cut, flow);
  fmt::print("{} tets stay on the left, {} on the right\n", kept, cn::num_polys(bar) - kept);
}
