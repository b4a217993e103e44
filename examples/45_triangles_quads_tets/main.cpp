// From one kind of poly to another: triangles are joined to quads, polygons are cut into triangles, polyhedra into tets that fit together. Properties follow.
#include <concino/generate.hpp>
#include <concino/geometry.hpp>
#include <concino/mesh.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace cn = concino;

int main() {
  // Pairs of triangles become quads, as many as possible: on a closed surface, all.
  const auto ball = cn::icosphere(3);
  std::vector<cn::poly_id> left;
  const cn::polygonmesh quads = cn::quads_from_triangles(ball, {.triangles = &left});
  fmt::print("{} triangles, {} quads, {} triangles left\n", cn::num_polys(ball), cn::num_polys(quads) - left.size(), left.size());

  // A bound on the corners leaves triangles where no better pair is found.
  cn::trimesh flat = cn::make_grid<cn::trimesh>({.cells = {12, 12}});
  cn::jitter(flat, 0.2);
  for (const double angle : {180.0, 120.0, 105.0}) {
    const cn::polygonmesh joined = cn::quads_from_triangles(flat, {.max_angle_deg = angle, .triangles = &left});
    fmt::print("corners below {} degrees: {} quads, {} triangles left\n", angle, cn::num_polys(joined) - left.size(), left.size());
  }

  // Back to triangles: each polygon is cut by diagonals.
  const cn::trimesh triangles = cn::to_triangles(quads);
  fmt::print("{} triangles again, with the same verts: {}\n", cn::num_polys(triangles), cn::num_verts(triangles) == cn::num_verts(ball));

  // Hexes become five or six tets each, without new verts. A face is cut in the same way for both of its hexes.
  const cn::tetmesh tets = cn::to_tets(cn::make_box<cn::hexmesh>({.cells = {4, 4, 4}}));
  fmt::print("64 hexes, {} tets, {} verts\n", cn::num_polys(tets), cn::num_verts(tets));

  // Cells of any shape get a new vert each. A property of the cells goes to their tets; this one is split by volume.
  const cn::box cube{{0, 0, 0}, {1, 1, 1}};
  auto cells = cn::voronoi_polyhedra(cn::random_points(30, cube), cube);
  const auto mass = cn::poly_property<double>(cells, "mass");
  cn::set_property_rule(cells, cn::element_kind::poly, "mass", cn::property_rule::sum);
  for (const auto p : cn::polys(cells)) mass[p] = 2 * cn::volume(cells, p);
  std::vector<cn::poly_id> inverted;
  const cn::tetmesh parts = cn::to_tets(cells, {.inverted = &inverted});
  const auto mass_of_part = cn::find_poly_property<double>(parts, "mass");
  double sum = 0, largest = 0;
  for (const auto p : cn::polys(parts)) {
    sum += mass_of_part[p];
    largest = std::max(largest, std::abs(mass_of_part[p] / cn::volume(parts, p) - 2));
  }
  fmt::print("{} cells, {} tets, {} inverted; their mass is {:.6f}, and their density 2 to {}\n", cn::num_polys(cells), cn::num_polys(parts), inverted.size(), sum,
             largest < 1e-9 ? "9 digits" : "few digits");
}
