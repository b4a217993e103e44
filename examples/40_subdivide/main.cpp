// Subdivides meshes: tets become hexes, any polys become simplices, and a coarse surface becomes a smooth one. Properties follow, and the correspondence says of which
// elements the new ones were made.
#include <concino/generate.hpp>
#include <concino/geometry.hpp>
#include <concino/mesh.hpp>
#include <concino/quality.hpp>
#include <concino/render/scene.hpp>
#include <concino/render/scene_png.hpp>

#include <fmt/core.h>

namespace cn = concino;

int main(int argc, char** argv) {
  // A hex at each vert of each tet. The mesh stays the same in space, and so do labels.
  auto tets = cn::make_grid<cn::tetmesh>({.cells = {3, 3, 3}});
  cn::jitter(tets, 0.2);
  const auto label = cn::poly_property<int>(tets, "label");
  for (const auto p : cn::polys(tets)) label[p] = cn::centroid(tets, p).x < 0.5 ? 1 : 2;
  std::vector<cn::poly_id> inverted;
  const cn::hexmesh hexes = cn::subdivide_midpoint(tets, {.inverted = &inverted});
  const auto label_of = cn::find_poly_property<int>(hexes, "label");
  double labelled = 0;
  for (const auto p : cn::polys(hexes)) labelled += label_of[p] == 1 ? cn::volume(hexes, p) : 0;
  fmt::print("{} tets, {} hexes of volume {:.6f}, {:.6f} of it with label 1; {} are inverted\n", cn::num_polys(tets), cn::num_polys(hexes), cn::total_measure(hexes),
             labelled, inverted.size());

  // Cells of any shape become tets, one for each vert, edge at it, face at this, and cell.
  const cn::box cube{{0, 0, 0}, {1, 1, 1}};
  const auto cells = cn::voronoi_polyhedra(cn::random_points(30, cube), cube);
  const cn::tetmesh simplices = cn::subdivide_barycentric(cells);
  fmt::print("{} Voronoi cells, {} tets of volume {:.6f}\n", cn::num_polys(cells), cn::num_polys(simplices), cn::total_measure(simplices));

  // A cube becomes smooth, but for the four edges on top, which stay sharp.
  const auto box = cn::make_box<cn::quadmesh>({.cells = {1, 1, 1}});
  auto top = cn::make_edge_map<bool>(box);
  for (const auto e : cn::edges(box)) {
    const auto [a, b] = cn::end_verts(box, e);
    top[e] = cn::point(box, a).z == 1 && cn::point(box, b).z == 1;
  }
  const cn::quadmesh smooth = cn::subdivide_catmull_clark(box, {.times = 4});
  const cn::quadmesh lid = cn::subdivide_catmull_clark(box, top, {.times = 4});
  fmt::print("{} quads: up to z = {:.3f} if all is smooth, {:.3f} if the top has an edge\n", cn::num_polys(smooth), cn::bounding_box(smooth).max.z,
             cn::bounding_box(lid).max.z);

  // Where the smooth surface will be, and its normals, without subdividing.
  const auto limit = cn::catmull_clark_limit(box);
  const auto corner = *cn::verts(box).begin();
  const cn::vec3 x = limit.points[corner], n = limit.normals[corner];
  fmt::print("the corner ({:g}, {:g}, {:g}) goes to ({:.4f}, {:.4f}, {:.4f}), with normal ({:.3f}, {:.3f}, {:.3f})\n", cn::point(box, corner).x,
             cn::point(box, corner).y, cn::point(box, corner).z, x.x, x.y, x.z, n.x, n.y, n.z);

  // A picture, if the program is given the name of a file: the smooth surface with its sharp top, and the cube around it.
  if (argc > 1) cn::save_png(cn::scene().add(lid, {.edges = true}).add(box, {.edges = true, .opacity = 0.15}), argv[1], {.width = 400, .height = 300, .up = {0, 0, 1}});
}
