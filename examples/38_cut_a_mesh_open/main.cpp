// Cuts through volumes of cells of every shape: a slice is a surface, a clip is the part of the mesh above a plane or a value, and an iso-surface shows where
// a function has a value. The parts of cut cells are cells again, and their volumes sum to those of the whole.
#include <concino/generate.hpp>
#include <concino/geometry.hpp>
#include <concino/level_sets.hpp>
#include <concino/mesh.hpp>
#include <concino/render/scene.hpp>
#include <concino/render/scene_png.hpp>
#include <concino/validate.hpp>

#include <fmt/core.h>

namespace cn = concino;

int main(int argc, char** argv) {
  // Voronoi cells in a cube, and how far each vert is from the centre.
  const cn::box cube{{0, 0, 0}, {1, 1, 1}};
  cn::polyhedralmesh m = cn::voronoi_polyhedra(cn::random_points(200, cube), cube);
  const auto number = cn::poly_property<int>(m, "cell");
  for (const auto p : cn::polys(m)) number[p] = static_cast<int>(p.raw());
  auto far = cn::vert_property<double>(m, "distance");
  for (const auto v : cn::verts(m)) far[v] = cn::distance(cn::point(m, v), {0.5, 0.5, 0.5});
  fmt::print("{} cells, volume {:.6f}\n", cn::num_polys(m), cn::total_measure(m));

  // A slice of the cube is a square, filled by polygons. Each knows its cell, and named properties come along.
  const cn::plane middle{{0, 0, 1}, 0.5};
  const auto s = cn::slice(m, middle);
  const auto of_slice = cn::find_poly_property<int>(s.mesh, "cell");
  const auto first = *cn::polys(s.mesh).begin();
  fmt::print("slice: {} polygons, area {:.6f}; the first one lies in cell {}\n", cn::num_polys(s.mesh), cn::total_measure(s.mesh), of_slice[first]);

  // The upper half as a mesh. Its faces on the cut are listed.
  const auto upper = cn::clip(m, middle);
  double cut_area = 0;
  for (const auto f : upper.cut_faces) cut_area += cn::area(upper.mesh, f);
  fmt::print("clip: {} cells, {} of them cut, volume {:.6f}, {} faces on the cut with area {:.6f}, {}\n", cn::num_polys(upper.mesh), upper.report.cut_polys,
             cn::total_measure(upper.mesh), upper.cut_faces.size(), cut_area, cn::validate(upper.mesh).facts.manifold ? "closed" : "not closed");

  // Both parts of a ball of radius 0.4 in one mesh.
  const auto both = cn::split(m, far, 0.4);
  double inside = 0, outside = 0;
  for (const auto p : cn::polys(both.mesh)) (both.above[p.raw()] ? outside : inside) += cn::measure(both.mesh, p);
  fmt::print("split: {:.6f} inside and {:.6f} outside sum to {:.6f}\n", inside, outside, inside + outside);

  // Its surface, and the volumes of shells, without making their meshes.
  const auto ball = cn::isosurface<cn::trimesh>(m, far, 0.4);
  fmt::print("iso-surface: {} triangles, {}\n", cn::num_polys(ball.mesh), cn::validate(ball.mesh).facts.manifold ? "a manifold" : "not a manifold");
  for (const double v : cn::measure_between(m, far, {0.0, 0.2, 0.4, 0.9})) fmt::print("shell: {:.6f}\n", v);

  // A picture, if the program is given the name of a file: the clipped cells, turned so that the cut is on top, and the iso-surface.
  if (argc > 1) {
    cn::scene picture;
    picture.add(upper.mesh, {.labels = cn::find_poly_property<int>(upper.mesh, "cell"), .edges = true}).add(ball.mesh, {.edges = true});
    cn::save_png(picture, argv[1], {.width = 400, .height = 300, .up = {0, 0, -1}});
  }
}
