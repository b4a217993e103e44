// From a closed surface to tets, and from tets to hexes. TetGen makes the tets, in a process of its own; they are verified before they are returned.
#include <concino/adapters/tetgen.hpp>
#include <concino/generate.hpp>
#include <concino/geometry.hpp>
#include <concino/mesh.hpp>
#include <concino/quality.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <vector>

namespace cn = concino;

int main() {
  // A torus of quads, each of which is cut into two triangles.
  const auto torus = cn::make_torus<cn::quadmesh>({.cells = {24, 12}});
  const auto tets = cn::tetrahedralize(torus, cn::tetgen, {.radius_edge = 1.6, .min_dihedral_deg = 14});
  fmt::print("{} tets of volume {:.4f}, all verts of the torus among their {}\n", cn::num_polys(tets.mesh), cn::total_measure(tets.mesh), cn::num_verts(tets.mesh));
  fmt::print("{} of them miss the wanted angles, since the boundary is kept\n", tets.report.beyond_min_dihedral.size());

  // Each vert and each boundary face knows where it comes from.
  std::size_t moved = 0, boundary = 0;
  for (const auto v : cn::verts(torus)) moved += cn::point(tets.mesh, tets.vert_of(v)) != cn::point(torus, v);
  for (const auto f : cn::faces(tets.mesh)) boundary += tets.poly_of(f).has_value();
  fmt::print("{} verts moved; {} faces lie on {} quads\n", moved, boundary, cn::num_polys(torus));

  // Smaller tets on one side.
  const auto length = [](const cn::vec3& p) { return p.x > 0 ? 0.15 : 0.6; };
  const auto graded = cn::tetrahedralize(torus, cn::tetgen, {.edge_length = length, .keep_boundary = false});
  std::size_t right = 0;
  for (const auto p : cn::polys(graded.mesh)) right += cn::centroid(graded.mesh, p).x > 0;
  fmt::print("graded: {} tets on the side of short edges, {} on the other\n", right, cn::num_polys(graded.mesh) - right);

  // Four hexes of each tet, all valid.
  const cn::hexmesh hexes = cn::subdivide_midpoint(tets.mesh);
  double worst = 1;
  for (const auto p : cn::polys(hexes)) worst = std::min(worst, cn::quality(hexes, p, cn::metric::scaled_jacobian));
  fmt::print("{} hexes of volume {:.4f}, {}\n", cn::num_polys(hexes), cn::total_measure(hexes), worst > 0 ? "all valid" : "some not valid");

  // What cannot be filled is refused, and says why.
  try {
    cn::tetrahedralize(cn::make_grid<cn::trimesh>({.cells = {2, 2}}), cn::tetgen);
  } catch (const cn::invalid_mesh& e) {
    fmt::print("{}\n", e.what());
  }
}
