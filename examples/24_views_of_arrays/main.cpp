// Use arrays as meshes, without an adapter and without a copy: spans and vectors of coordinates and of corners, for triangles, tets and hexes.
// <concino/adapters/eigen.hpp> does the same for matrices.
#include <concino/adapters/span.hpp>
#include <concino/geometry.hpp>
#include <concino/graph.hpp>
#include <concino/mesh/corner_orders.hpp>
#include <concino/validate.hpp>

#include <fmt/core.h>

#include <array>
#include <span>
#include <vector>

namespace cn = concino;

int main() {
  // The corners of a box, and its surface: two triangles per side, counter-clockwise seen from outside.
  std::vector<double> xyz = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 0, 2, 1, 0, 2, 0, 1, 2, 1, 1, 2};
  const std::vector<int> triangles = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
  auto surface = cn::view_tri(xyz, triangles);
  fmt::print("surface: {} edges, area {}, from corner to corner {:.4f}\n", cn::num_edges(surface), cn::total_measure(surface),
             cn::dijkstra(surface, cn::vert_id{0})[cn::vert_id{7}]);

  // For pointers, use spans; the view reads them in place. Seen from corner 3 of a tet, corners 0, 1, 2 run counter-clockwise ...
  const unsigned cells[] = {0, 1, 2, 4, 3, 2, 1, 7, 5, 4, 7, 1, 6, 7, 4, 2, 1, 2, 4, 7};
  const std::span<const unsigned> list(cells);
  const auto tets = cn::view_tet(xyz, list);
  fmt::print("tets: {} faces, volume {}, {} defects\n", cn::num_faces(tets), cn::total_measure(tets), cn::validate(tets).count());

  // ... and where a library lists them clockwise, pass tet_order::mirrored.
  std::vector<std::array<unsigned, 4>> mirrored;
  for (std::size_t i = 0; i < list.size(); i += 4) mirrored.push_back({list[i], list[i + 1], list[i + 3], list[i + 2]});
  fmt::print("clockwise: {}\n", cn::validate(cn::view_tet(xyz, mirrored))[0].what);
  fmt::print("with tet_order::mirrored: volume {}\n", cn::total_measure(cn::view_tet(xyz, mirrored, cn::tet_order::mirrored)));

  // A hex lists its bottom, then its top, both counter-clockwise seen from above. The corners here run along x, y, z instead.
  const std::vector<long> hex = {0, 1, 2, 3, 4, 5, 6, 7};
  fmt::print("hex: {}\n", cn::validate(cn::view_hex(xyz, hex))[0].what);
  const auto box = cn::view_hex(xyz, hex, cn::hex_order::lexicographic);
  fmt::print("with hex_order::lexicographic: volume {}, {} defects\n", cn::total_measure(box), cn::validate(box).count());

  // All views read the same numbers: a change through one of them, or in the array, changes all of them.
  cn::set_point(surface, cn::vert_id{7}, std::array{1., 1., 3.});
  xyz[3 * 6 + 2] = 3;
  fmt::print("two corners raised: area {:.4f}, volumes {:.4f} and {:.4f}\n", cn::total_measure(surface), cn::total_measure(tets), cn::total_measure(box));
}
