// Find shortest paths on four graphs with the same line of code: from vert to vert or from poly to poly, on a surface or in a volume.
// The type of the source selects the graph: a vert selects the primal graph, a poly the dual graph.
#include <concino/graph.hpp>
#include <concino/mesh.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <vector>

namespace cn = concino;

/// The largest distance from `source`.
template<class M, class Source>
double reach(const M& m, Source source) {
  const auto distance = cn::dijkstra(m, source);  // the same line for all four graphs
  double farthest = 0;
  for (double d : distance.values()) farthest = std::max(farthest, d);
  return farthest;
}

int main() {
  const int n = 10;
  std::vector<cn::vec3> points;
  std::vector<std::vector<int>> quads, hexes;
  for (int k = 0; k <= n; ++k)
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) points.push_back({i, j, k});
  const auto id = [](int i, int j, int k) { return (k * (n + 1) + j) * (n + 1) + i; };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      quads.push_back({id(i, j, 0), id(i + 1, j, 0), id(i + 1, j + 1, 0), id(i, j + 1, 0)});
      for (int k = 0; k < n; ++k)
        hexes.push_back({id(i, j, k), id(i + 1, j, k), id(i + 1, j + 1, k), id(i, j + 1, k),
                         id(i, j, k + 1), id(i + 1, j, k + 1), id(i + 1, j + 1, k + 1), id(i, j + 1, k + 1)});
    }
  const cn::hexmesh volume(points, hexes);
  points.resize((n + 1) * (n + 1));  // the lowest layer
  const cn::quadmesh surface(points, quads);

  fmt::print("farthest vert, surface: {}\n", reach(surface, cn::vert_id{0}));
  fmt::print("farthest vert, volume:  {}\n", reach(volume, cn::vert_id{0}));
  fmt::print("farthest poly, surface: {}\n", reach(surface, cn::poly_id{0}));
  fmt::print("farthest poly, volume:  {}\n", reach(volume, cn::poly_id{0}));

  // Any function can give the lengths, and `targets` stops the search early.
  const auto hops = cn::dijkstra(volume, cn::poly_id{0}, [](auto, auto) { return 1.0; }, {.targets = {cn::poly_id{5}}});
  fmt::print("poly 5 is {} faces away\n", hops[cn::poly_id{5}]);
}
