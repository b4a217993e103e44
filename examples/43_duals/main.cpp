// The dual of a mesh has a cell for each vert. At the boundary, cells keep the shape of the mesh, keep only its creases, or are left out; the maps say which
// element belongs to which. With circumcentres, the cells of a Delaunay mesh are its Voronoi cells.
#include <concino/generate.hpp>
#include <concino/geometry.hpp>
#include <concino/mesh.hpp>
#include <concino/render/scene.hpp>
#include <concino/render/scene_png.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace cn = concino;

int main(int argc, char** argv) {
  // The unit cube in 4 x 4 x 4 hexes. Its dual covers the same cube.
  const auto cube = cn::make_grid<cn::hexmesh>({.cells = {4, 4, 4}});
  const auto describe = [](const char* name, const cn::polyhedralmesh& d) {
    fmt::print("{:>20}: {} cells with {} faces and {} verts, of volume {:.4f}\n", name, cn::num_polys(d), cn::num_faces(d), cn::num_verts(d), cn::total_measure(d));
  };
  describe("clipped", cn::dual_mesh(cube));
  describe("with creases only", cn::dual_mesh(cube, {.crease_angle_deg = 30}));
  describe("closed", cn::dual_mesh(cube, {.boundary = cn::dual_boundary::closed}));
  describe("discarded", cn::dual_mesh(cube, {.boundary = cn::dual_boundary::discarded}));

  // From a value at each vert to one at each cell: the maps connect them.
  cn::dual_maps maps;
  const cn::polyhedralmesh cells = cn::dual_mesh(cube, {.crease_angle_deg = 30, .maps = &maps});
  double integral = 0;  // of x
  for (const auto v : cn::verts(cube)) integral += cn::point(cube, v).x * cn::volume(cells, maps.poly_of_vert[v.raw()]);
  fmt::print("the integral of x over the cube is {:.3f}\n", integral);

  // Voronoi cells on a sphere: their verts are circumcentres, so each edge of a cell is equally far from two verts of the sphere.
  const cn::trimesh sphere = cn::icosphere(2);
  const cn::polygonmesh d = cn::dual_mesh(sphere, {.points = cn::dual_points::circumcentres, .maps = &maps});
  double farthest = 0;
  for (const auto v : cn::verts(sphere))
    for (const auto x : cn::adj_p2v(d, maps.poly_of_vert[v.raw()])) farthest = std::max(farthest, cn::distance(cn::point(d, x), cn::point(sphere, v)));
  fmt::print("{} cells on a sphere, each within {:.3f} of its site\n", cn::num_polys(d), farthest);

  // A picture, if the program is given the name of a file: the Voronoi cells, and their sites.
  if (argc > 1) cn::save_png(cn::scene().add(d, {.edges = true, .edge_width = 2, .crease_angle = 0}).add_points(sphere, {.radius = 0.02}), argv[1], {.width = 380, .height = 320});
}
