// Test the adapter of your own mesh. An adapter that compiles may still be wrong: conformance() checks every law, range, thread and algorithm that it can,
// and reports in words what it found.
#include "adapters.hpp"

#include <concino/testing/conformance.hpp>

#include <fmt/core.h>

namespace cn = concino;

wings::Mesh tent() {  // a pyramid with one of its four triangles missing, and a vertex that no face uses
  return {{0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0, 1, 1, 2, 5, 5, 5}, {{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}}};
}

/// A pyramid on top of a box. `lid`: the half-face that closes the box at the top.
hfm::PolyhedralMesh two_cells(int lid = 2) {
  hfm::PolyhedralMesh m;
  for (const float z : {0.f, 1.f})
    for (const auto& [x, y] : {std::pair(0.f, 0.f), std::pair(1.f, 0.f), std::pair(1.f, 1.f), std::pair(0.f, 1.f)}) m.addVertex(x, y, z);
  m.addVertex(0.5f, 0.5f, 2);
  for (const auto& face : {std::vector<int>{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}) m.addFace(face);
  for (const auto& face : {std::vector<int>{4, 5, 8}, {5, 6, 8}, {6, 7, 8}, {7, 4, 8}}) m.addFace(face);
  m.addCell({0, lid, 4, 6, 8, 10});
  m.addCell({3, 12, 14, 16, 18});
  return m;
}

int main() {
  fmt::print("winged edges\n{}\n", cn::conformance(tent).text());

  //! [proof]
  const hfm::PolyhedralMesh cells = two_cells();
  fmt::print("half-faces\n{}\n", cn::conformance([&] { return indexed_volume_of(cells); }).text());
  //! [proof]

  const CornerTable corners({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, {0, 1, 2, 0, 2, 3});
  fmt::print("corner table\n{}\n", cn::conformance([&] { return indexed_corners(corners); }).text());

  // What a mistake looks like: the box has the half-face that belongs to the pyramid.
  const hfm::PolyhedralMesh turned = two_cells(3);
  fmt::print("half-faces, one of the wrong orientation\n{}", cn::conformance([&] { return indexed_volume_of(turned); }).text());
}
