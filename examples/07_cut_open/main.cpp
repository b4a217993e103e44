// Cut a torus open into a disk. Two loops, around its tube and through its hole, generate all others. After cutting along both, the torus is one square
// sheet, a disk. The same code cuts a surface with any number of holes into one disk.
#include <concino/graph.hpp>
#include <concino/mesh.hpp>

#include <fmt/core.h>

#include <cmath>
#include <vector>

namespace cn = concino;

/// The Euler characteristic, verts - edges + polys: 2 on a sphere, 0 on a torus, 1 on a disk.
template<class M>
int chi(const M& m) {
  return int(cn::num_verts(m)) - int(cn::num_edges(m)) + int(cn::num_polys(m));
}

int main() {
  const int n = 12, k = 30;  // quads around the tube, and along it
  std::vector<cn::vec3> points;
  std::vector<std::vector<int>> quads;
  for (int j = 0; j < k; ++j)
    for (int i = 0; i < n; ++i) {
      const double a = 6.283185307 * i / n, b = 6.283185307 * j / k;
      points.push_back({(3 + std::cos(a)) * std::cos(b), (3 + std::cos(a)) * std::sin(b), std::sin(a)});
      const int right = (i + 1) % n, up = (j + 1) % k;
      quads.push_back({j * n + i, up * n + i, up * n + right, j * n + right});
    }
  const cn::quadmesh torus(points, quads);
  fmt::print("torus: {} verts, chi {}, genus {}, {} borders\n", cn::num_verts(torus), chi(torus), (2 - chi(torus)) / 2,
             cn::boundary_loops(torus).count);

  // A spanning tree of verts, and a spanning tree of polys that does not cross it. Each edge in neither tree closes one loop.
  const auto trees = cn::tree_cotree(torus);
  fmt::print("{} edges: {} in the tree, {} crossed by the cotree, {} left\n", cn::num_edges(torus), trees.tree.size(), trees.cotree.size(),
             trees.rest.size());
  const auto loops = cn::homology_generators(torus);
  for (const auto& loop : loops) {
    double length = 0;
    for (std::size_t i = 0; i < loop.verts.size(); ++i)
      length += norm(cn::point(torus, loop.verts[i]) - cn::point(torus, loop.verts[(i + 1) % loop.verts.size()]));
    fmt::print("a loop of {} edges, length {:.3f}\n", loop.edges.size(), length);
  }

  const auto cut = cn::cut_along(torus, loops);
  const cn::quadmesh disk(cut.surface);
  const auto border = cn::boundary_loops(disk);
  fmt::print("cut open: {} verts, chi {}, {} border of {} edges\n", cn::num_verts(disk), chi(disk), border.count,
             border.loops[0].edges.size());

  // The corners of the square: where both cuts cross, one vert has four copies.
  int copies = 0;
  for (const auto v : cut.verts) copies += v == loops[0].verts[0];
  fmt::print("where the loops cross, one vert became {}\n", copies);
}
