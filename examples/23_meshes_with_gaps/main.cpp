// Adapt meshes with gaps, without border half-edges, and with another order of corners: three adapters, each shorter than a screen, which the page
// docs/adapt-advanced.md explains. The state of the mesh after deletions is tested too.
#include "adapters.hpp"

#include <concino/adapters/span.hpp>
#include <concino/geometry.hpp>
#include <concino/validate.hpp>

namespace cn = concino;

student::Mesh plate() {  // seven quads and two triangles around a hole, and an isolated vertex
  return {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}, {3, 1, 0},
           {0, 2, 0}, {1, 2, 0}, {2, 2, 0}, {3, 2, 0}, {0, 3, 0}, {1, 3, 0}, {2, 3, 0}, {3, 3, 0}, {9, 9, 9}},
          {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {4, 5, 9, 8}, {6, 7, 11, 10}, {8, 9, 13, 12}, {9, 10, 14, 13}, {10, 11, 15}, {10, 15, 14}}};
}

//! [states]
#include <concino/testing/conformance.hpp>
#include <concino/validate/halfedge_links.hpp>

#include <fmt/core.h>

void delete_some(student::Mesh& m) {
  for (const unsigned f : {0u, 2u, 8u}) m.deleteFace(f);  // leaves faces that touch in a vertex only
  m.deleteVertex(0);
}

void prove() {
  fmt::print("half-edges\n{}", concino::conformance(plate, {.states = {{"after faces and a vertex were deleted", delete_some}}}).text());
  student::Mesh m = plate();
  delete_some(m);
  concino::assert_halfedge_links(m);  // cheap enough for every mesh that is loaded; throws an error that names the cause
}
//! [states]

int main() {
  prove();
  student::Mesh holes = plate();
  delete_some(holes);
  fmt::print("{} verts, index bound {}, area {}\n\n", cn::num_verts(holes), cn::vert_index_bound(holes), cn::total_measure(holes));

  const CornerTable fan({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 7, 7, 7}, {0, 1, 2, 0, 2, 3, 0, 3, 4});
  fmt::print("corner table\n{}\n", cn::conformance([&] { return corners(fan); }).text());

  const Bricks bricks(3, 2, 2);
  fmt::print("hexes\n{}\n", cn::conformance([&] { return indexed_bricks(bricks); }).text());

  // A mesh that half-edges cannot represent is reported ...
  const CornerTable bow_tie({0, 0, 0, 1, 0, 0, 1, 1, 0, -1, 0, 0, -1, -1, 0}, {0, 1, 2, 0, 3, 4});
  try {
    cn::assert_halfedge_links(corners(bow_tie));
  } catch (const cn::invalid_mesh& e) {
    fmt::print("{}\n", e.what());
  }

  // ... and so is a wrong order of corners. Arrays need no adapter at all.
  std::vector<double> xyz;
  for (std::size_t i = 0; i < bricks.x.size(); ++i) xyz.insert(xyz.end(), {bricks.x[i], bricks.y[i], bricks.z[i]});
  fmt::print("{}\n", cn::validate(cn::view_hex(xyz, bricks.corners))[0].what);
  fmt::print("volume {}\n", cn::total_measure(cn::view_hex(xyz, bricks.corners, cn::hex_order::lexicographic)));
}
